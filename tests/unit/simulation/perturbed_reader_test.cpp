// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/drive/perturbed_reader.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/odometry_track.hpp"
#include "hitos/capture/procesador.hpp"
#include "hitos/capture/recorded_tour.hpp"
#include "hitos/simulation/drive/simulated_tour_reader.hpp"
#include "unit/capture/test_files.hpp"
#include "worlds.hpp"

namespace hitos {
namespace {

using test::Log;
using test::read_all;

std::unique_ptr<TourReader> plain() {
    return std::make_unique<Procesador>(
        open_log(std::string(HITOS_SOURCE_DIR) + "/data/bigloop.log.gz"));
}

std::unique_ptr<TourReader> copy(std::uint64_t number) {
    return make_perturbed_reader(plain(), number);
}

/// The robot's way from scan to scan, by the odometry.
std::vector<Pose> steps_of(const Log& log, std::size_t from) {
    std::size_t next = 0;
    OdometryTrack track([&]() -> std::optional<Odometria> {
        return next < log.odometry.size() ? std::optional(log.odometry[next++]) : std::nullopt;
    });
    std::vector<Pose> steps;
    std::optional<Pose> last;
    for (std::size_t i = from; i < log.scans.size(); ++i) {
        const Pose pose = track.at(log.scans[i].time_s);
        if (last) steps.push_back(between(*last, pose));
        last = pose;
    }
    return steps;
}

double root_mean_square(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value * value;
    return std::sqrt(sum / static_cast<double>(values.size()));
}

TEST(PerturbedReader, LeavesOutTheFirstScansAndTheOdometryBefore) {
    const Log all = read_all(*plain());
    const Log second = read_all(*copy(2));
    ASSERT_EQ(second.scans.size(), all.scans.size() - 6);
    const double begin_s = all.scans[6].time_s;
    EXPECT_EQ(second.scans.front().time_s, begin_s);
    EXPECT_LE(second.odometry.front().time_s, begin_s);
    EXPECT_GT(second.odometry[1].time_s, begin_s);
    EXPECT_EQ(second.odometry.front().twist, Twist());
    EXPECT_EQ(second.odometry.back().time_s, all.odometry.back().time_s);
}

TEST(PerturbedReader, ATourThatIsTooShortForACopyIsToldSo) {
    const std::size_t scans = read_all(*plain()).scans.size();
    try {
        copy((scans + 2) / 3)->next_scan();
        ADD_FAILURE() << "a copy of no scan";
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr("too short for copy"));
    }
    EXPECT_TRUE(copy((scans - 1) / 3)->next_scan());
}

TEST(PerturbedReader, DoesNotKnowATruthOfAFrameThatIsLeftOut) {
    const auto tour = std::make_shared<const SimulatedTour>(test::small_world());
    ASSERT_TRUE(SimulatedTourReader(tour).truth());
    EXPECT_FALSE(make_perturbed_reader(std::make_unique<SimulatedTourReader>(tour), 1)->truth());
}

TEST(PerturbedReader, AddsTenMillimetresToRangesAsTheLaserSeesThem) {
    // In the second one the laser sits 0.2 m ahead of the robot's centre.
    for (const char* name : {"/data/bigloop.log.gz", "/data/logs/carmen-robotlaser.log.gz"}) {
        const auto open = [&] {
            return std::make_unique<Procesador>(open_log(std::string(HITOS_SOURCE_DIR) + name));
        };
        const Log all = read_all(*open());
        const Log first = read_all(*make_perturbed_reader(open(), 1));
        const Pose laser = first.scans.front().fan.pose_robot_laser;
        const auto angle = [&](const Point2& p) {
            return std::atan2(p.y - laser.y, p.x - laser.x);
        };
        const auto range = [&](const Point2& p) {
            return std::hypot(p.x - laser.x, p.y - laser.y);
        };
        std::vector<double> errors;
        for (std::size_t i = 0; i < first.scans.size(); ++i) {
            const std::vector<Point2>& truth = all.scans[i + 3].points;
            const std::vector<Point2>& points = first.scans[i].points;
            ASSERT_EQ(points.size(), truth.size()) << name;
            for (std::size_t k = 0; k < points.size(); ++k) {
                errors.push_back(range(points[k]) - range(truth[k]));
                ASSERT_NEAR(std::remainder(angle(points[k]) - angle(truth[k]), 2.0 * kPi), 0.0,
                            1e-9)
                    << name;
            }
        }
        EXPECT_NEAR(root_mean_square(errors), 0.01, 3e-4) << name;
    }
}

TEST(PerturbedReader, LeavesNoReadingOnTheLaser) {
    const test::TempFolder folder;
    std::string text = "ODOM 0 0 0 0 0 0 0 h 0\n";
    for (int k = 0; k < 60; ++k)
        text += fmt::format("FLASER 2 0.022 2 0 0 0 0 0 0 {} h {}\n", k, k);
    const auto log = folder.put("near.log", text);
    const Log near =
        read_all(*make_perturbed_reader(std::make_unique<Procesador>(open_log(log.string())), 1));
    double nearest = 1.0;
    for (const Scan& scan : near.scans)
        nearest = std::min(nearest, std::hypot(scan.points.at(0).x, scan.points.at(0).y));
    EXPECT_NEAR(nearest, 0.02, 1e-12);  // of which a half would lie nearer
}

TEST(PerturbedReader, ScalesAndTurnsTheSteps) {
    const std::vector<Pose> truth = steps_of(read_all(*plain()), 3);
    const std::vector<Pose> steps = steps_of(read_all(*copy(1)), 0);
    ASSERT_EQ(steps.size(), truth.size());
    std::vector<double> scales;
    std::vector<double> turns;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const double length = std::hypot(truth[i].x, truth[i].y);
        if (length < 0.05 || std::abs(truth[i].theta) > 0.01) continue;
        scales.push_back(std::hypot(steps[i].x, steps[i].y) / length - 1.0);
        turns.push_back(steps[i].theta - truth[i].theta);
    }
    ASSERT_GT(scales.size(), 300U);
    EXPECT_NEAR(root_mean_square(scales), 0.03, 0.003);
    EXPECT_NEAR(root_mean_square(turns), 0.003, 0.0003);
}

