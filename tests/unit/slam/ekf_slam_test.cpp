#include "ekf_slam.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "hitos/capture/error.hpp"
#include "hitos/slam/filters.hpp"
#include "room_tour.hpp"

namespace hitos {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

FilterParams ekf_params() {
    FilterParams params;
    params.algorithm = SlamAlgorithm::ekf_slam;
    return params;
}

/// The slope of a function of a vector, by central differences; angles of the result are rows in
/// `angles`.
template <class F>
MatrixXd slope(const F& f, const VectorXd& at, const std::vector<int>& angles) {
    constexpr double kStep = 1e-6;
    MatrixXd out(f(at).size(), at.size());
    for (Eigen::Index k = 0; k < at.size(); ++k) {
        VectorXd plus = at;
        VectorXd minus = at;
        plus(k) += kStep;
        minus(k) -= kStep;
        VectorXd difference = f(plus) - f(minus);
        for (const int angle : angles) difference(angle) = wrap_angle(difference(angle));
        out.col(k) = difference / (2.0 * kStep);
    }
    return out;
}

/// EKF-SLAM from the textbook: one dense covariance, every Jacobian by numerical differentiation
/// of the whole state, Joseph's form, the inverse of S. Lines only see the side they were seen
/// from: a flipped prediction is tried beside the plain one.
class SlowEkfSlam {
  public:
    explicit SlowEkfSlam(const FilterParams& params) : params_(params), robot_(params.motion) {}

    void step(const std::vector<Control>& controls, const Observation& observation) {
        const MotionIncrement increment = sum_controls(controls);
        const Pose before = pose();
        const auto move = [&](const VectorXd& state) {
            VectorXd out = state;
            const Pose after = robot_.mean({state(0), state(1), state(2)}, increment);
            out.head<3>() << after.x, after.y, after.theta;
            return out;
        };
        const MatrixXd f = slope(move, x_, {2});
        x_ = move(x_);
        p_ = f * p_ * f.transpose();
        if (steps_++ > 0) {
            p_.topLeftCorner<3, 3>() += robot_.noise_covariance(before, increment);
        }

        Measurements seen;
        seen.take(observation, params_.observation);
        struct Match {
            std::size_t landmark;
            Vector2 nu;
            MatrixXd h;
            Matrix2 r;
        };
        std::vector<Match> matches;
        std::vector<std::pair<bool, Measurement>> fresh;  // is it a line?
        for (int kind = 0; kind < 2; ++kind) {
            for (const Measurement& m : kind == 0 ? seen.lines : seen.corners) {
                double nearest = 1e300;
                double nearest_log = -1e300;
                double second = 1e300;
                double second_log = -1e300;
                Match match{};
                for (std::size_t i = 0; i < is_line_.size(); ++i) {
                    if (is_line_[i] != (kind == 0)) continue;
                    // The nearer of the two sides.
                    Vector2 nu;
                    bool flipped = false;
                    nu = m.z - predict(x_, i, false);
                    nu(1) = wrap_angle(nu(1));
                    if (is_line_[i] && std::abs(nu(1)) > kPi / 2.0) {
                        flipped = true;
                        nu = m.z - predict(x_, i, true);
                        nu(1) = wrap_angle(nu(1));
                    }
                    const MatrixXd h =
                        slope([&](const VectorXd& s) { return VectorXd(predict(s, i, flipped)); },
                              x_, {1});
                    const Matrix2 s = h * p_ * h.transpose() + m.r;
                    const double d2 = nu.dot(s.inverse() * nu);
                    const double log_likelihood = -0.5 * d2 - 0.5 * std::log(s.determinant());
                    if (d2 < nearest) {
                        second = nearest;
                        second_log = nearest_log;
                        nearest = d2;
                        nearest_log = log_likelihood;
                        match = {i, nu, h, m.r};
                    } else if (d2 < second) {
                        second = d2;
                        second_log = log_likelihood;
                    }
                }
                const double gate = -2.0 * std::log(1.0 - params_.association.gate_probability);
                const double far = -2.0 * std::log(1.0 - params_.association.new_probability);
                const bool ambiguous = second <= gate && std::exp(second_log - nearest_log) >
                                                             params_.association.ambiguity_ratio;
                if (nearest <= gate && !ambiguous) matches.push_back(match);
                if (nearest > far) fresh.emplace_back(kind == 0, m);
            }
        }
        if (!matches.empty()) {
            const auto rows = 2 * static_cast<Eigen::Index>(matches.size());
            VectorXd nu(rows);
            MatrixXd h(rows, x_.size());
            MatrixXd r = MatrixXd::Zero(rows, rows);
            for (Eigen::Index k = 0; k < rows; k += 2) {
                const Match& match = matches[static_cast<std::size_t>(k / 2)];
                nu.segment<2>(k) = match.nu;
                h.middleRows<2>(k) = match.h;
                r.block<2, 2>(k, k) = match.r;
            }
            const MatrixXd gain = p_ * h.transpose() * (h * p_ * h.transpose() + r).inverse();
            const MatrixXd rest = MatrixXd::Identity(x_.size(), x_.size()) - gain * h;
            x_ += gain * nu;
            p_ = rest * p_ * rest.transpose() + gain * r * gain.transpose();
        }
        normalize();
        for (const auto& [line, m] : fresh) add(line, m);
        normalize();
    }

