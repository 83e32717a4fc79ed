// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/closed_scan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "wall_scan.hpp"

namespace hitos {
namespace {

using Corners = std::vector<Point2>;

/// Ranges from the origin to closed polygons at `count` bearings over a whole turn; infinite where
/// nothing is met within 30 m.
std::vector<double> ranges_to(const std::vector<Corners>& polygons, std::uint32_t count) {
    std::vector<double> ranges(count, std::numeric_limits<double>::infinity());
    for (std::uint32_t k = 0; k < count; ++k) {
        const double angle = 2.0 * kPi * k / count;
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        for (const Corners& polygon : polygons) {
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const Point2& a = polygon[i];
                const Point2& b = polygon[(i + 1) % polygon.size()];
                const double side_a = c * a.y - s * a.x;
                const double side_b = c * b.y - s * b.x;
                if ((side_a > 0.0) == (side_b > 0.0)) continue;
                const double t = side_a / (side_a - side_b);
                const double range = c * (a.x + t * (b.x - a.x)) + s * (a.y + t * (b.y - a.y));
                if (range > 0.0 && range < 30.0) ranges[k] = std::min(ranges[k], range);
            }
        }
    }
    return ranges;
}

/// The same surroundings as a laser sees them whose first ray lies at bearing number `first`.
Scan seen_from(const std::vector<double>& ranges, std::uint32_t first, bool clockwise) {
    Scan scan;
    const auto count = static_cast<std::uint32_t>(ranges.size());
    const double turn = 2.0 * kPi / count;
    scan.fan.count = count;
    scan.fan.max_range_m = 30.0;
    scan.fan.min_angle_rad = first * turn;
    scan.fan.max_angle_rad = (first + (clockwise ? -1.0 : 1.0) * (count - 1)) * turn;
    bool run_open = false;
    for (std::uint32_t ray = 0; ray < count; ++ray) {
        const double range = ranges[(clockwise ? first + count - ray : first + ray) % count];
        if (!std::isfinite(range)) {
            run_open = false;
            continue;
        }
        if (!run_open) scan.run_starts.push_back(static_cast<std::uint32_t>(scan.points.size()));
        run_open = true;
        const double angle = scan.fan.angle_rad(ray);
        scan.points.push_back({range * std::cos(angle), range * std::sin(angle)});
        scan.rays.push_back(ray);
    }
    return scan;
}

/// Rooms without and with things in them, one with an open side.
std::vector<std::vector<Corners>> surroundings() {
    const Corners room{{-3, -2}, {4, -2}, {4, 3}, {-3, 3}};
    const Corners niche{{-3, -2}, {4, -2}, {4, 1}, {2, 1}, {2, 4}, {-1, 4}, {-1, 1.5}, {-3, 1.5}};
    const Corners box{{1.5, 0.5}, {2.5, 0.7}, {2.3, 1.7}, {1.3, 1.5}};
    return {{room}, {niche}, {room, box}, {{{-3, -2}, {40, -2}, {40, 3}, {-3, 3}}}};
}

std::vector<ExtractionParams> all_methods() {
    std::vector<ExtractionParams> all(4);
    all[1].split_merge = {0.06, LineFit::least_squares, 0.3, 0.1};
    all[1].lines.collinear.gap_m = 0.6;
    all[1].covariance = ObservationCovariance::points;
    all[2].method = all[3].method = "ransac";
    all[3].ransac.order = RansacOrder::ransac_first;
    for (ExtractionParams& params : all) params.corner_distance_m = 0.2;
    return all;
}

TEST(ClosedFan, IsOneOfAWholeTurnInEitherDirection) {
    const double step = 2.0 * kPi / 360;
    for (const double first : {0.0, -kPi, 1.0}) {
        for (const double sign : {1.0, -1.0}) {
            const auto closed = [&](double turn_rad) {
                return Fan{first, first + sign * turn_rad, 360, 8.0, {}}.closed();
            };
            EXPECT_TRUE(closed(2.0 * kPi - step));
            EXPECT_TRUE(closed(6.2657)) << "as logs round it";
            EXPECT_TRUE(closed(2.0 * kPi)) << "the last ray is the first again";
            EXPECT_FALSE(closed(2.0 * kPi - 3.0 * step));
            EXPECT_FALSE(closed(1.5 * kPi));
            EXPECT_FALSE(closed(4.0 * kPi));
        }
    }
    EXPECT_FALSE(Fan{}.closed());
    EXPECT_FALSE((Fan{0.0, 0.0, 1, 8.0, {}}.closed()));
}

TEST(ClosedScan, AnOpenOneIsLeftAlone) {
    Scan scan = seen_from(ranges_to({surroundings()[0]}, 360), 0, false);
    scan.fan.max_angle_rad = 1.5 * kPi;
    Scan room;
    EXPECT_EQ(&cut_open(scan, room), &scan);
    EXPECT_FALSE(goes_all_round(scan));
}

TEST(ClosedScan, IsCutAtACornerOrAnEndOfAWallOrAGap) {
    Scan room;
    const auto ends = [&](const Scan& scan) {
        const Scan& cut = cut_open(scan, room);
        EXPECT_EQ(cut.points.size(), scan.points.size());
        EXPECT_EQ(cut.run_starts.size(), goes_all_round(scan) ? 1U : scan.run_starts.size());
        for (std::size_t i = 0; i < cut.points.size(); ++i) {
            const double bearing = std::atan2(cut.points[i].y, cut.points[i].x);
            EXPECT_NEAR(wrap_angle(cut.fan.angle_rad(cut.rays[i]) - bearing), 0.0, 1e-9);
        }
        return std::pair(cut.points.back(), cut.points.front());
    };
    const std::vector<double> plain = ranges_to(surroundings()[0], 360);
    for (const std::uint32_t first : {0U, 90U, 201U}) {
        const auto [last, next] = ends(seen_from(plain, first, false));
        EXPECT_LT(std::min(distance(last, {-3, 3}), distance(last, {4, 3})), 0.15);
        EXPECT_LT(distance(last, next), 0.2);
    }
    std::vector<double> holed = plain;
    for (const std::size_t k : {10U, 100U, 101U, 102U, 103U}) {
        holed[k] = std::numeric_limits<double>::infinity();
    }
    const auto [last, next] = ends(seen_from(holed, 101, true));
    EXPECT_NEAR(std::atan2(last.y, last.x), 99.0 * kRadiansPerDegree, 1e-9);
    EXPECT_NEAR(std::atan2(next.y, next.x), 104.0 * kRadiansPerDegree, 1e-9);
}

/// The law of the closed scan: neither its first ray nor its direction is a fact of the world.
TEST(ClosedScan, FirstRayAndDirectionChangeNoFeature) {
    std::mt19937 engine(11);
    std::normal_distribution<double> noise(0.0, 0.01);
    std::uniform_real_distribution<double> part;
    int lines = 0;
    for (const std::uint32_t count : {360U, 361U, 720U, 1440U}) {
        for (const std::vector<Corners>& polygons : surroundings()) {
            for (const double missing : {0.0, 0.03}) {
                std::vector<double> ranges = ranges_to(polygons, count);
                for (double& range : ranges) {
                    range = std::round(1000.0 * (range + noise(engine))) / 1000.0;
                    if (part(engine) < missing) range = std::numeric_limits<double>::infinity();
                }
                for (const ExtractionParams& params : all_methods()) {
                    const Observation whole = extract(params, seen_from(ranges, 0, false));
                    lines += static_cast<int>(whole.lines.size());
                    for (const std::uint32_t first : {1U, 77U, count / 2, count - 3}) {
                        for (const bool clockwise : {false, true}) {
                            const Observation seen =
                                extract(params, seen_from(ranges, first, clockwise));
                            ASSERT_EQ(seen.lines.size(), whole.lines.size());
                            ASSERT_EQ(seen.corners.size(), whole.corners.size());
                            for (std::size_t i = 0; i < seen.lines.size(); ++i) {
                                ASSERT_EQ(seen.lines[i].count, whole.lines[i].count);
                                expect_line(seen.lines[i], whole.lines[i].recta, 1e-9, 1e-9);
                            }
                            for (std::size_t i = 0; i < seen.corners.size(); ++i) {
                                EXPECT_NEAR(seen.corners[i].x, whole.corners[i].x, 1e-6);
                                EXPECT_NEAR(seen.corners[i].y, whole.corners[i].y, 1e-6);
                            }
                        }
                    }
                }
            }
        }
    }
    EXPECT_GT(lines, 400);
}

TEST(ClosedScan, EveryMethodFindsTheWallsAndCornersOfAClosedRoom) {
    std::mt19937 engine(12);
    std::normal_distribution<double> noise(0.0, 0.0005);
    for (const std::uint32_t count : {360U, 720U, 1440U}) {
        for (const double last : {1.0, 0.0}) {  // distinct rays all round, or the first one twice
            std::vector<double> ranges = ranges_to(surroundings()[0], count);
            for (double& range : ranges) range += noise(engine);
            for (const ExtractionParams& params : all_methods()) {
                Scan scan = seen_from(ranges, 45, false);
                if (last == 0.0) {
                    scan.points.push_back(scan.points.front());
                    scan.rays.push_back(count);
                    ++scan.fan.count;
                    scan.fan.max_angle_rad += 2.0 * kPi / count;
                }
                const Observation seen = extract(params, scan);
                EXPECT_EQ(seen.lines.size(), 4U) << params.method << ", " << count << " rays";
                EXPECT_EQ(seen.corners.size(), 4U) << params.method << ", " << count << " rays";
            }
        }
    }
}

TEST(ClosedScan, WhatIsShorterThanTheShortestLineIsStillNoLine) {
    ExtractionParams params;
    params.lines.min_length_m = 6.0;
    const Scan scan = seen_from(ranges_to(surroundings()[0], 360), 30, false);
    EXPECT_EQ(extract(params, scan).lines.size(), 2U) << "of 7 m, beside two of 5 m";
}

TEST(SplitAndMerge, ARunThatComesBackToWhereItBeganHasItsWalls) {
    // A laser with a blind sector behind it, near a wall: the ends are 0.2 m apart.
    std::vector<double> ranges = ranges_to({{{-0.6, -2}, {4, -2}, {4, 3}, {-0.6, 3}}}, 360);
    for (std::size_t k = 171; k < 190; ++k) ranges[k] = std::numeric_limits<double>::infinity();
    ExtractionParams params;
    params.lines.collinear.gap_m = 0.1;
    Scan scan = seen_from(ranges, 190, false);
    scan.fan.max_angle_rad -= 19.0 * kRadiansPerDegree;
    scan.fan.count = 341;
    ASSERT_FALSE(scan.fan.closed());
    EXPECT_EQ(extract(params, scan).lines.size(), 5U) << "the one behind in two parts";
    scan.fan = {};  // as logs have it that hold points alone
    scan.rays.clear();
    EXPECT_EQ(extract(params, scan).lines.size(), 5U);
    // Half a turn is the thesis's laser, and its order stays: what has near ends is no line.
    const std::vector<Point2> niche =
        joined(joined(wall({0.0, -0.2}, {2.0, -0.2}, 60), wall({2.0, -0.2}, {2.0, 0.2}, 30)),
               wall({2.0, 0.2}, {0.0, 0.2}, 60));
    EXPECT_TRUE(extract(params, scan_of({niche})).lines.empty());
}

TEST(ClosedScan, AWallSeenAlongItselfTakesNoPointOfTheOneBehindItsEnd) {
    // Past the block's face at y = -0.15 a ray meets the far wall almost where the face would be.
    const std::vector<Corners> polygons = {{{-3, -3}, {5.6, -3}, {5.6, 3}, {-3, 3}},
                                           {{2, -0.15}, {5, -0.15}, {5, -2}, {2, -2}}};
    ExtractionParams params;
    params.lines.min_points = 9;
    params.split_merge = {0.04, LineFit::least_squares};
    const Observation seen = extract(params, seen_from(ranges_to(polygons, 1440), 0, false));
    const auto met = [&](const Point2& place) {
        return std::count_if(seen.corners.begin(), seen.corners.end(), [&](const Esquina& corner) {
            return distance({corner.x, corner.y}, place) < 0.1;
        });
    };
    EXPECT_EQ(met({5.6, -0.15}), 0);
    EXPECT_EQ(met({2.0, -0.15}), 1);
    EXPECT_EQ(met({5.6, 3.0}), 1);
    bool face = false;
    for (const DetectedLine& line : seen.lines) {
        face |= difference(line.recta, {0.15, -kPi / 2.0}).rho < 0.01;
    }
    EXPECT_TRUE(face);
}

TEST(ClosedScan, AWallWithMissingRaysOnTheSeamIsOneWall) {
    ExtractionParams params;
    params.lines.collinear.gap_m = 0.5;
    params.lines.min_points = 8;
    std::vector<double> ranges = ranges_to(surroundings()[0], 720);
    // Two gaps in the wall ahead, the wider one where the scan is cut.
    for (const std::size_t k : {0U, 1U, 2U, 40U}) {
        ranges[k] = std::numeric_limits<double>::infinity();
    }
    const Observation seen = extract(params, seen_from(ranges, 0, false));
    EXPECT_EQ(seen.lines.size(), 4U);
}

TEST(ClosedScan, TinyOnesAreNoTrouble) {
    for (const std::uint32_t count : {3U, 4U, 5U, 9U}) {
        const std::vector<double> ranges = ranges_to(surroundings()[0], count);
        for (const ExtractionParams& params : all_methods()) {
            EXPECT_TRUE(extract(params, seen_from(ranges, 1, true)).empty());
        }
    }
    Scan nothing;
    nothing.fan = {0.0, 6.27, 360, 8.0, {}};
    EXPECT_TRUE(extract({}, nothing).empty());
}

}  // namespace
}  // namespace hitos
