// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint_state.hpp"

#include <algorithm>

namespace hitos {
namespace {

/// Three strips, each become the sum of all three by a row of F.
HITOS_INLINE void turn_three(double* x, double* y, double* z, const Matrix3& f) {
    const double xx = f(0, 0);
    const double xy = f(0, 1);
    const double xz = f(0, 2);
    const double yx = f(1, 0);
    const double yy = f(1, 1);
    const double yz = f(1, 2);
    const double zx = f(2, 0);
    const double zy = f(2, 1);
    const double zz = f(2, 2);
    HITOS_LANES
    for (std::size_t i = 0; i < Strip::kRows; ++i) {
        const double x0 = x[i];
        const double y0 = y[i];
        const double z0 = z[i];
        x[i] = x0 * xx + y0 * xy + z0 * xz;
        y[i] = x0 * yx + y0 * yy + z0 * yz;
        z[i] = x0 * zx + y0 * zy + z0 * zz;
    }
}

/// P_mr F' of all rows.
void turn_pose(TallMatrix& columns, const Matrix3& f) {
    vectorised([&]() HITOS_INLINED {
        for (std::size_t p = 0; p < columns.panels(); ++p) {
            double* const x = columns.panel(p);
            turn_three(x, x + Strip::kRows, x + 2 * Strip::kRows, f);
        }
    });
}

/// Two columns become what the first three are by the rows of G.
void add_columns(TallMatrix& columns, std::size_t at, const Matrix23& g) {
    for (std::size_t p = 0; p < columns.panels(); ++p) {
        double* const x = columns.panel(p);
        for (Eigen::Index k = 0; k < 2; ++k) {
            double* const to = x + (at + static_cast<std::size_t>(k)) * Strip::kRows;
            for (std::size_t i = 0; i < Strip::kRows; ++i) {
                to[i] = g(k, 0) * x[i] + g(k, 1) * x[Strip::kRows + i] +
                        g(k, 2) * x[2 * Strip::kRows + i];
            }
        }
    }
}

}  // namespace

JointState::JointState() {
    hand_.reshape(0, Strip::kRows);
    own_.reshape(0, 2);
    set_rows(kPose);
}

Matrix3 JointState::pose_covariance() const {
    Matrix3 p;
    for (Eigen::Index i = 0; i < 3; ++i) {
        for (Eigen::Index j = 0; j < 3; ++j) {
            p(i, j) = hand_(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
        }
    }
    return p;
}

Matrix2 JointState::landmark_covariance(Eigen::Index at) const {
    const std::size_t row = row_of(at);
    Matrix2 p;
    p << own_(row, 0), own_(row, 1), own_(row, 1), own_(row + 1, 0);
    return p;
}

Matrix23 JointState::cross_covariance(Eigen::Index at) const {
    const std::size_t row = row_of(at);
    Matrix23 p;
    p << hand_(row, 0), hand_(row, 1), hand_(row, 2), hand_(row + 1, 0), hand_(row + 1, 1),
        hand_(row + 1, 2);
    return p;
}

Matrix2 JointState::landmarks_covariance(Eigen::Index a, Eigen::Index b) const {
    if (a == b) return landmark_covariance(a);
    const std::size_t row = row_of(a);
    Matrix2 p;
    if (const std::size_t column = column_of(b); column > 0) {
        p << hand_(row, column), hand_(row, column + 1), hand_(row + 1, column),
            hand_(row + 1, column + 1);
        return p;
    }
    if (column_of(a) > 0) return landmarks_covariance(b, a).transpose();
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) {
            const double learnt = lagging_ ? gained_of(row + i).dot(gained_of(row_of(b) + j)) : 0.0;
            p(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                settled_(row + i, row_of(b) + j) - learnt;
        }
    }
    return p;
}

void JointState::move(const Pose& pose, const Matrix3& f, const Matrix3& q) {
    set_pose(pose);
    const Matrix3 moved = f * pose_covariance() * f.transpose() + q;
    turn_pose(hand_, f);
    if (lags()) turn_pose(now_, f);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const auto [low, high] = std::minmax(i, j);
            hand_(i, j) = moved(static_cast<Eigen::Index>(high), static_cast<Eigen::Index>(low));
        }
        for (std::size_t column = kFirst; column < columns(); ++column) {
            hand_(i, column) = hand_(row_of_column(column), i);
        }
    }
}