    Pose pose() const { return {x_(0), x_(1), x_(2)}; }
    const VectorXd& state() const { return x_; }
    const MatrixXd& covariance() const { return p_; }

  private:
    Vector2 predict(const VectorXd& state, std::size_t i, bool flipped) const {
        const Pose at{state(0), state(1), state(2)};
        const double a = state(3 + 2 * static_cast<Eigen::Index>(i));
        const double b = state(4 + 2 * static_cast<Eigen::Index>(i));
        if (!is_line_[i]) {
            return {std::hypot(a - at.x, b - at.y), std::atan2(b - at.y, a - at.x) - at.theta};
        }
        const Vector2 h(a - at.x * std::cos(b) - at.y * std::sin(b), b - at.theta);
        return flipped ? Vector2(-h(0), h(1) + kPi) : h;
    }

    void add(bool line, const Measurement& m) {
        const auto place = [&](const VectorXd& arguments) {  // x, y, theta, z0, z1
            const double angle = arguments(2) + arguments(4);
            VectorXd out(2);
            if (line) {
                out << arguments(3) + arguments(0) * std::cos(angle) +
                           arguments(1) * std::sin(angle),
                    angle;
            } else {
                out << arguments(0) + arguments(3) * std::cos(angle),
                    arguments(1) + arguments(3) * std::sin(angle);
            }
            return out;
        };
        VectorXd arguments(5);
        arguments << x_(0), x_(1), x_(2), m.z(0), m.z(1);
        const MatrixXd g = slope(place, arguments, {});
        const Eigen::Index n = x_.size();
        MatrixXd whole = MatrixXd::Zero(n + 2, n + 2);  // d(state with the new one)/d(state, z)
        whole.topLeftCorner(n, n).setIdentity();
        whole.block(n, 0, 2, 3) = g.leftCols(3);
        whole.bottomRightCorner(2, 2) = g.rightCols(2);
        MatrixXd both = MatrixXd::Zero(n + 2, n + 2);
        both.topLeftCorner(n, n) = p_;
        both.bottomRightCorner(2, 2) = m.r;
        p_ = whole * both * whole.transpose();
        VectorXd larger(n + 2);
        larger << x_, place(arguments);
        x_ = larger;
        is_line_.push_back(line);
    }

    void normalize() {
        x_(2) = wrap_angle(x_(2));
        for (std::size_t i = 0; i < is_line_.size(); ++i) {
            if (!is_line_[i]) continue;
            const Eigen::Index at = 3 + 2 * static_cast<Eigen::Index>(i);
            if (x_(at) < 0.0) {
                x_(at) = -x_(at);
                x_(at + 1) += kPi;
                p_.row(at) *= -1.0;
                p_.col(at) *= -1.0;
            }
            x_(at + 1) = wrap_angle(x_(at + 1));
        }
    }

    FilterParams params_;
    Robot robot_;
    int steps_ = 0;
    VectorXd x_ = VectorXd::Zero(3);
    MatrixXd p_ = MatrixXd::Zero(3, 3);
    std::vector<bool> is_line_;
};

void compare_with_slow(const FilterParams& params, const Tour& tour) {
    EkfSlam fast(params);
    SlowEkfSlam slow(params);
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        fast.step(tour.controls[k], tour.observations[k]);
        slow.step(tour.controls[k], tour.observations[k]);
        const MatrixXd covariance = fast.covariance();
        ASSERT_EQ(covariance.rows(), slow.covariance().rows()) << "step " << k;
        ASSERT_NEAR(fast.best_pose().x, slow.pose().x, 1e-6) << "step " << k;
        ASSERT_NEAR(fast.best_pose().y, slow.pose().y, 1e-6);
        ASSERT_NEAR(wrap_angle(fast.best_pose().theta - slow.pose().theta), 0.0, 1e-6);
        ASSERT_LT((covariance - slow.covariance()).cwiseAbs().maxCoeff(), 1e-6) << "step " << k;
    }
    EXPECT_GE(fast.best_lines(), 3);
    EXPECT_GE(fast.best_corners(), 3);
}

