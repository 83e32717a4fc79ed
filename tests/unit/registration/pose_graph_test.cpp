// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/registration/pose_graph.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "hitos/registration/pose_graph_solver.hpp"

namespace hitos {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

Pose moved(Pose pose, int component, double by) {
    (component == 0 ? pose.x : component == 1 ? pose.y : pose.theta) += by;
    return pose;
}

/// Poses round a circle that closes, and what the way between them was measured to be.
struct Ring {
    std::vector<Pose> truth;
    std::vector<KeyPose> keys;  // by odometry
    std::vector<PoseEdge> edges;
};

Matrix3d information(double sigma_m, double sigma_rad) {
    return Vector3d(1 / (sigma_m * sigma_m), 1 / (sigma_m * sigma_m), 1 / (sigma_rad * sigma_rad))
        .asDiagonal();
}

Ring make_ring(int count, double noise, unsigned seed) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> normal(0.0, 1.0);
    constexpr double kMetres = 0.03;
    constexpr double kRadians = 0.01;
    const Pose step{1.0, 0.1, 2.0 * kPi / count};
    Ring ring;
    Pose pose;
    Pose odometry;
    const auto measured = [&](const Pose& from, const Pose& to) {
        Pose z = between(from, to);
        return Pose{z.x + noise * kMetres * normal(engine), z.y + noise * kMetres * normal(engine),
                    z.theta + noise * kRadians * normal(engine)};
    };
    for (int i = 0; i < count; ++i) {
        ring.truth.push_back(pose);
        ring.keys.push_back({odometry, static_cast<std::uint64_t>(i)});
        const Pose next = compose(pose, step);
        if (i + 1 < count) {
            const auto at = static_cast<std::uint32_t>(i);
            const Pose z = measured(pose, next);
            ring.edges.push_back(
                {at, at + 1, z, information(kMetres, kRadians), EdgeKind::odometry});
            odometry = compose(odometry, z);
        }
        pose = next;
    }
    const auto last = static_cast<std::uint32_t>(count - 1);
    ring.edges.push_back({0, last, measured(ring.truth.front(), ring.truth.back()),
                          information(0.01, 0.003), EdgeKind::loop});
    return ring;
}

double greatest_error(const Ring& ring) {
    double greatest = 0.0;
    for (std::size_t i = 0; i < ring.keys.size(); ++i) {
        greatest = std::max(greatest, std::hypot(ring.keys[i].pose.x - ring.truth[i].x,
                                                 ring.keys[i].pose.y - ring.truth[i].y));
    }
    return greatest;
}

/// Gauss-Newton with dense matrices and numerical Jacobians; the first key is no variable.
void solve_densely(std::vector<KeyPose>& keys, const std::vector<PoseEdge>& edges, bool robust) {
    constexpr double kSmall = 1e-6;
    const auto size = static_cast<Eigen::Index>(3 * (keys.size() - 1));
    for (int iteration = 0; iteration < 60; ++iteration) {
        MatrixXd h = MatrixXd::Zero(size, size);
        VectorXd b = VectorXd::Zero(size);
        for (const PoseEdge& edge : edges) {
            const Pose from = keys[edge.from].pose;
            const Pose to = keys[edge.to].pose;
            const auto error = [&](const Pose& p, const Pose& q) {
                const Pose way = between(p, q);
                return Vector3d(way.x - edge.z.x, way.y - edge.z.y,
                                wrap_angle(way.theta - edge.z.theta));
            };
            const Vector3d e = error(from, to);
            MatrixXd j = MatrixXd::Zero(3, size);
            for (int c = 0; c < 3; ++c) {
                const Eigen::Index from_at = 3 * static_cast<Eigen::Index>(edge.from) - 3 + c;
                const Eigen::Index to_at = 3 * static_cast<Eigen::Index>(edge.to) - 3 + c;
                if (edge.from > 0) {
                    j.col(from_at) +=
                        (error(moved(from, c, kSmall), to) - error(moved(from, c, -kSmall), to)) /
                        (2 * kSmall);
                }
                if (edge.to > 0) {
                    j.col(to_at) +=
                        (error(from, moved(to, c, kSmall)) - error(from, moved(to, c, -kSmall))) /
                        (2 * kSmall);
                }
            }
            const double d2 = e.dot(edge.information * e);
            const Matrix3d w = (robust ? 1.0 / (1.0 + d2 / 9.0) : 1.0) * edge.information;
            h += j.transpose() * w * j;
            b += j.transpose() * w * e;
        }
        const VectorXd step = -h.ldlt().solve(b);
        for (std::size_t i = 1; i < keys.size(); ++i) {
            const auto at = static_cast<Eigen::Index>(3 * (i - 1));
            keys[i].pose.x += step(at);
            keys[i].pose.y += step(at + 1);
            keys[i].pose.theta = wrap_angle(keys[i].pose.theta + step(at + 2));
        }
    }
}

