// SPDX-License-Identifier: GPL-3.0-or-later
// The Gaussian that EKF-SLAM carries: pose and landmarks in one state [P eq 3, 9].
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "half_matrix.hpp"
#include "hitos/features/caracteristica.hpp"
#include "models/sensor.hpp"
#include "tall_matrix.hpp"

namespace hitos {

/// Mean and covariance of (x, y, theta, first landmark, second, …), two components a landmark.
///
/// Only half of the covariance is kept, and only what is at hand is kept up to date: the columns of
/// the pose and of the landmarks attended to, those that were seen of late, and every landmark's
/// own block. How landmarks out of sight covary follows when it is asked for, as in the compressed
/// filter (Guivant & Nebot, "Optimization of the simultaneous localization and map-building
/// algorithm for real-time implementation", IEEE Transactions on Robotics and Automation 17(3),
/// 2001): with C their covariances with all that is attended to, as they were at first, all that is
/// learnt takes a C Z Z' C' from their covariance, Z of as few rows as C has columns. Nothing is
/// neglected; a step costs time linear in the number of landmarks, and settle() brings all up to
/// date by one pass when too many are attended to.
class JointState {
  public:
    static constexpr Eigen::Index kPose = 3;

    JointState();

    Eigen::Index size() const { return size_; }
    Pose pose() const { return {mean_(0), mean_(1), mean_(2)}; }
    Matrix3 pose_covariance() const;

    /// Components `at` and `at` + 1.
    Vector2 landmark(Eigen::Index at) const { return mean_.segment<2>(at + 1); }
    Matrix2 landmark_covariance(Eigen::Index at) const;
    /// Covariance of a landmark with the pose.
    Matrix23 cross_covariance(Eigen::Index at) const;

    /// Covariance of one landmark with another, or with itself; quick where one of them is
    /// attended to or nothing has been learnt since settle().
    Matrix2 landmarks_covariance(Eigen::Index a, Eigen::Index b) const;

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
    /// Brings the columns of these landmarks to hand.
    void attend(std::vector<Eigen::Index> places);

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
    void set_landmark(Eigen::Index at, const Vector2& mean) { mean_.segment<2>(at + 1) = mean; }
    /// Turns the sign of one component's covariances with all others; the caller sets its mean.
    void negate(Eigen::Index component);

    /// Brings all covariances up to date; nothing but the pose is attended to then.
    void settle();

    /// The whole covariance, both triangles; for tests and measures.
    Eigen::MatrixXd covariance() const;
    std::size_t bytes() const;

  private:
    // Within, the pose has a fourth component that is always 0, so that landmarks begin at even
    // rows and no panel parts one: a component of a landmark stands one row further down.
    static constexpr std::size_t kFirst = 4;
    static std::size_t row_of(Eigen::Index at) { return static_cast<std::size_t>(at) + 1; }
    std::size_t rows() const { return static_cast<std::size_t>(size_) + 1; }
    std::size_t landmarks() const { return static_cast<std::size_t>(size_ - kPose) / 2; }

    /// A measurement by columns at hand: two rows of H, with zeros for columns not needed.
    struct Reading {
        static constexpr std::size_t kColumns = 5;
        std::array<std::size_t, kColumns> columns{};
        Eigen::Matrix<double, 2, kColumns> by;
        Vector2 nu;
        Matrix2 r;
    };
    void learn(std::span<const Reading> readings);

    /// Where a landmark's columns at hand begin; 0 where they are not.
    std::size_t column_of(Eigen::Index at) const {
        return column_of_[static_cast<std::size_t>(at - kPose) / 2];
    }
    std::size_t columns() const { return kFirst + 2 * attended_.size(); }
    /// The row whose covariances stand in a column at hand.
    std::size_t row_of_column(std::size_t column) const;
    void attend_to(Eigen::Index at);
    /// Makes a landmark's two columns the next ones; `row` is its first row.
    void take_column(std::size_t row);
    /// Whether the covariances of landmarks out of sight may lag behind.
    bool lags() const { return attended_.size() < landmarks(); }
    /// C Z of a row, of a landmark out of sight.
    Eigen::VectorXd gained_of(std::size_t row) const;
    /// What is behind the columns at hand once nothing but the pose is.
    void begin_anew();
    void set_rows(Eigen::Index size);
    /// Makes room for so many more columns at hand, where need be by settle(): for so many then.
    void make_room(std::size_t more, std::size_t anew);

    Eigen::Index size_ = kPose;
    Eigen::VectorXd mean_;
    TallMatrix hand_;  ///< columns at hand: three of the pose, one of zeros, two a landmark
    TallMatrix own_;   ///< of every row P_ii, and P_i,i+1 where a landmark begins
    std::vector<std::size_t> attended_;   ///< first rows of the landmarks at hand
    std::vector<std::size_t> column_of_;  ///< of every landmark
    HalfMatrix settled_;  ///< the covariance as it was; of landmarks at hand nothing that counts
    TallMatrix first_;    ///< C
    std::size_t first_columns_ = kFirst;
    TallMatrix now_;     ///< what makes the columns at hand of those of C, landmarks out of sight
    TallMatrix gained_;  ///< Z, lower triangle
    bool lagging_ = false;
    // Working memory of learn() and settle().
    TallMatrix w_;
    TallMatrix w_now_;
    std::vector<double> factors_;
    std::vector<double> by_;
};

}  // namespace hitos