TEST(PerturbedReader, OfARobotAtRestTheStepsStayWhatTheyAre) {
    const test::TempFolder folder;
    const auto log = folder.put("a.log",
                                "ODOM 0 0 0 0 0 0 0 h 0\nFLASER 2 1 2 0 0 0 0 0 0 0 h 0\n"
                                "FLASER 2 1 2 0 0 0 0 0 0 1 h 1\nFLASER 2 1 2 0 0 0 0 0 0 2 h 2\n"
                                "FLASER 2 1 2 0 0 0 0 0 0 3 h 3\nFLASER 2 1 2 0 0 0 0 0 0 4 h 4\n");
    const Log rest =
        read_all(*make_perturbed_reader(std::make_unique<Procesador>(open_log(log.string())), 1));
    EXPECT_EQ(rest.scans.size(), 2U);
    for (const Odometria& reading : rest.odometry) EXPECT_EQ(reading.twist, Twist());
}

TEST(PerturbedReader, ACopyIsTheSameEveryTimeAndAnotherOneIsNot) {
    const auto reader = copy(1);
    const Log first = read_all(*reader);
    reader->restart();
    const Log again = read_all(*reader);
    EXPECT_EQ(again.scans, first.scans);
    EXPECT_EQ(again.odometry, first.odometry);
    EXPECT_EQ(read_all(*reader->reopen()).odometry, first.odometry);
    // As studies share it between runs.
    RecordedReader recorded(record_tour(*reader, [](std::size_t) { return true; }));
    const Log shared = read_all(recorded);
    EXPECT_EQ(shared.scans, first.scans);
    EXPECT_EQ(shared.odometry, first.odometry);
    const Log other = read_all(*copy(2));
    EXPECT_NE(other.scans.back().points, first.scans.back().points);
    const auto twist = [](const Log& log) { return log.odometry[log.odometry.size() - 500].twist; };
    EXPECT_NE(twist(other), twist(first));
}

}  // namespace
}  // namespace hitos
