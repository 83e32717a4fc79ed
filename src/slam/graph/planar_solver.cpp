// SPDX-License-Identifier: GPL-3.0-or-later
// Levenberg's and Marquardt's least squares of a planar graph (Madsen, Nielsen and Tingleff, 2004).
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stop_token>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/registration/normal_equations.hpp"
#include "hitos/registration/pose_graph_solver.hpp"
#include "planar_error.hpp"

namespace hitos {
namespace {

constexpr int kMostPlanarSteps = 200;
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// Which vertices edges tie to each other: a leader for each, the first of its part.
std::vector<std::uint32_t> leaders(const PlanarGraph& graph) {
    std::vector<std::uint32_t> leader(graph.vertices.size());
    std::iota(leader.begin(), leader.end(), 0U);
    const auto find = [&](std::uint32_t i) {
        while (leader[i] != i) i = leader[i] = leader[leader[i]];
        return i;
    };
    for (const PlanarEdge& edge : graph.edges) {
        const auto [first, second] = std::minmax({find(edge.from), find(edge.to)});
        leader[second] = first;
    }
    for (std::uint32_t i = 0; i < leader.size(); ++i) leader[i] = find(i);
    return leader;
}

/// The greatest information of an edge at each vertex, all 0 where nothing says anything: one that
/// is known very well must not hold the others.
std::vector<double> greatest_information(const PlanarGraph& graph) {
    std::vector<double> units(graph.vertices.size(), 0.0);
    double greatest = 0.0;
    for (const PlanarEdge& edge : graph.edges) {
        const double unit = edge.information.diagonal().maxCoeff();
        for (const std::uint32_t vertex : {edge.from, edge.to}) {
            units[vertex] = std::max(units[vertex], unit);
        }
        greatest = std::max(greatest, unit);
    }
    for (double& unit : units) {
        if (unit <= 0.0) unit = greatest;
    }
    return units;
}

class PlanarSolver {
  public:
    PlanarSolver(PlanarGraph& graph, bool robust, std::stop_token stop)
        : graph_(graph),
          robust_(robust),
          stop_(std::move(stop)),
          units_(greatest_information(graph)) {
        hold_parts();
        variables_.assign(graph.vertices.size(), kNone);
        for (std::size_t i = 0; i < graph.vertices.size(); ++i) {
            const PlanarVertex& vertex = graph.vertices[i];
            if (vertex.fixed || held_[i]) continue;
            variables_[i] =
                equations_.add_variable(vertex.kind == PlanarVertex::Kind::pose ? 3 : 2);
        }
    }

    PlanarSolution solve(PlanarStart from) {
        const std::vector<PlanarVertex> before = graph_.vertices;
        solution_.chi_square_before = chi_square(graph_);
        loss_ = loss();
        if (!std::isfinite(loss_)) {
            throw Error(message(
                HITOS_TEXT("Errors",
                           "the errors of the graph's edges are beyond reckoning; are its numbers "
                           "metres and radians, and its information their inverse variances?")));
        }
        if (equations_.variables() > 0) {
            check_size();
            constexpr int kFew = 3;
            if (from == PlanarStart::best) start();
            iterate(from == PlanarStart::best ? kMostPlanarSteps : kFew);
        }
        solution_.converged = solution_.converged || equations_.variables() == 0;
        solution_.chi_square_after = chi_square(graph_);
        for (std::size_t i = 0; i < before.size(); ++i) {
            if (before[i].kind == PlanarVertex::Kind::line) continue;
            solution_.greatest_move_m = std::max(
                solution_.greatest_move_m, distance(before[i].point(), graph_.vertices[i].point()));
        }
        return std::move(solution_);
    }