TEST(EkfSlam, EqualsTheTextbook) {
    compare_with_slow(ekf_params(), make_tour(120, 0.1));
}

TEST(EkfSlam, EqualsTheTextbookWithProportionalNoise) {
    FilterParams params = ekf_params();
    params.motion.model = MotionModel::proportional;
    params.observation = {0.001, 0.0001};
    compare_with_slow(params, make_tour(120, 0.1));
}

TEST(EkfSlam, EqualsTheTextbookWithCovariancesOfItsOwnForEveryFeature) {
    compare_with_slow(ekf_params(), with_covariances(make_tour(120, 0.1)));
}

TEST(EkfSlam, EqualsTheTextbookWithoutOdometry) {
    FilterParams params = ekf_params();
    params.motion = {MotionModel::no_odometry, 0.1, 0.1, 0.05};
    compare_with_slow(params, make_tour(60, 0.1));
}

TEST(EkfSlam, MapsTheRoom) {
    const Tour tour = make_tour(300, 0.1);
    EkfSlam filter(ekf_params());
    double odometry_error = 0.0;
    Pose odometry;
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        filter.step(tour.controls[k], tour.observations[k]);
        odometry = Robot(MotionParams{}).mean(odometry, sum_controls(tour.controls[k]));
        odometry_error = std::hypot(odometry.x - tour.truth[k].x, odometry.y - tour.truth[k].y);
    }
    EXPECT_EQ(filter.best_lines(), 4);
    EXPECT_EQ(filter.best_corners(), 4);
    const double error = std::hypot(filter.best_pose().x - tour.truth.back().x,
                                    filter.best_pose().y - tour.truth.back().y);
    EXPECT_LT(error, 0.1);
    EXPECT_LT(error, odometry_error);
    for (const ICaracteristica& landmark : filter.best_map()) {
        if (const auto* line = std::get_if<Recta>(&landmark.value)) {
            EXPECT_NEAR(line->rho, 5.0, 0.1);
        }
        EXPECT_GT(landmark.observations, 50);
        EXPECT_GT(landmark.covariance.determinant(), 0.0);
    }
    EXPECT_EQ(filter.best_history().size(), tour.controls.size());
}

TEST(EkfSlam, CovarianceIsPositiveAfterTenThousandSteps) {  // symmetric it is by construction
    const Tour tour = make_tour(10000, 0.1);
    FilterParams params = ekf_params();
    params.motion.model = MotionModel::proportional;
    params.observation = {1e-4, 1e-5};
    EkfSlam filter(params);
    double least = 1e300;
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        filter.step(tour.controls[k], tour.observations[k]);
        if (k % 500 != 499) continue;
        const MatrixXd covariance = filter.covariance();
        const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(covariance);
        least = std::min(least, solver.eigenvalues().minCoeff());
    }
    EXPECT_EQ(filter.steps(), 10000U);
    EXPECT_GT(filter.best_lines() + filter.best_corners(), 7);
    EXPECT_GT(least, 0.0);
}

TEST(EkfSlam, ALandmarkIsNeverSurerThanTheStartAllows) {
    // A robot that is unsure of its place when it first sees a wall never gets to know the wall
    // better than that: the landmarks' limit covariance (Dissanayake et al., 2001).
    FilterParams params = ekf_params();
    params.motion = {MotionModel::odometry, 0.2, 0.2, 0.0};
    params.observation = {1e-4, 1e-6};
    params.association.ambiguity = AmbiguityRule::off;
    EkfSlam filter(params);
    filter.step({}, {});
    const Control control{{0.1, 0.0, 0.0}, 1.0};
    filter.step(std::span(&control, 1), {});  // now unsure by 0.2 m
    Observation seen;
    seen.lines.push_back({{3.0, 0.0}, 0, 0});
    for (int k = 0; k < 200; ++k) filter.step({}, seen);
    const double var_rho = filter.best_map().at(0).covariance(0, 0);
    EXPECT_GE(var_rho, 0.04);
    EXPECT_LT(var_rho, 0.04 + 1e-4);
}

