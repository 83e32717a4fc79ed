// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "hitos/base/error.hpp"
#include "hitos/base/validate.hpp"
#include "hitos/services/run/run_checkpoint.hpp"
#include "hitos/services/run/run_worker.hpp"
#include "hitos/slam/filters.hpp"
#include "ready_tour.hpp"

namespace hitos {
namespace {

using State = Progress::State;
using test::expected_path;
using test::kRepository;
using test::path_of;
using test::small_tour;

/// Everything that can be seen of a run, to the last bit.
void expect_same_state(RunWorker& worker, const Algoritmo& expected) {
    worker
        .with_run([&expected](const Algoritmo& run) {
            EXPECT_EQ(run.steps(), expected.steps());
            EXPECT_EQ(run.finished(), expected.finished());
            EXPECT_TRUE(run.best_trajectory() == expected.best_trajectory());
            EXPECT_TRUE(run.online_trajectory() == expected.online_trajectory());
            EXPECT_TRUE(run.odometry_trajectory() == expected.odometry_trajectory());
            const LandmarkMap map = run.filter().best_map();
            const LandmarkMap expected_map = expected.filter().best_map();
            ASSERT_EQ(map.size(), expected_map.size());
            for (std::size_t i = 0; i < map.size(); ++i) {
                EXPECT_EQ(map[i].value, expected_map[i].value);
                EXPECT_EQ(map[i].covariance, expected_map[i].covariance);
                EXPECT_EQ(map[i].observations, expected_map[i].observations);
                EXPECT_EQ(map[i].first_seen, expected_map[i].first_seen);
                EXPECT_EQ(map[i].last_seen, expected_map[i].last_seen);
            }
            const auto extents = run.line_extents().of(map, run.best_trajectory());
            const auto expected_extents =
                expected.line_extents().of(expected_map, expected.best_trajectory());
            ASSERT_EQ(extents.size(), expected_extents.size());
            for (std::size_t i = 0; i < extents.size(); ++i) {
                EXPECT_EQ(extents[i].landmark, expected_extents[i].landmark);
                EXPECT_EQ(extents[i].a, expected_extents[i].a);
                EXPECT_EQ(extents[i].b, expected_extents[i].b);
                EXPECT_EQ(extents[i].points, expected_extents[i].points);
            }
            EXPECT_EQ(run.filter().statistics().neff, expected.filter().statistics().neff);
            const auto hypotheses = run.filter().hypotheses();
            const auto expected_hypotheses = expected.filter().hypotheses();
            ASSERT_EQ(hypotheses.size(), expected_hypotheses.size());
            for (std::size_t i = 0; i < hypotheses.size(); ++i) {
                EXPECT_EQ(hypotheses[i].pose, expected_hypotheses[i].pose);
                EXPECT_EQ(hypotheses[i].weight_before, expected_hypotheses[i].weight_before);
                EXPECT_EQ(hypotheses[i].from, expected_hypotheses[i].from);
            }
            EXPECT_EQ(run.scan(), expected.scan());
            const Grid& grid = run.step_grid();
            const Grid& expected_grid = expected.step_grid();
            ASSERT_EQ(grid.columns(), expected_grid.columns());
            ASSERT_EQ(grid.rows(), expected_grid.rows());
            for (int row = 0; row < grid.rows(); ++row) {
                for (int column = 0; column < grid.columns(); ++column) {
                    ASSERT_EQ(grid.log_odds(column, row), expected_grid.log_odds(column, row));
                }
            }
        })
        .get();
}

Configuracion registered_tour() {
    Configuracion configuration = ArchivoConfiguracion::read(kRepository / "config/recorded.cfg");
    configuration.source.file = kRepository / "data/bigloop.log.gz";
    configuration.filter.particles = 10;
    return configuration;
}

class GoingBack : public testing::TestWithParam<const char*> {};

TEST_P(GoingBack, TheStateAtAScanIsTheOneOfARunForwards) {
    Configuracion configuration = small_tour();
    const std::string algorithm = GetParam();
    if (algorithm == "registered") {
        configuration = registered_tour();
    } else if (algorithm == "ransac") {  // which draws at random, scan by scan
        configuration.extraction.method = "ransac";
        configuration.filter.algorithm = "ekf-slam";
    } else {
        configuration.filter.algorithm = algorithm;
    }
    RunWorker worker(configuration, open_source(configuration.source),
                     {.step_grid = true, .go_back = true});
    worker.seek(150);
    worker.wait();
    EXPECT_EQ(worker.progress().state, State::paused);
    Algoritmo expected(configuration, open_source(configuration.source));
    const auto expect_at = [&](std::uint64_t steps) {
        if (expected.steps() > steps || expected.finished()) expected.restart();
        while (expected.steps() < steps) ASSERT_TRUE(expected.step());
        worker.seek(steps);
        worker.wait();
        EXPECT_EQ(worker.progress().steps, steps);
        EXPECT_EQ(worker.progress().state, State::paused);
        expect_same_state(worker, expected);
    };
    for (const std::uint64_t steps : {149U, 40U, 97U, 96U, 1U, 0U, 150U}) {
        SCOPED_TRACE(steps);
        expect_at(steps);
    }
    // From the end, beyond which the path has been smoothed, and on to the end again.
    worker.run();
    worker.wait();
    EXPECT_EQ(worker.progress().state, State::finished);
    const Trajectory whole = path_of(worker);
    const std::size_t figures = worker.figures_since(0).size();
    expect_at(120);
    EXPECT_EQ(worker.figures_since(0).size(), figures)
        << "what is known of later scans stays known";
    worker.run();
    worker.wait();
    EXPECT_TRUE(path_of(worker) == whole);
}

std::string in_one_word(const testing::TestParamInfo<const char*>& name) {
    std::string word = name.param;
    std::erase(word, '-');
    return word;
}

INSTANTIATE_TEST_SUITE_P(Algorithms, GoingBack,
                         testing::Values("fastslam", "ekf-slam", "graph-slam", "registered",
                                         "ransac"),
                         in_one_word);

/// The whole run with those changes by hand, on this thread.
std::unique_ptr<Algoritmo> run_with(Configuracion configuration, const std::string& edits) {
    configuration.registration.edits = edits;
    auto run = std::make_unique<Algoritmo>(configuration, open_source(configuration.source));
    while (run->step()) {
    }
    return run;
}

class ChangesByHand : public testing::TestWithParam<const char*> {};

TEST_P(ChangesByHand, GiveWhatTheyGiveFromTheBeginning) {
    const char* const algorithm = GetParam();
    Configuracion configuration = ArchivoConfiguracion::read(kRepository / "config/recorded.cfg");
    configuration.source.file = kRepository / "data/bigloop-noisy.log.gz";
    configuration.filter.particles = 5;
    configuration.filter.algorithm = algorithm;
    ASSERT_TRUE(needs_registration(configuration.filter)) << algorithm;
    const auto plain = run_with(configuration, "");
    ASSERT_FALSE(plain->registration()->loops().empty()) << algorithm;
    const Pose fixed = run_with(configuration, "fix 800 1 2 0")->best_trajectory()[799].pose;
    EXPECT_NEAR(fixed.x, 1.0, 0.05) << algorithm;
    EXPECT_NEAR(fixed.y, 2.0, 0.05) << algorithm;
    EXPECT_NEAR(fixed.theta, 0.0, 0.02) << algorithm;
    const LoopRecord loop = plain->registration()->loops().front();
    const std::string refused =
        text_of(std::vector<GraphEdit>{{GraphEdit::Kind::refuse, {loop.scan}, {loop.earlier}}});

    AlgoritmoOptions options;
    options.go_back = true;
    RunWorker worker(configuration, open_source(configuration.source), options);
    worker.run();
    worker.wait();
    // What is foreseen is shown alone until the run is there, even to who asks for more.
    // The worker rests between two steps as long as somebody looks.
    std::shared_ptr<const Snapshot> foreseen;
    const auto look = [&](const std::string& edits, const std::string& next) {
        std::promise<void> seen;
        std::promise<void> there;
        worker.set_edits(edits);
        worker.with_run([](const Algoritmo&) {}).wait();  // of a step that was under way
        auto rest = worker.with_run([&](const Algoritmo&) {
            there.set_value();
            seen.get_future().wait();
        });
        there.get_future().wait();
        foreseen = worker.latest_snapshot();
        worker.request_snapshot();
        if (!next.empty()) worker.set_edits(next);
        seen.set_value();
        rest.wait();
    };
    look(refused, {});
    ASSERT_TRUE(foreseen) << algorithm;
    EXPECT_TRUE(foreseen->foreseen) << algorithm;
    EXPECT_EQ(foreseen->steps, plain->steps()) << algorithm;
    EXPECT_NE(foreseen->best_trajectory, plain->best_trajectory()) << algorithm;
    // Another change while the tour is taken again.
    look(refused + "; fix 800 1 2 0", refused);
    ASSERT_TRUE(foreseen) << algorithm;
    EXPECT_TRUE(foreseen->foreseen) << algorithm;
    EXPECT_EQ(foreseen->steps, plain->steps()) << algorithm;
    EXPECT_NEAR(foreseen->best_trajectory[799].pose.x, 1.0, 0.1) << algorithm;
    EXPECT_NEAR(foreseen->best_trajectory[799].pose.y, 2.0, 0.1) << algorithm;
    worker.wait();
    EXPECT_FALSE(worker.latest_snapshot()->foreseen) << algorithm;
    EXPECT_EQ(worker.progress().state, State::finished);
    EXPECT_LT(worker.progress().steps_per_second, 1e6) << algorithm;
    expect_same_state(worker, *run_with(configuration, refused));
    EXPECT_EQ(worker.figures_since(0).size(), plain->steps());
    // What is asked for meanwhile is the run's own, when it is there.
    worker.set_edits("");
    worker.request_snapshot();
    worker.wait();
    EXPECT_FALSE(worker.latest_snapshot()->foreseen) << algorithm;
    expect_same_state(worker, *plain);
    worker.set_edits(refused);
    worker.wait();
    // Of a change behind where the run has gone back to nothing is foreseen.
    worker.set_edits("fix 800 1 2 0");
    worker.seek(400);
    worker.wait();
    worker.set_edits("");
    worker.wait();
    EXPECT_EQ(worker.progress().steps, 400U);
    worker.set_edits(refused);
    worker.seek(RunWorker::kToTheEnd);
    worker.wait();
    // Others later, while the run is on its way; and all of them taken back.
    worker.set_edits(refused + "; slip 700");
    worker.set_edits("slip 700; fix 800 1 2 0");
    worker.wait();
    expect_same_state(worker, *run_with(configuration, "slip 700; fix 800 1 2 0"));
    worker.seek(300);
    worker.wait();
    worker.set_edits("");
    worker.wait();
    EXPECT_EQ(worker.progress().steps, 300U);
    worker.run();
    worker.wait();
    expect_same_state(worker, *plain);
    EXPECT_THROW(worker.set_edits("open 3"), ConfigError);
    expect_same_state(worker, *plain);
    // A run that failed by them is mended by others.
    worker.set_edits("slip 999999");
    worker.wait();
    EXPECT_EQ(worker.progress().state, State::failed);
    worker.set_edits("slip 700");
    worker.wait();
    EXPECT_EQ(worker.progress().state, State::finished);
    expect_same_state(worker, *run_with(configuration, "slip 700"));
    // On the way elsewhere it goes on to there; a pause is a pause.
    worker.seek(500);
    worker.set_edits("");
    worker.wait();
    EXPECT_EQ(worker.progress().steps, 500U);
    EXPECT_EQ(worker.progress().state, State::paused);
    for (int i = 0; i < 20; ++i) {
        worker.set_edits(i % 2 == 0 ? refused : "");
        worker.pause();
        worker.wait();
        EXPECT_EQ(worker.progress().state, State::paused);
        EXPECT_LE(worker.progress().steps, 500U);
    }
    // What was wanted counts for a run that begins anew too.
    worker.set_edits(refused);
    worker.restart();
    worker.run();
    worker.wait();
    expect_same_state(worker, *run_with(configuration, refused));
}

INSTANTIATE_TEST_SUITE_P(Algorithms, ChangesByHand,
                         testing::Values("fastslam", "ekf-slam", "graph-slam"), in_one_word);

TEST(RunWorker, TheLastOrderCounts) {
    const Configuracion configuration = small_tour();
    RunWorker worker(configuration, open_source(configuration.source), {.go_back = true});
    worker.seek(200);
    worker.seek(30);
    worker.wait();
    EXPECT_EQ(worker.progress().steps, 30U);
    worker.seek(300);
    worker.restart();
    worker.wait();
    EXPECT_EQ(worker.progress().steps, 0U);
    worker.seek(50);
    worker.wait();
    worker.run(7);
    worker.wait();
    EXPECT_EQ(worker.progress().steps, 57U);
    EXPECT_EQ(path_of(worker), expected_path(57));
}

TEST(RunWorker, GoesBackFromTheBeginningWhereNothingIsRemembered) {
    const Configuracion configuration = small_tour();
    RunWorker worker(configuration, open_source(configuration.source));
    worker.run(60);
    worker.wait();
    worker.seek(20);
    worker.wait();
    EXPECT_EQ(worker.progress().steps, 20U);
    EXPECT_EQ(path_of(worker), expected_path(20));
}

/// While the run goes on its grid may be shown as it was before a correction; not when it rests.
TEST(RunWorker, AtRestTheGridIsTheOneOfTheRun) {
    const Configuracion configuration = registered_tour();
    RunWorker worker(configuration, open_source(configuration.source),
                     {.step_grid = true, .go_back = true});
    const auto shown = [&worker] {
        worker.request_snapshot();
        worker.wait();
        return worker.latest_snapshot()->step_grid;
    };
    const auto expect_whole = [&](const GridTiles& tiles) {
        const GridTiles expected =
            worker.with_run([](const Algoritmo& run) { return tiles_of(run.step_grid()); }).get();
        EXPECT_EQ(tiles.area, expected.area);
        ASSERT_EQ(tiles.tiles.size(), expected.tiles.size());
        for (std::size_t i = 0; i < tiles.tiles.size(); ++i) {
            ASSERT_EQ(tiles.tiles[i] == nullptr, expected.tiles[i] == nullptr);
            if (tiles.tiles[i]) {
                EXPECT_EQ(tiles.tiles[i]->grey, expected.tiles[i]->grey);
            }
        }
    };
    worker.run();
    while (worker.progress().state == State::running) worker.request_snapshot();
    worker.wait();
    const auto last = worker.latest_snapshot();
    if (last->revision == worker.progress().revision && !last->grid_behind) {
        expect_whole(last->step_grid);
    }
    expect_whole(shown());
    EXPECT_FALSE(worker.latest_snapshot()->grid_behind);
    for (const std::uint64_t steps : {200U, 90U, 300U}) {
        worker.seek(steps);
        worker.request_snapshot();  // on the way
        expect_whole(shown());
    }
}

TEST(RunCheckpoint, OneThatHasChangedIsSeen) {
    const Configuracion configuration = small_tour();
    Algoritmo run(configuration, open_source(configuration.source), {.go_back = true});
    while (run.steps() < 20) run.step();
    const auto kept = run.checkpoint();
    const std::vector<StatePart> parts = parts_of(kept->state, kept->step_grid);
    EXPECT_EQ(kept->parts.empty(), !kValidates);
    run.step();
    EXPECT_NO_THROW(check_same(parts, parts_of(kept->state, kept->step_grid), "copy"));
    const auto expect_seen = [&](const char* part, const auto& change) {
        RunCheckpoint changed = *kept;
        change(changed);
        const auto seen = [&](const auto& check) {
            try {
                check();
                ADD_FAILURE() << "nothing was seen of the " << part;
            } catch (const std::logic_error& error) {
                EXPECT_EQ(std::string(error.what()), "return to the state after 20 scans: the " +
                                                         std::string(part) + " is not what it was");
            }
        };
        seen([&] {
            check_same(parts, parts_of(changed.state, changed.step_grid),
                       "return to the state after 20 scans");
        });
        if (kValidates) seen([&] { run.go_to(changed); });
    };
    expect_seen("path as it was driven",
                [](RunCheckpoint& changed) { changed.state.online.back().pose.x += 1e-12; });
    expect_seen("scan", [](RunCheckpoint& changed) { changed.state.scan.points.pop_back(); });
    expect_seen("grid", [](RunCheckpoint& changed) { changed.step_grid.clear(); });
    // And in builds that check, a whole one is come back to.
    run.go_to(*kept);
    EXPECT_EQ(run.steps(), 20U);
}

TEST(RunCheckpoints, StayWithinTheirMemoryAndGrowApart) {
    const Configuracion configuration = small_tour();
    Algoritmo run(configuration, open_source(configuration.source), {.go_back = true});
    constexpr std::size_t kLittle = std::size_t{4} << 20;
    RunCheckpoints few(kLittle);
    RunCheckpoints many;
    while (run.steps() < 600 && run.step()) {
        few.note(run);
        many.note(run);
    }
    EXPECT_LE(few.bytes(), kLittle);
    EXPECT_GT(few.bytes(), kLittle / 2);  // most of it is in use
    EXPECT_LE(many.count(), RunCheckpoints::kMost);
    EXPECT_GT(many.count(), RunCheckpoints::kMost / 3);
    EXPECT_GT(few.spacing(), many.spacing());
    EXPECT_EQ(many.before(7), nullptr);
    const auto at = many.before(599);
    ASSERT_TRUE(at);
    EXPECT_LE(at->steps(), 599U);
    EXPECT_GT(at->steps() + many.spacing(), 599U);
}

}  // namespace
}  // namespace hitos
