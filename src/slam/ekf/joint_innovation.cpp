// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint_innovation.hpp"

#include <Eigen/Cholesky>
#include <limits>

namespace hitos {

JointInnovationDistance::JointInnovationDistance(const JointState& state,
                                                 std::span<const JointState::Row> rows)
    : state_(state), rows_(rows) {}

Matrix2 JointInnovationDistance::covariance(const JointState::Row& a,
                                            const JointState::Row& b) const {
    const Matrix23 by_pose =
        a.by_pose * state_.pose_covariance() + a.by_landmark * state_.cross_covariance(a.at);
    const Matrix2 by_landmark = a.by_pose * state_.cross_covariance(b.at).transpose() +
                                a.by_landmark * state_.landmarks_covariance(a.at, b.at);
    return by_pose * b.by_pose.transpose() + by_landmark * b.by_landmark.transpose();
}

double JointInnovationDistance::push(const JointCandidate& pairing) {
    const JointState::Row& row = rows_[pairing.place];
    const auto before = 2 * static_cast<Eigen::Index>(paired_.size());
    if (l_.rows() < before + 2) {
        const Eigen::Index room = std::max<Eigen::Index>(2 * l_.rows(), 16);
        l_.conservativeResize(room, room);
        y_.conservativeResize(room);
    }
    Eigen::Matrix<double, Eigen::Dynamic, 2> across(before, 2);
    for (std::size_t j = 0; j < paired_.size(); ++j) {
        across.middleRows<2>(2 * static_cast<Eigen::Index>(j)) = covariance(rows_[paired_[j]], row);
    }
    l_.topLeftCorner(before, before).triangularView<Eigen::Lower>().solveInPlace(across);
    const Matrix2 rest = covariance(row, row) + row.r - across.transpose() * across;
    const Eigen::LLT<Matrix2> factor(rest);
    const bool positive = factor.info() == Eigen::Success;
    l_.block(before, 0, 2, before) = across.transpose();
    l_.block<2, 2>(before, before) = factor.matrixL();
    const Vector2 left = row.nu - across.transpose() * y_.head(before);
    y_.segment<2>(before) = factor.matrixL().solve(left);
    const double sum =
        (distances_.empty() ? 0.0 : distances_.back()) + y_.segment<2>(before).squaredNorm();
    paired_.push_back(pairing.place);
    // Rounding can cost S its positivity where variances are next to nothing.
    distances_.push_back(positive && sum >= 0.0 ? sum : std::numeric_limits<double>::infinity());
    return distances_.back();
}

void JointInnovationDistance::pop() {
    paired_.pop_back();
    distances_.pop_back();
}

}  // namespace hitos
