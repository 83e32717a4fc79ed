// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/run/run_worker.hpp"

#include <gtest/gtest.h>

#include "hitos/base/error.hpp"
#include "hitos/capture/file_growth.hpp"
#include "ready_tour.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::expected_path;
using test::path_of;
using test::small_tour;
using State = Progress::State;

/// Lets a tour's scans through one by one.
class Gate {
  public:
    void allow(std::uint64_t scans) {
        const std::scoped_lock lock(mutex_);
        allowed_ += scans;
        changed_.notify_all();
    }
    void open() { allow(std::uint64_t{1} << 62U); }
    /// The number of the scan that is handed out, from 0 on, once it may be.
    std::uint64_t pass() {
        std::unique_lock lock(mutex_);
        ++asked_;
        changed_.notify_all();
        changed_.wait(lock, [this] { return given_ < allowed_; });
        return given_++;
    }
    void wait_until_asked_for(std::uint64_t scans) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return asked_ >= scans; });
    }
    std::uint64_t given() const {
        const std::scoped_lock lock(mutex_);
        return given_;
    }

  private:
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::uint64_t allowed_ = 0;
    std::uint64_t asked_ = 0;
    std::uint64_t given_ = 0;
};

/// A tour of empty scans without end, as fast as its gate lets them through.
class GatedReader final : public TourReader {
  public:
    explicit GatedReader(std::shared_ptr<Gate> gate) : gate_(std::move(gate)) {}
    std::optional<Scan> next_scan() override {
        Scan scan;
        scan.time_s = static_cast<double>(gate_->pass());
        return scan;
    }
    std::optional<Odometria> next_odometry() override { return std::nullopt; }
    void restart() override {}
    std::unique_ptr<TourReader> reopen() const override {
        return std::make_unique<GatedReader>(gate_);
    }
    const ReadReport& report() const override { return report_; }
    std::optional<double> progress() const override { return std::nullopt; }
    std::string name() const override { return "gate"; }
    std::string format() const override { return "world"; }
    ReadOptions options() const override { return {}; }

  private:
    std::shared_ptr<Gate> gate_;
    ReadReport report_;
};

/// A scan for every byte of a file that grows; odometry up to the one that is awaited.
class GrowingReader final : public TourReader {
  public:
    GrowingReader(std::shared_ptr<FileGrowth> growth, std::uint64_t readings)
        : growth_(std::move(growth)), readings_(readings) {}
    std::optional<Scan> next_scan() override {
        if (!growth_->wait_beyond(scans_)) return std::nullopt;
        Scan scan;
        scan.time_s = static_cast<double>(scans_++);
        return scan;
    }
    std::optional<Odometria> next_odometry() override {
        constexpr std::uint64_t kNever = 1000;
        if (told_ == readings_) {
            growth_->wait_beyond(kNever);
            return std::nullopt;
        }
        Odometria reading;
        reading.time_s = static_cast<double>(told_++);
        return reading;
    }
    void restart() override {}
    std::unique_ptr<TourReader> reopen() const override {
        return std::make_unique<GrowingReader>(growth_, readings_);
    }
    const ReadReport& report() const override { return report_; }
    std::optional<double> progress() const override { return std::nullopt; }
    std::string name() const override { return "growing"; }
    std::string format() const override { return "world"; }
    ReadOptions options() const override { return {}; }

  private:
    std::shared_ptr<FileGrowth> growth_;
    std::uint64_t readings_;
    std::uint64_t scans_ = 0;
    std::uint64_t told_ = 0;
    ReadReport report_;
};

/// Asked between two steps, on the worker's own thread.
std::uint64_t steps_of(RunWorker& worker) {
    return worker.with_run([](const Algoritmo& run) { return run.steps(); }).get();
}

