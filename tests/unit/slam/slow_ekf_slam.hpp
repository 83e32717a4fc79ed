// SPDX-License-Identifier: GPL-3.0-or-later
// EKF-SLAM as slow and plain as can be, to compare the real one with.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "association/measurement.hpp"
#include "hitos/slam/params.hpp"
#include "hitos/slam/robot.hpp"

namespace hitos {

/// The slope of a function of a vector, by central differences; angles of the result are rows in
/// `angles`.
template <class F>
Eigen::MatrixXd slope(const F& f, const Eigen::VectorXd& at, const std::vector<int>& angles) {
    constexpr double kStep = 1e-6;
    Eigen::MatrixXd out(f(at).size(), at.size());
    for (Eigen::Index k = 0; k < at.size(); ++k) {
        Eigen::VectorXd plus = at;
        Eigen::VectorXd minus = at;
        plus(k) += kStep;
        minus(k) -= kStep;
        Eigen::VectorXd difference = f(plus) - f(minus);
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
    explicit SlowEkfSlam(const FilterParams& params)
        : params_(params), robot_(make_robot(params.motion)) {}

    void step(const std::vector<Control>& controls, const Observation& observation) {
        const MotionIncrement increment = sum_controls(controls);
        const Pose before = pose();
        const auto move = [&](const Eigen::VectorXd& state) {
            Eigen::VectorXd out = state;
            const Pose after = robot_->mean({state(0), state(1), state(2)}, increment);
            out.head<3>() << after.x, after.y, after.theta;
            return out;
        };
        const Eigen::MatrixXd f = slope(move, x_, {2});
        x_ = move(x_);
        p_ = f * p_ * f.transpose();
        if (steps_++ > 0) {
            p_.topLeftCorner<3, 3>() += robot_->noise_covariance(before, increment);
        }

        Measurements seen;
        measure(observation, params_.observation, seen);
        struct Match {
            std::size_t landmark;
            Vector2 nu;
            Eigen::MatrixXd h;
            Matrix2 r;
        };
        const double gate = -2.0 * std::log(1.0 - params_.association.gate_probability);
        std::vector<Match> matches;
        std::vector<std::pair<bool, Measurement>> fresh;  // is it a line?
        for (int kind = 0; kind < 2; ++kind) {
            for (const Measurement& m :
                 kind == 0 ? seen.of<SensorRecta>() : seen.of<SensorEsquina>()) {
                double nearest = 1e300;
                double nearest_log = -1e300;
                std::vector<double> plausible;  // ln likelihoods of those inside the gate
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
                    const Eigen::MatrixXd h = slope(
                        [&](const Eigen::VectorXd& s) {
                            return Eigen::VectorXd(predict(s, i, flipped));
                        },
                        x_, {1});
                    const Matrix2 s = h * p_ * h.transpose() + m.r;
                    const double d2 = nu.dot(s.inverse() * nu);
                    const double log_likelihood = -0.5 * d2 - 0.5 * std::log(s.determinant());
                    if (d2 <= gate) plausible.push_back(log_likelihood);
                    if (d2 < nearest) {
                        nearest = d2;
                        nearest_log = log_likelihood;
                        match = {i, nu, h, m.r};
                    }
                }
                const double far = -2.0 * std::log(1.0 - params_.association.new_probability);
                // Any other than the nearest whose likelihood is near its own.
                const auto rivals = std::ranges::count_if(plausible, [&](double log) {
                    return std::exp(log - nearest_log) > params_.association.ambiguity_ratio;
                });
                const bool ambiguous = rivals > 1;
                if (nearest <= gate && !ambiguous) matches.push_back(match);
                if (nearest > far) fresh.emplace_back(kind == 0, m);
            }
        }
        if (!matches.empty()) {
            const auto rows = 2 * static_cast<Eigen::Index>(matches.size());
            Eigen::VectorXd nu(rows);
            Eigen::MatrixXd h(rows, x_.size());
            Eigen::MatrixXd r = Eigen::MatrixXd::Zero(rows, rows);
            for (Eigen::Index k = 0; k < rows; k += 2) {
                const Match& match = matches[static_cast<std::size_t>(k / 2)];
                nu.segment<2>(k) = match.nu;
                h.middleRows<2>(k) = match.h;
                r.block<2, 2>(k, k) = match.r;
            }
            const Eigen::MatrixXd gain =
                p_ * h.transpose() * (h * p_ * h.transpose() + r).inverse();
            const Eigen::MatrixXd rest = Eigen::MatrixXd::Identity(x_.size(), x_.size()) - gain * h;
            x_ += gain * nu;
            p_ = rest * p_ * rest.transpose() + gain * r * gain.transpose();
        }
        normalize();
        for (const auto& [line, m] : fresh) add(line, m);
        normalize();
    }

    Pose pose() const { return {x_(0), x_(1), x_(2)}; }
    const Eigen::VectorXd& state() const { return x_; }
    const Eigen::MatrixXd& covariance() const { return p_; }

  private:
    Vector2 predict(const Eigen::VectorXd& state, std::size_t i, bool flipped) const {
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
        const auto place = [&](const Eigen::VectorXd& arguments) {  // x, y, theta, z0, z1
            const double angle = arguments(2) + arguments(4);
            Eigen::VectorXd out(2);
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
        Eigen::VectorXd arguments(5);
        arguments << x_(0), x_(1), x_(2), m.z(0), m.z(1);
        const Eigen::MatrixXd g = slope(place, arguments, {});
        const Eigen::Index n = x_.size();
        Eigen::MatrixXd whole =
            Eigen::MatrixXd::Zero(n + 2, n + 2);  // d(state with the new one)/d(state, z)
        whole.topLeftCorner(n, n).setIdentity();
        whole.block(n, 0, 2, 3) = g.leftCols(3);
        whole.bottomRightCorner(2, 2) = g.rightCols(2);
        Eigen::MatrixXd both = Eigen::MatrixXd::Zero(n + 2, n + 2);
        both.topLeftCorner(n, n) = p_;
        both.bottomRightCorner(2, 2) = m.r;
        p_ = whole * both * whole.transpose();
        Eigen::VectorXd larger(n + 2);
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
    std::unique_ptr<Robot> robot_;
    int steps_ = 0;
    Eigen::VectorXd x_ = Eigen::VectorXd::Zero(3);
    Eigen::MatrixXd p_ = Eigen::MatrixXd::Zero(3, 3);
    std::vector<bool> is_line_;
};

}  // namespace hitos
