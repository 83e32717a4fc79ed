// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/features/extractor.hpp"

#include <gtest/gtest.h>

#include <random>

#include "collinear_merge.hpp"
#include "extractors.hpp"
#include "hitos/base/error.hpp"
#include "hitos/features/line_methods.hpp"
#include "wall_scan.hpp"

namespace hitos {
namespace {

TEST(SplitAndMerge, FindsTheTwoWallsOfACornerAndTheCorner) {
    const Scan scan =
        scan_of({joined(wall({2.0, -2.0}, {2.0, 3.0}, 40), wall({2.0, 3.0}, {-3.0, 3.0}, 40))});
    ExtractionParams params;
    params.corner_distance_m = 0.13;  // the second wall's first point is 0.128 m from the corner
    const Observation seen = extract(params, scan);
    ASSERT_EQ(seen.lines.size(), 2U);
    expect_line(seen.lines[0], {2.0, 0.0}, 1e-9, 1e-9);
    expect_line(seen.lines[1], {3.0, kPi / 2}, 1e-9, 1e-9);
    // The halves are disjoint: the point of the split belongs to the first.
    EXPECT_EQ(seen.lines[0].count, 40U);
    EXPECT_EQ(seen.lines[1].count, 39U);
    ASSERT_EQ(seen.corners.size(), 1U);
    EXPECT_NEAR(seen.corners[0].x, 2.0, 1e-9);
    EXPECT_NEAR(seen.corners[0].y, 3.0, 1e-9);
    params.corner_angle_rad = 1.5;
    EXPECT_EQ(extract(params, scan).corners.size(), 1U);  // the walls are square to each other
    params.corner_distance_m = 0.12;
    EXPECT_TRUE(extract(params, scan).corners.empty());
}

TEST(SplitAndMerge, ABendIsACornerWhereItsAngleIsWideEnough) {
    // Walls that turn by 0.3 rad, towards the laser and away from it.
    for (const double turn : {0.3, -0.3}) {
        const Point2 bend{3.0, 0.0};
        const Scan scan =
            scan_of({joined(wall({3.0, -2.0}, bend, 60),
                            wall(bend, {3.0 + 2.0 * std::sin(turn), 2.0 * std::cos(turn)}, 60))});
        ExtractionParams params;
        for (const auto& [angle, corners] : {std::pair{0.0, 1U}, {0.29, 1U}, {0.31, 0U}}) {
            params.corner_angle_rad = angle;
            EXPECT_EQ(extract(params, scan).corners.size(), corners) << turn << ", " << angle;
        }
    }
}

TEST(SplitAndMerge, EverySupportingPointIsWithinDmaxOfItsLine) {
    std::mt19937 engine(5);
    std::uniform_real_distribution<double> value(-4.0, 4.0);
    ExtractionParams params;
    params.lines.min_length_m = 0.3;
    params.lines.min_points = 5;
    params.lines.collinear.rho_m = 1e-9;  // without the merge the bound is exact
    int found = 0;
    for (int i = 0; i < 200; ++i) {
        const Point2 a{value(engine), value(engine)};
        const Point2 b{value(engine), value(engine)};
        const Point2 c{value(engine), value(engine)};
        const Scan scan = scan_of({joined(wall(a, b, 60), wall(b, c, 60))}, 0.004);
        const Observation seen = extract(params, scan);
        for (const DetectedLine& line : seen.lines) {
            ++found;
            EXPECT_GE(line.count, 5U);
            for (std::uint32_t k = line.first; k < line.first + line.count; ++k) {
                EXPECT_LT(std::abs(signed_distance(line.recta, seen.support[k])), 0.02);
            }
        }
    }
    EXPECT_GT(found, 200);
}

class EveryMethod : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(All, EveryMethod, testing::Values("split-merge", "ransac"),
                         [](const auto& test) {
                             return test.param == std::string("ransac") ? "ransac" : "split_merge";
                         });

TEST_P(EveryMethod, ThresholdsRefuseShortAndSparseLines) {
    const Scan scan = scan_of({wall({2.0, 0.0}, {2.0, 1.0}, 20)});
    ExtractionParams params;
    params.method = GetParam();
    EXPECT_EQ(extract(params, scan).lines.size(), 1U);
    params.lines.min_points = 21;
    EXPECT_TRUE(extract(params, scan).lines.empty());
    params.lines.min_points = 20;
    EXPECT_EQ(extract(params, scan).lines.size(), 1U);
    params.lines.min_length_m = 1.01;
    EXPECT_TRUE(extract(params, scan).lines.empty());
}

TEST_P(EveryMethod, AnInvalidReadingBreaksARunAndTheMergeJoinsItAgain) {
    const Scan scan =
        scan_of({wall({2.0, -2.0}, {2.0, -0.1}, 20), wall({2.0, 0.1}, {2.0, 2.0}, 20)});
    ExtractionParams params;
    params.method = GetParam();
    const Observation merged = extract(params, scan);
    ASSERT_EQ(merged.lines.size(), 1U);
    EXPECT_EQ(merged.lines[0].count, 40U);
    params.lines.collinear.gap_m = 0.1;  // the pieces are 0.2 m apart
    EXPECT_EQ(extract(params, scan).lines.size(), 2U);
    params.lines.collinear.gap_m = 0.3;
    EXPECT_EQ(extract(params, scan).lines.size(), 1U);
}

TEST_P(EveryMethod, EachPieceIsMeasuredFromTheOneBefore) {
    const Scan scan =
        scan_of({wall({2.0, -2.0}, {2.0, -0.9}, 20), wall({2.0, -0.7}, {2.0, 0.4}, 20),
                 wall({2.0, 0.6}, {2.0, 2.0}, 20)});
    ExtractionParams params;
    params.method = GetParam();
    params.lines.collinear.gap_m = 0.3;
    EXPECT_EQ(extract(params, scan).lines.size(), 1U);
}

TEST(EndsOf, AreTheFirstAndTheLastPointUnlessTheSeamMakesThemNeighbours) {
    const Recta line{2.0, 0.0};
    // Noise along the wall puts other points outermost.
    const std::vector<Point2> points{{2.0, 0.0}, {2.0, -0.01}, {2.0, 1.0}, {2.0, 2.01}, {2.0, 2.0}};
    EXPECT_EQ(ends_of(points, line)[0], points.front());
    EXPECT_EQ(ends_of(points, line)[1], points.back());
    const std::vector<Point2> seam{{2.0, 0.1}, {2.0, 2.0}, {2.0, -2.0}, {2.0, 0.0}};
    EXPECT_EQ(ends_of(seam, line)[0], seam[2]);
    EXPECT_EQ(ends_of(seam, line)[1], seam[1]);
}

TEST(SplitAndMerge, CollinearMergeKnowsThatThetaWraps) {
    // A wall behind the robot whose normal lies at +-pi: one piece tilts to either side.
    const Scan scan =
        scan_of({wall({-2.0, -2.0}, {-2.01, -0.2}, 20), wall({-2.01, 0.2}, {-2.0, 2.0}, 20)});
    const Observation seen = extract({}, scan);
    ASSERT_EQ(seen.lines.size(), 1U);
    expect_line(seen.lines[0], {2.0, kPi}, 1e-9, 1e-9);
}

TEST(SplitAndMerge, ParallelWallsOnBothSidesAreNotMerged) {
    const Scan scan =
        scan_of({wall({-2.0, 0.05}, {2.0, 0.05}, 30), wall({2.0, -0.3}, {-2.0, -0.3}, 30)});
    EXPECT_EQ(extract({}, scan).lines.size(), 2U);
}

TEST(SplitAndMerge, AWallThroughTheSensorIsOneLineFromBothSides) {
    // rho is 0 but for 1 mm: its sign, and with it theta, differ between the pieces.
    const Scan scan =
        scan_of({wall({0.5, 0.001}, {2.0, 0.001}, 20), wall({2.5, -0.001}, {4.0, -0.001}, 20)});
    EXPECT_EQ(extract({}, scan).lines.size(), 1U);
}

TEST(SplitAndMerge, GapsEndARunWhereAsked) {
    const Scan scan =
        scan_of({joined(wall({2.0, -2.0}, {2.0, -0.5}, 20), wall({2.0, 0.5}, {2.0, 2.0}, 20))});
    ExtractionParams params;
    params.lines.collinear.gap_m = 0.3;
    ASSERT_EQ(extract(params, scan).lines.size(), 1U);  // without gap breaking one straight run
    params.split_merge.gap_m = 0.5;
    EXPECT_EQ(extract(params, scan).lines.size(), 2U);
    params.split_merge.gap_per_range = 0.5;  // 0.5 + 0.5 * 2 m: wide enough again
    EXPECT_EQ(extract(params, scan).lines.size(), 1U);
}

TEST(SplitAndMerge, TheNearerOfTwoNeighboursSaysHowWideAGapMayBe) {
    // A wall along the line of sight with 1.9 m missing from 2 m to 3.9 m: more than 0.6 * 2 m,
    // less than 0.6 * 3.9 m.
    const Scan scan = scan_of(
        {joined({{1.0, 0.0}}, joined(wall({1.0, 0.0}, {2.0, 0.0}, 20),
                                     joined({{2.0, 0.0}}, wall({3.9, 0.0}, {5.0, 0.0}, 23))))});
    ExtractionParams params;
    params.lines.collinear.gap_m = 0.5;  // the pieces stay two
    EXPECT_EQ(extract(params, scan).lines.size(), 1U);
    params.split_merge.gap_per_range = 0.6;
    EXPECT_EQ(extract(params, scan).lines.size(), 2U);
    params.split_merge.gap_per_range = 1.0;
    EXPECT_EQ(extract(params, scan).lines.size(), 1U);
}

TEST(SplitAndMerge, GapsAreMeasuredFromTheLaserNotFromTheRobot) {
    // Around the robot's centre the ranges are 2 m; a laser 1.5 m ahead of it sees them at 0.5 m.
    Scan scan = scan_of({joined(wall({2.0, -1.0}, {2.0, -0.1}, 20),
                                joined({{2.0, -0.1}}, wall({2.0, 0.1}, {2.0, 1.0}, 20)))});
    ExtractionParams params;
    params.lines.collinear.gap_m = 0.15;     // the pieces stay two
    params.split_merge.gap_per_range = 0.2;  // 0.2 m apart: more than 0.2 * 0.5 m, less than 0.4 m
    EXPECT_EQ(extract(params, scan).lines.size(), 1U);
    scan.fan.pose_robot_laser = {1.5, 0.0, 0.3};
    EXPECT_EQ(extract(params, scan).lines.size(), 2U);
    // The same readings of a laser at the centre give the same pieces: the mounting moves all.
    for (Point2& p : scan.points) p.x -= 1.5;
    scan.fan.pose_robot_laser = {};
    EXPECT_EQ(extract(params, scan).lines.size(), 2U);
}

TEST(SplitAndMerge, LeastSquaresBeatsEndPointsOnNoisyWalls) {
    ExtractionParams ends;
    ends.split_merge.dmax_m = 0.05;
    ExtractionParams squares = ends;
    squares.split_merge.fit = LineFit::least_squares;
    double error_ends = 0.0;
    double error_squares = 0.0;
    for (unsigned seed = 0; seed < 50; ++seed) {
        const Scan scan = scan_of({wall({2.0, -2.0}, {2.0, 2.0}, 60)}, 0.01, seed);
        const auto a = extract(ends, scan);
        const auto b = extract(squares, scan);
        ASSERT_EQ(a.lines.size(), 1U);
        ASSERT_EQ(b.lines.size(), 1U);
        error_ends += difference(a.lines[0].recta, {2.0, 0.0}).theta;
        error_squares += difference(b.lines[0].recta, {2.0, 0.0}).theta;
    }
    EXPECT_LT(error_squares, 0.7 * error_ends);
}

TEST(Extractor, CornerNeedsSupportOfBothLines) {
    // The lines meet at (2, 3), but the second wall starts 0.5 m away from there.
    const Scan scan =
        scan_of({wall({2.0, -2.0}, {2.0, 3.0}, 40), wall({1.5, 3.0}, {-3.0, 3.0}, 40)});
    ExtractionParams params;
    EXPECT_TRUE(extract(params, scan).corners.empty());
    params.corner_distance_m = 0.51;
    EXPECT_EQ(extract(params, scan).corners.size(), 1U);
}

TEST(Extractor, WallsThatMeetAtAFlatAngleHaveACornerAndParallelOnesNone) {
    const Point2 bend{2.0, 0.0};
    const auto walls = [&](double angle) {
        const Point2 end{2.0 - 2.0 * std::sin(angle), 2.0 * std::cos(angle)};
        return scan_of({wall({2.0, -2.0}, bend, 40), wall(bend, end, 40)});
    };
    const Observation flat = extract({}, walls(0.15));
    ASSERT_EQ(flat.lines.size(), 2U);
    ASSERT_EQ(flat.corners.size(), 1U);
    EXPECT_NEAR(flat.corners[0].x, 2.0, 1e-6);
    EXPECT_NEAR(flat.corners[0].y, 0.0, 1e-6);
    ExtractionParams unmerged;
    unmerged.lines.collinear.rho_m = 0.0;
    const Observation parallel = extract(unmerged, walls(0.0));
    EXPECT_EQ(parallel.lines.size(), 2U);
    EXPECT_TRUE(parallel.corners.empty());
}

TEST(Extractor, WallsAtAThousandthOfARadianMeet) {
    Observation seen;
    seen.support = {{2.0, -1.0}, {2.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}};
    seen.lines = {{{2.0, 0.0}, 0, 2}, {{2.0 * std::cos(1e-3), 1e-3}, 2, 2}};
    find_corners(seen, 0.1);
    ASSERT_EQ(seen.corners.size(), 1U);
    EXPECT_NEAR(seen.corners[0].x, 2.0, 1e-9);
    EXPECT_NEAR(seen.corners[0].y, 0.0, 1e-9);
}

TEST(Extractor, CornersOfFittedWallsLieNearerTheTruthAndLeaveTheLinesAlone) {
    ExtractionParams ends;
    ends.split_merge.dmax_m = 0.05;
    ends.corner_distance_m = 0.3;
    ends.covariance = ObservationCovariance::points;
    ExtractionParams fitted = ends;
    fitted.corner_lines = CornerLines::fitted;
    double error_ends = 0.0;
    double error_fitted = 0.0;
    for (unsigned seed = 0; seed < 50; ++seed) {
        const Scan scan =
            scan_of({joined(wall({2.0, -2.0}, {2.0, 3.0}, 60), wall({2.0, 3.0}, {-3.0, 3.0}, 60))},
                    0.01, seed);
        const Observation a = extract(ends, scan);
        const Observation b = extract(fitted, scan);
        ASSERT_EQ(a.corners.size(), 1U);
        ASSERT_EQ(b.corners.size(), 1U);
        ASSERT_EQ(a.lines.size(), b.lines.size());
        for (std::size_t i = 0; i < a.lines.size(); ++i) {
            EXPECT_EQ(a.lines[i].recta, b.lines[i].recta);
            EXPECT_EQ(a.line_covariances[i], b.line_covariances[i]);
        }
        EXPECT_LT(b.corner_covariances[0].trace(), a.corner_covariances[0].trace());
        error_ends += std::hypot(a.corners[0].x - 2.0, a.corners[0].y - 3.0);
        error_fitted += std::hypot(b.corners[0].x - 2.0, b.corners[0].y - 3.0);
    }
    EXPECT_LT(error_fitted, 0.8 * error_ends);
}

TEST(Extractor, CornersOfLinesThatAreFittedAnywayAreTheSame) {
    const Scan scan = scan_of(
        {joined(wall({2.0, -2.0}, {2.0, 3.0}, 60), wall({2.0, 3.0}, {-3.0, 3.0}, 60))}, 0.005);
    ExtractionParams params;
    params.split_merge.fit = LineFit::least_squares;
    params.corner_distance_m = 0.3;
    const Observation detected = extract(params, scan);
    params.corner_lines = CornerLines::fitted;
    ASSERT_EQ(detected.corners.size(), 1U);
    EXPECT_EQ(extract(params, scan).corners, detected.corners);
}

TEST(LineMethods, AreRegisteredWithWhatOnlyTheyRead) {
    EXPECT_TRUE(
        line_methods().words().starts_with("split-merge, ransac, "))  // the first is the default
        << line_methods().words();
    EXPECT_TRUE(line_methods().reads("split-merge", "split_merge.dmax"));
    EXPECT_FALSE(line_methods().reads("ransac", "split_merge.dmax"));
    EXPECT_FALSE(line_methods().reads("split-merge", "ransac.threshold"));
    EXPECT_TRUE(line_methods().reads("ransac", "split_merge.min_points"));  // both read it
    ExtractionParams params;
    params.method = "hough";
    EXPECT_THROW(make_extractor(params), ConfigError);
}

TEST(Extractor, DetectsWhatIsAskedFor) {
    const Scan scan =
        scan_of({joined(wall({2.0, -2.0}, {2.0, 3.0}, 40), wall({2.0, 3.0}, {-3.0, 3.0}, 40))});
    ExtractionParams params;
    params.corner_distance_m = 0.2;
    params.detect = Detection::lines;
    EXPECT_EQ(extract(params, scan).lines.size(), 2U);
    EXPECT_TRUE(extract(params, scan).corners.empty());
    params.detect = Detection::corners;
    EXPECT_TRUE(extract(params, scan).lines.empty());
    EXPECT_EQ(extract(params, scan).corners.size(), 1U);
}

TEST(Extractor, LandmarksThatASensorToldAreCornersWithTheirIdentities) {
    Scan scan =
        scan_of({joined(wall({2.0, -2.0}, {2.0, 3.0}, 40), wall({2.0, 3.0}, {-3.0, 3.0}, 40))});
    scan.landmarks = {{2.0, kPi / 2.0, 3}, {1.0, 0.0}};
    for (const Detection detect : {Detection::lines, Detection::corners, Detection::both}) {
        ExtractionParams params;
        params.corner_distance_m = 0.2;
        params.covariance = ObservationCovariance::points;
        params.detect = detect;
        const Observation seen = extract(params, scan);
        const std::size_t found = detect == Detection::lines ? 0 : 1;
        EXPECT_EQ(seen.lines.empty(), detect == Detection::corners);
        ASSERT_EQ(seen.corners.size(), found + 2);
        EXPECT_EQ(seen.corner_covariances.size(), found);
        EXPECT_NEAR(seen.corners[found].y, 2.0, 1e-12);
        EXPECT_EQ(seen.identity(found), 3);
        EXPECT_EQ(seen.identity(found + 1), LandmarkSighting::kNameless);
        EXPECT_EQ(seen.identity(0) == LandmarkSighting::kNameless, found > 0);
    }
}

TEST(Extractor, AWallOnWhichTheScansSeamLiesIsFittedToItsOuterEnds) {
    // A laser all round: the wall behind is the scan's first piece and its last.
    const Scan scan =
        scan_of({wall({-2.0, 0.0}, {-2.0, -3.0}, 30), wall({0.0, -3.0}, {2.0, -3.0}, 30),
                 wall({-2.0, 3.0}, {-2.001, 0.1}, 30)});
    ExtractionParams params;
    params.covariance = ObservationCovariance::points;
    const Observation seen = extract(params, scan);
    ASSERT_EQ(seen.lines.size(), 2U);
    EXPECT_EQ(seen.lines[0].count, 60U);
    expect_line(seen.lines[0], {2.0, kPi}, 1e-3, 1e-3);
    EXPECT_LT(std::sqrt(seen.line_covariances[0](1, 1)), 0.01);
}

TEST(Extractor, EmptyAndTinyScansAreNoTrouble) {
    EXPECT_TRUE(extract({}, Scan{}).empty());
    EXPECT_TRUE(extract({}, scan_of({{{1.0, 1.0}}})).empty());
    ExtractionParams params;
    params.lines.min_points = 2;
    params.lines.min_length_m = 0.0;
    EXPECT_TRUE(extract(params, scan_of({{{1.0, 1.0}, {1.0, 1.0}, {1.0, 1.0}}})).empty());
}

TEST(Extractor, RefusesImpossibleParameters) {
    ExtractionParams params;
    params.lines.min_points = 1;
    EXPECT_THROW(make_extractor(params), ConfigError);
    params = {};
    params.split_merge.dmax_m = 0.0;
    EXPECT_THROW(make_extractor(params), ConfigError);
}

}  // namespace
}  // namespace hitos