Eigen::Index JointState::append(const Vector2& mean, const Matrix23& by_pose, const Matrix2& own) {
    make_room(2, 2);
    const Eigen::Index at = size_;
    const std::size_t column = columns();
    set_rows(at + 2);
    set_landmark(at, mean);
    const std::size_t row = row_of(at);
    const Matrix2 whole = by_pose * pose_covariance() * by_pose.transpose() + own;
    add_columns(hand_, column, by_pose);
    if (lags()) add_columns(now_, column, by_pose);
    take_column(row);
    for (std::size_t k = 0; k < 2; ++k) {
        for (std::size_t other = 0; other < column; ++other) {
            hand_(row + k, other) = hand_(row_of_column(other), column + k);
        }
    }
    hand_(row, column) = own_(row, 0) = whole(0, 0);
    hand_(row + 1, column + 1) = own_(row + 1, 0) = whole(1, 1);
    hand_(row, column + 1) = hand_(row + 1, column) = own_(row, 1) = whole(1, 0);
    return at;
}

void JointState::negate(Eigen::Index component) {
    const std::size_t row = row_of(component);
    const std::size_t landmark = row - row % 2;
    own_(landmark, 1) *= -1.0;
    for (std::size_t c = 0; c < columns(); ++c) hand_(row, c) *= -1.0;
    const std::size_t begin = column_of_[(landmark - kFirst) / 2];
    if (begin == 0) {
        settled_.negate(row);
        for (std::size_t c = 0; c < first_columns_; ++c) first_(row, c) *= -1.0;
        return;
    }
    const std::size_t column = begin + row % 2;
    for (std::size_t i = 0; i < rows(); ++i) hand_(i, column) *= -1.0;
    for (std::size_t i = 0; lags() && i < first_columns_; ++i) now_(i, column) *= -1.0;
}

Matrix2 JointState::difference_covariance(Eigen::Index first, Eigen::Index second,
                                          double sign) const {
    Matrix2 f = Matrix2::Identity();
    f(0, 0) = sign;
    const Matrix2 cross = landmarks_covariance(first, second) * f.transpose();
    return landmark_covariance(first) + f * landmark_covariance(second) * f.transpose() - cross -
           cross.transpose();
}

void JointState::settle() {
    settled_.resize(rows());
    if (lagging_ && lags()) {
        const std::size_t count = first_columns_;
        const std::size_t terms = whole_terms(count);
        by_.assign(terms * count, 0.0);
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t j = 0; j <= i; ++j) by_[i * count + j] = gained_(i, j);
        }
        w_.reshape(hand_.panels(), terms);
        vectorised([&]() HITOS_INLINED {
            for (std::size_t p = 0; p < w_.panels(); ++p) {
                std::fill_n(w_.panel(p), terms * Strip::kRows, 0.0);
                subtract_products(w_.panel(p), count, first_.panel(p), by_.data(), count, terms);
            }
        });
        settled_.subtract_square(w_, terms);
    }
    for (std::size_t c = 0; c < columns(); ++c) settled_.write_column(row_of_column(c), hand_, c);
    for (std::size_t i = kFirst; i < rows(); i += 2) {
        settled_.set(i, i, own_(i, 0));
        settled_.set(i + 1, i, own_(i, 1));
        settled_.set(i + 1, i + 1, own_(i + 1, 0));
    }
    begin_anew();
}

void JointState::begin_anew() {
    attended_.clear();
    std::ranges::fill(column_of_, 0);
    lagging_ = false;
    first_columns_ = kFirst;
    const std::size_t room = hand_.columns();
    first_.reshape(hand_.panels(), room);
    for (std::size_t p = 0; p < first_.panels(); ++p) {
        std::copy_n(hand_.panel(p), kFirst * Strip::kRows, first_.panel(p));
    }
    for (TallMatrix* square : {&now_, &gained_}) {
        square->reshape(room / Strip::kRows, room);
        for (std::size_t p = 0; p < square->panels(); ++p) {
            std::fill_n(square->panel(p), room * Strip::kRows, 0.0);
        }
    }
    for (std::size_t i = 0; i + 1 < kFirst; ++i) now_(i, i) = 1.0;
}

void JointState::set_rows(Eigen::Index size) {
    // Counted last: where memory ends, the state is as it was.
    const auto count = static_cast<std::size_t>(size) + 1;
    const std::size_t panels = (count + Strip::kRows - 1) / Strip::kRows;
    if (settled_.size() > 0) {  // else all are at hand
        settled_.resize(count);
        first_.set_panels(panels);
    }
    own_.set_panels(panels);
    mean_.conservativeResizeLike(
        Eigen::VectorXd::Zero(static_cast<Eigen::Index>(panels * Strip::kRows)));
    column_of_.resize(static_cast<std::size_t>(size - kPose) / 2);
    hand_.set_panels(panels);  // by which the others are walked through
    size_ = size;
}

