// SPDX-License-Identifier: GPL-3.0-or-later
#include "loop_closer.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "free_view.hpp"
#include "loop_limits.hpp"

namespace hitos {
namespace {

constexpr double kLeastWay = 15.0;        // [m] driven since; nearer is no loop
constexpr double kGreatestWindow = 15.0;  // [m]
constexpr double kGreatestTurn = 0.6;     // [rad]
constexpr double kStretchHalf = 40.0;     // [m], of the stretch's map
constexpr double kNearOutside = 3.0;      // [m] that a candidate may lie beyond the window

/// Three standard deviations and a little.
double unsure_m(const GraphReach& reach) {
    return 0.5 + 3.0 * std::sqrt(reach.variance_m2);
}

double window_m(const GraphReach& reach) {
    return std::min(kGreatestWindow, unsure_m(reach));
}

double window_rad(const GraphReach& reach) {
    return std::min(kGreatestTurn, 0.06 + 3.0 * std::sqrt(reach.variance_rad2));
}

bool long_ago(const KeyGraph& graph, std::size_t key) {
    return graph.scans.back().travelled_m - graph.scans[key].travelled_m >= kLeastWay;
}

/// Whether a key lies far enough back to be another passage; where no way leads to it, nobody
/// knows.
bool passed(const GraphReach& reach) {
    return reach.way_m >= kLeastWay && reach.way_m < GraphReach::kNever;
}

}  // namespace

std::optional<LoopCloser::Place> LoopCloser::likeliest(const KeyGraph& graph, GraphWays& ways) {
    const std::size_t newest = graph.size() - 1;
    constexpr double kWidest = kGreatestWindow + kNearOutside + 1e-6;
    const Pose& now = graph.poses[newest].pose;
    std::optional<Place> best;
    double best_cost = GraphReach::kNever;
    for (const std::uint32_t j : graph.awake()) {
        const Pose& then = graph.poses[j].pose;
        if (!long_ago(graph, j) || !is_within(then, now, kWidest)) continue;
        const GraphReach& reach = ways.to(j);
        if (!passed(reach)) continue;
        const double window = window_m(reach) + kNearOutside;
        const double distance = distance_m(then, now);
        if (distance > window) continue;
        const double cost = distance / window + 0.02 * std::sqrt(reach.variance_m2);
        if (cost < best_cost) {
            best_cost = cost;
            best = {j, now, {window_m(reach), window_rad(reach)}, false};
        }
    }
    return best;
}

/// Where the last find far off says that the newest key is.
std::optional<LoopCloser::Place> LoopCloser::followed(const KeyGraph& graph,
                                                      GraphWays& ways) const {
    if (found_.empty() || !found_.back().far ||
        graph.scans.back().travelled_m - found_.back().travelled_m >= kMemory) {
        return std::nullopt;
    }
    const Pose there = compose(found_.back().move, graph.poses.back().pose);
    std::optional<Place> best;
    double nearest = kStretch;
    for (const std::uint32_t j : graph.awake()) {
        const Pose& then = graph.poses[j].pose;
        if (!long_ago(graph, j) || !is_within(then, there, nearest)) continue;
        if (!passed(ways.to(j))) continue;
        nearest = distance_m(then, there);
        best = {j, there, kAboutFound, true};
    }
    return best;
}

/// Whether no key can be less sure than a window holds. To any one leads the way back to where all
/// were looked at and on from there, on which a heading counts at a distance greater by no more
/// than the way since; a root of sums of squares, so that Minkowski's inequality bounds it. Since
/// nothing leads over who has come to rest meanwhile, all are looked at again soon.
bool LoopCloser::sure_of_all(const KeyGraph& graph) const {
    constexpr std::size_t kSoon = 100;  // keys
    const std::size_t newest = graph.size() - 1;
    if (!sureness_ || newest - sureness_->key > kSoon) return false;
    if (sureness_->part_begin != graph.part_begin(newest)) return false;
    const double way_m = graph.scans[newest].travelled_m - graph.scans[sureness_->key].travelled_m;
    GraphReach bound{way_m, 0.0, 0.0};
    for (std::size_t key = sureness_->key + 1; key <= newest; ++key) {  // the way back
        const KeyScan& step = graph.scans[key];
        bound.variance_m2 += step.variance_m2 + step.variance_rad2 * way_m * way_m;
    }
    const double on_m =
        std::sqrt(sureness_->variance_m2) + way_m * std::sqrt(sureness_->variance_rad2);
    bound.variance_m2 += on_m * on_m;
    return unsure_m(bound) <= kGreatestWindow;
}

/// Of the stretches that the newest key may be on and no window would hold the one that was looked
/// at longest ago, of several the nearest.
std::optional<LoopCloser::Place> LoopCloser::far_off(const KeyGraph& graph, GraphWays& ways) {
    constexpr double kAbout = 8.0;  // [m], of the window: half the width of what the query sees
    if (sure_of_all(graph)) return std::nullopt;
    Sureness sureness{graph.size() - 1, graph.part_begin(graph.size() - 1)};
    const Pose& now = graph.poses.back().pose;
    const auto stretch = [&](std::size_t key) {
        return static_cast<std::int64_t>(graph.scans[key].travelled_m / kStretch);
    };
    std::optional<Place> best;
    std::uint64_t longest_ago = ~std::uint64_t{0};
    double best_cost = 0.0;
    for (const std::uint32_t j : graph.awake()) {
        const GraphReach& reach = ways.to(j);
        if (reach.way_m < GraphReach::kNever) {
            sureness.variance_m2 = std::max(sureness.variance_m2, reach.variance_m2);
            sureness.variance_rad2 = std::max(sureness.variance_rad2, reach.variance_rad2);
        }
        const double unsure = unsure_m(reach);
        if (unsure <= kGreatestWindow || !long_ago(graph, j) || !passed(reach)) continue;
        const Pose& then = graph.poses[j].pose;
        const double cost = distance_m(then, now) / (unsure + kNearOutside);
        const auto looked = looked_at_.find(stretch(j));
        const std::uint64_t last = looked == looked_at_.end() ? 0 : looked->second;
        if (cost > 1.0 || last > longest_ago || (last == longest_ago && cost >= best_cost)) {
            continue;
        }
        longest_ago = last;
        best_cost = cost;
        best = {j, {then.x, then.y, now.theta}, {kAbout, window_rad(reach)}, true};
    }
    sureness_ = sureness;
    if (best) looked_at_[stretch(best->key)] = ++far_looks_;
    return best;
}

/// The points of the last metres up to a key, in its frame; returns of how many keys they are.
std::size_t LoopCloser::gather(const KeyGraph& graph, std::size_t newest, const Query& how,
                               std::vector<SurfacePoint>& points) {
    constexpr double kFar = 20.0;   // [m]
    constexpr double kThin = 0.35;  // [m], side of the cells that keep one point each
    const Pose& now = graph.poses[newest].pose;
    points.clear();
    std::size_t keys = 0;
    std::unordered_set<std::int64_t> taken;  // asked only whether it holds a cell
    const std::size_t most = std::min(how.most_keys, newest + 1 - how.first_key);
    for (std::size_t n = 0; n < most; ++n) {
        const std::size_t j = newest - n;
        if (graph.scans[newest].travelled_m - graph.scans[j].travelled_m >= how.way_m) break;
        ++keys;
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
            points.push_back({static_cast<float>(at.x), static_cast<float>(at.y),
                              static_cast<float>(c * nx - s * ny),
                              static_cast<float>(s * nx + c * ny)});
        }
    }
    return keys;
}

