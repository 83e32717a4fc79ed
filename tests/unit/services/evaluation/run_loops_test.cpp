// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/run_loops.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hitos {
namespace {

using testing::HasSubstr;

LoopRecord record(std::uint64_t scan, std::uint64_t earlier, const Pose& pose,
                  LoopVerdict verdict = LoopVerdict::closed) {
    LoopRecord record;
    record.scan = scan;
    record.earlier = earlier;
    record.pose_earlier_scan = pose;
    record.verdict = verdict;
    return record;
}

/// A metre a scan along x, a second apart.
Trajectory straight(std::size_t scans) {
    Trajectory path;
    for (std::size_t i = 0; i < scans; ++i)
        path.push_back({static_cast<double>(i), {static_cast<double>(i), 0.0, 0.0}});
    return path;
}

TEST(RunLoops, AreAllInTheOrderOfTheScans) {
    const std::vector<LoopRecord> closed{record(4, 1, {}), record(8, 2, {})};
    const std::vector<LoopRecord> refused{record(3, 0, {}, LoopVerdict::alone),
                                          record(6, 2, {}, LoopVerdict::bare)};
    const auto loops = run_loops(closed, refused, straight(9));
    std::vector<std::uint64_t> scans;
    for (const RunLoop& loop : loops) scans.push_back(loop.record.scan);
    EXPECT_THAT(scans, testing::ElementsAre(3, 4, 6, 8));
    EXPECT_EQ(loops[1].scan.pose.x, 4.0);
    EXPECT_EQ(loops[1].earlier.time_s, 1.0);
    EXPECT_TRUE(loops[1].closed());
    EXPECT_FALSE(loops[2].closed());
}

TEST(RunLoops, OnlyThoseTheReferenceTellsOfAreJudged) {
    // As the reference has it the later scan lies 3 m ahead of the earlier one.
    auto loops = run_loops(
        std::vector<LoopRecord>{record(4, 1, {3.1, 0.0, 0.0}), record(5, 2, {3.0, 1.5, 0.0}),
                                record(8, 5, {0.0, 0.0, 0.0})},
        std::vector<LoopRecord>{record(3, 0, {9.0, 0.0, 0.0}, LoopVerdict::strained)}, straight(9));
    Trajectory reference = straight(7);
    judge_loops(loops, reference, 0.02);
    EXPECT_FALSE(loops[1].error_m) << "without headings it tells nothing";
    reference[6].pose.theta = 1e-9;
    std::swap(reference[1], reference[5]);  // in whatever order it stands
    judge_loops(loops, reference, 0.02);
    EXPECT_NEAR(loops[0].error_m.value(), 6.0, 1e-12);
    EXPECT_NEAR(loops[1].error_m.value(), 0.1, 1e-12);
    EXPECT_NEAR(loops[2].error_m.value(), 1.5, 1e-12);
    EXPECT_FALSE(loops[3].error_m);
    const LoopPrecision precision = precision_of(loops);
    EXPECT_EQ(precision.judged, 2U);  // the refused one is none
    EXPECT_EQ(precision.wrong, 1U);
    EXPECT_NEAR(loops[1].error_rad.value(), 0.0, 1e-12);
    EXPECT_NEAR(precision.worst_m, 1.5, 1e-12);
    judge_loops(loops, {}, 0.02);
    EXPECT_EQ(precision_of(loops).judged, 0U);
}

TEST(RunLoops, AreRowsWithWhatThereIs) {
    LoopRecord strained = record(4, 1, {0.5, -0.25, 0.125}, LoopVerdict::strained);
    strained.chi_square = 91.4;
    strained.chi_square_limit = 33.0;
    const std::string csv = loops_csv(run_loops({}, std::vector{strained}, straight(5)));
    EXPECT_EQ(csv.substr(0, csv.find(',')), "scan");
    const std::string row = csv.substr(csv.find('\n') + 1);
    EXPECT_THAT(row, HasSubstr("5,2,strained,4.000000,1.000000,4.000000,0.000000,1.000000,0.000000,"
                               "0.500000,-0.250000,0.125000,"));
    EXPECT_THAT(row, HasSubstr(",,91.400000,33.000000,,,,,,\"the graph would be bent"));
    EXPECT_THAT(row, HasSubstr("chi-square 91, and at most 33 is allowed"));
}

TEST(LoopVerdicts, AreReadAsWritten) {
    for (int i = 0; i <= static_cast<int>(LoopVerdict::unlike); ++i) {
        const auto verdict = static_cast<LoopVerdict>(i);
        EXPECT_EQ(verdict_of(word_of(verdict)), verdict);
        EXPECT_FALSE(reason_of(record(1, 0, {}, verdict)).english().empty());
    }
    EXPECT_ANY_THROW(verdict_of("open"));
}

TEST(LoopVerdicts, TellWhatIsBeyondALimitFromTheLimit) {
    LoopRecord loop = record(1, 0, {}, LoopVerdict::poor_fit);
    loop.score = 0.495564;
    EXPECT_THAT(reason_of(loop).english(), HasSubstr("a score of 0.496, and more than 0.5"));
    loop.verdict = LoopVerdict::seen_through;
    loop.seen_through = 0.3004;
    EXPECT_THAT(reason_of(loop).english(), HasSubstr("30.04 % of what the other saw, and at most "
                                                     "30 % is allowed"));
    loop.verdict = LoopVerdict::strained;
    loop.chi_square = 33.2;
    loop.chi_square_limit = 33.0;
    EXPECT_THAT(reason_of(loop).english(), HasSubstr("chi-square 33.2, and at most 33 is"));
}

}  // namespace
}  // namespace hitos
