#include "hitos/services/run/run_worker.hpp"

#include <gtest/gtest.h>

#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/run/open_source.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using State = Progress::State;
const std::filesystem::path kSource = HITOS_SOURCE_DIR;

Configuracion ready_tour() {
    Configuracion configuration = ArchivoConfiguracion::read(kSource / "config/simulated.cfg");
    configuration.source.file = kSource / "data/bigloop.log.gz";
    configuration.filter.particles = 20;
    return configuration;
}

/// The best path of the same configuration, run on this thread.
Trajectory expected_path(int steps) {
    const Configuracion configuration = ready_tour();
    Algoritmo run(configuration, open_source(configuration.source));
    for (int i = 0; i < steps && run.step(); ++i) {
    }
    return run.best_trajectory();
}

Trajectory path_of(RunWorker& worker) {
    return worker.with_run([](const Algoritmo& run) { return run.best_trajectory(); }).get();
}

TEST(RunWorker, RunsToTheEndAsTheLoopOnOneThread) {
    const Configuracion configuration = ready_tour();
    RunWorker worker(configuration, open_source(configuration.source));
    EXPECT_EQ(worker.progress().state, State::ready);
    worker.run();
    worker.wait();
    const Progress progress = worker.progress();
    EXPECT_EQ(progress.state, State::finished);
    EXPECT_EQ(progress.steps, 1050U);
    EXPECT_EQ(progress.fraction, 1.0);
    EXPECT_EQ(progress.lines + progress.corners, 16);
    EXPECT_EQ(path_of(worker), expected_path(1 << 20));
}

TEST(RunWorker, StepsPausesAndGoesOn) {
    const Configuracion configuration = ready_tour();
    RunWorker worker(configuration, open_source(configuration.source));
    worker.run(1);
    worker.wait();
    EXPECT_EQ(worker.progress().steps, 1U);
    EXPECT_EQ(worker.progress().state, State::paused);
    worker.run(9);
    worker.wait();
    EXPECT_EQ(worker.progress().steps, 10U);
    worker.run();
    while (worker.progress().steps < 50) std::this_thread::yield();
    worker.pause();
    worker.wait();
    const auto paused_at = worker.progress().steps;
    EXPECT_GE(paused_at, 50U);
    EXPECT_LT(paused_at, 1050U);
    EXPECT_EQ(worker.progress().state, State::paused);
    worker.run();
    worker.wait();
    // Interruptions change nothing.
    EXPECT_EQ(path_of(worker), expected_path(1 << 20));
}

TEST(RunWorker, RestartsFromAnyState) {
    const Configuracion configuration = ready_tour();
    RunWorker worker(configuration, open_source(configuration.source));
    worker.run();
    worker.restart();  // while it runs
    worker.wait();
    EXPECT_EQ(worker.progress().state, State::ready);
    EXPECT_EQ(worker.progress().steps, 0U);
    worker.run(30);
    worker.wait();
    EXPECT_EQ(path_of(worker), expected_path(30));
    worker.run();
    worker.wait();
    worker.run();  // at the end: nothing
    worker.wait();
    EXPECT_EQ(worker.progress().state, State::finished);
    worker.restart();
    worker.run(5);  // right behind the restart
    worker.wait();
    EXPECT_EQ(worker.progress().steps, 5U);
}

TEST(RunWorker, SnapshotsAreOfOneStep) {
    const Configuracion configuration = ready_tour();
    RunWorker worker(configuration, open_source(configuration.source));
    EXPECT_EQ(worker.latest_snapshot(), nullptr);
    worker.run();
    std::uint64_t last = 0;
    for (int i = 0; i < 20; ++i) {
        worker.request_snapshot();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        const auto snapshot = worker.latest_snapshot();
        if (!snapshot) continue;
        EXPECT_GE(snapshot->steps, last);
        last = snapshot->steps;
        EXPECT_EQ(snapshot->best_trajectory.size(), snapshot->steps);
        EXPECT_EQ(snapshot->odometry_trajectory.size(), snapshot->steps);
        EXPECT_EQ(snapshot->hypotheses.size(), 20U);
        if (snapshot->steps > 0) {
            EXPECT_EQ(snapshot->best_pose, snapshot->best_trajectory.back().pose);
            EXPECT_EQ(snapshot->associations.size(),
                      snapshot->observation.lines.size() + snapshot->observation.corners.size());
        }
    }
    worker.wait();
    EXPECT_EQ(worker.latest_snapshot()->steps <= 1050, true);
    worker.request_snapshot();  // nothing runs: it is made at once
    worker.wait();
    EXPECT_EQ(worker.latest_snapshot()->steps, 1050U);
    worker.restart();
    worker.wait();
    EXPECT_EQ(worker.latest_snapshot(), nullptr);
}

TEST(RunWorker, AFailureIsToldAndEndsTheRun) {
    const test::TempFolder folder;
    Configuracion configuration;
    configuration.source.file = folder.put("odometry.log", "ODOM 1 0.1 0\nODOM 2 0.1 0\n");
    RunWorker worker(configuration, open_source(configuration.source));
    worker.run();
    worker.wait();
    EXPECT_EQ(worker.progress().state, State::failed);
    EXPECT_NE(worker.progress().error.find("no readable scan"), std::string::npos);
    // A source that has gone meanwhile: restarting fails, and says so.
    std::filesystem::remove(configuration.source.file);
    worker.restart();
    worker.wait();
    EXPECT_EQ(worker.progress().state, State::failed);
    EXPECT_FALSE(worker.progress().error.empty());
}

TEST(RunWorker, ExceptionsOfTasksReachTheCaller) {
    const Configuracion configuration = ready_tour();
    RunWorker worker(configuration, open_source(configuration.source));
    auto future = worker.with_run([](const Algoritmo& run) -> int {
        if (run.steps() == 0) throw std::runtime_error("nothing yet");
        return 1;
    });
    EXPECT_THROW(future.get(), std::runtime_error);
}

TEST(RunWorker, EndsWhileRunning) {
    const Configuracion configuration = ready_tour();
    for (int i = 0; i < 5; ++i) {
        RunWorker worker(configuration, open_source(configuration.source));
        worker.run();
        worker.request_snapshot();
        std::this_thread::sleep_for(std::chrono::milliseconds(i));
    }
}

}  // namespace
}  // namespace hitos
