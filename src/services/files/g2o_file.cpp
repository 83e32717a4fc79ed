// After g2o's types slam2d and slam2d_addons: a vertex is its tag, number and estimate, an edge its
// tag, numbers, measurement and the upper triangle of its information, row by row. Lines stand with
// theta before rho, and a vertex ends with the numbers of its end points, -1 where it has none.
#include "g2o_file.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>
#include <initializer_list>
#include <iterator>

#include "hitos/base/error.hpp"
#include "hitos/base/rounding.hpp"

namespace hitos {
namespace {

void put(std::string& out, std::initializer_list<double> values) {
    for (const double value : values) {
        if (!std::isfinite(value)) {
            throw Error(message(HITOS_TEXT(
                "Errors", "the graph has a number that is not finite and cannot be written")));
        }
        fmt::format_to(std::back_inserter(out), " {}", without_sign_of_zero(value));
    }
}

template <class Matrix>
void put_upper(std::string& out, const Matrix& information) {
    for (Eigen::Index row = 0; row < information.rows(); ++row) {
        for (Eigen::Index column = row; column < information.cols(); ++column) {
            put(out, {information(row, column)});
        }
    }
    out += '\n';
}

void put_landmark(std::string& out, std::size_t number, const ICaracteristica& landmark) {
    if (const auto* corner = std::get_if<Esquina>(&landmark.value)) {
        fmt::format_to(std::back_inserter(out), "VERTEX_XY {}", number);
        put(out, {corner->x, corner->y});
        out += '\n';
        return;
    }
    const auto& line = std::get<Recta>(landmark.value);
    fmt::format_to(std::back_inserter(out), "VERTEX_LINE2D {}", number);
    put(out, {line.theta, line.rho});
    out += " -1 -1\n";
}

void put_sighting(std::string& out, std::size_t landmark, const GraphSighting& sighting) {
    const Eigen::Matrix2d information = sighting.seen.covariance.inverse();
    if (const auto* corner = std::get_if<Esquina>(&sighting.seen.value)) {
        fmt::format_to(std::back_inserter(out), "EDGE_SE2_XY {} {}", sighting.pose, landmark);
        put(out, {corner->x, corner->y});
        put_upper(out, information);
        return;
    }
    const auto& line = std::get<Recta>(sighting.seen.value);
    fmt::format_to(std::back_inserter(out), "EDGE_SE2_LINE2D {} {}", sighting.pose, landmark);
    put(out, {line.theta, line.rho});
    put(out, {information(1, 1), information(0, 1), information(0, 0)});
    out += '\n';
}

}  // namespace

std::string g2o_text(const LandmarkGraphFile& graph) {
    std::string out;
    for (std::size_t i = 0; i < graph.poses.size(); ++i) {
        const Pose& pose = graph.poses[i];
        fmt::format_to(std::back_inserter(out), "VERTEX_SE2 {}", i);
        put(out, {pose.x, pose.y, pose.theta});
        out += '\n';
    }
    for (std::size_t i = 0; i < graph.map.size(); ++i) {
        put_landmark(out, graph.poses.size() + i, graph.map[i]);
    }
    if (!graph.poses.empty()) out += "FIX 0\n";
    for (const GraphStep& step : graph.steps) {
        fmt::format_to(std::back_inserter(out), "EDGE_SE2 {} {}", step.from, step.to);
        put(out, {step.z.x, step.z.y, step.z.theta});
        put_upper(out, step.information);
    }
    for (const GraphSighting& sighting : graph.sightings) {
        put_sighting(out, graph.poses.size() + sighting.landmark, sighting);
    }
    return out;
}

}  // namespace hitos