TEST(PoseGraph, JacobiansAreThoseOfNumericalDifferentiation) {
    const Pose from{-3.0, 7.0, 2.8};
    const Pose to{1.0, 4.5, -2.9};
    PoseEdge edge{0, 1, {0.3, -0.2, 0.4}, Matrix3d::Identity(), EdgeKind::scan};
    for (const Point2 at : {Point2{}, Point2{2.5, -1.25}}) {
        edge.at = at;
        const EdgeError error = edge_error(edge, from, to);
        constexpr double kSmall = 1e-6;
        for (int c = 0; c < 3; ++c) {
            const Vector3d by_from = (edge_error(edge, moved(from, c, kSmall), to).value -
                                      edge_error(edge, moved(from, c, -kSmall), to).value) /
                                     (2 * kSmall);
            const Vector3d by_to = (edge_error(edge, from, moved(to, c, kSmall)).value -
                                    edge_error(edge, from, moved(to, c, -kSmall)).value) /
                                   (2 * kSmall);
            EXPECT_LT((error.by_from.col(c) - by_from).norm(), 1e-8) << "component " << c;
            EXPECT_LT((error.by_to.col(c) - by_to).norm(), 1e-8) << "component " << c;
        }
    }
}

TEST(PoseGraph, AnEdgeOfAPlaceIsOneOfTheOriginWhileItTurnsLittle) {
    const Pose from{-3.0, 7.0, 2.8};
    const Pose true_to = compose(from, {4.0, 1.0, -0.7});
    PoseEdge edge{0, 1, {}, {}, EdgeKind::by_hand, {2.5, -1.25}};
    const Point2 seen = transform(between(from, true_to), edge.at);
    edge.z = {seen.x, seen.y, -0.7};
    for (const double heading : {0.0, 1e4}) {
        edge.information = Eigen::Vector3d(400.0, 100.0, heading).asDiagonal();
        const PoseEdge other = edge_of_origin(edge, from, true_to);
        EXPECT_EQ(other.at, Point2{});
        EXPECT_LT(edge_error(other, from, true_to).value.norm(), 1e-12);
        for (int c = 0; c < 3; ++c) {
            const Pose to = moved(moved(true_to, c, 1e-3), 2, 2e-3);
            const Vector3d a = edge_error(edge, from, to).value;
            const Vector3d b = edge_error(other, from, to).value;
            const double d2 = a.dot(edge.information * a);
            EXPECT_NEAR(b.dot(other.information * b), d2, 0.01 * d2) << c;
        }
    }
    edge.at = {};
    EXPECT_EQ(edge_of_origin(edge, from, true_to).z, edge.z);
}

TEST(PoseGraph, ErrorIsNoneWhereTheEdgeIsTrueAndItsAngleWraps) {
    const Pose from{-3.0, 7.0, 3.0};
    const Pose to{1.0, 4.5, -3.0};
    PoseEdge edge{0, 1, between(from, to), Matrix3d::Identity(), EdgeKind::scan};
    EXPECT_LT(edge_error(edge, from, to).value.norm(), 1e-12);
    edge.z.theta += 2.0 * kPi - 0.01;
    EXPECT_NEAR(edge_error(edge, from, to).value(2), 0.01, 1e-12);
}

TEST(PoseGraph, ExactEdgesGiveTheExactPoses) {
    Ring ring = make_ring(40, 0.0, 1);
    for (std::size_t i = 1; i < ring.keys.size(); ++i) ring.keys[i].pose.x += 0.3;
    solve(ring.keys, ring.edges, {20, true});
    EXPECT_LT(greatest_error(ring), 1e-5);
}