void LoopCloser::gather_query(const KeyGraph& graph, std::size_t newest) {
    query_keys_ = gather(graph, newest, {kStretch, kQueryKeys, graph.part_begin(newest)}, query_);
}

/// Whether a former find says the same of where the newest key is.
bool LoopCloser::says(const Found& found, const Pose& now, const Pose& then, double travelled_m) {
    const Pose said = compose(found.move, now);
    // What the odometry may have erred by in between.
    return distance_m(said, then) < 0.4 + 0.01 * (travelled_m - found.travelled_m) &&
           std::abs(wrap_angle(said.theta - then.theta)) < 0.06;
}

bool LoopCloser::agreed(const Pose& now, const Pose& then, double travelled_m, bool far) {
    constexpr std::size_t kMostKept = 12;
    int agreeing = 1;
    double span = 0.0;
    for (const Found& found : found_) {
        const double ago = travelled_m - found.travelled_m;
        if (ago >= kMemory) continue;
        if (!says(found, now, then, travelled_m)) continue;
        ++agreeing;
        span = std::max(span, ago);
    }
    found_.push_back({compose(then, inverse(now)), travelled_m, far});
    if (found_.size() > kMostKept) found_.pop_front();
    if (far) return agreeing >= params_.loops_agree + kMoreOfFar && span > kFarSpan;
    return agreeing >= params_.loops_agree && (params_.loops_agree == 1 || span > kSpan);
}

