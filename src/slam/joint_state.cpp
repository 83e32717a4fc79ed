#include "joint_state.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

#include "hitos/base/memory_need.hpp"

namespace hitos {

void JointState::move(const Pose& pose, const Matrix3& f, const Matrix3& q) {
    mean_.head<3>() << pose.x, pose.y, pose.theta;
    const Matrix3 moved = f * pose_covariance() * f.transpose() + q;
    for (Eigen::Index j = 0; j < kPose; ++j) {
        for (Eigen::Index i = j; i < kPose; ++i) covariance_(i, j) = moved(i, j);
    }
    auto cross = covariance_.block(kPose, 0, size_ - kPose, kPose);
    cross = (cross * f.transpose()).eval();
}

template <int Columns>
void JointState::read_columns(Eigen::Index first, Eigen::Ref<Eigen::MatrixXd> out) const {
    out.topRows(first) = covariance_.block(first, 0, Columns, first).transpose();
    out.middleRows(first, Columns) = covariance_block<Columns, Columns>(first, first);
    const Eigen::Index below = first + Columns;
    out.bottomRows(size_ - below) = covariance_.block(below, first, size_ - below, Columns);
}

void JointState::update(std::span<const Row> rows) {
    if (rows.empty()) return;
    const auto count = 2 * static_cast<Eigen::Index>(rows.size());
    columns_.resize(size_, kPose + 2);
    w_.resize(size_, count);
    s_.resize(count, count);
    Eigen::VectorXd nu(count);
    read_columns<kPose>(0, columns_.leftCols<kPose>());
    for (Eigen::Index k = 0; k < count; k += 2) {
        const Row& row = rows[static_cast<std::size_t>(k / 2)];
        read_columns<2>(row.at, columns_.rightCols<2>());
        w_.middleCols<2>(k).noalias() = columns_.leftCols<kPose>() * row.by_pose.transpose() +
                                        columns_.rightCols<2>() * row.by_landmark.transpose();
        nu.segment<2>(k) = row.nu;
    }
    for (Eigen::Index k = 0; k < count; k += 2) {
        const Row& row = rows[static_cast<std::size_t>(k / 2)];
        s_.middleRows<2>(k) =
            row.by_pose * w_.topRows<kPose>() + row.by_landmark * w_.middleRows<2>(row.at);
        s_.block<2, 2>(k, k) += row.r;
    }
    const Eigen::LLT<Eigen::MatrixXd> factor(s_);
    if (factor.info() != Eigen::Success) return;
    mean_.head(size_).noalias() += w_ * factor.solve(nu);
    factor.matrixU().solveInPlace<Eigen::OnTheRight>(w_);
    covariance_.topLeftCorner(size_, size_).selfadjointView<Eigen::Lower>().rankUpdate(w_, -1.0);
}

Eigen::Index JointState::append(const Vector2& mean, const Matrix23& by_pose, const Matrix2& own) {
    const Eigen::Index at = size_;
    grow(at + 2);
    mean_.segment<2>(at) = mean;
    covariance_.block<2, 3>(at, 0) = by_pose * pose_covariance();
    covariance_.block(at, kPose, 2, at - kPose) =
        by_pose * covariance_.block(kPose, 0, at - kPose, kPose).transpose();
    covariance_.block<2, 2>(at, at) = by_pose * pose_covariance() * by_pose.transpose() + own;
    size_ = at + 2;
    return at;
}

void JointState::negate(Eigen::Index component) {
    covariance_.row(component).head(component) *= -1.0;
    covariance_.col(component).segment(component + 1, size_ - component - 1) *= -1.0;
}

Matrix2 JointState::difference_covariance(Eigen::Index first, Eigen::Index second,
                                          double sign) const {
    Matrix2 f = Matrix2::Identity();
    f(0, 0) = sign;
    const Matrix2 cross = landmarks_covariance(first, second) * f.transpose();
    return landmark_covariance(first) + f * landmark_covariance(second) * f.transpose() - cross -
           cross.transpose();
}

void JointState::join(Eigen::Index first, Eigen::Index second, const Vector2& nu, double sign,
                      const Matrix2& r) {
    Matrix2 f = Matrix2::Identity();
    f(0, 0) = sign;
    columns_.resize(size_, 4);
    read_columns<2>(first, columns_.leftCols<2>());
    read_columns<2>(second, columns_.rightCols<2>());
    w_ = columns_.leftCols<2>() - columns_.rightCols<2>() * f;
    const Matrix2 s = difference_covariance(first, second, sign) + r;
    const Eigen::LLT<Matrix2> factor(s);
    const bool regular = factor.info() == Eigen::Success;
    if (!regular) return;
    mean_.head(size_).noalias() -= w_ * factor.solve(nu);
    factor.matrixU().solveInPlace<Eigen::OnTheRight>(w_);
    covariance_.topLeftCorner(size_, size_).selfadjointView<Eigen::Lower>().rankUpdate(w_, -1.0);
}

void JointState::remove(Eigen::Index at) {
    const Eigen::Index behind = size_ - at - 2;
    mean_.segment(at, behind) = mean_.segment(at + 2, behind).eval();
    covariance_.block(at, 0, behind, at) = covariance_.block(at + 2, 0, behind, at).eval();
    covariance_.block(at, at, behind, behind) =
        covariance_.block(at + 2, at + 2, behind, behind).eval();
    size_ -= 2;
}

void JointState::transform(const Matrix3& by_pose, std::span<const Turn> landmarks) {
    const auto left = [&](Eigen::Index row, Eigen::Index rows, const auto& by) {
        covariance_.block(row, 0, rows, row) = (by * covariance_.block(row, 0, rows, row)).eval();
    };
    const auto right = [&](Eigen::Index column, Eigen::Index columns, const auto& by) {
        const Eigen::Index below = size_ - column - columns;
        auto block = covariance_.block(column + columns, column, below, columns);
        block = (block * by.transpose()).eval();
    };
    const Matrix3 pose = by_pose * pose_covariance() * by_pose.transpose();
    covariance_.topLeftCorner<3, 3>() = pose;
    right(0, kPose, by_pose);
    for (const Turn& turn : landmarks) {
        left(turn.at, 2, turn.by);
        right(turn.at, 2, turn.by);
        const Matrix2 own = turn.by * landmark_covariance(turn.at) * turn.by.transpose();
        covariance_.block<2, 2>(turn.at, turn.at) = own;
    }
}

void JointState::grow(Eigen::Index size) {
    if (size <= covariance_.rows()) return;
    // By a quarter: the memory goes with the square. Columns stay aligned.
    constexpr Eigen::Index kAligned = 8;
    const Eigen::Index wished = std::max({size, covariance_.rows() * 5 / 4, Eigen::Index{32}});
    const Eigen::Index capacity = (wished + kAligned - 1) / kAligned * kAligned;
    const auto columns = static_cast<std::size_t>(capacity);
    require_memory(columns * columns * sizeof(double));
    mean_.conservativeResize(capacity);
    covariance_.conservativeResize(capacity, capacity);
}

Eigen::MatrixXd JointState::covariance() const {
    return covariance_.topLeftCorner(size_, size_).selfadjointView<Eigen::Lower>();
}

}  // namespace hitos