TEST(PoseGraph, SolvesWhatADenseSolverDoes) {
    for (const bool robust : {false, true}) {
        Ring ring = make_ring(25, 1.0, 17);
        std::vector<KeyPose> dense = ring.keys;
        const std::vector<KeyPose> before = ring.keys;
        // A call stops where steps fall below a millimetre; the next goes on from there.
        double moved_m = solve(ring.keys, ring.edges, {30, robust});
        for (int i = 0; i < 10; ++i) solve(ring.keys, ring.edges, {30, robust});
        solve_densely(dense, ring.edges, robust);
        double greatest = 0.0;
        for (std::size_t i = 0; i < dense.size(); ++i) {
            EXPECT_NEAR(ring.keys[i].pose.x, dense[i].pose.x, 1e-4) << "key " << i;
            EXPECT_NEAR(ring.keys[i].pose.y, dense[i].pose.y, 1e-4) << "key " << i;
            EXPECT_NEAR(ring.keys[i].pose.theta, dense[i].pose.theta, 1e-5) << "key " << i;
            greatest = std::max(greatest, std::hypot(dense[i].pose.x - before[i].pose.x,
                                                     dense[i].pose.y - before[i].pose.y));
        }
        EXPECT_NEAR(moved_m, greatest, 2e-3);
        EXPECT_GT(moved_m, 0.05);
    }
}

TEST(PoseGraph, AClosedLoopTakesTheDriftAway) {
    double before = 0.0;
    double after = 0.0;
    double last_before = 0.0;
    double last_after = 0.0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        Ring ring = make_ring(60, 1.0, seed);
        const auto last = [&] {
            return std::hypot(ring.keys.back().pose.x - ring.truth.back().x,
                              ring.keys.back().pose.y - ring.truth.back().y);
        };
        before += greatest_error(ring);
        last_before += last();
        solve(ring.keys, ring.edges, {20, true});
        after += greatest_error(ring);
        last_after += last();
    }
    EXPECT_LT(after, 0.6 * before);  // the far side of the ring is still uncertain
    EXPECT_LT(last_after, 0.1 * last_before);
}

TEST(PoseGraph, AnEdgeThatIsWrongLosesItsWeight) {
    Ring ring = make_ring(30, 1.0, 29);
    solve(ring.keys, ring.edges, {20, true});
    const std::vector<KeyPose> good = ring.keys;
    Pose wrong = between(ring.truth[5], ring.truth[20]);
    wrong.x += 3.0;
    ring.edges.push_back({5, 20, wrong, information(0.03, 0.01), EdgeKind::scan});
    std::vector<KeyPose> plain = good;
    solve(ring.keys, ring.edges, {20, true});
    solve(plain, ring.edges, {20, false});
    double robust_m = 0.0;
    double plain_m = 0.0;
    for (std::size_t i = 0; i < good.size(); ++i) {
        robust_m = std::max(robust_m, std::abs(ring.keys[i].pose.x - good[i].pose.x));
        plain_m = std::max(plain_m, std::abs(plain[i].pose.x - good[i].pose.x));
    }
    EXPECT_LT(robust_m, 0.05);
    EXPECT_GT(plain_m, 0.3);
}

TEST(PoseGraph, OneSolverWithFewerEdgesDoesWhatASolverOfThoseAloneDoes) {
    Ring ring = make_ring(40, 1.0, 23);
    for (std::size_t i = 1; i < ring.keys.size(); ++i) {
        ring.keys[i].pose.x += 0.05 * static_cast<double>(i);
    }
    const std::size_t fewer = ring.edges.size() - 1;
    std::vector<KeyPose> alone = ring.keys;
    PoseGraphSolver solver(ring.keys.size(), ring.edges);
    const double moved_m = solver.solve(ring.keys, {20, false}, fewer);
    EXPECT_GT(moved_m, 1.0);
    EXPECT_NEAR(moved_m, solve(alone, std::span(ring.edges).first(fewer), {20, false}), 1e-6);
    for (std::size_t i = 0; i < alone.size(); ++i) {
        EXPECT_NEAR(ring.keys[i].pose.x, alone[i].pose.x, 1e-6) << "key " << i;
        EXPECT_NEAR(ring.keys[i].pose.y, alone[i].pose.y, 1e-6) << "key " << i;
    }
    solver.solve(ring.keys, {20, true});
    solve(alone, ring.edges, {20, true});
    for (std::size_t i = 0; i < alone.size(); ++i) {
        EXPECT_NEAR(ring.keys[i].pose.x, alone[i].pose.x, 1e-3) << "key " << i;
        EXPECT_NEAR(ring.keys[i].pose.y, alone[i].pose.y, 1e-3) << "key " << i;
    }
}