TEST(RunWorker, RunsToTheEndAsTheLoopOnOneThread) {
    const Configuracion configuration = small_tour();
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

TEST(RunWorker, RunsInPartsAsInOneGo) {
    const Configuracion configuration = small_tour();
    RunWorker worker(configuration, open_source(configuration.source));
    worker.run(1);
    worker.wait();
    EXPECT_EQ(worker.progress().steps, 1U);
    EXPECT_EQ(worker.progress().state, State::paused);
    worker.run(9);
    worker.wait();
    EXPECT_EQ(worker.progress().steps, 10U);
    EXPECT_EQ(path_of(worker), expected_path(10));
    worker.run();
    worker.wait();
    EXPECT_EQ(path_of(worker), expected_path(1 << 20));
}

TEST(RunWorker, APauseEndsWithTheStepUnderWay) {
    const auto gate = std::make_shared<Gate>();
    RunWorker worker({}, std::make_unique<GatedReader>(gate));
    worker.run();
    gate->allow(3);
    gate->wait_until_asked_for(4);
    EXPECT_EQ(worker.progress().steps, 3U);
    worker.pause();
    EXPECT_EQ(worker.progress().state, State::running);  // the fourth step is under way
    worker.wait_for(std::chrono::milliseconds(0));       // does not wait for its end
    EXPECT_EQ(worker.progress().steps, 3U);
    gate->allow(100);
    worker.wait();
    EXPECT_EQ(worker.progress().state, State::paused);
    // Once round the worker's loop: where it still wanted to step, it would have.
    for (int i = 0; i < 3; ++i) EXPECT_EQ(steps_of(worker), 4U);
    EXPECT_EQ(worker.progress().steps, 4U);
    EXPECT_EQ(gate->given(), 4U);
    worker.run(2);
    worker.wait();
    EXPECT_EQ(gate->given(), 6U);
}

/// Nobody has to wait for the robot to see where it stands.
TEST(RunWorker, AStepThatWaitsForATourToComeShowsTheStateBeforeIt) {
    const test::TempFolder folder;
    for (const std::uint64_t readings : {std::uint64_t{1000}, std::uint64_t{4}}) {
        Configuracion configuration;
        configuration.source.read.growth =
            std::make_shared<FileGrowth>(folder.put("scans", "12345"));
        const auto growth = configuration.source.read.growth;
        RunWorker worker(configuration, std::make_unique<GrowingReader>(growth, readings));
        worker.run();
        const std::uint64_t scans = readings > 5 ? 5 : 4;  // the fifth waits for its odometry
        std::shared_ptr<const Snapshot> shown;
        while (!shown || shown->steps < scans) {
            worker.request_snapshot();
            shown = worker.latest_snapshot();
        }
        EXPECT_EQ(shown->steps, scans);
        EXPECT_EQ(shown->scan.time_s, static_cast<double>(scans - 1));
        EXPECT_EQ(shown->best_trajectory.size(), scans);
        EXPECT_FALSE(shown->grid_behind);
        growth->end();
        worker.wait();
        EXPECT_EQ(worker.progress().state, State::finished);
        EXPECT_EQ(worker.progress().steps, 5U);
    }
}

TEST(RunWorker, ARestartForgetsTheStepUnderWay) {
    const auto gate = std::make_shared<Gate>();
    RunWorker worker({}, std::make_unique<GatedReader>(gate));
    worker.run();
    gate->allow(3);
    gate->wait_until_asked_for(4);
    worker.restart();
    EXPECT_EQ(worker.progress().state, State::ready);
    gate->allow(100);
    worker.wait();
    EXPECT_EQ(worker.progress().state, State::ready);
    EXPECT_EQ(worker.progress().steps, 0U);
    EXPECT_TRUE(worker.figures_since(0).empty());
    EXPECT_EQ(steps_of(worker), 0U);
    EXPECT_EQ(gate->given(), 4U);
    worker.run(5);
    worker.wait();
    EXPECT_EQ(worker.progress().steps, 5U);
    EXPECT_EQ(worker.figures_since(0).size(), 5U);
    EXPECT_EQ(worker.figures_since(3).size(), 2U);
}

TEST(RunWorker, RestartsFromTheMiddleAndFromTheEnd) {
    const Configuracion configuration = small_tour();
    RunWorker worker(configuration, open_source(configuration.source));
    worker.run(40);
    worker.wait();
    worker.restart();
    worker.run(30);  // right behind the restart
    worker.wait();
    EXPECT_EQ(path_of(worker), expected_path(30));
    worker.run();
    worker.wait();
    worker.run();  // at the end: nothing
    worker.wait();
    EXPECT_EQ(worker.progress().state, State::finished);
    worker.restart();
    worker.wait();
    EXPECT_EQ(worker.progress().state, State::ready);
    EXPECT_EQ(worker.progress().steps, 0U);
}

TEST(RunWorker, ASnapshotAskedForDuringAStepIsOfItsEnd) {
    const auto gate = std::make_shared<Gate>();
    RunWorker worker({}, std::make_unique<GatedReader>(gate));
    worker.run();
    gate->allow(3);
    gate->wait_until_asked_for(4);
    EXPECT_EQ(worker.latest_snapshot(), nullptr);
    worker.request_snapshot();
    gate->allow(1);
    gate->wait_until_asked_for(5);  // the run goes on behind it
    ASSERT_NE(worker.latest_snapshot(), nullptr);
    EXPECT_EQ(worker.latest_snapshot()->steps, 4U);
    worker.pause();
    gate->allow(1);
    worker.wait();
    EXPECT_EQ(worker.latest_snapshot()->steps, 4U);  // nobody has asked for another
}

TEST(RunWorker, SnapshotsAreOfOneStep) {
    const Configuracion configuration = small_tour();
    RunWorker worker(configuration, open_source(configuration.source));
    for (const std::uint64_t steps : {30U, 60U}) {
        worker.run(30);
        worker.request_snapshot();
        worker.wait();
        worker.request_snapshot();  // nothing runs: it is made at once
        worker.wait();
        const auto snapshot = worker.latest_snapshot();
        ASSERT_NE(snapshot, nullptr);
        EXPECT_EQ(snapshot->steps, steps);
        EXPECT_EQ(snapshot->best_trajectory.size(), steps);
        EXPECT_EQ(snapshot->odometry_trajectory.size(), steps);
        EXPECT_EQ(snapshot->hypotheses.size(), 20U);
        EXPECT_EQ(snapshot->best_pose, snapshot->best_trajectory.back().pose);
        EXPECT_EQ(snapshot->best_trajectory, expected_path(static_cast<int>(steps)));
        EXPECT_FALSE(snapshot->best_map.empty());
        EXPECT_EQ(snapshot->associations.size(),
                  snapshot->observation.lines.size() + snapshot->observation.corners.size());
    }
    worker.restart();
    worker.wait();
    EXPECT_EQ(worker.latest_snapshot(), nullptr);
}

TEST(RunWorker, TheJointCovarianceIsMadeWhereItIsAskedFor) {
    for (const char* algorithm : {"ekf-slam", "fastslam"}) {
        Configuracion configuration = small_tour();
        configuration.filter.algorithm = algorithm;
        RunWorker worker(configuration, open_source(configuration.source));
        worker.run(200);
        worker.wait();
        const auto ask = [&](const SnapshotParts& parts) {
            worker.request_snapshot(parts);
            worker.wait();
            return worker.latest_snapshot();
        };
        EXPECT_EQ(ask({})->joint_covariance.size(), 0);
        const auto snapshot = ask({.particle = {}, .ancestry = false, .joint_covariance = true});
        EXPECT_GT(snapshot->pose_covariance.trace(), 0.0);
        if (algorithm == std::string("ekf-slam")) {
            ASSERT_EQ(snapshot->joint_covariance.rows(),
                      3 + 2 * static_cast<Eigen::Index>(snapshot->best_map.size()));
            const Eigen::Matrix3d pose = snapshot->joint_covariance.topLeftCorner<3, 3>();
            EXPECT_EQ(pose, snapshot->pose_covariance);
        } else {
            EXPECT_EQ(snapshot->joint_covariance.size(), 0);
        }
    }
}

TEST(RunWorker, AFailureIsToldAndEndsTheRun) {
    const test::TempFolder folder;
    Configuracion configuration;
    configuration.source.file = folder.put("odometry.log", "ODOM 1 0.1 0\nODOM 2 0.1 0\n");
    RunWorker worker(configuration, open_source(configuration.source));
    worker.run();
    worker.wait();
    EXPECT_EQ(worker.progress().state, State::failed);
    EXPECT_NE(worker.progress().error.english().find("no readable scan"), std::string::npos);
    // Whoever asks gets it with its type and place, as often as he likes.
    for (int i = 0; i < 2; ++i) {
        try {
            std::rethrow_exception(worker.progress().failure);
        } catch (const FormatError& error) {
            EXPECT_EQ(error.path(), configuration.source.file);
        }
    }
    // A source that has gone meanwhile: restarting fails, and says so.
    std::filesystem::remove(configuration.source.file);
    worker.restart();
    worker.wait();
    EXPECT_EQ(worker.progress().state, State::failed);
    EXPECT_FALSE(worker.progress().error.empty());
}

TEST(RunWorker, ExceptionsOfTasksReachTheCaller) {
    const Configuracion configuration = small_tour();
    RunWorker worker(configuration, open_source(configuration.source));
    auto future = worker.with_run([](const Algoritmo& run) -> int {
        if (run.steps() == 0) throw std::runtime_error("nothing yet");
        return 1;
    });
    EXPECT_THROW(future.get(), std::runtime_error);
}

TEST(RunWorker, ItsEndDoesNotWaitForTheTours) {
    // A tour that never ends: whoever waited for its end would wait here for ever.
    const auto gate = std::make_shared<Gate>();
    gate->open();
    {
        RunWorker worker({}, std::make_unique<GatedReader>(gate));
        worker.run();
        worker.request_snapshot();
        gate->wait_until_asked_for(3);
    }
    EXPECT_EQ(gate.use_count(), 1);  // the reader is gone, and with it whoever asks
    EXPECT_GE(gate->given(), 2U);
}

}  // namespace
}  // namespace hitos