void JointState::make_room(std::size_t more, std::size_t anew) {
    constexpr std::size_t kMost =
        2 * Strip::kRows;  // 30 landmarks; more where more are needed at once
    std::size_t needed = columns() + more;
    if (needed <= hand_.columns()) return;
    if (needed > kMost) {
        settle();
        needed = std::max(columns() + anew, kMost);
    }
    const std::size_t room = (needed + Strip::kRows - 1) / Strip::kRows * Strip::kRows;
    if (room == hand_.columns()) return;
    if (settled_.size() > 0) {
        first_.set_columns(room);
        for (TallMatrix* square : {&now_, &gained_}) {
            square->set_columns(room);
            square->set_panels(room / Strip::kRows);
        }
    }
    hand_.set_columns(room);  // which tells that there is room
}

void JointState::remove(Eigen::Index at) {
    settle();
    const Eigen::Index behind = size_ - at - 2;
    mean_.segment(at + 1, behind) = mean_.segment(at + 3, behind).eval();
    settled_.remove(row_of(at), 2);
    for (std::size_t i = row_of(at); i + 2 < rows(); ++i) {
        for (std::size_t c = 0; c < kFirst; ++c) hand_(i, c) = hand_(i + 2, c);
        for (std::size_t c = 0; c < 2; ++c) own_(i, c) = own_(i + 2, c);
    }
    for (std::size_t i = rows() - 2; i < rows(); ++i) {
        for (std::size_t c = 0; c < kFirst; ++c) hand_(i, c) = 0.0;
    }
    set_rows(size_ - 2);
    begin_anew();
}

void JointState::transform(const Matrix3& by_pose, std::span<const Turn> landmarks) {
    settle();
    const Matrix3 pose = by_pose * pose_covariance() * by_pose.transpose();
    turn_pose(hand_, by_pose);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const auto [low, high] = std::minmax(i, j);
            hand_(i, j) = pose(static_cast<Eigen::Index>(high), static_cast<Eigen::Index>(low));
        }
    }
    for (std::size_t a = 0; a < landmarks.size(); ++a) {
        const Matrix2& by = landmarks[a].by;
        const std::size_t row = row_of(landmarks[a].at);
        for (std::size_t c = 0; c < 3; ++c) {
            const Vector2 cross = by * Vector2(hand_(row, c), hand_(row + 1, c));
            hand_(row, c) = cross(0);
            hand_(row + 1, c) = cross(1);
        }
        for (std::size_t b = 0; b <= a; ++b) {
            const std::size_t column = row_of(landmarks[b].at);
            Matrix2 p;
            p << settled_(row, column), settled_(row, column + 1), settled_(row + 1, column),
                settled_(row + 1, column + 1);
            p = by * p * landmarks[b].by.transpose();
            settled_.set(row + 1, column, p(1, 0));
            settled_.set(row, column, p(0, 0));
            settled_.set(row + 1, column + 1, p(1, 1));
            if (a != b) settled_.set(row, column + 1, p(0, 1));
            if (a != b) continue;
            own_(row, 0) = p(0, 0);
            own_(row, 1) = p(1, 0);
            own_(row + 1, 0) = p(1, 1);
        }
    }
    for (std::size_t c = 0; c < kFirst; ++c) settled_.write_column(c, hand_, c);
    begin_anew();
}

Eigen::MatrixXd JointState::covariance() const {
    JointState settled = *this;
    settled.settle();
    Eigen::MatrixXd whole(size_, size_);
    for (Eigen::Index i = 0; i < size_; ++i) {
        for (Eigen::Index j = 0; j < size_; ++j) {
            const std::size_t row = i < kPose ? static_cast<std::size_t>(i) : row_of(i);
            const std::size_t column = j < kPose ? static_cast<std::size_t>(j) : row_of(j);
            whole(i, j) = settled.settled_(row, column);
        }
    }
    return whole;
}

std::size_t JointState::bytes() const {
    std::size_t bytes = settled_.bytes();
    for (const TallMatrix* part : {&hand_, &own_, &first_, &now_, &gained_, &w_, &w_now_}) {
        bytes += part->bytes();
    }
    return bytes;
}

}  // namespace hitos
