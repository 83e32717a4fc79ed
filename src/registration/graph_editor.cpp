// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph_editor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

/// Whether the change is of that scan and needs it as a key.
bool makes_key(const GraphEdit& edit, std::uint64_t scan) {
    return edit.needs_keys() &&
           (edit.scan.scan == scan || (edit.of_two() && edit.earlier.scan == scan));
}

/// What a change of two scans names.
NamedLoop named_by(const GraphEdit& edit) {
    return {edit.scan.scan, edit.earlier.scan};
}

/// Whether the stretch that a refusal keeps out passes the place that an edit names.
bool passes(const GraphEdit& refusal, const GraphEdit& edit, const KeyGraph& graph,
            std::span<const LoopRecord> refused) {
    const Joint named = graph.joint_at(edit.scan.scan, edit.earlier.scan);
    std::optional<Joint> nearest;
    double begin_m = named.later_m + Joint::kBeside;
    const auto away_m = [&](const Joint& joint) { return std::abs(joint.later_m - named.later_m); };
    for (const LoopRecord& loop : refused) {
        if (loop.refused_by != named_by(refusal)) continue;
        const Joint joint = graph.joint_at(loop.scan, loop.earlier);
        begin_m = std::min(begin_m, joint.later_m);
        if (!nearest || away_m(joint) < away_m(*nearest)) nearest = joint;
    }
    return nearest && named.later_m >= begin_m - Joint::kBeside && nearest->is_near(named);
}

}  // namespace

GraphEditor::GraphEditor(std::vector<GraphEdit> edits)
    : edits_(std::move(edits)), met_(edits_.size(), false) {}

void GraphEditor::replace(std::vector<GraphEdit> edits) {
    std::vector<bool> met;
    for (const GraphEdit& edit : edits) {
        const auto former = std::ranges::find_if(
            edits_, [&](const GraphEdit& one) { return same_change(one, edit); });
        met.push_back(former != edits_.end() &&
                      met_[static_cast<std::size_t>(former - edits_.begin())]);
    }
    edits_ = std::move(edits);
    met_ = std::move(met);
}

void GraphEditor::check(std::uint64_t number, const Scan& scan) const {
    constexpr double kSameStamp = 1e-3;  // [s]
    for (std::size_t i = 0; i < edits_.size(); ++i) {
        for (const EditedScan& named : {edits_[i].scan, edits_[i].earlier}) {
            if (named.scan != number || !named.stamp_s) continue;
            if (std::abs(*named.stamp_s - scan.stamp_s()) <= kSameStamp) {
                const std::uint32_t mark = scan.mark.value;
                if (named.mark == 0 || mark == 0 || named.mark == mark) continue;
                throw ConfigError(
                    kGraphEditsKey,
                    HITOS_TEXT("Errors",
                               "change %1 is of another tour: scan %2 was another one when it was "
                               "made, of the same time; where it is the same in another format, "
                               "take the \"~%3\" out"),
                    i + 1, number + 1, fmt::format("{:08x}", named.mark));
            }
            throw ConfigError(kGraphEditsKey,
                              HITOS_TEXT("Errors",
                                         "change %1 is of another tour, or of this one read "
                                         "otherwise: scan %2 had the stamp %3 when it was made, "
                                         "and has %4"),
                              i + 1, number + 1, *named.stamp_s, scan.stamp_s());
        }
    }
}

void GraphEditor::check_end(std::uint64_t scans) const {
    for (std::size_t i = 0; i < edits_.size(); ++i) {
        if (edits_[i].scan.scan < scans) continue;
        throw ConfigError(
            kGraphEditsKey,
            HITOS_TEXT("Errors",
                       "change %1 is of another tour: it names scan %2, and there are "
                       "%3"),
            i + 1, edits_[i].scan.scan + 1, scans);
    }
}

void GraphEditor::check_held(const KeyGraph& graph, std::uint64_t begin,
                             std::span<const std::uint64_t> forced) const {
    for (std::size_t i = 0; i < edits_.size(); ++i) {
        const std::uint64_t named = edits_[i].earlier.scan;
        if (edits_[i].scan.scan < begin || !makes_key(edits_[i], named) || named >= begin ||
            !std::ranges::binary_search(forced, named)) {
            continue;
        }
        const bool of_map = std::ranges::any_of(edits_, [&](const GraphEdit& edit) {
            return edit.scan.scan < begin && makes_key(edit, named);
        });
        if (of_map) continue;
        std::uint64_t key = 0;
        for (const KeyPose& pose : graph.poses) {
            if (pose.scan < named && !std::ranges::binary_search(forced, pose.scan))
                key = pose.scan;
        }
        throw ConfigError(kGraphEditsKey,
                          HITOS_TEXT("Errors",
                                     "change %1 names scan %2 of the map, which is held "
                                     "(source.hold) and would have to get a key scan there; name "
                                     "scan %3, its key before that, or do not hold the map"),
                          i + 1, named + 1, key + 1);
    }
}

