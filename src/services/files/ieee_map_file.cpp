// SPDX-License-Identifier: GPL-3.0-or-later
// After the descriptions of the standard by its authors: F. Amigoni, W. Yu, T. Andre, D. Holz,
// M. Magnusson, M. Matteucci, H. Moon, M. Yokotsuka, G. Biggs, R. Madhavan, "A Standard for Map
// Data Representation: IEEE 1873-2015 Facilitates Interoperability Between Robots", IEEE Robotics &
// Automation Magazine 25(1), 2018: a global map of local maps, each with a coordinate system of its
// own; grids of equal cells; points, and line segments by rho, alpha, psi_a and psi_b, with the
// elements of their covariances as attributes.
#include "ieee_map_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/rounding.hpp"
#include "map_shapes.hpp"
#include "version.hpp"
#include "written_cells.hpp"
#include "xml_text.hpp"

namespace hitos {
namespace {

constexpr int kUnknown = -1;

/// Of being occupied, in per cent.
int percent_of(float log_odds) {
    if (log_odds == 0.0F) return kUnknown;
    return static_cast<int>(std::lround(100.0 / (1.0 + std::exp(-static_cast<double>(log_odds)))));
}

void put_covariance(std::string& out, const char* first, const char* second,
                    const Eigen::Matrix2d& covariance) {
    if (!is_known(covariance)) return;
    fmt::format_to(std::back_inserter(out),
                   R"( covariance_{0}{0}="{2}" covariance_{0}{1}="{3}" covariance_{1}{1}="{4}")",
                   first, second, without_sign_of_zero(covariance(0, 0)),
                   without_sign_of_zero(covariance(0, 1)), without_sign_of_zero(covariance(1, 1)));
}

void put_place(std::string& out) {
    out += R"(      <coordinate_system units_length="m" units_angle="rad" x="0" y="0" theta="0"/>)"
           "\n";
}

/// alpha in [0, 2 pi), and how far its end is from the foot of the normal.
void put_segment(std::string& out, const std::string& id, const Recta& line, const Point2& a,
                 const Point2& b, const Eigen::Matrix2d& covariance) {
    const PreparedRecta prepared(line);
    const double first = prepared.along(a);
    const double second = prepared.along(b);
    fmt::format_to(std::back_inserter(out),
                   R"(      <line_segment id="{}" rho="{}" alpha="{}" psi_a="{}" psi_b="{}")", id,
                   without_sign_of_zero(line.rho),
                   without_sign_of_zero(line.theta < 0.0 ? line.theta + 2.0 * kPi : line.theta),
                   without_sign_of_zero(std::min(first, second)),
                   without_sign_of_zero(std::max(first, second)));
    put_covariance(out, "rho", "alpha", covariance);
    out += "/>\n";
}

void put_geometric_map(std::string& out, const IeeeMapContent& content) {
    // Refuses what is not finite, and segments of no line.
    map_shapes(content.map, content.segments, {}, 1.0);
    std::vector<int> numbers(content.map.size(), 0);
    int lines = 0;
    int corners = 0;
    for (std::size_t i = 0; i < content.map.size(); ++i) {
        numbers[i] = content.map[i].kind() == FeatureKind::line ? ++lines : ++corners;
    }
    out += "    <local_map id=\"landmarks\" type=\"geometric\">\n";
    put_place(out);
    for (std::size_t i = 0; i < content.map.size(); ++i) {
        const auto* corner = std::get_if<Esquina>(&content.map[i].value);
        if (corner == nullptr) continue;
        fmt::format_to(std::back_inserter(out), R"(      <point id="corner_{}" x="{}" y="{}")",
                       numbers[i], without_sign_of_zero(corner->x),
                       without_sign_of_zero(corner->y));
        put_covariance(out, "x", "y", content.map[i].covariance);
        out += "/>\n";
    }
    int part = 0;
    for (std::size_t i = 0; i < content.segments.size(); ++i) {
        const auto& [landmark, a, b, points] = content.segments[i];
        part = i > 0 && content.segments[i - 1].landmark == landmark ? part + 1 : 1;
        const ICaracteristica& line = content.map[static_cast<std::size_t>(landmark)];
        put_segment(out,
                    fmt::format("line_{}_{}", numbers[static_cast<std::size_t>(landmark)], part),
                    std::get<Recta>(line.value), a, b, line.covariance);
    }
    out += "    </local_map>\n";
}

void put_grid_map(std::string& out, const Grid& grid) {
    if (grid.empty()) return;
    check_written_cells(grid);
    out += "    <local_map id=\"occupancy\" type=\"grid\">\n";
    put_place(out);
    const Point2 origin = grid.origin();
    fmt::format_to(std::back_inserter(out),
                   R"(      <grid origin_x="{}" origin_y="{}" resolution_x="{}" resolution_y="{}" )"
                   R"(size_x="{}" size_y="{}" value="occupancy_percent" unknown="{}">)"
                   "\n",
                   without_sign_of_zero(origin.x), without_sign_of_zero(origin.y),
                   grid.resolution_m(), grid.resolution_m(), grid.columns(), grid.rows(), kUnknown);
    for (int row = 0; row < grid.rows(); ++row) {
        fmt::format_to(std::back_inserter(out), "        <row y=\"{}\">", row);
        for (int column = 0; column < grid.columns(); ++column) {
            if (column > 0) out += ' ';
            fmt::format_to(std::back_inserter(out), "{}", percent_of(grid.log_odds(column, row)));
        }
        out += "</row>\n";
    }
    out += "      </grid>\n    </local_map>\n";
}

}  // namespace

std::string ieee_map_xml(const IeeeMapContent& content) {
    std::string out = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<map_data standard=\"IEEE 1873-2015\">\n"
        "  <metadata>\n"
        "    <name>{}</name>\n"
        "    <producer>Hitos {}</producer>\n"
        "    <algorithm>{}</algorithm>\n"
        "  </metadata>\n"
        "  <global_map id=\"map\">\n",
        xml_escaped(content.name), kVersion, xml_escaped(content.algorithm));
    put_geometric_map(out, content);
    put_grid_map(out, content.grid);
    return out + "  </global_map>\n</map_data>\n";
}

}  // namespace hitos
