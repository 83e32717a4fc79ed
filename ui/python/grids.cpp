// SPDX-License-Identifier: GPL-3.0-or-later
// Occupancy grids as arrays, and their drawing along a path.

#include "grids.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <utility>

#include "arguments.hpp"
#include "arrays.hpp"
#include "hitos/services/grid/grid_builder.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "python_calls.hpp"
#include "tours.hpp"

namespace hitos::python {
namespace {

using HeldGrid = std::shared_ptr<const GridArray>;

template <class Number>
py::object view_of_cells(const HeldGrid& grid, const std::vector<Number>& cells) {
    if (cells.empty() && grid->columns > 0) return py::none();
    constexpr auto kSize = static_cast<py::ssize_t>(sizeof(Number));
    return view(py::dtype::of<Number>(), {grid->rows, grid->columns},
                {kSize * grid->columns, kSize}, cells.data(), grid);
}

std::size_t cell_count(const GridArray& grid) {
    return static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
}

std::shared_ptr<GridArray> draw_grid(const py::object& tour, const py::object& trajectory,
                                     const py::object& given) {
    const Configuracion configuration = configuration_for(tour_argument(tour), given);
    Trajectory path = trajectory_from(trajectory, "trajectory");
    const Work under_way;
    std::atomic<bool> stopped = false;
    std::future<HeldGrid> drawn = std::async(
        std::launch::async,
        [&configuration, &stopped, path = std::move(path)]() mutable -> HeldGrid {
            GridBuilder builder(configuration.grid, open_tour(configuration), std::move(path));
            while (!stopped && builder.step()) {
            }
            return array_of(builder.grid());
        });
    return std::const_pointer_cast<GridArray>(
        wait_for<HeldGrid>(std::move(drawn), [&] { stopped = true; }));
}

}  // namespace

HeldGrid array_of(const Grid& grid) {
    auto made = std::make_shared<GridArray>();
    made->columns = grid.columns();
    made->rows = grid.rows();
    made->origin = grid.empty() ? Point2() : grid.origin();
    made->resolution_m = grid.resolution_m();
    made->grey.reserve(cell_count(*made));
    made->log_odds.reserve(cell_count(*made));
    for (int row = 0; row < made->rows; ++row) {
        for (int column = 0; column < made->columns; ++column) {
            made->log_odds.push_back(grid.log_odds(column, row));
        }
    }
    const GridTiles tiles = tiles_of(grid);
    made->grey = array_of(tiles)->grey;
    return made;
}

HeldGrid array_of(const GridTiles& tiles) {
    auto made = std::make_shared<GridArray>();
    made->resolution_m = tiles.resolution_m;
    if (tiles.area.empty()) return made;
    made->columns = static_cast<int>(tiles.area.end_column - tiles.area.first_column);
    made->rows = static_cast<int>(tiles.area.end_row - tiles.area.first_row);
    made->origin = {static_cast<double>(tiles.area.first_column) * tiles.resolution_m,
                    static_cast<double>(tiles.area.first_row) * tiles.resolution_m};
    made->grey.assign(cell_count(*made), kUnknownGrey);
    for (std::size_t place = 0; place < tiles.tiles.size(); ++place) {
        if (!tiles.tiles[place]) continue;
        const auto across = static_cast<std::int64_t>(place) % tiles.columns;
        const auto up = static_cast<std::int64_t>(place) / tiles.columns;
        // The tile's first cell, from the array's.
        const std::int64_t column =
            (tiles.first_column + across) * kTileSide - tiles.area.first_column;
        const std::int64_t row = (tiles.first_row + up) * kTileSide - tiles.area.first_row;
        const std::int64_t first = std::max<std::int64_t>(0, -column);
        const std::int64_t end = std::min<std::int64_t>(kTileSide, made->columns - column);
        if (first >= end) continue;
        for (std::int64_t y = std::max<std::int64_t>(0, -row);
             y < std::min<std::int64_t>(kTileSide, made->rows - row); ++y) {
            const auto from = tiles.tiles[place]->grey.begin() + y * kTileSide;
            std::copy(from + first, from + end,
                      made->grey.begin() + (row + y) * made->columns + column + first);
        }
    }
    return made;
}

void bind_grids(py::module_& module) {
    py::class_<GridArray, std::shared_ptr<GridArray>>(module, "Grid", R"(An occupancy grid. Row 0 is
the lowest (least y), column 0 the leftmost. To draw it:

    plt.imshow(grid.grey, cmap="gray", vmin=0, vmax=255, origin="lower", extent=grid.extent))")
        .def_property_readonly(
            "grey", [](const std::shared_ptr<GridArray>& g) { return view_of_cells(g, g->grey); },
            R"(rows x columns of 8 bits: 255 free, 0 occupied, linear in the probability from
either to 205 (hitos.UNKNOWN_GREY), which is where nothing is known. A read-only view.)")
        .def_property_readonly(
            "log_odds",
            [](const std::shared_ptr<GridArray>& g) { return view_of_cells(g, g->log_odds); },
            R"(rows x columns of 32-bit log-odds, 0 where nothing is known: a read-only view. None of
the grids of snapshots, which have their picture only.)")
        .def_property_readonly(
            "origin", [](const GridArray& g) { return py::make_tuple(g.origin.x, g.origin.y); },
            "x, y of the lower left corner of cell (0, 0) [m].")
        .def_property_readonly(
            "resolution", [](const GridArray& g) { return g.resolution_m; }, "Side of a cell [m].")
        .def_property_readonly(
            "shape", [](const GridArray& g) { return py::make_tuple(g.rows, g.columns); },
            "(rows, columns)")
        .def_property_readonly(
            "extent",
            [](const GridArray& g) {
                return py::make_tuple(g.origin.x, g.origin.x + g.columns * g.resolution_m,
                                      g.origin.y, g.origin.y + g.rows * g.resolution_m);
            },
            "(left, right, bottom, top) [m], as matplotlib's imshow takes it.")
        .def("__repr__", [](const GridArray& g) {
            return fmt::format("<Grid of {} x {} cells of {} m>", g.columns, g.rows,
                               g.resolution_m);
        });
    module.attr("UNKNOWN_GREY") = kUnknownGrey;
    define(
        module, "draw_grid", &draw_grid, py::arg("tour"), py::arg("trajectory"),
        py::arg("configuration") = py::none(),
        R"(Draws the scans of a tour along any path, an N x 4 array of t, x, y, theta: poses and scans
are paired in order. The configuration's grid.* parameters say how, e.g. {"grid.resolution": 0.1}.)");
}

}  // namespace hitos::python
