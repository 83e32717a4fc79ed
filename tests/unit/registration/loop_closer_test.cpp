// SPDX-License-Identifier: GPL-3.0-or-later
#include "loop_closer.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_scan.hpp"
#include "hitos/registration/pose_algebra.hpp"
#include "hitos/registration/registration_params.hpp"

namespace hitos {
namespace {

using test::closed;
using test::drawn_points;

/// A passage about a block, 2 m wide, with bays that are unlike each other.
Walls ring(const std::vector<Point2>& inner) {
    Walls walls =
        closed({{-8, -6}, {-3, -6}, {-3, -6.8}, {-1, -6.8}, {-1, -6},   {8, -6},  {8, 1},
                {8.7, 1}, {8.7, 3}, {8, 3},     {8, 6},     {2, 6},     {2, 6.5}, {0, 6.5},
                {0, 6},   {-8, 6},  {-8, 0},    {-8.5, 0},  {-8.5, -2}, {-8, -2}});
    const Walls block = closed(inner);
    walls.insert(walls.end(), block.begin(), block.end());
    return walls;
}

std::ptrdiff_t count(const std::vector<LoopRecord>& records, LoopVerdict verdict) {
    return std::ranges::count(records, verdict, &LoopRecord::verdict);
}

const std::vector<Point2> kBlock{{-6, -4}, {6, -4}, {6, 4}, {-6, 4}};

/// The way along the middle of the passage from its lower left, in steps of `step` metres.
std::vector<Pose> way(double metres, double step) {
    const std::vector<Pose> legs{
        {-6.5, -5, 0}, {7, -5, kPi / 2}, {7, 5, kPi}, {-7, 5, -kPi / 2}, {-7, -5, 0}};
    std::vector<Pose> poses;
    std::size_t leg = 0;
    Pose pose = legs[0];
    const int count = static_cast<int>(std::ceil(metres / step));
    for (int i = 0; i < count; ++i) {
        poses.push_back(pose);
        pose = compose(pose, {step, 0.0, 0.0});
        const Pose& next = legs[leg % 4 + 1];
        const Pose ahead = between(pose, next);
        if (ahead.x <= 0.0) {
            pose = {next.x, next.y, next.theta};
            ++leg;
        }
    }
    return poses;
}

/// Drives the way, seeing `walls` for 40 m and `later` from there on, while its path drifts to the
/// left; searches at every second key of the second round. After 30 m it is `lost`: moved by that,
/// and as unsure. From 47 m on it bends by `bend` at every key.
class Rounds {
  public:
    Rounds(const Walls& walls, const Walls& later, double loop_score = 0.6, const Pose& lost = {},
           double bend = 0.0, int loops_agree = 3)
        : params_{.loop_score = loop_score, .loops_agree = loops_agree} {
        const double step = 0.5;
        Pose drifted;
        std::size_t k = 0;
        for (const Pose& truth : way(68.0, step)) {
            if (k == 0) drifted = truth;
            if (k > 0) {
                const Pose moved = between(before_, truth);
                const double turn = 0.0004 + (static_cast<double>(k) * step > 47.0 ? bend : 0.0);
                drifted = compose(drifted, {moved.x, moved.y + 0.006, moved.theta + turn});
            }
            before_ = truth;
            KeyScan key;
            const double travelled = static_cast<double>(k) * step;
            key.hold(drawn_points(travelled > 40.0 ? later : walls, truth));
            key.travelled_m = travelled;
            key.variance_m2 = 4e-4;
            key.variance_rad2 = 4e-6;
            if (travelled == 30.0) {
                drifted = compose(lost, drifted);
                key.variance_m2 += lost.x * lost.x + lost.y * lost.y;
                key.variance_rad2 += lost.theta * lost.theta;
            }
            graph_.add({drifted, k}, std::move(key));
            ++k;
            if (travelled < 40.0 || k % 2 == 1) continue;
            ways_.begin(graph_, graph_.size() - 1);
            if (auto found = closer_.search(graph_, ways_, refused)) {
                loop = found;
                truth_at_loop = truth;
                return;
            }
        }
    }

    std::optional<LoopFound> loop;
    std::vector<LoopRecord> refused;
    Pose truth_at_loop;
    Pose newest() const { return graph_.poses.back().pose; }
    const KeyGraph& graph() const { return graph_; }
    const LoopCloser& closer() const { return closer_; }

