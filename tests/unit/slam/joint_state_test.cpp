// SPDX-License-Identifier: GPL-3.0-or-later
#include "ekf/joint_state.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <random>

#include "hitos/base/vectorised.hpp"

namespace hitos {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Random {
    std::mt19937 engine;
    double normal() { return std::normal_distribution<double>()(engine); }
    Eigen::Index below(Eigen::Index count) {
        return std::uniform_int_distribution<Eigen::Index>(0, count - 1)(engine);
    }
    Matrix2 positive(double scale) {
        Matrix2 a;
        a << normal(), normal(), normal(), normal();
        return scale * (a * a.transpose() + Matrix2::Identity());
    }
};

/// The same Gaussian with one plain covariance.
class PlainState {
  public:
    void move(const Pose& pose, const Matrix3& f, const Matrix3& q) {
        mean_.head<3>() << pose.x, pose.y, pose.theta;
        p_.topRows<3>() = (f * p_.topRows<3>()).eval();
        p_.leftCols<3>() = (p_.leftCols<3>() * f.transpose()).eval();
        p_.topLeftCorner<3, 3>() += q;
    }
    void update(std::span<const JointState::Row> rows) {
        const auto count = 2 * static_cast<Eigen::Index>(rows.size());
        MatrixXd h = MatrixXd::Zero(count, mean_.size());
        MatrixXd r = MatrixXd::Zero(count, count);
        VectorXd nu(count);
        for (Eigen::Index k = 0; k < count; k += 2) {
            const JointState::Row& row = rows[static_cast<std::size_t>(k / 2)];
            h.block<2, 3>(k, 0) = row.by_pose;
            h.block<2, 2>(k, row.at) = row.by_landmark;
            r.block<2, 2>(k, k) = row.r;
            nu.segment<2>(k) = row.nu;
        }
        const MatrixXd gain = p_ * h.transpose() * (h * p_ * h.transpose() + r).inverse();
        mean_ += gain * nu;
        p_ -= (gain * (h * p_)).eval();
        p_ = (0.5 * (p_ + p_.transpose())).eval();
    }
    void append(const Vector2& mean, const Matrix23& by_pose, const Matrix2& own) {
        const Eigen::Index n = mean_.size();
        p_.conservativeResize(n + 2, n + 2);
        p_.bottomLeftCorner(2, n) = by_pose * p_.topLeftCorner(3, n);
        p_.rightCols<2>() = p_.leftCols<3>() * by_pose.transpose();
        p_.bottomRightCorner<2, 2>() += own;
        mean_.conservativeResize(n + 2);
        mean_.tail<2>() = mean;
    }
    void negate(Eigen::Index component) {
        p_.row(component) *= -1.0;
        p_.col(component) *= -1.0;
    }
    void remove(Eigen::Index at) {
        std::vector<Eigen::Index> left;
        for (Eigen::Index i = 0; i < mean_.size(); ++i) {
            if (i != at && i != at + 1) left.push_back(i);
        }
        p_ = p_(left, left).eval();
        mean_ = mean_(left).eval();
    }
    void transform(const Matrix3& by_pose, std::span<const JointState::Turn> turns) {
        MatrixXd j = MatrixXd::Zero(mean_.size(), mean_.size());
        j.topLeftCorner<3, 3>() = by_pose;
        for (const JointState::Turn& turn : turns) j.block<2, 2>(turn.at, turn.at) = turn.by;
        p_ = j * p_ * j.transpose();
    }
    const VectorXd& mean() const { return mean_; }
    const MatrixXd& covariance() const { return p_; }

  private:
    VectorXd mean_ = VectorXd::Zero(3);
    MatrixXd p_ = MatrixXd::Zero(3, 3);
};

/// Both, told the same.
class Twins {
  public:
    explicit Twins(std::uint32_t seed) : random_{std::mt19937(seed)} {}

    Eigen::Index landmarks() const { return (state.size() - 3) / 2; }
    Eigen::Index place(Eigen::Index landmark) const { return 3 + 2 * landmark; }