TEST(EkfSlam, GatesPartMatchedIgnoredAndNew) {
    FilterParams params = ekf_params();
    params.observation = {0.01, 0.01};  // sigma 0.1, alone in the innovation: 0.141
    EkfSlam filter(params);
    const auto outcome = [&](double rho) {
        Observation seen;
        seen.lines.push_back({{rho, 0.0}, 0, 0});
        EkfSlam copy = filter;
        copy.step({}, seen);
        return copy.associations()[0].outcome;
    };
    Observation seen;
    seen.lines.push_back({{3.0, 0.0}, 0, 0});
    filter.step({}, seen);
    EXPECT_EQ(filter.associations()[0].outcome, Association::Outcome::created);
    const double sigma = std::sqrt(0.02);
    // Square roots of the chi-square gates with 2 degrees of freedom: 2.448 and 4.292.
    EXPECT_EQ(outcome(3.0 + 2.44 * sigma), Association::Outcome::matched);
    EXPECT_EQ(outcome(3.0 + 2.46 * sigma), Association::Outcome::ignored);
    EXPECT_EQ(outcome(3.0 + 4.28 * sigma), Association::Outcome::ignored);
    EXPECT_EQ(outcome(3.0 + 4.30 * sigma), Association::Outcome::created);
}

TEST(EkfSlam, AnAmbiguousObservationChangesNoLandmark) {
    FilterParams params = ekf_params();
    params.observation = {0.01, 0.01};
    params.association.ambiguity_ratio = 0.1;
    for (const AmbiguityRule rule : {AmbiguityRule::keep_likelihood, AmbiguityRule::off}) {
        params.association.ambiguity = rule;
        params.association.new_probability = 0.95;
        EkfSlam filter(params);
        Observation walls;
        walls.lines.push_back({{3.0, 0.0}, 0, 0});
        walls.lines.push_back({{3.4, 0.0}, 0, 0});
        filter.step({}, walls);
        ASSERT_EQ(filter.best_lines(), 2);
        Observation between;
        between.lines.push_back({{3.21, 0.0}, 0, 0});
        filter.step({}, between);
        EXPECT_EQ(filter.associations()[0].outcome, rule == AmbiguityRule::off
                                                        ? Association::Outcome::matched
                                                        : Association::Outcome::ignored);
        EXPECT_EQ(filter.best_lines(), 2);
    }
}

TEST(EkfSlam, VariancesNextToNothingBreakNothing) {
    // Far below what doubles can tell apart beside the pose's variance.
    FilterParams params = ekf_params();
    params.observation = {1e-12, 1e-12};
    params.motion = {MotionModel::odometry, 1.0, 1.0, 0.5};
    const Tour tour = make_tour(400, 0.1);
    EkfSlam filter(params);
    for (std::size_t k = 0; k < tour.controls.size(); ++k) {
        filter.step(tour.controls[k], tour.observations[k]);
    }
    EXPECT_TRUE(std::isfinite(filter.best_pose().x));
    EXPECT_TRUE(filter.covariance().allFinite());
    EXPECT_LT(filter.best_lines() + filter.best_corners(), 2500);  // what was seen: 1,800 or so
}

TEST(EkfSlam, AssociationsPointIntoTheMap) {
    EkfSlam filter(ekf_params());
    Observation seen;
    seen.corners.push_back({2.0, 2.0});
    filter.step({}, seen);
    EXPECT_EQ(filter.associations()[0].landmark, 0);
    seen.lines.push_back({{4.0, 1.0}, 0, 0});  // lines come first in the map
    filter.step({}, seen);
    ASSERT_EQ(filter.associations().size(), 2U);
    const LandmarkMap map = filter.best_map();
    for (const Association& association : filter.associations()) {
        ASSERT_GE(association.landmark, 0);
        EXPECT_EQ(map.at(static_cast<std::size_t>(association.landmark)).kind(), association.kind);
    }
    EXPECT_EQ(filter.associations()[0].outcome, Association::Outcome::created);
    EXPECT_EQ(filter.associations()[1].outcome, Association::Outcome::matched);
    EXPECT_EQ(map[1].observations, 2);
}

TEST(EkfSlam, FactoryRefusesImpossibleValues) {
    FilterParams params = ekf_params();
    EXPECT_NE(make_filter(params, 1, 1), nullptr);
    params.association.new_probability = 0.9;  // below the gate
    EXPECT_THROW(make_filter(params, 1, 1), ConfigError);
    params = ekf_params();
    params.observation.var_rho_m2 = 0.0;
    EXPECT_THROW(make_filter(params, 1, 1), ConfigError);
}

}  // namespace
}  // namespace hitos
