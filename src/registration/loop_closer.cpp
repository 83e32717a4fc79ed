#include "loop_closer.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "free_view.hpp"

namespace hitos {
namespace {

constexpr double kLeastWay = 15.0;        // [m] driven since; nearer is no loop
constexpr double kGreatestWindow = 15.0;  // [m]
constexpr double kGreatestTurn = 0.6;     // [rad]
constexpr double kStretch = 5.0;          // [m] of travel, of the query and about the old key
constexpr double kNearOutside = 3.0;      // [m] that a candidate may lie beyond the window

/// Three standard deviations and a little.
double window_m(const GraphReach& reach) {
    return std::min(kGreatestWindow, 0.5 + 3.0 * std::sqrt(reach.variance_m2));
}

double window_rad(const GraphReach& reach) {
    return std::min(kGreatestTurn, 0.06 + 3.0 * std::sqrt(reach.variance_rad2));
}

}  // namespace

std::optional<std::uint32_t> LoopCloser::candidate(const KeyGraph& graph,
                                                   std::span<const GraphReach> reached) const {
    const std::size_t newest = graph.size() - 1;
    const Pose& now = graph.poses[newest].pose;
    std::optional<std::uint32_t> best;
    double best_cost = GraphReach::kNever;
    for (std::size_t j = 0; j < newest; ++j) {
        const double travelled = graph.scans[newest].travelled_m - graph.scans[j].travelled_m;
        if (travelled < kLeastWay || reached[j].way_m < kLeastWay) continue;
        const double window = window_m(reached[j]) + kNearOutside;
        const Pose& then = graph.poses[j].pose;
        const double distance = std::hypot(then.x - now.x, then.y - now.y);
        if (distance > window) continue;
        const double cost = distance / window + 0.02 * std::sqrt(reached[j].variance_m2);
        if (cost < best_cost) {
            best_cost = cost;
            best = static_cast<std::uint32_t>(j);
        }
    }
    return best;
}

void LoopCloser::gather_query(const KeyGraph& graph) {
    constexpr std::size_t kMostKeys = 16;
    constexpr double kFar = 20.0;   // [m]
    constexpr double kThin = 0.35;  // [m], side of the cells that keep one point each
    const std::size_t newest = graph.size() - 1;
    const Pose& now = graph.poses[newest].pose;
    query_.clear();
    query_keys_ = 0;
    std::unordered_set<std::int64_t> taken;  // asked only whether it holds a cell
    for (std::size_t n = 0; n < std::min(kMostKeys, graph.size()); ++n) {
        const std::size_t j = newest - n;
        if (graph.scans[newest].travelled_m - graph.scans[j].travelled_m >= kStretch) break;
        ++query_keys_;
        const Pose pose = between(now, graph.poses[j].pose);
        const double c = std::cos(pose.theta);
        const double s = std::sin(pose.theta);
        for (const SurfacePoint& p : graph.scans[j].points()) {
            const Point2 at =
                transform(pose, Point2{static_cast<double>(p.x), static_cast<double>(p.y)});
            if (std::hypot(at.x, at.y) > kFar) continue;
            const auto cell = static_cast<std::int64_t>(std::floor(at.x / kThin)) * 1000003 +
                              static_cast<std::int64_t>(std::floor(at.y / kThin));
            if (!taken.insert(cell).second) continue;
            const auto nx = static_cast<double>(p.nx);
            const auto ny = static_cast<double>(p.ny);
            query_.push_back({static_cast<float>(at.x), static_cast<float>(at.y),
                              static_cast<float>(c * nx - s * ny),
                              static_cast<float>(s * nx + c * ny)});
        }
    }
}

bool LoopCloser::agreed(const Pose& now, const Pose& then, double travelled_m) {
    constexpr double kMemory = 12.0;    // [m] of travel
    constexpr double kLeastSpan = 1.5;  // [m] of travel between the first and the last
    constexpr std::size_t kMostKept = 12;
    int agreeing = 1;
    double span = 0.0;
    for (const Found& found : found_) {
        const double ago = travelled_m - found.travelled_m;
        if (ago >= kMemory) continue;
        const Pose said = compose(found.move, now);
        // What the odometry may have erred by in between.
        if (std::hypot(said.x - then.x, said.y - then.y) < 0.4 + 0.01 * ago &&
            std::abs(wrap_angle(said.theta - then.theta)) < 0.06) {
            ++agreeing;
            span = std::max(span, ago);
        }
    }
    found_.push_back({compose(then, inverse(now)), travelled_m});
    if (found_.size() > kMostKept) found_.pop_front();
    return agreeing >= params_.loops_agree && (params_.loops_agree == 1 || span > kLeastSpan);
}

/// Places that look alike in what there is differ in what there is not: one passage looks through
/// where the other saw a wall. True loops have up to 0.24 of it (doors, people), false ones 0.4.
bool LoopCloser::contradicted(const KeyGraph& graph, const LoopFound& loop,
                              const PointMap& map) const {
    constexpr double kMuch = 0.3;
    constexpr std::size_t kEveryOldKey = 3;
    constexpr std::size_t kEveryNewKey = 2;
    constexpr std::size_t kEveryPoint = 8;
    const std::size_t newest = graph.size() - 1;
    std::vector<FreeView> views;
    for (std::size_t i = 0; i < loop.sources.size(); i += kEveryOldKey) {
        const std::uint32_t j = loop.sources[i];
        views.emplace_back(graph.scans[j].points(), graph.poses[j].pose);
    }
    std::vector<Point2> points;
    place(query_, loop.pose, points);
    if (contradiction(points, views) > kMuch) return true;

    views.clear();
    const Pose move = compose(loop.pose, inverse(graph.poses[newest].pose));
    for (std::size_t n = 0; n < query_keys_; n += kEveryNewKey) {
        views.emplace_back(graph.scans[newest - n].points(),
                           compose(move, graph.poses[newest - n].pose));
    }
    points.clear();
    for (std::size_t i = 0; i < map.points().size(); i += kEveryPoint) {
        const MapPoint& p = map.points()[i];
        points.push_back(
            {map.centre().x + static_cast<double>(p.x), map.centre().y + static_cast<double>(p.y)});
    }
    return contradiction(points, views) > kMuch;
}

std::optional<LoopFound> LoopCloser::search(const KeyGraph& graph,
                                            std::span<const GraphReach> reached) {
    constexpr std::size_t kFewestPoints = 40;
    constexpr std::size_t kMostBefore = 15;
    constexpr std::size_t kMostKeys = 30;
    constexpr double kLeastScore = 0.5;
    constexpr double kLeastSpread = 0.03;  // of a corridor's matches along it
    const auto found = candidate(graph, reached);
    if (!found) return std::nullopt;
    gather_query(graph);
    if (query_.size() < kFewestPoints) return std::nullopt;
    ++searches_;

    const std::size_t newest = graph.size() - 1;
    const double old_travelled = graph.scans[*found].travelled_m;
    LoopFound loop;
    loop.key = *found;
    for (std::size_t j = *found + 1; j-- > 0 && loop.sources.size() < kMostBefore;) {
        if (old_travelled - graph.scans[j].travelled_m >= kStretch) break;
        loop.sources.push_back(static_cast<std::uint32_t>(j));
    }
    for (std::size_t j = *found + 1; j < newest && loop.sources.size() < kMostKeys; ++j) {
        if (graph.scans[j].travelled_m - old_travelled >= kStretch) break;
        loop.sources.push_back(static_cast<std::uint32_t>(j));
    }
    const SearchWindow window{window_m(reached[*found]), window_rad(reached[*found])};
    const Pose& old = graph.poses[*found].pose;
    PointMap map;
    build_map(graph, loop.sources, old, 40.0, map);
    const CorrelationMap picture(map, 25.0 + 0.5 * window.position_m, 4);
    const Pose now = graph.poses[newest].pose;
    const auto correlated = correlate(query_, picture, now, window, params_.loop_score);
    if (!correlated) return std::nullopt;

    const PosePrior hardly_any{correlated->pose, 1e-3 * Eigen::Matrix3d::Identity()};
    loop.pose = matcher_.fit(query_, map, correlated->pose, hardly_any, 25);
    const Linearization l = matcher_.linearize(query_, map, loop.pose, kFineStage);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> spread(l.h.topLeftCorner<2, 2>());
    if (match_score(query_, map, loop.pose, 1) <= kLeastScore ||
        spread.eigenvalues()(0) <= kLeastSpread * std::max(1, l.matches) ||
        contradicted(graph, loop, map)) {
        ++refused_;
        return std::nullopt;
    }
    if (!agreed(now, loop.pose, graph.scans[newest].travelled_m)) return std::nullopt;
    return loop;
}

}  // namespace hitos
