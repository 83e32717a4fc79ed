// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "hitos/base/error.hpp"
#include "wall_scan.hpp"

namespace hitos {
namespace {

ExtractionParams ransac_params() {
    ExtractionParams params;
    params.method = "ransac";
    return params;
}

TEST(Ransac, FindsTheTwoWallsOfACornerAndTheCorner) {
    const Scan scan =
        scan_of({joined(wall({2.0, -2.0}, {2.0, 3.0}, 40), wall({2.0, 3.0}, {-3.0, 3.0}, 40))});
    const Observation seen = extract(ransac_params(), scan);
    ASSERT_EQ(seen.lines.size(), 2U);
    expect_line(seen.lines[0], {2.0, 0.0}, 1e-9, 1e-9);  // in scan order
    expect_line(seen.lines[1], {3.0, kPi / 2}, 1e-9, 1e-9);
    EXPECT_EQ(seen.lines[0].count + seen.lines[1].count, 80U);  // the corner in both
    ASSERT_EQ(seen.corners.size(), 1U);
    EXPECT_NEAR(seen.corners[0].x, 2.0, 1e-9);
    EXPECT_NEAR(seen.corners[0].y, 3.0, 1e-9);
}

TEST(Ransac, FindsTheWallAmongFortyPercentOutliers) {
    // A wall 3 m away, 120 rays of which 48 tell a range drawn at random; 10 mm range noise.
    int found = 0;
    for (unsigned seed = 1; seed <= 100; ++seed) {
        std::mt19937 engine(seed);
        std::uniform_real_distribution<double> range(0.3, 8.0);
        std::vector<Point2> points = wall({3.0, -3.0}, {3.0, 3.0}, 120);
        std::vector<std::size_t> rays(points.size());
        for (std::size_t i = 0; i < rays.size(); ++i) rays[i] = i;
        std::shuffle(rays.begin(), rays.end(), engine);
        for (std::size_t k = 0; k < 48; ++k) {
            Point2& p = points[rays[k]];
            const double factor = range(engine) / std::hypot(p.x, p.y);
            p = {p.x * factor, p.y * factor};
        }
        Observation seen;
        make_extractor(ransac_params(), seed)->extract(scan_of({points}, 0.01, seed), seen);
        if (seen.lines.size() != 1) continue;
        const LineDifference apart = difference(seen.lines[0].recta, {3.0, 0.0});
        if (apart.rho < 0.01 && apart.theta < 0.5 * kPi / 180.0) ++found;
    }
    EXPECT_GE(found, 99);
}

TEST(Ransac, SplitAndMergeWouldNotFindIt) {
    // What RANSAC is for: with one stray reading in six, no run is left for Split & Merge.
    std::vector<Point2> points = wall({3.0, -3.0}, {3.0, 3.0}, 120);
    std::mt19937 engine(69);
    std::uniform_real_distribution<double> factor(0.2, 0.8);
    for (std::size_t i = 3; i < points.size(); i += 6) {
        const double f = factor(engine);
        points[i] = {points[i].x * f, points[i].y * f};
    }
    const Scan scan = scan_of({points});
    EXPECT_TRUE(extract({}, scan).lines.empty());
    const Observation seen = extract(ransac_params(), scan);
    ASSERT_EQ(seen.lines.size(), 1U);
    expect_line(seen.lines[0], {3.0, 0.0}, 1e-9, 1e-9);
}

TEST(Ransac, AnEdgeEndsAWall) {
    // Two parallel walls, the second 1 m further away: no point of one belongs to the other.
    const Scan scan =
        scan_of({joined(wall({2.0, -2.0}, {2.0, 0.0}, 30), wall({3.0, 0.0}, {3.0, 3.0}, 31))});
    const Observation seen = extract(ransac_params(), scan);
    ASSERT_EQ(seen.lines.size(), 2U);
    expect_line(seen.lines[0], {2.0, 0.0}, 1e-9, 1e-9);
    expect_line(seen.lines[1], {3.0, 0.0}, 1e-9, 1e-9);
}

TEST(Ransac, AWallThatCrossesTheLineOfAnotherGivesItNoSupport) {
    // The line of the first wall goes on to meet the third one at (-3, 2); nobody saw it there.
    const Scan scan = scan_of(
        {joined(joined(wall({3.0, 2.0}, {1.0, 2.0}, 40), wall({1.0, 2.0}, {1.0, 4.0}, 20)),
                joined(wall({1.0, 4.0}, {-3.0, 4.0}, 40), wall({-3.0, 4.0}, {-3.0, -1.0}, 51)))});
    const Observation seen = extract(ransac_params(), scan);
    ASSERT_EQ(seen.lines.size(), 4U);
    EXPECT_EQ(seen.corners.size(), 3U);
    for (const Esquina& corner : seen.corners) {
        EXPECT_GT(std::hypot(corner.x + 3.0, corner.y - 2.0), 1.0);
    }
}

TEST(Ransac, AFarWallBehindAnEdgeGivesNoSupport) {
    // Past the end of the first wall its line meets the wall 3 m behind, a few rays later.
    std::vector<Point2> points = wall({1.0, -2.0}, {1.0, 1.0}, 40);
    const std::vector<Point2> behind = wall({1.2, 4.0}, {-3.0, 4.0}, 43);  // the third at x = 1
    points.insert(points.end(), behind.begin(), behind.end());
    const Observation seen = extract(ransac_params(), scan_of({points}));
    ASSERT_EQ(seen.lines.size(), 2U);
    EXPECT_EQ(seen.lines[0].count, 40U);
    EXPECT_TRUE(seen.corners.empty());
}

TEST(Ransac, PointsWhereTwoWallsMeetGoToTheNearer) {
    // At an obtuse corner many points lie within the threshold of both.
    std::mt19937 engine(71);
    double error = 0.0;
    for (unsigned seed = 0; seed < 50; ++seed) {
        const Scan scan =
            scan_of({joined(wall({2.0, -2.0}, {2.0, 0.0}, 40), wall({2.0, 0.0}, {1.4, 2.0}, 40))},
                    0.003, seed);
        const Observation seen = extract(ransac_params(), scan);
        ASSERT_EQ(seen.lines.size(), 2U) << seed;
        error = std::max(error, difference(seen.lines[0].recta, {2.0, 0.0}).theta);
    }
    EXPECT_LT(error, 0.004);  // a sixth of the threshold over the wall's length is 0.0035 rad
}

TEST(Ransac, AStepInAWallSharesNoPoint) {
    // 0.4 m: less than an edge, more than the threshold.
    std::vector<Point2> points = wall({2.0, -3.0}, {2.0, 0.0}, 40);
    const std::vector<Point2> behind = wall({2.4, 0.05}, {2.4, 3.0}, 40);
    points.insert(points.end(), behind.begin(), behind.end());
    const Observation seen = extract(ransac_params(), scan_of({points}));
    ASSERT_EQ(seen.lines.size(), 2U);
    EXPECT_EQ(seen.lines[0].count, 40U);
    EXPECT_EQ(seen.lines[1].count, 40U);
}

TEST(Ransac, ASharedPointDoesNotTiltTheWallItIsNotOn) {
    // The first wall ends 15 mm off the second one's line.
    std::vector<Point2> points = wall({2.0, -2.0}, {2.0, 0.0}, 40);
    const std::vector<Point2> other = wall({1.9, 0.015}, {-1.0, 0.015}, 40);
    points.insert(points.end(), other.begin(), other.end());
    const Observation seen = extract(ransac_params(), scan_of({points}));
    ASSERT_EQ(seen.lines.size(), 2U);
    EXPECT_EQ(seen.lines[1].count, 41U);
    expect_line(seen.lines[1], {0.015, kPi / 2}, 1e-9, 1e-9);
}

TEST(Ransac, TheNearerOfTwoNeighboursSaysWhatAnEdgeIs) {
    // A wall along the line of sight with 0.21 m missing behind 2 m: more than a tenth of 2 m, less
    // than a tenth of 2.21 m.
    std::vector<Point2> points = wall({1.0, 0.0}, {2.0, 0.0}, 25);
    const std::vector<Point2> behind = wall({2.21, 0.0}, {3.5, 0.0}, 25);
    points.insert(points.end(), behind.begin(), behind.end());
    ExtractionParams params = ransac_params();
    params.ransac.edge_m = 0.0;
    params.lines.collinear.gap_m = 0.1;  // pieces stay apart
    EXPECT_EQ(extract(params, scan_of({points})).lines.size(), 2U);
    params.ransac.edge_m = 0.05;
    EXPECT_EQ(extract(params, scan_of({points})).lines.size(), 1U);
}

/// A wall with ten readings in its middle that return from anywhere in front of it.
Scan wall_with_clutter() {
    std::vector<Point2> points = wall({2.0, -2.0}, {2.0, -0.3}, 30);
    for (int i = 0; i < 10; ++i) {
        const double range = i % 2 == 0 ? 0.5 + 0.05 * i : 1.4 - 0.04 * i;
        const double angle = -0.14 + 0.03 * i;
        points.push_back({range * std::cos(angle), range * std::sin(angle)});
    }
    const std::vector<Point2> rest = wall({2.0, 0.3}, {2.0, 2.0}, 30);
    points.insert(points.end(), rest.begin(), rest.end());
    return scan_of({points});
}

TEST(Ransac, FirstOfAllDropsStrayReadingsBeforeAnythingIsDivided) {
    ExtractionParams params = ransac_params();
    params.lines.collinear.rho_m = 0.0;  // pieces stay apart
    const Scan scan = wall_with_clutter();
    EXPECT_EQ(extract(params, scan).lines.size(), 2U);
    params.ransac.order = RansacOrder::ransac_first;
    const Observation seen = extract(params, scan);
    ASSERT_EQ(seen.lines.size(), 1U);
    EXPECT_EQ(seen.lines[0].count, 60U);
    expect_line(seen.lines[0], {2.0, 0.0}, 1e-9, 1e-9);
}

TEST(Ransac, FirstOfAllStillDividesALineAtEdges) {
    // Two walls on one line with a doorway, through which another wall is seen.
    std::vector<Point2> points = wall({2.0, -2.0}, {2.0, -0.4}, 30);
    const std::vector<Point2> behind = wall({4.0, -0.6}, {4.0, 0.6}, 20);
    const std::vector<Point2> rest = wall({2.0, 0.4}, {2.0, 2.0}, 30);
    points.insert(points.end(), behind.begin(), behind.end());
    points.insert(points.end(), rest.begin(), rest.end());
    ExtractionParams params = ransac_params();
    params.lines.collinear.rho_m = 0.0;
    params.ransac.order = RansacOrder::ransac_first;
    const Observation seen = extract(params, scan_of({points}));
    ASSERT_EQ(seen.lines.size(), 3U);
    EXPECT_EQ(seen.lines[0].count, 30U);
    EXPECT_EQ(seen.lines[1].count, 30U);
    EXPECT_EQ(seen.lines[2].count, 20U);
}

TEST(Ransac, FirstOfAllDividesALineWhereRaysSawNothingWhateverTheScanBefore) {
    const std::vector<Point2> one = wall({2.0, -2.0}, {2.0, -0.05}, 30);
    const std::vector<Point2> other = wall({2.0, 0.05}, {2.0, 2.0}, 30);
    std::vector<Point2> whole = one;
    whole.insert(whole.end(), other.begin(), other.end());
    ExtractionParams params = ransac_params();
    params.lines.collinear.rho_m = 0.0;
    params.ransac.order = RansacOrder::ransac_first;
    const auto extractor = make_extractor(params, 1);
    Observation seen;
    extractor->extract(scan_of({one, other}), seen);
    EXPECT_EQ(seen.lines.size(), 2U);
    extractor->extract(scan_of({whole}), seen);
    EXPECT_EQ(seen.lines.size(), 1U);
}

TEST(Ransac, TheSameSeedAndScanNumberGiveTheSameLines) {
    std::mt19937 engine(73);
    std::uniform_real_distribution<double> value(1.0, 3.0);
    std::vector<Point2> clutter;
    for (int i = 0; i < 150; ++i) {
        const double angle = -1.5 + 0.02 * i;
        const double r = value(engine);
        clutter.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    const Scan scan = scan_of({clutter});
    ExtractionParams params = ransac_params();
    params.lines.min_points = 8;
    params.ransac.threshold_m = 0.1;
    params.ransac.iterations = 20;  // few, so that draws matter
    const auto lines_of = [&](std::uint64_t seed) {
        const auto extractor = make_extractor(params, seed);
        std::vector<Recta> lines;
        Observation seen;
        for (int k = 0; k < 3; ++k) {
            extractor->extract(scan, seen);
            for (const DetectedLine& line : seen.lines) lines.push_back(line.recta);
        }
        return lines;
    };
    ASSERT_FALSE(lines_of(1).empty());
    EXPECT_EQ(lines_of(1), lines_of(1));
    EXPECT_NE(lines_of(1), lines_of(2));
}

TEST(Ransac, EmptyAndTinyScansAreNoTrouble) {
    ExtractionParams params = ransac_params();
    params.lines.min_points = 2;
    params.lines.min_length_m = 0.0;
    EXPECT_TRUE(extract(params, Scan{}).empty());
    EXPECT_TRUE(extract(params, scan_of({{{1.0, 1.0}}})).empty());
    EXPECT_TRUE(extract(params, scan_of({{{1.0, 1.0}, {1.0, 1.0}, {1.0, 1.0}}})).empty());
}

TEST(Ransac, RefusesImpossibleParameters) {
    ExtractionParams params = ransac_params();
    params.ransac.iterations = 0;
    EXPECT_THROW(make_extractor(params), ConfigError);
    params = ransac_params();
    params.ransac.threshold_m = 0.0;
    EXPECT_THROW(make_extractor(params), ConfigError);
    params = ransac_params();
    params.covariance = ObservationCovariance::points;
    params.point_sigma_m = 0.0;
    EXPECT_THROW(make_extractor(params), ConfigError);
}

TEST(Ransac, ALineIsFittedAnewUntilItsPointsStay) {
    // One draw alone, of two points that are as often as not near each other: the wall's other
    // points come to the line step by step.
    ExtractionParams params = ransac_params();
    params.ransac.iterations = 1;
    int whole = 0;
    for (unsigned seed = 1; seed <= 100; ++seed) {
        Observation seen;
        make_extractor(params, seed)
            ->extract(scan_of({wall({3.0, -1.5}, {3.0, 1.5}, 60)}, 0.02, seed), seen);
        if (seen.lines.size() == 1 && seen.lines[0].count >= 54) ++whole;
    }
    EXPECT_GE(whole, 80);  // where it is fitted but once 68
}

}  // namespace
}  // namespace hitos
