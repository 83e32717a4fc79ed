// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/relations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/rounding.hpp"
#include "hitos/base/text_input.hpp"
#include "stamp_pairs.hpp"

namespace hitos {
namespace {

constexpr std::array<std::string_view, 8> kRelationFields = {"t1", "t2",   "x",     "y",
                                                             "z",  "roll", "pitch", "yaw"};

bool finite(const PoseRelation& relation) {
    const auto& [from, to, pose] = relation;
    return std::isfinite(from) && std::isfinite(to) && std::isfinite(pose.x) &&
           std::isfinite(pose.y) && std::isfinite(pose.theta);
}

const char* missing(const MeasuredRelation& row) {
    if (row.has_from) return row.has_to ? "" : "no pose at t2";
    return row.has_to ? "no pose at t1" : "no pose at t1 and t2";
}

std::vector<double> squared(std::vector<double> values) {
    for (double& value : values) value *= value;
    return values;
}

}  // namespace

double MeasuredRelation::translation_m() const {
    if (!estimate_from_to) return 0.0;
    return std::hypot(estimate_from_to->x - relation.pose_from_to.x,
                      estimate_from_to->y - relation.pose_from_to.y);
}

double MeasuredRelation::rotation_rad() const {
    if (!estimate_from_to) return 0.0;
    return std::abs(wrap_angle(estimate_from_to->theta - relation.pose_from_to.theta));
}

std::vector<PoseRelation> read_relations(const std::filesystem::path& path) {
    return parse_relations(input::read_text(path), path.string());
}

std::vector<PoseRelation> parse_relations(std::string_view text, const std::string& name) {
    std::vector<PoseRelation> relations;
    std::uint64_t number = 0;
    while (const auto line = input::next_line(text)) {
        ++number;
        const std::string_view content = input::trimmed(line->substr(0, line->find('#')));
        if (content.empty()) continue;
        const auto [t1, t2, x, y, z, roll, pitch, yaw] =
            input::finite_numbers(content, kRelationFields, {name, number});
        relations.push_back({t1, t2, {x, y, wrap_angle(yaw)}});
    }
    if (relations.empty()) {
        throw FormatError(name, 0,
                          HITOS_TEXT("Errors",
                                     "no relation in the file; expected 8 numbers, t1 t2 x y z "
                                     "roll pitch yaw on each line"));
    }
    return relations;
}

std::string relations_text(std::span<const PoseRelation> relations) {
    std::string text = "# t1 t2 x y z roll pitch yaw [s, m, rad]\n";
    for (std::size_t i = 0; i < relations.size(); ++i) {
        const auto& [from, to, pose] = relations[i];
        if (!finite(relations[i])) {
            throw Error(message(HITOS_TEXT("Errors",
                                           "relation %1 (t1 %2, t2 %3, x %4, y %5, yaw %6) is not "
                                           "finite and cannot be written"),
                                i + 1, from, to, pose.x, pose.y, pose.theta));
        }
        text += fmt::format("{} {} {} {} 0 0 0 {}\n", without_sign_of_zero(from),
                            without_sign_of_zero(to), without_sign_of_zero(pose.x),
                            without_sign_of_zero(pose.y), without_sign_of_zero(pose.theta));
    }
    return text;
}

std::vector<PoseRelation> relations_of(const Trajectory& trajectory,
                                       std::span<const PosePair> pairs) {
    std::vector<PoseRelation> relations;
    relations.reserve(pairs.size());
    for (const auto& [from, to] : pairs) {
        const StampedPose& a = trajectory[from];
        const StampedPose& b = trajectory[to];
        relations.push_back({a.time_s, b.time_s, between(a.pose, b.pose)});
    }
    return relations;
}

std::vector<MeasuredRelation> measure_relations(Trajectory estimate,
                                                std::span<const PoseRelation> relations,
                                                double tolerance_s) {
    std::ranges::stable_sort(estimate, {}, &StampedPose::time_s);
    std::vector<MeasuredRelation> measured;
    measured.reserve(relations.size());
    for (const PoseRelation& relation : relations) {
        const StampedPose* from = nearest_pose(estimate, relation.from_s, tolerance_s);
        const StampedPose* to = nearest_pose(estimate, relation.to_s, tolerance_s);
        MeasuredRelation& row = measured.emplace_back();
        row.relation = relation;
        row.has_from = from != nullptr;
        row.has_to = to != nullptr;
        if (row.has_from && row.has_to) row.estimate_from_to = between(from->pose, to->pose);
    }
    return measured;
}

RelationErrors relation_errors(std::span<const MeasuredRelation> measured) {
    RelationErrors errors;
    std::vector<double> translations;
    std::vector<double> rotations;
    for (const MeasuredRelation& row : measured) {
        if (!row.has_from && !row.has_to) ++errors.without_both;
        if (!row.has_from && row.has_to) ++errors.without_from;
        if (row.has_from && !row.has_to) ++errors.without_to;
        if (!row.estimate_from_to) continue;
        ++errors.used;
        translations.push_back(row.translation_m());
        rotations.push_back(row.rotation_rad());
    }
    errors.translation_m = figures_of(translations);
    errors.rotation_rad = figures_of(rotations);
    errors.translation_squared_m2 = figures_of(squared(std::move(translations)));
    errors.rotation_squared_rad2 = figures_of(squared(std::move(rotations)));
    return errors;
}

std::string relations_csv(std::span<const MeasuredRelation> measured) {
    std::string text =
        "t1,t2,x_m,y_m,yaw_rad,slam_x_m,slam_y_m,slam_yaw_rad,translation_error_m,"
        "rotation_error_rad,missing\n";
    for (const MeasuredRelation& row : measured) {
        const auto& [from, to, pose] = row.relation;
        text += fmt::format("{},{},{:.9f},{:.9f},{:.9f},", from, to, pose.x, pose.y, pose.theta);
        if (const auto& own = row.estimate_from_to) {
            text += fmt::format("{:.9f},{:.9f},{:.9f},{:.9f},{:.9f},\n", own->x, own->y, own->theta,
                                row.translation_m(), row.rotation_rad());
        } else {
            text += fmt::format(",,,,,{}\n", missing(row));
        }
    }
    return text;
}

}  // namespace hitos
