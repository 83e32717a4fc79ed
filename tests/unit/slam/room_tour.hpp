// SPDX-License-Identifier: GPL-3.0-or-later
// A tour through a room for the tests of whole filters.
#pragma once

#include <Eigen/Core>
#include <random>
#include <span>
#include <vector>

#include "hitos/features/control.hpp"
#include "hitos/features/extractor.hpp"
#include "hitos/slam/slam_filter.hpp"

namespace hitos {

/// One step of a filter that does not look at the scan itself.
inline void feed(SlamFilter& filter, std::span<const Control> controls,
                 const Observation& observation) {
    const Scan scan;
    filter.step({scan, controls, observation});
}

/// A square room driven round: exact observations of its walls and corners, noisy odometry.
struct Tour {
    std::vector<std::vector<Control>> controls;
    std::vector<Observation> observations;
    std::vector<Pose> truth;
};

inline Tour make_tour(int steps, double odometry_error) {
    const std::vector<Recta> walls{{5.0, 0.0}, {5.0, kPi / 2}, {5.0, kPi}, {5.0, -kPi / 2}};
    const std::vector<Esquina> corners{{5, 5}, {-5, 5}, {-5, -5}, {5, -5}};
    std::mt19937 engine(53);
    std::normal_distribution<double> normal(0.0, 1.0);
    Tour tour;
    Pose pose;
    for (int k = 0; k < steps; ++k) {
        const Control control{{0.4, 0.0, 0.15}, k == 0 ? 0.0 : 0.2};
        pose = compose(pose, displacement(control.twist, control.duration_s));
        Control logged = control;
        logged.twist.v *= 1.0 + odometry_error * normal(engine);
        logged.twist.w *= 1.0 + odometry_error * normal(engine);
        tour.controls.push_back({logged});
        tour.truth.push_back(pose);
        Observation seen;
        if (k % 7 != 3) {  // every seventh scan shows nothing
            for (const Recta& wall : walls) {
                Recta local = transform(inverse(pose), wall);
                local.rho = std::abs(local.rho + 0.01 * normal(engine));
                local.theta = wrap_angle(local.theta + 0.003 * normal(engine));
                if (std::abs(local.theta) < 1.6) seen.lines.push_back({local, 0, 0});
            }
            for (const Esquina& corner : corners) {
                Esquina local = transform(inverse(pose), corner);
                local.x += 0.01 * normal(engine);
                local.y += 0.01 * normal(engine);
                if (local.x > 0.0) seen.corners.push_back(local);
            }
        }
        tour.observations.push_back(seen);
    }
    return tour;
}

/// Gives every feature a covariance of its own.
inline Tour with_covariances(Tour tour) {
    std::mt19937 engine(59);
    std::uniform_real_distribution<double> unit(0.2, 1.0);
    const auto covariance = [&](double sigma0, double sigma1) {
        const double a = sigma0 * unit(engine);
        const double b = sigma1 * unit(engine);
        const double both = (1.2 * unit(engine) - 0.7) * a * b;
        Eigen::Matrix2d out;
        out << a * a, both, both, b * b;
        return out;
    };
    for (Observation& seen : tour.observations) {
        for (std::size_t i = 0; i < seen.lines.size(); ++i) {
            seen.line_covariances.push_back(covariance(0.1, 0.05));
        }
        for (std::size_t i = 0; i < seen.corners.size(); ++i) {
            seen.corner_covariances.push_back(covariance(0.2, 0.2));
        }
    }
    return tour;
}

}  // namespace hitos
