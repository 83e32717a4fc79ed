// SPDX-License-Identifier: GPL-3.0-or-later
// The least squares of graphs against those of Ceres, whose errors are written anew here and
// differentiated by itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "hitos/slam/planar_graph.hpp"
#include "unit/slam/manhattan.hpp"

#ifdef HITOS_HAVE_CERES
#include <ceres/ceres.h>

#include <Eigen/Cholesky>
#endif

namespace hitos {
namespace {

#ifdef HITOS_HAVE_CERES

template <class T>
T wrapped(const T& angle) {
    return ceres::atan2(ceres::sin(angle), ceres::cos(angle));
}

/// The error of an edge as g2o states it, times the root of its information.
struct CeresError {
    const PlanarEdge& edge;
    Eigen::Matrix3d root = Eigen::Matrix3d::Zero();

    explicit CeresError(const PlanarEdge& of) : edge(of) {
        const Eigen::MatrixXd used = of.information.topLeftCorner(of.size(), of.size());
        root.topLeftCorner(of.size(), of.size()) = used.llt().matrixU();
    }

    template <class T>
    bool operator()(const T* from, const T* to, T* out) const {
        const T c = ceres::cos(from[2]);
        const T s = ceres::sin(from[2]);
        std::array<T, 3> error{T(0.0), T(0.0), T(0.0)};
        if (edge.kind == PlanarEdge::Kind::line) {
            error[0] = wrapped(to[0] - from[2] - T(edge.z(0)));
            error[1] =
                to[1] - from[0] * ceres::cos(to[0]) - from[1] * ceres::sin(to[0]) - T(edge.z(1));
        } else {
            const T x = c * (to[0] - from[0]) + s * (to[1] - from[1]) - T(edge.z(0));
            const T y = c * (to[1] - from[1]) - s * (to[0] - from[0]) - T(edge.z(1));
            error[0] = x;
            error[1] = y;
            if (edge.kind == PlanarEdge::Kind::step) {
                const double turn = edge.z(2);
                error[0] = std::cos(turn) * x + std::sin(turn) * y;
                error[1] = std::cos(turn) * y - std::sin(turn) * x;
                error[2] = wrapped(to[2] - from[2] - T(turn));
            }
        }
        for (Eigen::Index i = 0; i < edge.size(); ++i) {
            out[i] = T(0.0);
            for (Eigen::Index j = i; j < edge.size(); ++j)
                out[i] += root(i, j) * error.at(static_cast<std::size_t>(j));
        }
        return true;
    }
};

/// Solves the graph; returns chi square.
double solve_by_ceres(PlanarGraph& graph) {
    ceres::Problem problem;
    for (const PlanarEdge& edge : graph.edges) {
        ceres::CostFunction* cost = nullptr;
        if (edge.size() == 3) {
            cost = new ceres::AutoDiffCostFunction<CeresError, 3, 3, 3>(new CeresError(edge));
        } else {
            cost = new ceres::AutoDiffCostFunction<CeresError, 2, 3, 2>(new CeresError(edge));
        }
        problem.AddResidualBlock(cost, nullptr, graph.vertices[edge.from].at.data(),
                                 graph.vertices[edge.to].at.data());
    }
    for (PlanarVertex& vertex : graph.vertices) {
        if (vertex.fixed) problem.SetParameterBlockConstant(vertex.at.data());
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    options.max_num_iterations = 500;
    options.function_tolerance = 0.0;
    options.gradient_tolerance = 1e-12;
    options.parameter_tolerance = 1e-15;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    EXPECT_TRUE(summary.IsSolutionUsable()) << summary.FullReport();
    return 2.0 * summary.final_cost;
}

void expect_agreement(const test::Manhattan& how) {
    PlanarGraph ours = test::ManhattanWorld(how).graph;
    PlanarGraph theirs = ours;
    const PlanarSolution solution = solve(ours, false);
    const double chi_square = solve_by_ceres(theirs);
    EXPECT_TRUE(solution.converged);
    EXPECT_NEAR(solution.chi_square_after, chi_square, 1e-6 * chi_square);
    double greatest = 0.0;
    for (std::size_t i = 0; i < ours.vertices.size(); ++i) {
        const Eigen::Vector3d difference = ours.vertices[i].at - theirs.vertices[i].at;
        for (Eigen::Index k = 0; k < 3; ++k) {
            const bool angle = k == (ours.vertices[i].kind == PlanarVertex::Kind::line ? 0 : 2);
            greatest =
                std::max(greatest, std::abs(angle ? wrap_angle(difference(k)) : difference(k)));
        }
    }
    EXPECT_LT(greatest, 1e-6);
    testing::Test::RecordProperty("greatest_difference", std::to_string(greatest * 1e9) + "e-9");
    testing::Test::RecordProperty(
        "chi_square_difference",
        std::to_string(std::abs(solution.chi_square_after / chi_square - 1.0) * 1e12) + "e-12");
}

TEST(PlanarGraphAndCeres, AgreeOnPosesWithLoops) {
    expect_agreement({.poses = 3500});
}

TEST(PlanarGraphAndCeres, AgreeWherePointsAreSeen) {
    expect_agreement({.poses = 1000, .half_m = 12.0, .points = 60});
}

TEST(PlanarGraphAndCeres, AgreeWherePointsAndLinesAreSeen) {
    expect_agreement({.poses = 600, .half_m = 10.0, .points = 20, .lines = 6});
}

#else

TEST(PlanarGraphAndCeres, Agree) {
    GTEST_SKIP() << "built without Ceres (libceres-dev): nothing is compared";
}

#endif

}  // namespace
}  // namespace hitos
