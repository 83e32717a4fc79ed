// The Gaussian that EKF-SLAM carries: pose and landmarks in one state [P eq 3, 9].
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <span>

#include "hitos/features/caracteristica.hpp"
#include "models/sensor.hpp"

namespace hitos {

/// Mean and covariance of (x, y, theta, first landmark, second, …), two components a landmark.
/// Only the covariance's lower triangle is kept: it cannot be but symmetric.
class JointState {
  public:
    static constexpr Eigen::Index kPose = 3;

    Eigen::Index size() const { return size_; }
    Pose pose() const { return {mean_(0), mean_(1), mean_(2)}; }
    Matrix3 pose_covariance() const { return covariance_block<3, 3>(0, 0); }

    /// Components `at` and `at` + 1.
    Vector2 landmark(Eigen::Index at) const { return mean_.segment<2>(at); }
    Matrix2 landmark_covariance(Eigen::Index at) const { return covariance_block<2, 2>(at, at); }
    /// Covariance of a landmark with the pose.
    Matrix23 cross_covariance(Eigen::Index at) const { return covariance_block<2, 3>(at, 0); }

    /// Covariance of one landmark with another, or with itself.
    Matrix2 landmarks_covariance(Eigen::Index a, Eigen::Index b) const {
        return covariance_block<2, 2>(a, b);
    }

    /// Moves the pose and carries its covariance: P_rr = F P_rr F' + Q, P_mr = P_mr F'
    /// [P eq 10, 11, 15].
    void move(const Pose& pose, const Matrix3& f, const Matrix3& q);

    /// A measurement of a landmark: innovation, and the Jacobians of h by pose and landmark.
    struct Row {
        Eigen::Index at = 0;
        Vector2 nu;
        Matrix23 by_pose;
        Matrix2 by_landmark;
        Matrix2 r;
    };
    /// One update with all rows [P eq 24-28]: with W = P H', S = H W + R = L L' and U = W L'^-1,
    /// mean += W S^-1 nu, P -= U U', which is (I - K H) P but symmetric. Angles are left as they
    /// come. Where rounding has cost S its positivity nothing is learnt.
    void update(std::span<const Row> rows);

    /// Appends a landmark at `mean` with covariance G P_rr G' + `own` and its covariances with all
    /// that is there, G = d(landmark)/d(pose) [P eq 29-34]. Returns its place.
    Eigen::Index append(const Vector2& mean, const Matrix23& by_pose, const Matrix2& own);

    /// Two landmarks are said to be one: of the components of the first minus those of the second,
    /// with the second's first one times `sign`, the difference `nu` should be 0 up to a noise of
    /// covariance R. Learns that as update() learns a measurement, for pose and all landmarks.
    void join(Eigen::Index first, Eigen::Index second, const Vector2& nu, double sign,
              const Matrix2& r);
    /// Covariance of that difference.
    Matrix2 difference_covariance(Eigen::Index first, Eigen::Index second, double sign) const;
    /// Takes a landmark out; those behind it move up by two components.
    void remove(Eigen::Index at);

    /// How a landmark is transformed: its covariances by this Jacobian.
    struct Turn {
        Eigen::Index at = 0;
        Matrix2 by;
    };
    /// P = J P J' with J of one block for the pose and one for every landmark; the caller sets the
    /// means. `landmarks` are all there are, in the order of their places.
    void transform(const Matrix3& by_pose, std::span<const Turn> landmarks);

    void set_pose(const Pose& pose) { mean_.head<3>() << pose.x, pose.y, pose.theta; }
    void set_heading(double theta) { mean_(2) = theta; }
    void set_landmark(Eigen::Index at, const Vector2& mean) { mean_.segment<2>(at) = mean; }
    /// Turns the sign of one component's covariances with all others; the caller sets its mean.
    void negate(Eigen::Index component);

    /// The whole covariance, both triangles; for tests and measures.
    Eigen::MatrixXd covariance() const;

  private:
    template <int Rows, int Columns>
    Eigen::Matrix<double, Rows, Columns> covariance_block(Eigen::Index row,
                                                          Eigen::Index column) const {
        Eigen::Matrix<double, Rows, Columns> block;
        for (Eigen::Index j = 0; j < Columns; ++j) {
            for (Eigen::Index i = 0; i < Rows; ++i) {
                block(i, j) =
                    covariance_(std::max(row + i, column + j), std::min(row + i, column + j));
            }
        }
        return block;
    }
    /// Whole columns [first, first + Columns) of the symmetric covariance.
    template <int Columns>
    void read_columns(Eigen::Index first, Eigen::Ref<Eigen::MatrixXd> out) const;
    void grow(Eigen::Index size);

    Eigen::Index size_ = kPose;
    Eigen::VectorXd mean_ = Eigen::VectorXd::Zero(kPose);
    Eigen::MatrixXd covariance_ = Eigen::MatrixXd::Zero(kPose, kPose);  // lower triangle
    // Working memory of update().
    Eigen::MatrixXd columns_;
    Eigen::MatrixXd w_;
    Eigen::MatrixXd s_;
};

}  // namespace hitos
