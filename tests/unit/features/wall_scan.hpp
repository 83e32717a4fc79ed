// SPDX-License-Identifier: GPL-3.0-or-later
// Scans of straight walls for the tests of extractors.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "hitos/features/extractor.hpp"

namespace hitos {

/// A scan of straight walls, each given by its end points, sampled evenly; `noise_m` shifts every
/// point along its ray.
inline Scan scan_of(const std::vector<std::vector<Point2>>& runs, double noise_m = 0.0,
                    unsigned seed = 3) {
    Scan scan;
    std::mt19937 engine(seed);
    std::normal_distribution<double> noise(0.0, 1.0);
    for (const auto& run : runs) {
        scan.run_starts.push_back(static_cast<std::uint32_t>(scan.points.size()));
        for (const Point2& p : run) {
            const double range = std::hypot(p.x, p.y);
            const double factor = (range + noise_m * noise(engine)) / range;
            scan.points.push_back({p.x * factor, p.y * factor});
        }
    }
    return scan;
}

inline std::vector<Point2> wall(const Point2& from, const Point2& to, int points) {
    std::vector<Point2> result;
    for (int i = 0; i < points; ++i) {
        const double t = static_cast<double>(i) / (points - 1);
        result.push_back({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)});
    }
    return result;
}

inline std::vector<Point2> joined(std::vector<Point2> a, const std::vector<Point2>& b) {
    a.insert(a.end(), b.begin() + 1, b.end());  // the corner is in both
    return a;
}

inline Observation extract(const ExtractionParams& params, const Scan& scan) {
    Observation out;
    make_extractor(params)->extract(scan, out);
    return out;
}

inline void expect_line(const DetectedLine& line, const Recta& truth, double rho_m,
                        double theta_rad) {
    const LineDifference apart = difference(line.recta, truth);
    EXPECT_NEAR(apart.rho, 0.0, rho_m);
    EXPECT_NEAR(apart.theta, 0.0, theta_rad);
}

}  // namespace hitos
