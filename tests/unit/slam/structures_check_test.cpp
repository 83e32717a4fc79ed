// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the checks of trees, maps and graphs see what is broken, and nothing where nothing is.

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "fastslam/filtro_particulas.hpp"
#include "fastslam/map_check.hpp"
#include "graph_tour.hpp"
#include "hitos/base/validate.hpp"
#include "room_tour.hpp"

namespace hitos {
namespace {

constexpr double kNot = std::numeric_limits<double>::quiet_NaN();

template <class Check>
void expect_broken(const Check& check, const std::string& what) {
    try {
        check();
        ADD_FAILURE() << "nothing was seen of: " << what;
    } catch (const std::logic_error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr(what));
    }
}

/// Two particles that begin as one.
struct SmallTree {
    PoseHistory history;
    std::vector<PoseHistory::Node> leaves;

    SmallTree() {
        const PoseHistory::Node root = history.append(PoseHistory::kNone, {});
        history.share(root);
        for (int i = 0; i < 2; ++i) leaves.push_back(history.append(root, {1.0, 0.0, 0.0}));
    }
};

TEST(StructuresCheck, SeesBrokenHistories) {
    const auto expect = [](const std::function<void(SmallTree&)>& breaks, const std::string& what,
                           std::size_t scans = 2) {
        SmallTree tree;
        breaks(tree);
        expect_broken([&] { tree.history.check(tree.leaves, scans); }, what);
    };
    EXPECT_NO_THROW(SmallTree().history.check(SmallTree().leaves, 2));
    expect([](SmallTree& tree) { tree.history.share(tree.leaves[0]); },
           "node 1 is held 1 times, and counts 2");
    expect([](SmallTree& tree) { tree.leaves.pop_back(); }, "node 2 is held 0 times, and counts 1");
    expect([](SmallTree& tree) { tree.history.release(tree.leaves[0]); },
           "particle 0 holds node 1 of 3, which is free or none");
    expect([](SmallTree& tree) { tree.leaves[1] = 77; },
           "particle 1 holds node 77 of 3, which is free or none");
    expect([](SmallTree& /*tree*/) {}, "particle 0 has 2 poses for 3 scans", 3);
    expect(
        [](SmallTree& tree) {
            std::vector<PoseHistory::Node> again{tree.leaves[0]};
            tree.history.release(tree.leaves[0]);
            tree.history.take_back(again);
        },
        "node 1 of 3 is free twice");
    // One particle alone has all nodes on its way.
    PoseHistory alone;
    PoseHistory::Node leaf = alone.append(PoseHistory::kNone, {});
    leaf = alone.append(leaf, {1.0, 0.0, 0.0});
    EXPECT_NO_THROW(alone.check(std::vector{leaf}, 2));
}

template <class S>
LandmarkEstimate<S> some_landmark(int i);
template <>
LandmarkEstimate<SensorRecta> some_landmark(int i) {
    return {{1.0 + 0.1 * i, wrap_angle(2.4 * i)}, 1e-4 * Matrix2::Identity()};
}
template <>
LandmarkEstimate<SensorEsquina> some_landmark(int i) {
    return {{2.0 * (i % 20), 2.0 * std::floor(i / 20.0)}, 1e-4 * Matrix2::Identity()};
}

/// A map with index and pages, and another that shares all of it.
template <class S>
struct TwoMaps {
    static constexpr int kLandmarks = 300;
    LandmarkTable<S> table;
    typename LandmarkTable<S>::Caches caches;

