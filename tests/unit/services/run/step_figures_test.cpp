// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/run/step_figures.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>

#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/run/run_worker.hpp"
#include "ready_tour.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::content;
using test::kRepository;
using test::small_tour;
using test::TempFolder;
using State = Progress::State;

/// The ready tour that is noisy: particles differ and are resampled.
Configuracion noisy_tour() {
    Configuracion configuration = ArchivoConfiguracion::read(kRepository / "config/simulated.cfg");
    configuration.source.file = kRepository / "data/bigloop.log.gz";
    configuration.filter.particles = 30;
    configuration.filter.resampling.rule = ResamplingRule::neff;
    configuration.filter.resampling.neff_threshold = 15.0;
    return configuration;
}

std::vector<StepFigures> all_figures(const Configuracion& configuration) {
    Algoritmo run(configuration, open_source(configuration.source));
    std::vector<StepFigures> figures;
    while (run.step()) figures.push_back(figures_of(run, 0.0));
    return figures;
}

TEST(StepFigures, CountWhatBecameOfEveryFeature) {
    const auto figures = all_figures(noisy_tour());
    ASSERT_EQ(figures.size(), 1050U);
    for (const StepFigures& step : figures) {
        EXPECT_EQ(step.matched + step.created + step.ignored, step.seen_lines + step.seen_corners);
        EXPECT_EQ(step.resampled, step.neff < 15.0) << step.time_s;
    }
    EXPECT_GT(figures[0].created, 0);
    EXPECT_EQ(figures[0].created, figures[0].lines + figures[0].corners);
    EXPECT_GT(std::ranges::count(figures, true, &StepFigures::resampled), 0);
    EXPECT_GT(std::ranges::count(figures, true, &StepFigures::best_changed), 0);
    EXPECT_LT(std::ranges::count(figures, true, &StepFigures::best_changed), 1050);
}

/// The tour goes round and comes back to what it saw in the beginning, whatever the algorithm.
class Unseen : public testing::TestWithParam<const char*> {};

TEST_P(Unseen, IsHowLongALandmarkWasOutOfSight) {
    Configuracion configuration = small_tour();
    configuration.filter.algorithm = GetParam();
    const bool graph = configuration.filter.algorithm == "graph-slam";
    if (graph) configuration.filter.motion.model = "registered";
    const auto figures = all_figures(configuration);
    ASSERT_EQ(figures.size(), 1050U);
    EXPECT_EQ(figures[0].unseen_s, 0.0);
    const auto longest = std::ranges::max_element(figures, {}, &StepFigures::unseen_s);
    EXPECT_GT(longest->unseen_s, 20.0);
    EXPECT_LE(longest->unseen_s, longest->time_s);
    // A landmark that was there a moment ago is the usual thing: one scan, or with a graph one key.
    const auto often =
        std::ranges::count_if(figures, [](const StepFigures& step) { return step.unseen_s < 2.0; });
    EXPECT_GT(often, 800);
}

INSTANTIATE_TEST_SUITE_P(Algorithms, Unseen, testing::Values("fastslam", "ekf-slam", "graph-slam"),
                         [](const auto& algorithm) {
                             std::string name = algorithm.param;
                             std::erase(name, '-');
                             return name;
                         });

TEST(StepFigures, TheTableHasALineForEveryScan) {
    Configuracion configuration = small_tour();
    Algoritmo run(configuration, open_source(configuration.source));
    std::vector<StepFigures> figures;
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(run.step());
        figures.push_back(figures_of(run, 0.5));
    }
    const std::string text = figures_to_csv(figures, nullptr);
    EXPECT_EQ(std::ranges::count(text, '\n'), 4);
    EXPECT_THAT(text, testing::StartsWith("scan,stamp_s,time_s,x_m,y_m,theta_rad,neff,"));
    EXPECT_THAT(text, testing::HasSubstr(",step_s\n1,"));
    EXPECT_THAT(text, testing::EndsWith(",0.5\n"));
    const Trajectory reference = {{figures[0].online.time_s, {1.0, 2.0, 0.0}},
                                  {figures[0].online.time_s + 1.0, {1.0, 2.0, 0.0}}};
    const TempFolder folder;
    write_figures(figures, &reference, folder.path() / "figures.csv");
    const std::string with = content(folder.path() / "figures.csv");
    EXPECT_THAT(with, testing::HasSubstr(",step_s,position_error_m,pose_nees\n"));
    EXPECT_THAT(with, testing::HasSubstr(",0.5,0,\n2,"));  // the first is where both meet
    EXPECT_THAT(with, testing::HasSubstr(",0.5,,\n3,"));   // the second has no partner
}

