// SPDX-License-Identifier: GPL-3.0-or-later
// Gaussians over poses whose covariance may be singular.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "hitos/base/random_stream.hpp"

namespace hitos {

/// Cholesky's lower triangle L, L L' = `covariance`, of a symmetric matrix that need not be
/// regular: a component that does not vary given those before it has a column of zeros. What is
/// negative by rounding counts as 0.
inline Eigen::Matrix3d root_of(const Eigen::Matrix3d& covariance) {
    constexpr double kRounding = 1e-12;  // of the component's own variance
    Eigen::Matrix3d root = Eigen::Matrix3d::Zero();
    for (int j = 0; j < 3; ++j) {
        const double rest = covariance(j, j) - root.row(j).head(j).squaredNorm();
        if (!(rest > kRounding * covariance(j, j))) continue;
        root(j, j) = std::sqrt(rest);
        for (int i = j + 1; i < 3; ++i) {
            root(i, j) =
                (covariance(i, j) - root.row(i).head(j).dot(root.row(j).head(j))) / root(j, j);
        }
    }
    return root;
}

/// Three independent standard normal draws.
inline Eigen::Vector3d normal_triple(RandomStream& random) {
    const auto [n0, n1] = random.normal_pair();
    return {n0, n1, random.normal_pair()[0]};
}

}  // namespace hitos
