#include "hitos/services/algoritmo.hpp"

#include <gtest/gtest.h>

#include "hitos/services/archivo_configuracion.hpp"
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
    SlamRun run(configuration, open_source(configuration.source));
    for (int i = 0; i < steps && run.step(); ++i) {
    }
    return run.best_trajectory();
}

Trajectory path_of(Algoritmo& algoritmo) {
    return algoritmo.with_run([](const SlamRun& run) { return run.best_trajectory(); }).get();
}

TEST(Algoritmo, RunsToTheEndAsTheLoopOnOneThread) {
    const Configuracion configuration = ready_tour();
    Algoritmo algoritmo(configuration, open_source(configuration.source));
    EXPECT_EQ(algoritmo.progress().state, State::ready);
    algoritmo.run();
    algoritmo.wait();
    const Progress progress = algoritmo.progress();
    EXPECT_EQ(progress.state, State::finished);
    EXPECT_EQ(progress.steps, 1050U);
    EXPECT_EQ(progress.fraction, 1.0);
    EXPECT_EQ(progress.lines + progress.corners, 16);
    EXPECT_EQ(path_of(algoritmo), expected_path(1 << 20));
}

TEST(Algoritmo, StepsPausesAndGoesOn) {
    const Configuracion configuration = ready_tour();
    Algoritmo algoritmo(configuration, open_source(configuration.source));
    algoritmo.run(1);
    algoritmo.wait();
    EXPECT_EQ(algoritmo.progress().steps, 1U);
    EXPECT_EQ(algoritmo.progress().state, State::paused);
    algoritmo.run(9);
    algoritmo.wait();
    EXPECT_EQ(algoritmo.progress().steps, 10U);
    algoritmo.run();
    while (algoritmo.progress().steps < 50) std::this_thread::yield();
    algoritmo.pause();
    algoritmo.wait();
    const auto paused_at = algoritmo.progress().steps;
    EXPECT_GE(paused_at, 50U);
    EXPECT_LT(paused_at, 1050U);
    EXPECT_EQ(algoritmo.progress().state, State::paused);
    algoritmo.run();
    algoritmo.wait();
    // Interruptions change nothing.
    EXPECT_EQ(path_of(algoritmo), expected_path(1 << 20));
}

TEST(Algoritmo, RestartsFromAnyState) {
    const Configuracion configuration = ready_tour();
    Algoritmo algoritmo(configuration, open_source(configuration.source));
    algoritmo.run();
    algoritmo.restart();  // while it runs
    algoritmo.wait();
    EXPECT_EQ(algoritmo.progress().state, State::ready);
    EXPECT_EQ(algoritmo.progress().steps, 0U);
    algoritmo.run(30);
    algoritmo.wait();
    EXPECT_EQ(path_of(algoritmo), expected_path(30));
    algoritmo.run();
    algoritmo.wait();
    algoritmo.run();  // at the end: nothing
    algoritmo.wait();
    EXPECT_EQ(algoritmo.progress().state, State::finished);
    algoritmo.restart();
    algoritmo.run(5);  // right behind the restart
    algoritmo.wait();
    EXPECT_EQ(algoritmo.progress().steps, 5U);
}

TEST(Algoritmo, SnapshotsAreOfOneStep) {
    const Configuracion configuration = ready_tour();
    Algoritmo algoritmo(configuration, open_source(configuration.source));
    EXPECT_EQ(algoritmo.latest_snapshot(), nullptr);
    algoritmo.run();
    std::uint64_t last = 0;
    for (int i = 0; i < 20; ++i) {
        algoritmo.request_snapshot();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        const auto snapshot = algoritmo.latest_snapshot();
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
    algoritmo.wait();
    EXPECT_EQ(algoritmo.latest_snapshot()->steps <= 1050, true);
    algoritmo.request_snapshot();  // nothing runs: it is made at once
    algoritmo.wait();
    EXPECT_EQ(algoritmo.latest_snapshot()->steps, 1050U);
    algoritmo.restart();
    algoritmo.wait();
    EXPECT_EQ(algoritmo.latest_snapshot(), nullptr);
}

TEST(Algoritmo, AFailureIsToldAndEndsTheRun) {
    const test::TempFolder folder;
    Configuracion configuration;
    configuration.source.file = folder.put("odometry.log", "ODOM 1 0.1 0\nODOM 2 0.1 0\n");
    Algoritmo algoritmo(configuration, open_source(configuration.source));
    algoritmo.run();
    algoritmo.wait();
    EXPECT_EQ(algoritmo.progress().state, State::failed);
    EXPECT_NE(algoritmo.progress().error.find("no readable scan"), std::string::npos);
    // A source that has gone meanwhile: restarting fails, and says so.
    std::filesystem::remove(configuration.source.file);
    algoritmo.restart();
    algoritmo.wait();
    EXPECT_EQ(algoritmo.progress().state, State::failed);
    EXPECT_FALSE(algoritmo.progress().error.empty());
}

TEST(Algoritmo, ExceptionsOfTasksReachTheCaller) {
    const Configuracion configuration = ready_tour();
    Algoritmo algoritmo(configuration, open_source(configuration.source));
    auto future = algoritmo.with_run([](const SlamRun& run) -> int {
        if (run.steps() == 0) throw std::runtime_error("nothing yet");
        return 1;
    });
    EXPECT_THROW(future.get(), std::runtime_error);
}

TEST(Algoritmo, EndsWhileRunning) {
    const Configuracion configuration = ready_tour();
    for (int i = 0; i < 5; ++i) {
        Algoritmo algoritmo(configuration, open_source(configuration.source));
        algoritmo.run();
        algoritmo.request_snapshot();
        std::this_thread::sleep_for(std::chrono::milliseconds(i));
    }
}

}  // namespace
}  // namespace hitos
