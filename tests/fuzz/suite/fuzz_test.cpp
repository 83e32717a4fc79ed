// SPDX-License-Identifier: GPL-3.0-or-later
// Thousands of damaged lines with a fixed seed: each costs at most itself, and is accounted for.
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "mutator.hpp"
#include "tour_laws.hpp"
#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

using test::Log;
using test::TempDir;

struct Sample {
    std::string_view format;
    std::vector<std::string> lines;
};

std::ostream& operator<<(std::ostream& out, const Sample& sample) {
    return out << sample.format;
}

std::vector<Sample> samples() {
    return {
        {"player",
         {"0.1 16777343 6665 laser 00 004 001 +0.1 +0.0 0.0 0.1 0.1",
          "0.1 16777343 6665 position2d 00 001 001 +00.000 +00.000 +0.000 +00.1 +00.0 +00.0 0",
          "0.2 16777343 6665 laser 00 001 001 0000 -1.5708 +1.5708 +0.01 +8.0 0002 1.0  1 2.0  1",
          "0.3 16777343 6665 position2d 00 001 001 +00.100 +00.000 +0.010 +00.1 +00.0 +00.0 0",
          "0.4 16777343 6665 laser 00 001 003 0000 +8.0 0003 1.0 -0.5  1 8.0 0.0  0 2.0 0.5  1",
          "0.4 16777343 6665 sonar 00 001 001 4 4 4", "## comment",
          "0.5 16777343 6665 ranger 00 001 001 0003 1.0 2.0 3.0"}},
        {"radish",
         {"position 0 1.0 0.0 0.0 0.0 0.1 0.0 0.0", "laser 0 1.1 1.0 -0.5 0 2.0 0.0 0 81.91 0.5 0",
          "position 0 1.2 0.1 0.0 0.0 0.1 0.0 0.0", "laser 0 1.3 1.5 -0.5 0 2.0 0.1 0 3.0 0.5 0"}},
        {"normalized",
         {"ODOM 1.0 0.5 0.1", "LASER 1.0 3 1 2 0 0 3 4", "ODOM 1.1 0.5 0.1 0.01",
          "LASER 1.1 2 1.5 2.5 nan 4"}},
        {"carmen",
         {"PARAM robot_front_laser_max 20.0 h 0", "ODOM 0 0 0 0 0 0 1.0 h 1.0",
          "FLASER 3 1.0 81.9 2.0 0 0 0 0.1 0 0 1.1 h 1.1",
          "ROBOTLASER1 0 -1.5 3.0 1.5 20.0 0.01 0 3 1 2 3 1 7 0.2 0 0 0.2 0 0 0 0 0 0 0 1.3 h 1.3",
          "RAWLASER1 0 -1.5 3.0 1.5 20.0 0.01 0 3 1 2 3 0 1.3 h 1.3",
          "ODOM 0.2 0 0 0 0 0 1.4 h 1.4"}}};
}

void check_values(const Log& log) {
    fuzz::require_sound({log.scans, log.odometry, log.report});
}

class Fuzz : public ::testing::TestWithParam<Sample> {};

TEST_P(Fuzz, OneDamagedLineCostsThatLineAtMost) {
    const Sample& sample = GetParam();
    const TempDir folder;
    std::string good;
    for (const std::string& line : sample.lines) good += line + "\n";
    const Log whole = test::read_log(folder.put("good", good), sample.format);
    ASSERT_GE(whole.scans.size(), 1U);
    test::Mutator mutator;
    std::uint64_t skipped = 0;
    for (int round = 0; round < 3000; ++round) {
        const std::string bad = mutator.mutate_line(mutator.one_of(sample.lines));
        const Log log = test::read_log(folder.put("bad", good + bad + "\n"), sample.format);
        SCOPED_TRACE(bad);
        check_values(log);
        const ReadReport& a = whole.report;
        const ReadReport& b = log.report;
        ASSERT_EQ(b.scans, log.scans.size());
        ASSERT_EQ(b.odometry, log.odometry.size());
        const std::uint64_t more_skipped = b.skipped - a.skipped;
        const std::uint64_t more_scans = b.scans + b.duplicate_scans - a.scans - a.duplicate_scans;
        const std::uint64_t more_odometry = b.odometry - a.odometry;
        ASSERT_LE(more_skipped, 1U);
        ASSERT_LE(more_scans, 1U);
        ASSERT_LE(more_odometry, 1U);
        // Either it is damage, or it gives what it says.
        if (more_skipped == 1) {
            ASSERT_EQ(more_scans + more_odometry, 0U);
        }
        skipped += more_skipped;
    }
    EXPECT_GT(skipped, 500U);
    EXPECT_LT(skipped, 2900U);
}

INSTANTIATE_TEST_SUITE_P(Formats, Fuzz, ::testing::ValuesIn(samples()),
                         [](const auto& value) { return std::string(value.param.format); });

}  // namespace
}  // namespace hitos