/// Places that look alike in what there is differ in what there is not: one passage looks through
/// where the other saw a wall. True loops have up to 0.24 of it (doors, people), false ones 0.4;
/// outdoors true ones may have more, and are found a few metres on.
double LoopCloser::seen_through(const KeyGraph& graph, std::size_t newest, const LoopFound& loop,
                                const PointMap& map) const {
    constexpr std::size_t kEveryOldKey = 3;
    constexpr std::size_t kEveryNewKey = 2;
    constexpr std::size_t kEveryPoint = 8;
    std::vector<FreeView> views;
    for (std::size_t i = 0; i < loop.sources.size(); i += kEveryOldKey) {
        const std::uint32_t j = loop.sources[i];
        views.emplace_back(graph.scans[j].points(), graph.poses[j].pose);
    }
    std::vector<Point2> points;
    place(query_, loop.pose, points);
    const double by_earlier = contradiction(points, views);
    if (by_earlier > kMostSeenThrough) return by_earlier;

    views.clear();
    const Pose move = compose(loop.pose, inverse(graph.poses[newest].pose));
    for (std::size_t n = 0; n < query_keys_; n += kEveryNewKey) {
        views.emplace_back(graph.scans[newest - n].points(),
                           compose(move, graph.poses[newest - n].pose));
    }
    points.clear();
    for (std::size_t i = 0; i < map.size(); i += kEveryPoint) {
        const MapPoint& p = map.point(i);
        points.push_back(
            {map.centre().x + static_cast<double>(p.x), map.centre().y + static_cast<double>(p.y)});
    }
    return std::max(by_earlier, contradiction(points, views));
}

/// The keys of the stretch about a key.
std::vector<std::uint32_t> LoopCloser::stretch_about(const KeyGraph& graph, std::uint32_t key) {
    constexpr std::size_t kMostBefore = 15;
    constexpr std::size_t kMostKeys = 30;
    const double way_m = graph.scans[key].travelled_m;
    const std::size_t begin = graph.part_begin(key);
    std::vector<std::uint32_t> keys;
    for (std::size_t j = key + 1; j-- > begin && keys.size() < kMostBefore;) {
        if (way_m - graph.scans[j].travelled_m >= kStretch) break;
        keys.push_back(static_cast<std::uint32_t>(j));
    }
    for (std::size_t j = key + 1; j + 1 < graph.size() && keys.size() < kMostKeys; ++j) {
        if (graph.scans[j].travelled_m - way_m >= kStretch || graph.part_begin(j) != begin) break;
        keys.push_back(static_cast<std::uint32_t>(j));
    }
    return keys;
}

void LoopCloser::measure(const KeyGraph& graph, std::size_t newest, const LoopFound& loop,
                         const PointMap& map, LoopRecord& record) const {
    const Linearization l = matcher_.linearize(query_, map, loop.pose, kFineStage);
    const auto points = static_cast<double>(std::max<std::size_t>(1, query_.size()));
    record.score = match_score(query_, map, loop.pose, 1);
    record.overlap = static_cast<double>(l.matches) / points;
    record.seen_through = seen_through(graph, newest, loop, map);
}

void LoopCloser::measure(const KeyGraph& graph, std::uint32_t key, std::uint32_t earlier,
                         LoopRecord& record) {
    gather_query(graph, key);
    LoopFound loop{compose(graph.poses[earlier].pose, record.pose_earlier_scan),
                   earlier,
                   stretch_about(graph, earlier),
                   {}};
    PointMap map;
    build_map(graph, loop.sources, graph.poses[earlier].pose, kStretchHalf, map);
    measure(graph, key, loop, map, record);
}