    void move() {
        Matrix3 f = Matrix3::Identity();
        f(0, 2) = 0.1 * random_.normal();
        f(1, 2) = 0.1 * random_.normal();
        Matrix3 a;
        a << random_.normal(), random_.normal(), random_.normal(), random_.normal(),
            random_.normal(), random_.normal(), random_.normal(), random_.normal(),
            random_.normal();
        const Matrix3 q = 1e-3 * a * a.transpose();
        const Pose pose{random_.normal(), random_.normal(), random_.normal()};
        state.move(pose, f, q);
        plain.move(pose, f, q);
    }
    void append() {
        Matrix23 g;
        g << 1.0, 0.0, random_.normal(), 0.0, 1.0, random_.normal();
        const Vector2 mean(random_.normal(), random_.normal());
        const Matrix2 own = random_.positive(1e-3);
        state.append(mean, g, own);
        plain.append(mean, g, own);
    }
    /// Sees `count` landmarks from the one at `first` on.
    void see(Eigen::Index first, Eigen::Index count) {
        std::vector<JointState::Row> rows;
        for (Eigen::Index i = 0; i < count; ++i) {
            JointState::Row row;
            row.at = place((first + i) % landmarks());
            row.nu << 0.03 * random_.normal(), 0.03 * random_.normal();
            row.by_pose << -1.0, 0.2 * random_.normal(), random_.normal(), 0.1, -1.0, -1.0;
            row.by_landmark << 1.0, 0.3 * random_.normal(), 0.1, 1.0;
            row.r = random_.positive(1e-3);
            rows.push_back(row);
        }
        state.update(rows);
        plain.update(rows);
    }
    void negate() {
        const Eigen::Index component = place(random_.below(landmarks())) + random_.below(2);
        state.negate(component);
        plain.negate(component);
    }
    void remove() {
        const Eigen::Index at = place(random_.below(landmarks()));
        state.remove(at);
        plain.remove(at);
    }
    void transform() {
        std::vector<JointState::Turn> turns;
        for (Eigen::Index i = 0; i < landmarks(); ++i) {
            turns.push_back({place(i), Matrix2::Identity() + random_.positive(0.05)});
        }
        Matrix3 by_pose = Matrix3::Identity();
        by_pose(0, 1) = 0.1;
        state.transform(by_pose, turns);
        plain.transform(by_pose, turns);
    }
    void compare(double tolerance) const {
        const MatrixXd& expected = plain.covariance();
        ASSERT_EQ(state.size(), expected.rows());
        const double least = tolerance * expected.cwiseAbs().maxCoeff();
        EXPECT_LT((state.covariance() - expected).cwiseAbs().maxCoeff(), least);
        EXPECT_LT((state.pose_covariance() - expected.topLeftCorner<3, 3>()).norm(), least);
        EXPECT_NEAR(state.pose().theta, plain.mean()(2), 10.0 * tolerance);
        for (Eigen::Index i = 0; i < landmarks(); ++i) {
            const Eigen::Index a = place(i);
            const Eigen::Index b = place((3 * i + 1) % landmarks());
            EXPECT_LT((state.landmark(a) - plain.mean().segment<2>(a)).norm(), 10.0 * tolerance);
            EXPECT_LT((state.landmark_covariance(a) - expected.block<2, 2>(a, a)).norm(), least);
            EXPECT_LT((state.cross_covariance(a) - expected.block<2, 3>(a, 0)).norm(), least);
            EXPECT_LT((state.landmarks_covariance(a, b) - expected.block<2, 2>(a, b)).norm(),
                      least);
        }
    }

    JointState state;
    PlainState plain;

  private:
    Random random_;
};

/// A robot that makes `landmarks`, then sees now these, now those.
Twins toured(std::uint32_t seed, Eigen::Index landmarks, Eigen::Index steps, Eigen::Index seen) {
    Twins twins(seed);
    twins.move();
    for (Eigen::Index i = 0; i < landmarks; ++i) {
        if (i % 7 == 3) twins.move();
        twins.append();
    }
    for (Eigen::Index k = 0; k < steps; ++k) {
        twins.move();
        twins.see(k / 2 * 3, seen);
    }
    return twins;
}

TEST(JointState, EqualsThePlainGaussian) {
    for (const Eigen::Index landmarks : {1, 14, 15, 30, 31, 32, 70}) {
        const Eigen::Index seen = std::min<Eigen::Index>(landmarks, 5);
        toured(19, landmarks, 40, seen).compare(1e-10);
    }
}

TEST(JointState, EqualsThePlainGaussianWhereManyAreSeenAtOnce) {
    Twins twins = toured(23, 90, 4, 70);
    twins.compare(1e-10);
    for (Eigen::Index k = 0; k < 20; ++k) {
        twins.move();
        twins.see(5 * k, 3);
        if (k % 4 == 0) twins.append();
    }
    twins.compare(1e-10);
}

TEST(JointState, EqualsThePlainGaussianWhateverHappensInBetween) {
    Twins twins = toured(29, 60, 10, 4);
    Random random{std::mt19937(31)};
    for (int k = 0; k < 200; ++k) {
        twins.move();
        twins.see(random.below(twins.landmarks()), 1 + random.below(6));
        switch (random.below(40)) {
            case 0:
                twins.remove();
                break;
            case 1:
                twins.transform();
                break;
            case 2:
            case 3:
                twins.append();
                break;
            case 4:
            case 5:
            case 6:
            case 7:
                twins.negate();
                break;
            default:
                break;
        }
        if (k % 20 == 0) twins.compare(1e-9);
    }
    twins.compare(1e-9);
}

TEST(JointState, IsPreciseHoweverLongItLags) {
    // Nothing but the same few of many landmarks is ever seen, so that nothing is ever settled.
    Twins twins = toured(37, 40, 0, 0);
    for (int k = 0; k < 1000; ++k) {
        twins.move();
        twins.see(k % 8, 3);
    }
    twins.compare(1e-10);
}

TEST(JointState, HasTheSameBitsByAnyVectors) {
    MatrixXd first;
    for (const VectorTarget target :
         {VectorTarget::sse2, VectorTarget::avx2, VectorTarget::avx512}) {
        use_vectors(target);
        const Twins twins = toured(41, 70, 40, 7);
        if (first.size() == 0) first = twins.state.covariance();
        EXPECT_EQ(twins.state.covariance(), first);
    }
    use_vectors(widest_vectors());
}

TEST(JointState, CopiesAreWhole) {
    Twins twins = toured(43, 70, 40, 7);
    Twins copy = twins;
    twins.move();
    twins.see(3, 9);
    copy.compare(1e-10);
    copy.see(20, 4);
    copy.compare(1e-10);
}

TEST(JointState, CountsItsMemory) {
    JointState state;
    for (int i = 0; i < 500; ++i) {
        state.append(Vector2::Zero(), Matrix23::Zero(), Matrix2::Identity());
    }
    constexpr double kWhole = 1003.0 * 1003.0 * sizeof(double);
    EXPECT_GT(static_cast<double>(state.bytes()), 0.5 * kWhole);
    EXPECT_LT(static_cast<double>(state.bytes()), 0.8 * kWhole);
}

}  // namespace
}  // namespace hitos
