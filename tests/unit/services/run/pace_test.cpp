// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/run/pace.hpp"

#include <gtest/gtest.h>

#include <chrono>

#include "hitos/services/run/run_worker.hpp"
#include "ready_tour.hpp"

namespace hitos {
namespace {

using std::chrono::milliseconds;
using State = Progress::State;
using test::expected_path;
using test::path_of;
using test::small_tour;

constexpr Pacer::Clock::time_point kStart{std::chrono::hours(1)};

TEST(Pacer, SpacesScansEvenly) {
    Pacer pacer;
    pacer.set({Pace::Kind::scans, 10.0});
    EXPECT_EQ(pacer.next(5, 0.0, kStart), kStart);
    EXPECT_EQ(pacer.next(6, 0.0, kStart), kStart + milliseconds(100));
    // A step that took a while does not put off those behind it.
    EXPECT_EQ(pacer.next(7, 0.0, kStart + milliseconds(180)), kStart + milliseconds(200));
    EXPECT_EQ(pacer.next(9, 0.0, kStart + milliseconds(390)), kStart + milliseconds(400));
}

TEST(Pacer, FollowsTheStampsOfTheScans) {
    Pacer pacer;
    pacer.set({Pace::Kind::recorded, 4.0});
    EXPECT_EQ(pacer.next(1, 20.0, kStart), kStart);
    EXPECT_EQ(pacer.next(2, 20.8, kStart), kStart + milliseconds(200));
    EXPECT_EQ(pacer.next(3, 24.0, kStart + milliseconds(200)), kStart + milliseconds(1000));
}

TEST(Pacer, DoesNotWaitWhereTheRecordingPaused) {
    Pacer pacer;
    pacer.set({Pace::Kind::recorded, 1.0});
    EXPECT_EQ(pacer.next(1, 0.0, kStart), kStart);
    const auto after = kStart + Pacer::kLongestGap;
    EXPECT_EQ(pacer.next(2, 3600.0, kStart), after);
    EXPECT_EQ(pacer.next(3, 3601.0, after), after + milliseconds(1000));
    EXPECT_EQ(pacer.next(4, 1e18, after), after + Pacer::kLongestGap);
    // A stamp that lies before: at once.
    EXPECT_LE(pacer.next(5, -1e18, after), after + Pacer::kLongestGap);
}

TEST(Pacer, DoesNotMakeUpForWhatItFellBehind) {
    Pacer pacer;
    pacer.set({Pace::Kind::scans, 10.0});
    EXPECT_EQ(pacer.next(1, 0.0, kStart), kStart);
    const auto late = kStart + milliseconds(5000);
    EXPECT_EQ(pacer.next(2, 0.0, late), late);
    EXPECT_EQ(pacer.next(3, 0.0, late), late + milliseconds(100));
}

TEST(Pacer, BeginsAnewWithAnotherPace) {
    Pacer pacer;
    EXPECT_EQ(pacer.next(1, 0.0, kStart), kStart);
    EXPECT_EQ(pacer.next(2, 100.0, kStart), kStart);  // as fast as possible
    pacer.set({Pace::Kind::scans, 2.0});
    EXPECT_EQ(pacer.next(3, 0.0, kStart), kStart);
    EXPECT_EQ(pacer.next(4, 0.0, kStart), kStart + milliseconds(500));
    pacer.begin();
    EXPECT_EQ(pacer.next(5, 0.0, kStart), kStart);
}

class PacedRun : public testing::Test {
  protected:
    /// So slow that the second scan never comes.
    static constexpr Pace kSlowest{Pace::Kind::scans, 1e-6};

    void wait_for_steps(std::uint64_t steps) {
        while (worker_.progress().steps < steps) std::this_thread::yield();
    }

    Configuracion configuration_ = small_tour();
    RunWorker worker_{configuration_, open_source(configuration_.source)};
};

TEST_F(PacedRun, TheFirstScanComesAtOnceAndTheNextAtItsTime) {
    worker_.set_pace({Pace::Kind::scans, 100.0});
    const auto begin = std::chrono::steady_clock::now();
    worker_.run(11);
    worker_.wait();
    // Not sooner; how much later is the machine's affair.
    EXPECT_GE(std::chrono::steady_clock::now() - begin, milliseconds(99));
    EXPECT_TRUE(path_of(worker_) == expected_path(11));
}

TEST_F(PacedRun, WhileItWaitsItAnswersAndPauses) {
    worker_.set_pace(kSlowest);
    worker_.run();
    wait_for_steps(1);
    worker_.request_snapshot();
    EXPECT_EQ(path_of(worker_).size(), 1U);
    EXPECT_EQ(worker_.progress().state, State::running);
    worker_.pause();
    EXPECT_EQ(worker_.progress().state, State::paused);
    worker_.wait();
    ASSERT_NE(worker_.latest_snapshot(), nullptr);
    EXPECT_EQ(worker_.latest_snapshot()->steps, 1U);
}

TEST_F(PacedRun, AnotherPaceHoldsAtOnce) {
    worker_.set_pace(kSlowest);
    worker_.run();
    wait_for_steps(1);
    worker_.set_pace({});
    worker_.wait();
    EXPECT_EQ(worker_.progress().state, State::finished);
    EXPECT_TRUE(path_of(worker_) == expected_path(1 << 20));
}

TEST_F(PacedRun, SeekingWaitsForNothing) {
    worker_.set_pace(kSlowest);
    worker_.seek(30);
    worker_.wait();
    EXPECT_EQ(worker_.progress().steps, 30U);
}

TEST_F(PacedRun, EndsWhileItWaits) {
    worker_.set_pace(kSlowest);
    worker_.run();
    wait_for_steps(1);
}  // without hanging

}  // namespace
}  // namespace hitos
