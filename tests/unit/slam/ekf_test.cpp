// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/ekf.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "hitos/base/random_stream.hpp"
#include "models/landmark_kinds.hpp"

namespace hitos {
namespace {

/// One landmark seen `steps` times from poses along a curve, with Gaussian noise; returns the
/// squared normalised error of the estimate after each update.
template <class S>
std::vector<double> normalised_errors(std::uint64_t seed, const typename S::Landmark& truth,
                                      int steps) {
    const double sigma0 = 0.02;
    const double sigma1 = 0.01;
    const EKF<S> ekf(Vector2(sigma0 * sigma0, sigma1 * sigma1).asDiagonal().toDenseMatrix());
    std::vector<double> errors;
    LandmarkEstimate<S> estimate{};
    for (int k = 0; k < steps; ++k) {
        const Pose pose{0.2 * k, std::sin(0.3 * k), 0.4 * k};
        RandomStream random(seed, RandomPurpose::laser_noise, static_cast<std::uint64_t>(k), 0);
        const auto noise = random.normal_pair();
        Vector2 z = S::predict(pose, truth);
        if (z(0) < 0.0) z << -z(0), z(1) + kPi;
        z += Vector2{sigma0 * noise[0], sigma1 * noise[1]};
        z(1) = wrap_angle(z(1));
        if (k == 0) {
            estimate = ekf.first(pose, z);
        } else {
            ekf.update(estimate, S::innovation(z, pose, estimate.mean));
        }
        // Error in the estimate's own normal form.
        Vector2 error = S::to_state(estimate.mean) - S::to_state(truth);
        if constexpr (std::is_same_v<S, SensorRecta>) {
            error(1) = wrap_angle(error(1));
            if (std::abs(error(1)) > kPi / 2.0) {
                error << estimate.mean.rho + truth.rho, wrap_angle(error(1) - kPi);
            }
        }
        errors.push_back(error.dot(estimate.covariance.ldlt().solve(error)));
    }
    return errors;
}

/// With correct models the error is chi-square with 2 degrees of freedom: mean 2, variance 4, at
/// every step. Five standard errors over the seeds.
template <class S>
void expect_chi_square(const typename S::Landmark& truth) {
    constexpr int kSeeds = 2000;
    constexpr int kSteps = 25;
    std::vector<double> sums(kSteps, 0.0);
    int inside95 = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        const auto errors = normalised_errors<S>(seed, truth, kSteps);
        for (int k = 0; k < kSteps; ++k)
            sums[static_cast<std::size_t>(k)] += errors[static_cast<std::size_t>(k)];
        if (errors.back() < 5.991) ++inside95;  // 95 % quantile of chi-square(2)
    }
    const double tolerance = 5.0 * std::sqrt(4.0 / kSeeds);
    for (const double sum : sums) EXPECT_NEAR(sum / kSeeds, 2.0, tolerance);
    EXPECT_NEAR(inside95 / double{kSeeds}, 0.95, 5.0 * std::sqrt(0.95 * 0.05 / kSeeds));
}

TEST(EKF, ErrorOfALineIsChiSquare) {
    expect_chi_square<SensorRecta>({5.0, 0.7});
}
TEST(EKF, ErrorOfALineAtTheWrapIsChiSquare) {
    expect_chi_square<SensorRecta>({3.0, kPi});
}
TEST(EKF, ErrorOfACornerIsChiSquare) {
    expect_chi_square<SensorEsquina>({4.0, -3.0});
}

TEST(EKF, UpdateEqualsTheTextbookFormula) {
    std::mt19937 engine(29);
    std::uniform_real_distribution<double> value(-3.0, 3.0);
    const EKF<SensorRecta> ekf(Vector2(0.04, 0.00122).asDiagonal().toDenseMatrix());
    for (int i = 0; i < 500; ++i) {
        const Pose pose{value(engine), value(engine), value(engine)};
        LandmarkEstimate<SensorRecta> estimate{{std::abs(value(engine)) + 4.0, value(engine)}, {}};
        const double a = 0.1 + std::abs(value(engine));
        const double b = 0.01 + 0.01 * std::abs(value(engine));
        estimate.covariance << a, 0.3 * std::sqrt(a * b), 0.3 * std::sqrt(a * b), b;
        Vector2 z = SensorRecta::predict(pose, estimate.mean) + 0.1 * Vector2{value(engine), 0.1};
        z(1) = wrap_angle(z(1));
        const Innovation nu = SensorRecta::innovation(z, pose, estimate.mean);
        // K = P H' (H P H' + R)^-1, mean += K nu, P = (I - K H) P [T table 3.2].
        const Matrix2 h = nu.jacobian;
        const Matrix2 p = estimate.covariance;
        Matrix2 r;
        r << 0.04, 0.0, 0.0, 0.00122;
        const Matrix2 q = h * p * h.transpose() + r;
        const Matrix2 k = p * h.transpose() * q.inverse();
        const Vector2 mean = SensorRecta::to_state(estimate.mean) + k * nu.nu;
        const Matrix2 covariance = (Matrix2::Identity() - k * h) * p;

        const auto likelihood = ekf.likelihood(nu, p);
        const double d2 = nu.nu.dot(q.inverse() * nu.nu);
        EXPECT_NEAR(likelihood.mahalanobis_squared, d2, 1e-9 * (1.0 + d2));
        EXPECT_NEAR(likelihood.log_likelihood,
                    -std::log(2.0 * kPi * std::sqrt(q.determinant())) - 0.5 * d2,
                    1e-9 * (1.0 + d2));

        ekf.update(estimate, nu);
        const Recta expected = normalized({mean(0), mean(1)});
        EXPECT_NEAR(estimate.mean.rho, expected.rho, 1e-10);
        EXPECT_NEAR(wrap_angle(estimate.mean.theta - expected.theta), 0.0, 1e-10);
        EXPECT_LT((estimate.covariance.cwiseAbs() - covariance.cwiseAbs()).cwiseAbs().maxCoeff(),
                  1e-10);
        EXPECT_EQ(estimate.covariance(0, 1), estimate.covariance(1, 0));
    }
}

}  // namespace
}  // namespace hitos