    TwoMaps() {
        table.rows.resize(2);
        table.pages.resize(2);
        auto landmarks = of(0);
        for (int i = 0; i < kLandmarks; ++i) landmarks.set(landmarks.append(), some_landmark<S>(i));
        table.list(0, caches).share();
        table.rows[1] = table.rows[0];
        table.pages[1] = table.pages[0];
    }
    typename S::Columns of(std::size_t map) {
        return {table.pools, table.rows[map], table.pages[map], caches};
    }
    void check() {
        const std::array all{&caches};
        MapCheck<S>(table, all).run();
    }
};

template <class S>
class StructuresCheckOfMaps : public testing::Test {};
using BothKinds = testing::Types<SensorRecta, SensorEsquina>;
TYPED_TEST_SUITE(StructuresCheckOfMaps, BothKinds, );

TYPED_TEST(StructuresCheckOfMaps, SeesBrokenOnes) {
    using Maps = TwoMaps<TypeParam>;
    const auto expect = [](const std::function<void(Maps&)>& breaks, const std::string& what) {
        Maps maps;
        breaks(maps);
        expect_broken([&] { maps.check(); }, what);
    };
    Maps sound;
    EXPECT_NO_THROW(sound.check());
    sound.of(1).set(5, some_landmark<TypeParam>(400));
    EXPECT_NO_THROW(sound.check());
    // Leaves and pages.
    expect(
        [](Maps& maps) {
            maps.table.pools.leaves.share(maps.table.rows[0].leaves[0], maps.caches.leaves);
        },
        "is held 2 times, and counts 3");
    expect(
        [](Maps& maps) {
            maps.table.pools.leaves.put_back(maps.table.rows[0].leaves[0], maps.caches.leaves);
        },
        "is held 2 times, and free 1 times");
    expect(
        [](Maps& maps) {
            auto& leaves = maps.table.pools.leaves;
            leaves.let_go(leaves.take(maps.caches.leaves), maps.caches.leaves);
        },
        "is held 0 times, and free 0 times");
    expect([](Maps& maps) { maps.table.pools.leaves.take(maps.caches.leaves); },
           "is held 0 times, and counts 1");
    expect([](Maps& maps) { maps.table.rows[1].leaves[3] = 5000; }, "map 1 has leaf 5000 of");
    expect([](Maps& maps) { maps.table.pools.pages[maps.table.pages[0][0]].count = 3; },
           "has 3 leaves where 16 are needed");
    expect([](Maps& maps) { maps.table.pages[1].pop_back(); }, "map 1 of 300 landmarks lacks");
    // The index.
    expect(
        [](Maps& maps) {
            constexpr int kState0 = TypeParam::Columns::kState0;
            maps.of(1).own_leaf_of(7).column(kState0)[7] += 5.0;
        },
        "map 1: the index does not have landmark 7");
    expect([](Maps& maps) { ++maps.table.rows[0].entries; }, "entries, and counts 301");
    expect(
        [](Maps& maps) {
            maps.table.pools.nodes[maps.table.rows[0].index].entries[0].low[0] += 1000.0F;
        },
        "does not hold all in it");
    expect(
        [](Maps& maps) {
            auto& nodes = maps.table.pools.nodes;
            auto id = maps.table.rows[0].index;
            while (nodes[id].level > 0) id = nodes[id].entries[0].id;
            nodes[id].entries[0].id = Maps::kLandmarks;  // one behind the last
        },
        "the index has landmark 300 of 300");
    expect([](Maps& maps) { maps.table.pools.nodes[maps.table.rows[0].index].level = 9; },
           "where 8 belongs");
    expect(
        [](Maps& maps) {
            maps.table.pools.nodes.share(maps.table.rows[0].index, maps.caches.nodes);
        },
        "is held 2 times, and counts 3");
}

GraphRun some_graph_run() {
    const SimNoise noise;
    return {graph_params(noise), noise, 5, corridor_walls(), corridor_corners()};
}

/// What the graph gives to read only, to break it.
template <class T>
T& writable(const T& of_a_graph) {
    return const_cast<T&>(of_a_graph);  // NOLINT(*-const-cast)
}

TEST(StructuresCheck, SeesBrokenGraphs) {
    GraphRun run = some_graph_run();
    run.drive(from_first(corridor_path(0.5, 0)));
    const auto expect = [&](const std::function<void(LandmarkGraph&)>& breaks,
                            const std::string& what) {
        LandmarkGraph graph = run.filter.graph();
        breaks(graph);
        expect_broken([&] { check(graph); }, what);
    };
    EXPECT_NO_THROW(check(run.filter.graph()));
    expect([](LandmarkGraph& graph) { writable(graph.edges())[3].to = 9999; },
           "edge 3 leads from key 3 to key 9999 of");
    expect([](LandmarkGraph& graph) { writable(graph.edges())[3].to = 8; },
           "key 4 lists edge 3, which is none of its own");
    expect([](LandmarkGraph& graph) { writable(graph.edges())[1].information(0, 1) += 1e3; },
           "edge 1: its information is not symmetric");
    expect([](LandmarkGraph& graph) { writable(graph.edges())[1].z.theta = kNot; },
           "edge 1: its motion is no number");
    expect([](LandmarkGraph& graph) { graph.pose(2).x = kNot; }, "key 2: its pose is no number");
    expect([](LandmarkGraph& graph) { writable(graph.sightings())[0].information *= -1.0; },
           "sighting 0: its information is not symmetric and positive definite");
    expect(
        [](LandmarkGraph& graph) {
            writable(graph.sightings())[0].information.row(1) *= 0.0;
            writable(graph.sightings())[0].information.col(1) *= 0.0;
        },
        "sighting 0: its information is not symmetric and positive definite");
    expect([](LandmarkGraph& graph) { writable(graph.landmarks())[0].sightings.pop_back(); },
           "is listed by 0 of the 1 that it names");
    expect([](LandmarkGraph& graph) { graph.move_landmark(1, Vector2(kNot, 0.0)); },
           "landmark 1: its place is no number");
    expect([](LandmarkGraph& graph) { graph.add_landmark(FeatureKind::corner, {}); },
           "was never seen");
}

TEST(StructuresCheck, FindsNothingAtAnyStepOfATour) {
    const Tour tour = make_tour(80, 0.05);
    FilterParams params;
    params.particles = 100;
    params.landmarks.vanish = true;
    params.landmarks.probation = 2;
    FiltroParticulas particles(params, 3, 2);
    bool resampled = false;
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        feed(particles, tour.controls[k], tour.observations[k]);
        resampled = resampled || particles.statistics().resampled;
        ASSERT_NO_THROW(particles.check_structures()) << k;
    }
    EXPECT_TRUE(resampled);
    GraphRun run = some_graph_run();
    for (const Pose& pose : from_first(corridor_path(0.5, 4))) {
        run.step(pose);
        ASSERT_NO_THROW(check(run.filter.graph()));
    }
    run.filter.correct(run.registration.close(0));
    EXPECT_NO_THROW(check(run.filter.graph()));
}

TEST(StructuresCheck, RunsAfterEveryStepWhereTheBuildAsksForIt) {
    GraphRun run = some_graph_run();
    const std::vector<Pose> path = from_first(corridor_path(0.5, 0));
    run.step(path[0]);
    run.step(path[1]);
    writable(run.filter.graph().edges())[0].information(0, 1) += 1e3;
    if (kValidates) {
        expect_broken([&] { run.step(path[2]); }, "edge 0: its information is not symmetric");
    } else {
        EXPECT_NO_THROW(run.step(path[2]));
    }
}

}  // namespace
}  // namespace hitos