TEST(StepFigures, TheNeesIsOfTheErrorAgainstTheReference) {
    Configuracion configuration = small_tour();
    configuration.filter.algorithm = "ekf-slam";
    Algoritmo run(configuration, open_source(configuration.source));
    std::vector<StepFigures> figures;
    for (int i = 0; i < 200; ++i) {
        ASSERT_TRUE(run.step());
        figures.push_back(figures_of(run, 0.0));
    }
    const StepFigures& last = figures.back();
    EXPECT_EQ(last.mean, run.filter().best_pose());
    EXPECT_EQ(last.covariance, run.filter().pose_covariance());
    // Where it believes to be, but for the last scan.
    Trajectory path;
    for (const StepFigures& step : figures) path.push_back(step.online);
    const double x = path.back().pose.x += 0.01;
    PositionError reference(path);
    EXPECT_EQ(nees_of(figures.front(), reference), std::nullopt);  // certain, by definition
    EXPECT_NEAR(nees_of(figures[150], reference).value(), 0.0, 1e-12);
    const double away = last.mean.x - x;
    const double expected = away * away * last.covariance.inverse()(0, 0);
    EXPECT_NEAR(nees_of(last, reference).value(), expected, 1e-6 * expected);
    EXPECT_THAT(figures_to_csv(figures, &path),
                testing::EndsWith(fmt::format(",{}\n", *nees_of(last, reference))));
}

TEST(PositionErrorTest, IsMeasuredFromTheFirstCommonPose) {
    PositionError error(
        {{10.0, {5.0, 5.0, kPi / 2}}, {11.0, {5.0, 6.0, kPi / 2}}, {12.0, {5.0, 7.0, kPi / 2}}});
    EXPECT_EQ(error.at({9.0, {}}), std::nullopt);
    EXPECT_NEAR(error.at({10.01, {0.0, 0.0, 0.0}}).value(), 0.0, 1e-12);
    EXPECT_NEAR(error.at({11.0, {1.0, 0.0, 0.3}}).value(), 0.0, 1e-12);
    EXPECT_NEAR(error.at({12.0, {2.0, 0.5, 0.0}}).value(), 0.5, 1e-12);
    EXPECT_EQ(error.at({12.03, {2.0, 0.5, 0.0}}), std::nullopt);
    EXPECT_NEAR(error.at({11.0, {1.0, 0.0, 0.3}}).value(), 0.0, 1e-12);  // back again
    // Between poses that are near it is interpolated.
    PositionError dense({{10.0, {}}, {10.4, {0.4, 0.0, 0.0}}});
    EXPECT_NEAR(dense.at({10.0, {}}).value(), 0.0, 1e-12);
    EXPECT_NEAR(dense.at({10.1, {0.1, 0.2, 0.0}}).value(), 0.2, 1e-12);
}

TEST(StopRulesTest, EveryRuleLooksAtItsFigure) {
    StepFigures step;
    step.time_s = 10.0;
    step.neff = 20.0;
    const auto met = [&](const StopRules& rules, std::optional<double> error = std::nullopt) {
        return rules.met(step, error);
    };
    EXPECT_EQ(met({}), StopReason::none);
    EXPECT_EQ(met({.time_s = 10.1}), StopReason::none);
    EXPECT_EQ(met({.time_s = 10.0}), StopReason::time);
    EXPECT_EQ(met({.neff_below = 20.0}), StopReason::none);
    EXPECT_EQ(met({.neff_below = 20.1}), StopReason::neff);
    EXPECT_EQ(met({.landmark_born = true}), StopReason::none);
    EXPECT_EQ(met({.seen_again_after_s = 5.0}), StopReason::none);
    EXPECT_EQ(met({.best_changed = true}), StopReason::none);
    EXPECT_EQ(met({.loop_closed = true}), StopReason::none);
    EXPECT_EQ(met({.position_error_above_m = 0.5}), StopReason::none);
    EXPECT_EQ(met({.position_error_above_m = 0.5}, 0.5), StopReason::none);
    EXPECT_EQ(met({.position_error_above_m = 0.5}, 0.6), StopReason::error);
    step.created = 1;
    step.unseen_s = 5.0;
    step.best_changed = step.loop_closed = true;
    EXPECT_EQ(met({.landmark_born = true}), StopReason::landmark_born);
    EXPECT_EQ(met({.seen_again_after_s = 5.0}), StopReason::seen_again);
    EXPECT_EQ(met({.seen_again_after_s = 5.1}), StopReason::none);
    EXPECT_EQ(met({.best_changed = true}), StopReason::best_changed);
    EXPECT_EQ(met({.loop_closed = true}), StopReason::loop_closed);
}

