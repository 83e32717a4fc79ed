// SPDX-License-Identifier: GPL-3.0-or-later
// Where a robot that was carried is, among all that it has seen before.
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "free_view.hpp"
#include "loop_closer.hpp"
#include "loop_limits.hpp"

namespace hitos {
namespace {

constexpr double kSaidHeading = 0.53;  // [rad], 30 degrees, from what somebody says

double likeness(const LoopFound& loop) {
    return likeness(loop.record);
}

/// The keys before a piece that are nearest to a place, of whatever passage, the nearest first:
/// what a stretch of one passage has not seen there, another one may have.
std::vector<std::uint32_t> keys_about(const KeyGraph& graph, const CarriedPiece& piece,
                                      const Pose& at) {
    constexpr double kAbout = 6.0;  // [m]
    constexpr std::size_t kMostAbout = 30;
    std::vector<std::pair<double, std::uint32_t>> near;
    for (std::uint32_t j = 0; j < piece.first; ++j) {
        const double distance = distance_m(graph.poses[j].pose, at);
        if (distance < kAbout) near.emplace_back(distance, j);
    }
    std::ranges::sort(near);
    std::vector<std::uint32_t> keys;
    for (std::size_t i = 0; i < std::min(kMostAbout, near.size()); ++i)
        keys.push_back(near[i].second);
    return keys;
}

}  // namespace

const LoopCloser::Before& LoopCloser::all_before(const KeyGraph& graph, const CarriedPiece& piece) {
    constexpr double kMargin = 20.0;     // [m] about the keys, what they see of walls
    constexpr double kGreatest = 200.0;  // [m] either way: 16 million cells a picture
    constexpr int kLevels = 4;
    if (before_ && before_->piece == piece.first) return *before_;
    std::vector<std::uint32_t> keys;
    std::vector<Point2> positions;
    Bounds bounds;
    for (std::uint32_t j = 0; j < piece.first; ++j) {
        keys.push_back(j);
        positions.push_back({graph.poses[j].pose.x, graph.poses[j].pose.y});
        bounds.hold(positions.back());
    }
    const Pose centre{0.5 * (bounds.low.x + bounds.high.x), 0.5 * (bounds.low.y + bounds.high.y),
                      0.0};
    const double half_m = std::min(
        kGreatest,
        kMargin + 0.5 * std::max(bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y));
    std::erase_if(positions, [&](const Point2& at) {
        return std::max(std::abs(at.x - centre.x), std::abs(at.y - centre.y)) > half_m;
    });
    PointMap map;
    build_map(graph, keys, centre, half_m, map);
    CorrelationMap picture(map, half_m, kLevels);
    SquareLattice squares(picture);
    before_ = std::make_shared<const Before>(
        Before{piece.first, std::move(positions), std::move(picture), std::move(squares)});
    return *before_;
}

bool LoopCloser::same_place(const Pose& a, const Pose& b) {
    return distance_m(a, b) < kAboutFound.position_m &&
           std::abs(wrap_angle(a.theta - b.theta)) < kAboutFound.heading_rad;
}

std::optional<LoopCloser::Place> LoopCloser::place_about(const KeyGraph& graph,
                                                         const CarriedPiece& piece,
                                                         const Pose& at) {
    std::vector<std::uint32_t> keys = keys_about(graph, piece, at);
    if (keys.empty()) return std::nullopt;
    return Place{keys.front(), at, kAboutFound, true, kMostPieceThrough, std::move(keys)};
}

/// The one place before the piece that looks like where the newest key is now.
std::optional<LoopFound> LoopCloser::single_place(const KeyGraph& graph, const CarriedPiece& piece,
                                                  std::vector<LoopRecord>& refused) {
    constexpr double kNearlyAsLike = 0.7;  // of places alike one may lie a little better
    constexpr std::size_t kMostKeys = 40;
    constexpr std::size_t kFewPoints = 100;
    const std::size_t newest = graph.size() - 1;
    const Before& before = all_before(graph, piece);
    std::vector<SurfacePoint> wide;
    gather(graph, newest, {kStretch, kMostKeys, piece.query}, wide);
    std::vector<LoopFound> like;
    std::vector<LoopRecord> unlike;
    // For places that are worth a look a few of them are enough, and much quicker.
    std::vector<SurfacePoint> few;
    const std::size_t every = wide.size() / kFewPoints + 1;
    for (std::size_t i = 0; i < wide.size(); i += every) few.push_back(wide[i]);
    std::optional<Pose> said;
    std::vector<Point2> about;
    if (piece.start) {
        said =
            compose(*piece.start, between(graph.poses[piece.first].pose, graph.poses[newest].pose));
        about.push_back({said->x, said->y});
    }
    BestPlaces best =
        best_places(few, before.picture, before.squares, said ? about : before.positions,
                    {.least_score = params_.loop_score});
    std::erase_if(best.places, [&said](const Correlation& place) {
        return said && std::abs(wrap_angle(place.pose.theta - said->theta)) > kSaidHeading;
    });
    for (const Correlation& place : best.places) {
        auto loop = look(graph, place_about(graph, piece, place.pose), unlike);
        if (loop && std::ranges::none_of(like, [&](const LoopFound& other) {
                return same_place(other.pose, loop->pose);  // from another start
            })) {
            like.push_back(std::move(*loop));
        }
    }
    std::ranges::stable_sort(like, std::greater<>(),
                             [](const LoopFound& loop) { return likeness(loop); });
    if (like.empty()) {
        if (!unlike.empty()) refused.push_back(unlike.front());
        return std::nullopt;
    }
    const bool single = like.size() == 1 || likeness(like[1]) < kNearlyAsLike * likeness(like[0]);
    if (single && best.all) return like[0];
    like[0].record.verdict = LoopVerdict::ambiguous;
    refused.push_back(like[0].record);
    sought_.push_back({{}, graph.scans[newest].travelled_m, true, false, piece.first});
    return std::nullopt;
}

/// Where the last find says that the newest key is.
std::optional<LoopFound> LoopCloser::followed_piece(const KeyGraph& graph,
                                                    const CarriedPiece& piece,
                                                    std::vector<LoopRecord>& refused) {
    const auto last = std::ranges::find_if(sought_.rbegin(), sought_.rend(), &Found::single);
    if (last == sought_.rend() || last->piece != piece.first ||
        graph.scans.back().travelled_m - last->travelled_m >= kMemory) {
        return std::nullopt;
    }
    const Pose there = compose(last->move, graph.poses.back().pose);
    return look(graph, place_about(graph, piece, there), refused);
}

/// Whether finds enough say so: where places look alike, of which finds that say otherwise tell,
/// the robot must be followed the further. Returns the greatest likeness of those that say so: it
/// may have turned to what nobody has seen since.
std::optional<double> LoopCloser::agreed_on_piece(const KeyGraph& graph, const LoopFound& loop,
                                                  std::size_t piece, bool said) {
    constexpr double kRemembered = 100.0;  // [m] of travel
    constexpr double kEachOther = 0.5;     // [m] further for each find that says otherwise
    const Pose& now = graph.poses.back().pose;
    const double travelled_m = graph.scans.back().travelled_m;
    while (!sought_.empty() && travelled_m - sought_.front().travelled_m > kRemembered) {
        sought_.pop_front();
    }
    int agreeing = 1;
    int others = 0;
    double span = 0.0;
    double most_like = likeness(loop);
    for (const Found& found : sought_) {
        if (found.piece != piece) continue;
        if (!found.single || !says(found, now, loop.pose, travelled_m)) {
            ++others;
            continue;
        }
        ++agreeing;
        span = std::max(span, travelled_m - found.travelled_m);
        most_like = std::max(most_like, found.likeness);
    }
    sought_.push_back(
        {compose(loop.pose, inverse(now)), travelled_m, true, true, piece, likeness(loop)});
    // Where somebody has said where it is, as many finds as for any loop.
    const double least_span = said ? kSpan : kFarSpan;
    const int least = params_.loops_agree + (said ? 0 : kMoreOfFar);
    const bool enough =
        agreeing >= least && agreeing > others && span > least_span + kEachOther * others;
    return enough ? std::optional(most_like) : std::nullopt;
}

/// Were the newest key at `pose`: the greater of the shares that its piece and what was before it
/// look through of what the other saw.
double LoopCloser::piece_seen_through(const KeyGraph& graph, const CarriedPiece& piece,
                                      const Pose& pose) {
    constexpr std::size_t kMostKeys = 100;  // of either side
    constexpr std::size_t kEveryPoint = 4;
    constexpr double kNear = 8.0;  // [m]; of what lies elsewhere nobody says anything
    struct Side {
        std::vector<KeyPose> keys;  // by key number, as they would lie
        std::vector<FreeView> views;
        std::vector<Point2> points;
    };
    Side since;
    Side before;
    const Pose move = compose(pose, inverse(graph.poses.back().pose));
    const std::size_t step = (graph.size() - piece.query) / kMostKeys + 1;
    for (std::size_t j = piece.query; j < graph.size(); j += step) {
        since.keys.push_back({compose(move, graph.poses[j].pose), j});
    }
    for (std::size_t j = 0; j < piece.first; ++j) {
        const Pose& at = graph.poses[j].pose;
        const bool near = std::ranges::any_of(
            since.keys, [&](const KeyPose& key) { return distance_m(key.pose, at) < kNear; });
        if (near) before.keys.push_back({at, j});
    }
    for (Side* side : {&since, &before}) {
        const std::size_t every = side->keys.size() / kMostKeys + 1;
        for (std::size_t i = 0; i < side->keys.size(); i += every) {
            const KeyPose& key = side->keys[i];
            const std::span<const SurfacePoint> points = graph.scans[key.scan].points();
            side->views.emplace_back(points, key.pose);
            for (std::size_t k = 0; k < points.size(); k += kEveryPoint) {
                place(points.subspan(k, 1), key.pose, side->points);
            }
        }
    }
    return std::max(contradiction(since.points, before.views),
                    contradiction(before.points, since.views));
}

std::optional<LoopFound> LoopCloser::search_piece(const KeyGraph& graph, const CarriedPiece& piece,
                                                  std::vector<LoopRecord>& refused) {
    // [m] of way between two looks at everything: a tenth of the way since the break, and the more
    // the more often nothing was found, in this piece or others: outdoors breaks are told where
    // nobody carried the robot.
    constexpr double kEvery = 1.0;
    constexpr double kSeldomest = 5.0;
    constexpr double kIdle = 0.2;
    const double way_m = graph.scans.back().travelled_m;
    const auto refuse = [&](LoopRecord& record, LoopVerdict verdict) {
        record.verdict = verdict;
        refused.push_back(record);
    };
    query_keys_ = gather(graph, graph.size() - 1, {kStretch, kQueryKeys, piece.query}, query_);
    if (query_.size() < kFewestPoints) return std::nullopt;
    std::optional<LoopFound> loop = followed_piece(graph, piece, refused);
    bool single = false;
    if (!loop) {
        const double wait_m = std::max(
            std::clamp(0.1 * (way_m - piece.broken_m), kEvery, kSeldomest), kIdle * idle_looks_);
        if (way_m - looked_everywhere_m_ < wait_m) return std::nullopt;
        looked_everywhere_m_ = way_m;
        loop = single_place(graph, piece, refused);
        idle_looks_ = loop ? 0 : idle_looks_ + 1;
        single = true;
    }
    if (!loop) return std::nullopt;
    const std::optional<double> most_like =
        agreed_on_piece(graph, *loop, piece.first, piece.start.has_value());
    if (!most_like) {
        refuse(loop->record, LoopVerdict::alone);
        return std::nullopt;
    }
    if (!single) {  // with all that was gathered by now, is it still the one place?
        if (way_m - looked_everywhere_m_ < kEvery) return std::nullopt;
        looked_everywhere_m_ = way_m;
        const std::optional<LoopFound> still = single_place(graph, piece, refused);
        if (!still || !same_place(still->pose, loop->pose)) return std::nullopt;
    }
    if (*most_like <= kLeastLikeness) {
        refuse(loop->record, LoopVerdict::unlike);
        return std::nullopt;
    }
    loop->record.seen_through =
        std::max(*loop->record.seen_through, piece_seen_through(graph, piece, loop->pose));
    if (*loop->record.seen_through > kMostPieceThrough) {
        refuse(loop->record, LoopVerdict::unlike);
        return std::nullopt;
    }
    return loop;
}

}  // namespace hitos