  private:
    RegistrationParams params_;
    ScanMatcher matcher_{params_.point_sigma_m};
    LoopCloser closer_{params_, matcher_};
    KeyGraph graph_;
    GraphWays ways_;
    Pose before_;
};

TEST(LoopCloser, FindsTheEarlierPassageWhenSeveralSearchesAgree) {
    const Walls walls = ring(kBlock);
    const Rounds rounds(walls, walls);
    ASSERT_TRUE(rounds.loop);
    const Pose drift = between(rounds.truth_at_loop, rounds.newest());
    EXPECT_GT(std::hypot(drift.x, drift.y), 0.2) << "else there is nothing to close";
    // The earlier passage has hardly drifted.
    EXPECT_NEAR(rounds.loop->pose.x, rounds.truth_at_loop.x, 0.1);
    EXPECT_NEAR(rounds.loop->pose.y, rounds.truth_at_loop.y, 0.1);
    EXPECT_NEAR(rounds.loop->pose.theta, rounds.truth_at_loop.theta, 0.02);
    EXPECT_GE(rounds.closer().searches(), 3U);
    const LoopRecord& record = rounds.loop->record;
    EXPECT_EQ(record.verdict, LoopVerdict::closed);
    EXPECT_EQ(record.scan, rounds.graph().poses.back().scan);
    EXPECT_EQ(record.earlier, rounds.graph().poses[rounds.loop->key].scan);
    EXPECT_GT(record.score, 0.7);
    EXPECT_GT(record.overlap, 0.8);
    EXPECT_LE(record.overlap, 1.0);
    EXPECT_LT(*record.seen_through, 0.1);
    // The two before it said the same, and waited for a third.
    EXPECT_EQ(count(rounds.refused, LoopVerdict::alone), 2);
    EXPECT_EQ(rounds.refused.size(), 2U);
    EXPECT_LT(rounds.graph().scans[rounds.loop->key].travelled_m, 16.0);
    for (const std::uint32_t source : rounds.loop->sources) {
        EXPECT_LT(rounds.graph().scans[source].travelled_m, 21.0);
    }
}

TEST(LoopCloser, APlaceThatLooksAlikeButIsOpenIsNone) {
    // The second time the block is narrower by a metre on every side: the outer walls fit, and the
    // score asked for is so low that they suffice.
    const Rounds rounds(ring(kBlock), ring({{-5, -3}, {5, -3}, {5, 3}, {-5, 3}}), 0.3);
    EXPECT_FALSE(rounds.loop);
    EXPECT_GE(count(rounds.refused, LoopVerdict::seen_through), 3);
    for (const LoopRecord& refused : rounds.refused) {
        EXPECT_EQ(refused.seen_through.value_or(0.0) > 0.3,
                  refused.verdict == LoopVerdict::seen_through);
        EXPECT_EQ(refused.score > 0.5, refused.verdict != LoopVerdict::poor_fit);
    }
}

TEST(LoopCloser, FindsAPassageThatNoWindowHolds) {
    const Walls walls = ring(kBlock);
    const Rounds rounds(walls, walls, 0.6, {21.0, -14.0, 0.35});
    ASSERT_TRUE(rounds.loop);
    const Pose off{rounds.newest().x - rounds.truth_at_loop.x,
                   rounds.newest().y - rounds.truth_at_loop.y, 0.0};
    EXPECT_GT(std::hypot(off.x, off.y), 18.0);
    EXPECT_NEAR(rounds.loop->pose.x, rounds.truth_at_loop.x, 0.15);
    EXPECT_NEAR(rounds.loop->pose.y, rounds.truth_at_loop.y, 0.15);
    EXPECT_NEAR(wrap_angle(rounds.loop->pose.theta - rounds.truth_at_loop.theta), 0.0, 0.02);
}

TEST(LoopCloser, FarOffAPlaceThatLooksAlikeButIsOpenIsNoneEither) {
    const Rounds rounds(ring(kBlock), ring({{-5, -3}, {5, -3}, {5, 3}, {-5, 3}}), 0.3,
                        {21.0, -14.0, 0.35});
    EXPECT_FALSE(rounds.loop);
    EXPECT_GE(count(rounds.refused, LoopVerdict::seen_through), 3);
}

TEST(LoopCloser, NothingIsALoopBeforeTheRobotHasGoneSomewhere) {
    const Walls room = test::recess_room();
    KeyGraph graph;
    GraphWays ways;
    RegistrationParams params;
    LoopCloser closer(params, ScanMatcher(params.point_sigma_m));
    std::vector<LoopRecord> refused;
    for (int k = 0; k < 20; ++k) {
        KeyScan key;
        const Pose pose{0.05 * k, 0.0, 0.0};
        key.hold(drawn_points(room, pose));
        key.travelled_m = 0.05 * k;
        graph.add({pose, static_cast<std::uint64_t>(k)}, std::move(key));
        ways.begin(graph, graph.size() - 1);
        EXPECT_FALSE(closer.search(graph, ways, refused));
    }
    EXPECT_EQ(closer.searches(), 0U);
    EXPECT_TRUE(refused.empty());
}

/// Where the graph gets unsure of what is far behind, far stretches are looked at as soon as if
/// nobody had been sure before: of one way out and back who looks at every key and who begins at
/// the last ones look alike then.
TEST(LoopCloser, WhoWasSureOfAllLooksAgainWhenTheGraphIsNot) {
    const Walls room = test::recess_room();
    const RegistrationParams params;
    const ScanMatcher matcher(params.point_sigma_m);
    for (const double turn_rad : {0.05, 0.2, 0.6}) {
        KeyGraph graph;
        GraphWays ways;
        LoopCloser always(params, matcher);
        std::uint64_t since = 0;  // looks of who always looks
        std::uint64_t anew = 0;   // of who begins at every key
        for (std::uint64_t k = 0; k < 160; ++k) {
            const double way = 0.5 * static_cast<double>(k);
            KeyScan key;
            key.hold(drawn_points(room, {0.1 * static_cast<double>(k % 10), 0.0, 0.0}));
            key.travelled_m = way;
            key.variance_m2 = 1e-6;
            key.variance_rad2 = k == 100 ? turn_rad * turn_rad : 1e-8;
            const double along = way < 40.0 ? way : 80.0 - way;
            graph.add({{along, way < 40.0 ? 0.0 : 18.5, 0.0}, k}, std::move(key));
            std::vector<LoopRecord> refused;
            LoopCloser begins(params, matcher);
            for (LoopCloser* closer : {&always, &begins}) {
                ways.begin(graph, k);
                closer->search(graph, ways, refused);
            }
            anew += begins.searches();
            since = always.searches();
            ASSERT_EQ(since, anew) << turn_rad << ", key " << k;
        }
        EXPECT_EQ(since > 0, turn_rad > 0.1) << turn_rad;
    }
}

/// Drives the x axis twice, 20 m and 10 m, and searches at every second key of the second time: how
/// often that finds the first passage, and how often it is refused as bare.
std::pair<int, std::ptrdiff_t> found_and_bare(const Walls& walls) {
    KeyGraph graph;
    GraphWays ways;
    const RegistrationParams params;
    LoopCloser closer(params, ScanMatcher(params.point_sigma_m));
    std::mt19937 engine(3);
    int found = 0;
    std::vector<LoopRecord> refused;
    for (std::uint64_t k = 0; k < 60; ++k) {
        const double along = 0.5 * static_cast<double>(k < 40 ? k : k - 40);
        KeyScan key;
        std::vector<SurfacePoint> points;
        find_surface_points(test::drawn_scan(walls, {along, 0.0, 0.0}, 0.01, &engine, 8.0), 80.0,
                            points);
        key.hold(points);
        key.travelled_m = 0.5 * static_cast<double>(k);
        key.variance_m2 = 4e-4;
        key.variance_rad2 = 4e-6;
        graph.add({{along, 0.0, 0.0}, k}, std::move(key));
        if (k < 40 || k % 2 == 1) continue;
        ways.begin(graph, graph.size() - 1);
        if (closer.search(graph, ways, refused)) ++found;
    }
    return {found, count(refused, LoopVerdict::bare)};
}

TEST(LoopCloser, APassageOfACorridorFitsAnywhereAlongItAndIsNone) {
    Walls corridor{{{-200.0, -1.0}, {200.0, -1.0}}, {{-200.0, 1.0}, {200.0, 1.0}}};
    const auto [found, bare] = found_and_bare(corridor);
    EXPECT_EQ(found, 0);
    EXPECT_GE(bare, 5);
    // With a bay every few metres there is something to hold on to.
    for (int i = -2; i < 12; ++i) {
        const Walls bay = closed({{3.0 * i, 1.0}, {3.0 * i + 0.8, 1.0}, {3.0 * i, 0.5}});
        corridor.insert(corridor.end(), bay.begin(), bay.end());
    }
    EXPECT_GE(found_and_bare(corridor).first, 1);
}

TEST(LoopCloser, SearchesThatDifferInHeadingDoNotAgree) {
    // The second round's path turns by more between two searches than a path may.
    const Walls walls = ring(kBlock);
    const Rounds bent(walls, walls, 0.35, {0.0, 0.0, 0.1}, 0.02, 2);
    EXPECT_FALSE(bent.loop);
    const Rounds straight(walls, walls, 0.35, {0.0, 0.0, 0.1}, 0.0, 2);
    EXPECT_TRUE(straight.loop);
}

}  // namespace
}  // namespace hitos
