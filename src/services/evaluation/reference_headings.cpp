// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a reference trajectory has headings: GPS and total stations tell positions alone.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

#include "hitos/base/translatable.hpp"
#include "reference_doubts.hpp"

namespace hitos {
namespace {

constexpr double kTurn = 0.3;        // [rad]
constexpr double kWithin = 2.0;      // [m] of way: slower it may be drift
constexpr int kFewTurns = 4;         // say nothing
constexpr double kUnlikeTurn = 0.5;  // of a turn
constexpr double kSameWay = 0.01;
constexpr double kStride = 0.5;  // [m] of the reference's way
constexpr int kFewSteps = 8;
constexpr double kAlong =
    0.9;  // mean of unit vectors: 1 where all steps go one way off the heading

double way_between(const Pose& a, const Pose& b) {
    return std::hypot(b.x - a.x, b.y - a.y);
}

/// The turns of the path, and of these the ones that the reference's headings do not make.
void count_turns(const Trajectory& path, const std::vector<Matched>& matched, HeadingsFit& fit) {
    std::size_t from = 0;
    double way = 0.0;
    for (std::size_t i = 1; i < matched.size(); ++i) {
        const Pose& begin = path[matched[from].estimate].pose;
        const Pose& here = path[matched[i].estimate].pose;
        way += way_between(path[matched[i - 1].estimate].pose, here);
        const double turn = wrap_angle(here.theta - begin.theta);
        const bool turned = std::abs(turn) >= kTurn;
        if (!turned && way < kWithin) continue;
        if (turned) {
            const double there =
                wrap_angle(matched[i].reference.theta - matched[from].reference.theta);
            ++fit.turns;
            if (std::abs(wrap_angle(there - turn)) > kUnlikeTurn * std::abs(turn)) ++fit.unlike;
        }
        from = i;
        way = 0.0;
    }
}

/// Whether the reference's headings keep to the way that it goes, straight on or sideways.
bool looks_along(const std::vector<Matched>& matched) {
    std::size_t from = 0;
    int steps = 0;
    std::complex<double> sum;
    for (std::size_t i = 1; i < matched.size(); ++i) {
        const Pose& a = matched[from].reference;
        const Pose& b = matched[i].reference;
        if (way_between(a, b) < kStride) continue;
        const double heading = a.theta + wrap_angle(b.theta - a.theta) / 2.0;
        sum += std::polar(1.0, std::atan2(b.y - a.y, b.x - a.x) - heading);
        ++steps;
        from = i;
    }
    return steps < kFewSteps || std::abs(sum) >= kAlong * steps;
}

/// By how much the reference's headings are off the path's, where all are by as much and the
/// positions of both have the same shape; else 0.
double turned_by(const Trajectory& path, const std::vector<Matched>& matched) {
    constexpr double kLeast = 0.35;  // [rad]
    constexpr double kAlike = 0.9;
    const auto count = static_cast<double>(matched.size());
    std::complex<double> mean;
    std::complex<double> mean_there;
    for (const auto& [i, there] : matched) {
        mean += std::complex(path[i].pose.x, path[i].pose.y) / count;
        mean_there += std::complex(there.x, there.y) / count;
    }
    std::complex<double> product;
    double squares = 0.0;
    std::complex<double> headings;
    for (const auto& [i, there] : matched) {
        const auto own = std::complex(path[i].pose.x, path[i].pose.y) - mean;
        const auto other = std::complex(there.x, there.y) - mean_there;
        product += std::conj(own) * other;
        squares += (std::norm(own) + std::norm(other)) / 2.0;
        headings += std::polar(1.0, there.theta - path[i].pose.theta);
    }
    const double off = wrap_angle(std::arg(headings) - std::arg(product));
    const bool alike = std::abs(product) >= kAlike * squares && squares > 0.0;
    return alike && std::abs(headings) >= kAlike * count && std::abs(off) >= kLeast ? off : 0.0;
}

}  // namespace

HeadingsFit fit_of_headings(const Trajectory& path, const std::vector<Matched>& matched) {
    HeadingsFit fit;
    if (matched.empty()) return fit;
    count_turns(path, matched, fit);
    fit.turned_rad = turned_by(path, matched);
    if (fit.turned_rad != 0.0) fit.headings = Headings::turned;
    if (fit.turns < kFewTurns || 5 * fit.unlike < 4 * fit.turns || looks_along(matched)) return fit;
    const double first = matched.front().reference.theta;
    const bool same = std::ranges::all_of(matched, [&](const Matched& pair) {
        return std::abs(wrap_angle(pair.reference.theta - first)) < kSameWay;
    });
    fit.headings = same ? Headings::none : Headings::unfit;
    return fit;
}

std::optional<Advice> HeadingsFit::doubt() const {
    if (told()) return std::nullopt;
    if (headings == Headings::none) {
        return Advice{
            HITOS_TEXT("Advice",
                       "The reference trajectory has no headings: its poses all look the "
                       "same way where the path makes %1 turns. Errors of headings, relative "
                       "errors and which loops are false are left out; the ATE is of "
                       "positions alone, and stands."),
            std::to_string(turns),
            {}};
    }
    if (headings == Headings::turned) {
        return Advice{
            HITOS_TEXT("Advice",
                       "The headings of the reference trajectory are off by %1, as those of "
                       "another part of the robot: turn them back by that. Errors of headings, "
                       "relative errors and which loops are false are left out; the ATE is of "
                       "positions alone, and stands."),
            fmt::format("{:.0f}°", turned_rad * kDegreesPerRadian),
            {}};
    }
    return Advice{HITOS_TEXT("Advice",
                             "The headings of the reference trajectory are none of this path: %1 "
                             "of its turns are not theirs. Errors of headings, relative errors and "
                             "which loops are false are left out; the ATE is of positions alone, "
                             "and stands."),
                  fmt::format("{}/{}", unlike, turns),
                  {}};
}

}  // namespace hitos
