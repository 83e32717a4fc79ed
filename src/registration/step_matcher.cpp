// SPDX-License-Identifier: GPL-3.0-or-later
#include "step_matcher.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "correlation.hpp"

namespace hitos {
namespace {

constexpr double kGoodScore = 0.7;   // no other start is tried
constexpr double kPoorScore = 0.65;  // a search is worth its time
constexpr double kLeastScore = 0.2;  // of a match at all
constexpr double kDeparture = 0.05;  // score lost per metre and per radian from the odometry

}  // namespace

double StepMatcher::score(std::span<const SurfacePoint> scan, const PointMap& map, const Pose& pose,
                          const Pose& odometry) const {
    return match_score(scan, map, pose, 2) -
           kDeparture * (std::abs(wrap_angle(pose.theta - odometry.theta)) +
                         std::hypot(pose.x - odometry.x, pose.y - odometry.y));
}

void StepMatcher::search(std::span<const SurfacePoint> scan, const PointMap& map,
                         const PosePrior& odometry, const Eigen::Vector2d& sigmas,
                         Start& best) const {
    constexpr double kMargin = 0.05;     // of score, for leaving the odometry
    constexpr double kFar = 18.0;        // [m]
    constexpr double kHalf = 20.0;       // [m], of the picture
    constexpr std::size_t kMany = 120;   // points, above which every second one will do,
    constexpr std::size_t kMost = 2000;  // and never more than these
    constexpr std::size_t kFewest = 20;
    std::vector<SurfacePoint> query;
    const std::size_t stride =
        std::max<std::size_t>(scan.size() > kMany ? 2 : 1, scan.size() / kMost);
    for (std::size_t i = 0; i < scan.size(); i += stride) {
        if (std::hypot(static_cast<double>(scan[i].x), static_cast<double>(scan[i].y)) < kFar) {
            query.push_back(scan[i]);
        }
    }
    if (query.size() <= kFewest) return;
    const CorrelationMap picture(map, kHalf, 3);
    const SearchWindow window{std::min(2.0, 0.3 + 3.0 * sigmas(0)),
                              std::min(0.8, 0.15 + 3.0 * sigmas(1))};
    const auto found =
        correlate(query, picture, odometry.mean, window, std::max(0.4, best.score + kMargin));
    if (!found) return;
    const PosePrior weak{found->pose, 0.01 * odometry.information, odometry.robust};
    const Pose pose = matcher_.fit(scan, map, found->pose, weak);
    const double its = score(scan, map, pose, odometry.mean);
    if (its > best.score + kMargin) best = {pose, its};
}

void StepMatcher::try_turned(std::span<const SurfacePoint> scan, const PointMap& map,
                             const PosePrior& odometry, Start& best) const {
    constexpr double kSame = 0.05;  // [m], half a radian counts a metre: it would end there too
    std::array<Pose, 5> ends{best.pose};
    std::size_t count = 1;
    for (const double turn : {-0.1, 0.1, -0.22, 0.22}) {
        const Pose start{odometry.mean.x, odometry.mean.y, odometry.mean.theta + turn};
        const Pose near = matcher_.fit(scan, map, start, odometry, ScanMatcher::kWideSteps);
        const auto ends_at = [&near](const Pose& end) {
            return std::hypot(near.x - end.x, near.y - end.y) +
                       2.0 * std::abs(wrap_angle(near.theta - end.theta)) <
                   kSame;
        };
        if (std::any_of(ends.begin(), ends.begin() + static_cast<std::ptrdiff_t>(count), ends_at))
            continue;
        const Pose pose = matcher_.fit(scan, map, near, odometry, ScanMatcher::kMostSteps,
                                       ScanMatcher::kWideSteps);
        ends[count++] = pose;
        const double its = score(scan, map, pose, odometry.mean);
        if (its > best.score + 1e-3) best = {pose, its};
    }
}

MatchedStep StepMatcher::match(std::span<const SurfacePoint> scan, const PointMap& map,
                               const PosePrior& odometry, const Eigen::Vector2d& sigmas) const {
    const Pose straight = matcher_.fit(scan, map, odometry.mean, odometry);
    Start best{straight, score(scan, map, straight, odometry.mean)};
    if (best.score <= kGoodScore) try_turned(scan, map, odometry, best);
    if (params_.search && best.score < kPoorScore) search(scan, map, odometry, sigmas, best);

    MatchedStep step;
    step.pose = best.pose;
    step.score = best.score;
    step.fine = matcher_.linearize(scan, map, best.pose, kFineStage);
    step.matched = step.fine.matches >= kLeastMatches && best.score > kLeastScore;
    if (!step.matched) step.pose = odometry.mean;
    return step;
}

}  // namespace hitos