void LoopCloser::fit(const KeyGraph& graph, std::uint32_t key, std::uint32_t earlier,
                     LoopRecord& record) {
    constexpr SearchWindow kNear{1.0, 0.2};  // as near as an eye lays them
    constexpr double kLeast = 0.2;
    gather_query(graph, key);
    const Pose& from = graph.poses[earlier].pose;
    LoopFound loop{
        compose(from, record.pose_earlier_scan), earlier, stretch_about(graph, earlier), {}};
    PointMap map;
    build_map(graph, loop.sources, from, kStretchHalf, map);
    const CorrelationMap picture(map, 25.0 + 0.5 * kNear.position_m, 4);
    if (const auto found = correlate(query_, picture, loop.pose, kNear, kLeast))
        loop.pose = found->pose;
    const PosePrior hardly_any{loop.pose, 1e-3 * Eigen::Matrix3d::Identity()};
    loop.pose = matcher_.fit(query_, map, loop.pose, hardly_any, 25);
    record.pose_earlier_scan = between(from, loop.pose);
    measure(graph, key, loop, map, record);
}

LoopRecord LoopCloser::record_of(const KeyGraph& graph, const LoopFound& loop) {
    LoopRecord record;
    const KeyPose& earlier = graph.poses[loop.key];
    record.scan = graph.poses.back().scan;
    record.earlier = earlier.scan;
    record.pose_earlier_scan = between(earlier.pose, loop.pose);
    record.way_m = graph.scans.back().travelled_m - graph.scans[loop.key].travelled_m;
    return record;
}

std::optional<LoopFound> LoopCloser::look(const KeyGraph& graph, const std::optional<Place>& at,
                                          std::vector<LoopRecord>& refused) {
    if (!at) return std::nullopt;
    if (query_.empty()) gather_query(graph, graph.size() - 1);
    if (query_.size() < kFewestPoints) return std::nullopt;
    ++searches_;
    const Place& place = *at;
    LoopFound loop;
    loop.key = place.key;
    loop.sources = place.sources.empty() ? stretch_about(graph, place.key) : place.sources;
    PointMap map;
    build_map(graph, loop.sources, graph.poses[place.key].pose, kStretchHalf, map);
    const CorrelationMap picture(map, 25.0 + 0.5 * place.window.position_m, 4);
    const auto correlated =
        correlate(query_, picture, place.centre, place.window, params_.loop_score);
    if (!correlated) return std::nullopt;

    const PosePrior hardly_any{correlated->pose, 1e-3 * Eigen::Matrix3d::Identity()};
    loop.pose = matcher_.fit(query_, map, correlated->pose, hardly_any, 25);
    const Linearization l = matcher_.linearize(query_, map, loop.pose, kFineStage);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> spread(l.h.topLeftCorner<2, 2>());
    LoopRecord& record = loop.record;
    record = record_of(graph, loop);
    record.score = match_score(query_, map, loop.pose, 1);
    record.overlap = static_cast<double>(l.matches) / static_cast<double>(query_.size());
    if (record.score <= kLeastLoopScore) {
        record.verdict = LoopVerdict::poor_fit;
    } else if (spread.eigenvalues()(0) <= kLeastLoopSpread * std::max(1, l.matches)) {
        record.verdict = LoopVerdict::bare;
    } else {
        record.seen_through = seen_through(graph, graph.size() - 1, loop, map);
        if (record.seen_through <= place.most_seen_through) return loop;
        record.verdict = LoopVerdict::seen_through;
    }
    refused.push_back(record);
    return std::nullopt;
}

std::optional<LoopFound> LoopCloser::search(const KeyGraph& graph, GraphWays& ways,
                                            std::vector<LoopRecord>& refused) {
    query_.clear();
    std::optional<Place> place = followed(graph, ways);
    std::optional<LoopFound> loop = look(graph, place, refused);
    if (!loop) loop = look(graph, place = likeliest(graph, ways), refused);
    if (!loop) loop = look(graph, place = far_off(graph, ways), refused);
    if (!loop ||
        agreed(graph.poses.back().pose, loop->pose, graph.scans.back().travelled_m, place->far)) {
        return loop;
    }
    loop->record.verdict = LoopVerdict::alone;
    refused.push_back(loop->record);
    return std::nullopt;
}

}  // namespace hitos
