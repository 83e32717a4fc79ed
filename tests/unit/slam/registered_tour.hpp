// SPDX-License-Identifier: GPL-3.0-or-later
// Tours with a registered path, for the tests of corrections.
#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "hitos/registration/registered_step.hpp"
#include "room_tour.hpp"

namespace hitos {

/// A path near the truth, as registration gives it.
inline std::vector<RegisteredStep> registered_path(const Tour& tour, double error_m) {
    std::mt19937 engine(71);
    std::normal_distribution<double> normal(0.0, 1.0);
    std::vector<RegisteredStep> path;
    Pose before;
    for (std::size_t k = 0; k < tour.truth.size(); ++k) {
        RegisteredStep step;
        step.scan = k;
        step.before = before;
        step.pose = tour.truth[k];
        if (k == 0) step.before = step.pose = {};
        if (k > 0) {
            step.pose.x += error_m * normal(engine);
            step.pose.y += error_m * normal(engine);
            step.path_m = 0.08;
            step.turned_rad = 0.03;
        }
        step.covariance = Eigen::Vector3d(4e-4, 4e-4, 1e-4).asDiagonal();
        step.matched = true;
        before = step.pose;
        path.push_back(step);
    }
    return path;
}

inline RegisteredStep moved(RegisteredStep step, const Pose& motion) {
    step.before = compose(motion, step.before);
    step.pose = compose(motion, step.pose);
    return step;
}

inline void feed_registered(SlamFilter& filter, const RegisteredStep& step,
                            const Observation& observation) {
    const Scan scan;
    filter.step({scan, {}, observation, &step});
}

inline void feed_registered(SlamFilter& filter, const Tour& tour,
                            const std::vector<RegisteredStep>& path, std::size_t from,
                            std::size_t to, const Pose& motion = {}) {
    for (std::size_t k = from; k < to; ++k) {
        feed_registered(filter, moved(path[k], motion), tour.observations[k]);
    }
}

}  // namespace hitos