bool GraphEditor::needs_key(std::uint64_t scan) const {
    return std::ranges::any_of(edits_,
                               [&](const GraphEdit& edit) { return makes_key(edit, scan); });
}

bool GraphEditor::slipped(std::uint64_t scan) {
    bool slipped = false;
    for (std::size_t i = 0; i < edits_.size(); ++i) {
        if (edits_[i].kind != GraphEdit::Kind::slip || edits_[i].scan.scan != scan) continue;
        slipped = met_[i] = true;
    }
    return slipped;
}

std::vector<GraphEdit> GraphEditor::of_newest(const KeyGraph& graph, bool placed) {
    std::vector<GraphEdit> found;
    for (std::size_t i = 0; i < edits_.size(); ++i) {
        if (!edits_[i].needs_keys() || edits_[i].scan.scan != graph.poses.back().scan) continue;
        if (edits_[i].anchors() && !placed) continue;
        met_[i] = true;
        found.push_back(edits_[i]);
    }
    return found;
}

/// Other changes move by some scans where a loop is found.
bool GraphEditor::names(const GraphEdit& edit, const KeyGraph& graph, const LoopFound& loop) {
    if (edit.kind != GraphEdit::Kind::refuse || loop.record.scan < edit.scan.scan) return false;
    const auto way_m = [&](std::size_t key) { return graph.scans[key].travelled_m; };
    return way_m(graph.size() - 1) - way_m(graph.key_at(edit.scan.scan)) <= Joint::kBeside &&
           std::abs(way_m(loop.key) - way_m(graph.key_at(edit.earlier.scan))) <= Joint::kBeside;
}

std::optional<NamedLoop> GraphEditor::refuses(const KeyGraph& graph, const LoopFound& loop) {
    constexpr double kMemory = 12.0;   // [m] of way without a find, as that of the search
    constexpr double kSame = 0.8;      // [m], less than what false places have in common
    constexpr double kSameTurn = 0.1;  // [rad]
    const Pose& now = graph.poses.back().pose;
    const double way_m = graph.scans.back().travelled_m;
    const Pose move = compose(loop.pose, inverse(now));
    for (std::size_t i = 0; i < edits_.size(); ++i) {
        if (met_[i] || !names(edits_[i], graph, loop)) continue;
        met_[i] = true;
        refused_.push_back({named_by(edits_[i]), way_m, move});
        return refused_.back().by;
    }
    for (Refused& last : refused_) {
        const Pose said = compose(last.move, now);
        if (way_m - last.way_m > kMemory ||
            std::hypot(said.x - loop.pose.x, said.y - loop.pose.y) > kSame ||
            std::abs(wrap_angle(said.theta - loop.pose.theta)) > kSameTurn) {
            continue;
        }
        last = {last.by, way_m, move};
        return last.by;
    }
    return std::nullopt;
}

std::vector<std::uint64_t> GraphEditor::unmet() const {
    std::vector<std::uint64_t> unmet;
    for (std::size_t i = 0; i < met_.size(); ++i) {
        if (!met_[i]) unmet.push_back(i);
    }
    return unmet;
}

std::vector<CoveredRefusal> GraphEditor::covered(const KeyGraph& graph,
                                                 std::span<const LoopRecord> refused,
                                                 std::uint64_t scans) const {
    std::vector<CoveredRefusal> covered;
    const auto is_refusal = [&](std::size_t place) {
        return edits_[place].kind == GraphEdit::Kind::refuse;
    };
    for (const std::uint64_t place : unmet()) {
        if (!is_refusal(place) || edits_[place].scan.scan >= scans) continue;
        for (std::size_t by = 0; by < edits_.size(); ++by) {
            if (!met_[by] || !is_refusal(by)) continue;
            if (!passes(edits_[by], edits_[place], graph, refused)) continue;
            covered.push_back({place, by});
            break;
        }
    }
    return covered;
}

std::optional<ChangesByHand> GraphEditor::counts() const {
    if (edits_.empty()) return std::nullopt;
    ChangesByHand counts;
    for (std::size_t i = 0; i < edits_.size(); ++i) {
        using Kind = GraphEdit::Kind;
        const Kind kind = edits_[i].kind;
        ++(!met_[i]               ? counts.met_nothing
           : kind == Kind::close  ? counts.closed
           : kind == Kind::refuse ? counts.refused
           : kind == Kind::fix    ? counts.fixed
           : kind == Kind::slip   ? counts.slips
                                  : counts.anchors);
    }
    return counts;
}

}  // namespace hitos