  private:
    void hold_parts() {
        const std::vector<std::uint32_t> leader = leaders(graph_);
        std::vector<char> tied(leader.size(), 0);  // of leaders: 1 by what is fixed, 2 by priors
        std::vector<std::uint32_t> first(leader.size(), 0);
        for (std::uint32_t i = 0; i < leader.size(); ++i) {
            if (graph_.vertices[i].fixed) tied[leader[i]] = 1;
            // A pose holds all of its part, a landmark where there is none.
            std::uint32_t& one = first[leader[i]];
            if (leader[i] == i) one = i;
            if (graph_.vertices[one].kind != PlanarVertex::Kind::pose &&
                graph_.vertices[i].kind == PlanarVertex::Kind::pose) {
                one = i;
            }
        }
        for (const PlanarEdge& edge : graph_.edges) {
            char& part = tied[leader[edge.to]];
            if (edge.prior() && part == 0) part = 2;
        }
        held_.assign(leader.size(), 0);
        for (std::uint32_t i = 0; i < leader.size(); ++i) {
            if (graph_.vertices[i].fixed) roots_.push_back(i);
            if (leader[i] != i) continue;
            ++solution_.parts;
            if (tied[i] != 1) roots_.push_back(first[i]);
            if (tied[i] != 0) continue;
            held_[first[i]] = 1;
            solution_.held.push_back(first[i]);
        }
    }

    /// Moves everything there if errors are less.
    void offer(std::vector<PlanarVertex> vertices) {
        std::swap(vertices, graph_.vertices);
        const double other = loss();
        if (other < loss_) {
            loss_ = other;
        } else {
            std::swap(vertices, graph_.vertices);
        }
    }

    /// Odometry that drifts begins so far off that steps may end in a wrong place; where the fewest
    /// edges from what is held have everything is nearer. Far off all edges would lose their
    /// weight: robust steps begin where plain ones end, and lose it step by step (Yang et al.,
    /// 2020).
    void start() {
        constexpr int kFewSteps = 5;
        constexpr double kNarrower = 4.0;
        offer(along_edges(graph_, roots_));
        if (!robust_) return;
        std::vector<PlanarVertex> found = graph_.vertices;
        robust_ = false;
        iterate(kMostPlanarSteps);
        robust_ = true;
        for (const PlanarEdge& edge : graph_.edges) {
            width_ = std::max(width_, mahalanobis_squared(graph_, edge));
        }
        for (; width_ > 1.0; width_ /= kNarrower) iterate(kFewSteps);
        width_ = 1.0;
        std::swap(found, graph_.vertices);
        loss_ = loss();
        offer(std::move(found));
    }

    /// A line is turned about what was seen of it (LocalCoordinates): before the first pose that
    /// saw it.
    void anchor_lines() {
        anchors_.assign(graph_.vertices.size(), {});
        std::vector<char> seen(graph_.vertices.size(), 0);
        for (const PlanarEdge& edge : graph_.edges) {
            if (edge.kind != PlanarEdge::Kind::line || seen[edge.to] != 0) continue;
            seen[edge.to] = 1;
            anchors_[edge.to] = graph_.vertices[edge.from].point();
        }
    }
    LandmarkPlace place_of(std::size_t vertex) const {
        const Eigen::Vector3d& at = graph_.vertices[vertex].at;
        const PreparedRecta line(Recta{at(1), at(0)});
        return {line.at(line.along(anchors_[vertex])), at(0)};
    }

    double loss() const {
        double sum = 0.0;
        for (const PlanarEdge& edge : graph_.edges) {
            const double d2 = mahalanobis_squared(graph_, edge);
            sum += robust_ && !edge.by_hand ? width_ * robust_loss(d2 / width_) : d2;
        }
        return sum;
    }

    void sum(double damping) {
        anchor_lines();
        equations_.begin();
        for (std::size_t i = 0; i < variables_.size(); ++i) {
            if (variables_[i] != kNone) equations_.hold(variables_[i], damping * units_[i]);
        }
        for (const PlanarEdge& edge : graph_.edges) {
            PlanarError error = planar_error(graph_, edge);
            if (robust_ && !edge.by_hand) {
                error.information *= robust_weight(mahalanobis_squared(error) / width_);
            }
            if (edge.kind == PlanarEdge::Kind::line) {
                // From (rho, theta).
                error.by_to = (error.by_to.rowwise().reverse() *
                               LocalCoordinates<SensorRecta>::jacobian(place_of(edge.to)))
                                  .eval();
            }
            const std::size_t from = edge.prior() ? kNone : variables_[edge.from];
            const std::size_t to = variables_[edge.to];
            const SmallMatrix& w = error.information;
            if (from == kNone && to == kNone) continue;
            if (from == kNone) {
                equations_.add(to, error.by_to, w, error.value);
            } else if (to == kNone) {
                equations_.add(from, error.by_from, w, error.value);
            } else if (from < to) {
                equations_.add(from, error.by_from, to, error.by_to, w, error.value);
            } else {
                equations_.add(to, error.by_to, from, error.by_from, w, error.value);
            }
        }
    }