TEST(PoseGraph, AnAnchorOfADrawingThatNothingElseLaysMovesNothing) {
    Ring ring = make_ring(40, 1.0, 23);
    for (int again = 0; again < 5; ++again) solve(ring.keys, ring.edges, {20, false});
    PoseEdge wall;
    wall.kind = EdgeKind::anchor;
    wall.to = 17;
    wall.at = {2.0, -1.0};
    wall.z = {691000.0, 5334000.0, 2.0};
    wall.information.setZero();
    wall.information(0, 0) = 400.0;  // across it alone
    wall.information(2, 2) = 1e4;
    ring.edges.push_back(wall);
    std::vector<KeyPose> anchored = ring.keys;
    for (int again = 0; again < 5; ++again) solve(anchored, ring.edges, {20, false});
    EXPECT_LT(greatest_move(ring.keys, anchored), 1e-6);
}

TEST(PoseGraph, GreatMovesSettleWhereEveryStepFactorisedDoes) {
    // Turned by half a radian and carried off, as before a great loop is closed.
    for (const bool robust : {false, true}) {
        Ring ring = make_ring(60, 1.0, 41);
        for (std::size_t i = 20; i < ring.keys.size(); ++i) {
            ring.keys[i].pose = compose({2.0, -1.0, 0.5}, ring.keys[i].pose);
        }
        std::vector<KeyPose> dense = ring.keys;
        solve(ring.keys, ring.edges, {60, robust});
        solve_densely(dense, ring.edges, robust);
        for (std::size_t i = 0; i < dense.size(); ++i) {
            EXPECT_NEAR(ring.keys[i].pose.x, dense[i].pose.x, 5e-3) << "key " << i;
            EXPECT_NEAR(ring.keys[i].pose.y, dense[i].pose.y, 5e-3) << "key " << i;
        }
    }
}

TEST(PoseGraph, ATurnThatNobodySawIsFoundInSixIterations) {
    // A turn in place outdoors: the wheels err by a third of a radian, and no scan says so. The
    // loop that does moves a hundred metres of stiff path by tens of metres.
    Ring ring = make_ring(400, 0.0, 43);
    constexpr std::size_t kTurn = 200;
    ring.edges[kTurn].information(2, 2) = 1.0 / (0.3 * 0.3);
    ring.edges[kTurn].z.theta += 0.35;
    const Pose there = ring.keys[kTurn].pose;
    for (std::size_t i = kTurn + 1; i < ring.keys.size(); ++i) {
        const Pose turned = compose(there, {0.0, 0.0, 0.35});
        ring.keys[i].pose = compose(turned, between(there, ring.keys[i].pose));
    }
    EXPECT_GT(greatest_error(ring), 30.0);
    solve(ring.keys, ring.edges, {6, false});
    EXPECT_LT(greatest_error(ring), 2.0);
    double tension = 0.0;
    for (const PoseEdge& edge : ring.edges) {
        const Vector3d error =
            edge_error(edge, ring.keys[edge.from].pose, ring.keys[edge.to].pose).value;
        tension += error.dot(edge.information * error);
    }
    EXPECT_LT(tension, 2.0);  // the turn's own
}

TEST(PoseGraph, RobustWeightHalvesAtThreeSigmas) {
    EXPECT_EQ(robust_weight(0.0), 1.0);
    EXPECT_DOUBLE_EQ(robust_weight(9.0), 0.5);
    EXPECT_LT(robust_weight(900.0), 0.01);
}

TEST(PoseGraph, TheFirstKeyIsHeld) {
    Ring ring = make_ring(20, 1.0, 31);
    // A frame of its own, far from the origin.
    const Pose frame{250.0, -80.0, 1.0};
    for (KeyPose& key : ring.keys) key.pose = compose(frame, key.pose);
    solve(ring.keys, ring.edges, {20, true});
    EXPECT_NEAR(ring.keys[0].pose.x, frame.x, 1e-6);
    EXPECT_NEAR(ring.keys[0].pose.y, frame.y, 1e-6);
    EXPECT_NEAR(ring.keys[0].pose.theta, frame.theta, 1e-6);
}

TEST(PoseGraph, NothingToSolveMovesNothing) {
    std::vector<KeyPose> keys{{{1.0, 2.0, 3.0}, 0}};
    EXPECT_EQ(solve(keys, {}, {}), 0.0);
    keys.push_back({{2.0, 2.0, 3.0}, 1});
    EXPECT_EQ(solve(keys, {}, {}), 0.0);
    EXPECT_EQ(keys[1].pose, (Pose{2.0, 2.0, 3.0}));
}

}  // namespace
}  // namespace hitos