TEST(StopRulesTest, TheRunStopsAtTheFirstScanThatMeetsOne) {
    const Configuracion configuration = noisy_tour();
    const auto figures = all_figures(configuration);
    RunWorker worker(configuration, open_source(configuration.source));
    std::uint64_t at = 0;
    const auto expect_stop = [&](const StopRules& rules, StopReason reason, auto holds) {
        worker.run(RunWorker::kToTheEnd, rules);
        worker.wait();
        const auto found =
            std::find_if(figures.begin() + static_cast<std::ptrdiff_t>(at), figures.end(), holds);
        ASSERT_NE(found, figures.end());
        at = static_cast<std::uint64_t>(found - figures.begin()) + 1;
        EXPECT_EQ(worker.progress().state, State::paused);
        EXPECT_EQ(worker.progress().steps, at);
        EXPECT_EQ(worker.progress().stopped_by, reason);
    };
    expect_stop({.landmark_born = true}, StopReason::landmark_born,
                [](const StepFigures& step) { return step.created > 0; });
    expect_stop({.time_s = 3.0}, StopReason::time,
                [](const StepFigures& step) { return step.time_s >= 3.0; });
    expect_stop({.neff_below = 16.0}, StopReason::neff,
                [](const StepFigures& step) { return step.neff < 16.0; });
    expect_stop({.best_changed = true}, StopReason::best_changed,
                [](const StepFigures& step) { return step.best_changed; });
    expect_stop({.seen_again_after_s = 20.0}, StopReason::seen_again,
                [](const StepFigures& step) { return step.unseen_s >= 20.0; });
    worker.run(5);
    worker.wait();
    EXPECT_EQ(worker.progress().stopped_by, StopReason::none);
}

TEST(StopRulesTest, AtTheToursEndNoRuleHasStoppedIt) {
    const Configuracion configuration = small_tour();
    const double last_s = all_figures(configuration).back().time_s;
    RunWorker worker(configuration, open_source(configuration.source));
    worker.run(RunWorker::kToTheEnd, {.time_s = last_s});
    worker.wait();
    EXPECT_EQ(worker.progress().stopped_by, StopReason::time);
    worker.run();
    worker.wait();
    EXPECT_EQ(worker.progress().state, State::finished);
    EXPECT_EQ(worker.progress().stopped_by, StopReason::none);
}

TEST(StepFigures, TellTheScansAtWhichLoopsWereClosed) {
    Configuracion configuration = small_tour();
    configuration.filter = ArchivoConfiguracion::read(kRepository / "config/recorded.cfg").filter;
    configuration.filter.particles = 2;
    Algoritmo run(configuration, open_source(configuration.source));
    std::vector<std::uint64_t> told;
    while (run.step()) {
        if (figures_of(run, 0.0).loop_closed) told.push_back(run.steps() - 1);
    }
    std::vector<std::uint64_t> closed;
    for (const LoopRecord& loop : run.registration()->loops()) closed.push_back(loop.scan);
    EXPECT_FALSE(closed.empty());
    EXPECT_EQ(told, closed);
}

TEST(StopRulesTest, TheErrorIsAgainstTheReferenceGivenAtAnyTime) {
    const Configuracion configuration = small_tour();
    const auto figures = all_figures(configuration);
    Trajectory reference;
    for (const StepFigures& step : figures) reference.push_back(step.online);
    for (std::size_t i = 60; i < reference.size(); ++i) reference[i].pose.x += 1.0;
    RunWorker worker(configuration, open_source(configuration.source));
    worker.run(20);
    worker.wait();
    worker.set_reference(reference);
    worker.run(RunWorker::kToTheEnd, {.position_error_above_m = 0.5});
    worker.wait();
    EXPECT_EQ(worker.progress().steps, 61U);
    EXPECT_EQ(worker.progress().stopped_by, StopReason::error);
    worker.restart();
    worker.run(RunWorker::kToTheEnd, {.position_error_above_m = 0.5});
    worker.wait();
    EXPECT_EQ(worker.progress().steps, 61U);
}

TEST(StepFigures, OfScansPassedAgainAreThoseOfTheFirstTime) {
    const Configuracion configuration = noisy_tour();
    AlgoritmoOptions options;
    options.go_back = true;
    RunWorker worker(configuration, open_source(configuration.source), options);
    worker.run(80);
    worker.wait();
    const std::string before = figures_to_csv(worker.figures_since(0), nullptr);
    worker.seek(30);
    worker.wait();
    worker.run(40);
    worker.wait();
    EXPECT_EQ(worker.progress().steps, 70U);
    EXPECT_TRUE(figures_to_csv(worker.figures_since(0), nullptr) == before);
}

}  // namespace
}  // namespace hitos
