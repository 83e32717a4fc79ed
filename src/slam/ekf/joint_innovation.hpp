// SPDX-License-Identifier: GPL-3.0-or-later
// The joint innovation of several pairings in EKF-SLAM.
#pragma once

#include <span>
#include <vector>

#include "association/joint_compatibility.hpp"
#include "joint_state.hpp"

namespace hitos {

/// nu' S^-1 nu of the pairings, S = H P H' + R with everything that pose and landmarks share. With
/// S = L L' a pairing more appends two rows to L and two components to y = L^-1 nu, so that the
/// distance |y|^2 grows by those alone. JointCandidate::place is the pairing's row.
class JointInnovationDistance final : public JointDistance {
  public:
    /// Both must outlive it, and stay as they are.
    JointInnovationDistance(const JointState& state, std::span<const JointState::Row> rows);

    double push(const JointCandidate& pairing) override;
    void pop() override;

  private:
    /// The covariance of the innovations of two pairings, without R.
    Matrix2 covariance(const JointState::Row& a, const JointState::Row& b) const;

    const JointState& state_;
    std::span<const JointState::Row> rows_;
    std::vector<std::uint32_t> paired_;
    std::vector<double> distances_;
    Eigen::MatrixXd l_;  // lower triangle, two rows a pairing
    Eigen::VectorXd y_;
};

}  // namespace hitos
