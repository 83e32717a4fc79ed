// SPDX-License-Identifier: GPL-3.0-or-later
// After the documentation of map_server (ROS 1) and nav2_map_server (ROS 2), mode "trinary":
// with p = (255 - pixel) / 255 a cell is occupied where p > occupied_thresh, free where
// p < free_thresh, else unknown.
#include "map_server_file.hpp"

#include <fmt/format.h>

#include <cmath>

#include "hitos/base/error.hpp"
#include "hitos/base/rounding.hpp"
#include "written_cells.hpp"

namespace hitos {
namespace {

char pixel_of(CellState state) {
    switch (state) {
        case CellState::occupied:
            return '\0';
        case CellState::free:
            return static_cast<char>(254);
        default:
            return static_cast<char>(205);
    }
}

}  // namespace

CellState state_of(float log_odds) {
    const auto odds = static_cast<double>(log_odds);
    static const double occupied_odds = std::log(kOccupiedFrom / (1.0 - kOccupiedFrom));
    static const double free_odds = std::log(kFreeBelow / (1.0 - kFreeBelow));
    if (odds > occupied_odds) return CellState::occupied;
    return odds < free_odds ? CellState::free : CellState::unknown;
}

std::string map_server_pgm(const Grid& grid) {
    if (grid.empty()) {
        throw Error(
            message(HITOS_TEXT("Errors", "the grid map is empty: there is nothing to draw")));
    }
    check_written_cells(grid);
    std::string out = fmt::format("P5\n{} {}\n255\n", grid.columns(), grid.rows());
    out.reserve(out.size() +
                static_cast<std::size_t>(grid.columns()) * static_cast<std::size_t>(grid.rows()));
    for (int row = grid.rows(); row-- > 0;) {
        for (int column = 0; column < grid.columns(); ++column) {
            out += pixel_of(state_of(grid.log_odds(column, row)));
        }
    }
    return out;
}

std::string map_server_yaml(const Grid& grid, const std::string& image) {
    const Point2 origin = grid.origin();
    return fmt::format(
        "image: {}\n"
        "mode: trinary\n"
        "resolution: {}\n"
        "origin: [{:.10g}, {:.10g}, 0.0]\n"
        "negate: 0\n"
        "occupied_thresh: {}\n"
        "free_thresh: {}\n",
        image, grid.resolution_m(), without_sign_of_zero(origin.x), without_sign_of_zero(origin.y),
        kOccupiedFrom, kFreeBelow);
}

}  // namespace hitos