    /// Moves everything by the step. Returns the greatest part of it [m, rad].
    double move() {
        double greatest = 0.0;
        for (std::size_t i = 0; i < variables_.size(); ++i) {
            if (variables_[i] == kNone) continue;
            PlanarVertex& vertex = graph_.vertices[i];
            const SmallVector step = equations_.step(variables_[i]);
            greatest = std::max(greatest, step.cwiseAbs().maxCoeff());
            if (vertex.kind == PlanarVertex::Kind::line) {
                LandmarkPlace place = place_of(i);
                LocalCoordinates<SensorRecta>::move(place, step);
                const Recta line = LocalCoordinates<SensorRecta>::landmark(place);
                vertex.at.head<2>() << line.theta, line.rho;
            } else {
                vertex.at.head(step.size()) += step;
            }
            if (vertex.kind == PlanarVertex::Kind::pose) vertex.at(2) = wrap_angle(vertex.at(2));
        }
        return greatest;
    }

    /// Where everything sees everything, a small file would take all memory and days.
    void check_size() {
        constexpr std::uint64_t kMillions = 100;
        sum(0.0);
        if (equations_.factor_fits(kMillions * 1'000'000)) return;
        throw Error(message(
            HITOS_TEXT("Errors",
                       "the edges join so many of the graph's vertices across it that solving it "
                       "takes more than %1 million numbers; expected a graph of places most of "
                       "which see few others"),
            kMillions));
    }

    void iterate(int most) {
        constexpr double kNoMove = 1e-9;    // [m, rad]
        constexpr double kRounding = 1e-4;  // [m, rad]: so small a step that helps nothing is noise
        // Damping, in units of the greatest information that a vertex has.
        constexpr double kLeast =
            1e-13;                       // keeps what nothing ties where it is, and is next to none
        constexpr double kFirst = 1e-6;  // after a step that made it worse
        constexpr double kMost = 1e6;
        constexpr double kFactor = 10.0;
        if (units_.front() <= 0.0) {
            solution_.converged = true;  // nothing says anything
            return;
        }
        loss_ = loss();
        solution_.converged = false;
        double least = kLeast;
        double damping = least;
        std::vector<PlanarVertex> places;
        for (int step = 0; step < most && damping <= kMost && !stop_.stop_requested(); ++step) {
            ++solution_.steps;
            sum(damping);
            places = graph_.vertices;
            double greatest = std::numeric_limits<double>::infinity();
            double after = greatest;
            if (equations_.solve()) {
                greatest = move();
                after = loss();
            } else {
                least = kFirst;  // a part may be free to turn
            }
            const bool better = after <= loss_;
            if (better) {
                loss_ = after;
            } else {
                graph_.vertices = places;
            }
            const bool free = damping <= least;
            if ((better && free && greatest <= kNoMove) || (!better && greatest <= kRounding)) {
                solution_.converged = true;
                return;
            }
            damping = better ? (damping > kFirst ? damping / kFactor : least)
                             : std::max(kFirst, damping * kFactor);
        }
    }

    PlanarGraph& graph_;
    bool robust_;
    std::stop_token stop_;
    std::vector<double> units_;  // of damping, by vertex
    double width_ = 1.0;         // of the robust loss, squared
    double loss_ = 0.0;
    NormalEquations equations_;
    std::vector<std::size_t> variables_;  // of vertices; kNone: does not move
    std::vector<char> held_;
    std::vector<std::uint32_t> roots_;  // fixed, held, or the first of a part with priors
    std::vector<Point2> anchors_;       // of lines
    PlanarSolution solution_;
};

}  // namespace

PlanarSolution solve(PlanarGraph& graph, bool robust, PlanarStart start,
                     const std::stop_token& stop) {
    return PlanarSolver(graph, robust, stop).solve(start);
}

}  // namespace hitos
