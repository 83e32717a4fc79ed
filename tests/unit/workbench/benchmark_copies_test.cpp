// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of a benchmark that map perturbed copies of a log.
#include <gmock/gmock.h>

#include <filesystem>
#include <string>

#include "hitos/base/error.hpp"
#include "hitos/workbench/benchmark.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::message_of;
using ::testing::HasSubstr;

class BenchmarkCopies : public ::testing::Test {
  protected:
    BenchmarkPlan plan(const std::string& tour) const {
        return read_benchmark_plan(folder_.put(
            "plan.toml",
            "runs = 3\n[[tour]]\n" + tour + "\n[[algorithm]]\nname = \"EKF\"\npreset = \"ekf\"\n"));
    }
    /// EKF-SLAM draws nothing at random where its lines are not: what differs is the tour.
    Spread error(const std::string& copies, const char* out) const {
        BenchmarkOptions options;
        options.out = folder_ / out;
        options.pictures = false;
        const BenchmarkTable table = run_benchmark(plan(tour_ + copies), options);
        const BenchmarkRow& row = table.rows.at(0);
        EXPECT_EQ(row.runs, 3) << row.problem;
        return row.figures["trajectory_error_m"].value();
    }

    const test::TempFolder folder_;
    const std::string logs_ = std::string(HITOS_SOURCE_DIR) + "/data/logs/";
    const std::string tour_ = "file = \"" + logs_ + "carmen-flaser.log.gz\"\ntrajectory = \"" +
                              folder_
                                  .put("path.tum",
                                       [] {
                                           std::string path;
                                           for (int i = 0; i < 60; ++i)
                                               path += std::to_string(0.2 * i) + " " +
                                                       std::to_string(0.01 * i * i) +
                                                       " 0 0 0 0 0 1\n";
                                           return path;
                                       }())
                                  .string() +
                              "\"\nset = [\"features.method=split-merge\"]\n";
};

TEST_F(BenchmarkCopies, AreTheRunsToursInTurn) {
    const Spread none = error("", "none");
    EXPECT_EQ(none.minimum, none.maximum);
    const Spread one = error("copies = 1\n", "one");
    EXPECT_EQ(one.minimum, one.maximum) << "every run has the same copy";
    EXPECT_NE(one.minimum, none.minimum);
    const Spread two = error("copies = 2\n", "two");
    EXPECT_LT(two.minimum, two.maximum);
    EXPECT_TRUE(two.minimum == one.minimum || two.maximum == one.minimum) << "of seed 1 the first";
    const double other = two.minimum == one.minimum ? two.maximum : two.minimum;
    EXPECT_NEAR(two.mean, (2.0 * one.minimum + other) / 3.0, 1e-12) << "and of seed 3";
    EXPECT_EQ(error("copies = 1\n", "two").mean, one.mean) << "nothing of two copies is used again";
}

TEST_F(BenchmarkCopies, AreOfLogsThatArePathsAlone) {
    const auto refusal = [&](const std::string& tour) {
        return message_of<FormatError>([&] { plan(tour); });
    };
    EXPECT_THAT(refusal("file = \"recinto\"\ncopies = 2"), HasSubstr("0 of a world"));
    EXPECT_THAT(refusal("file = \"a.log\"\nmap = \"a.map\"\ncopies = 2"), HasSubstr("copies"));
    EXPECT_THAT(refusal("file = \"a.log\"\ncopies = -1"), HasSubstr("from 0 to 100"));
    EXPECT_EQ(plan("file = \"a.log\"\ncopies = 4").tours[0].copies, 4);
}

}  // namespace
}  // namespace hitos
