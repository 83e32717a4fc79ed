// SPDX-License-Identifier: GPL-3.0-or-later
// Occupancy grids in log-odds [T 2.5.4].
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hitos/capture/scan.hpp"
#include "hitos/services/grid/grid_params.hpp"

namespace hitos {

/// Cells [first, end), counted from the cell whose lower left corner is the world's origin.
struct CellArea {
    std::int64_t first_column = 0;
    std::int64_t first_row = 0;
    std::int64_t end_column = 0;
    std::int64_t end_row = 0;

    bool empty() const { return end_column <= first_column || end_row <= first_row; }
    friend bool operator==(const CellArea&, const CellArea&) = default;
};

/// The least area that holds both.
CellArea united(const CellArea& a, const CellArea& b);

/// The grey of cells in pictures where nothing is known.
inline constexpr std::uint8_t kUnknownGrey = 205;

/// The grey of a cell in pictures: 255 free, 0 occupied, linear in the probability from either to
/// kUnknownGrey, so that what was seen free once is no darker than what nobody saw; kUnknownGrey
/// where nothing is known (log-odds 0).
std::uint8_t grey_of(float log_odds);

/// Greatest number of cells of a grid; what would need more, or tiles of more than twice as many,
/// is left out.
inline constexpr std::int64_t kMostGridCells = std::int64_t{1} << 28;

/// Side of the tiles that grids and their pictures are held in, in cells.
inline constexpr int kTileSide = 64;

/// The column or row of the tile that a cell lies in, both counted from the world's origin.
constexpr std::int64_t tile_of(std::int64_t cell) {
    return cell >= 0 ? cell / kTileSide : -((-cell + kTileSide - 1) / kTileSide);
}

/// A grid that grows as needed and is no greater than what was drawn. Cell (column, row) covers
/// [origin + column * resolution, origin + (column + 1) * resolution) in x, likewise rows in y;
/// the world's origin lies on a corner of cells.
class Grid {
  public:
    /// Throws ConfigError for a value that no grid can have.
    explicit Grid(const GridParams& params = {});

    /// Adds a scan taken from `pose_world_robot`: every ray frees the cells it passes, from the
    /// laser on, and occupies the one it ends in; within one scan no cell that was hit is freed. A
    /// ray beyond the greatest range frees cells up to it and occupies none. Non-finite poses and
    /// points, and what no grid can hold, are left out.
    void add(const Scan& scan, const Pose& pose_world_robot);
    void clear();

    bool empty() const { return columns_ == 0; }
    /// Scans of which something is left out as no grid could hold it.
    std::uint64_t scans_left_out() const { return scans_left_out_; }
    /// With which a grid could hold these too [m]; at least that of this one.
    double resolution_for_all() const;
    /// Cells of the tiles that something was drawn into.
    std::int64_t seen_cells() const;
    /// Memory that its cells take.
    std::size_t bytes() const;
    int columns() const { return columns_; }
    int rows() const { return rows_; }
    Point2 origin() const;  ///< world coordinates of the lower left corner [m]
    CellArea area() const;  ///< the same place in cells
    /// No cell out of it was changed by the last add(); empty before the first one.
    const CellArea& last_change() const { return last_change_; }
    double resolution_m() const { return params_.resolution_m; }
    float log_odds(int column, int row) const {
        constexpr std::size_t kSide = kTileSide;
        const std::size_t x = static_cast<std::size_t>(column) + column_offset_;
        const std::size_t y = static_cast<std::size_t>(row) + row_offset_;
        const Tile& tile = tiles_[y / kSide * tile_columns_ + x / kSide];
        return tile.empty() ? 0.0F : tile[y % kSide * kSide + x % kSide];
    }
    bool known(int column, int row) const { return log_odds(column, row) != 0.0F; }

    /// 8-bit grey picture, row 0 at the top (greatest y), as grey_of() has it: white free, black
    /// occupied, kUnknownGrey unknown.
    struct Picture {
        int width = 0;
        int height = 0;
        std::vector<std::uint8_t> grey;
    };
    Picture picture() const;

  private:
    /// A ray's end in cells from the world's origin.
    struct Ray {
        double u = 0.0;
        double v = 0.0;
        bool hit = false;
    };
    struct Hit {
        float* cell = nullptr;
        float before = 0.0F;
    };
    /// kTileSide x kTileSide cells, row by row from the lower left one; empty where nothing is
    /// known.
    using Tile = std::vector<float>;
    class RayEraser;

    void collect_rays(const Scan& scan, const Pose& pose_world_robot, const Pose& pose_world_laser);
    CellArea extent(double laser_u, double laser_v) const;
    bool keep_rays_that_fit(double laser_u, double laser_v);
    void hold(const CellArea& box);
    float* cell_at(double u, double v);

    GridParams params_;
    std::vector<Tile> tiles_;  // row-major from the lower left; more than the bounds, to grow into
    std::size_t tile_columns_ = 0;
    std::size_t tile_rows_ = 0;
    std::size_t column_offset_ = 0;  // of the bounds from the first tile's cell
    std::size_t row_offset_ = 0;
    int columns_ = 0;
    int rows_ = 0;
    std::int64_t first_column_ = 0;  // cell index of column 0, counted from the world's origin
    std::int64_t first_row_ = 0;
    CellArea last_change_;
    std::uint64_t scans_left_out_ = 0;
    CellArea wanted_;        ///< by those that were left out
    std::vector<Ray> rays_;  // scratch: the scan being added
    std::vector<Hit> hits_;  // scratch: cells that it hits, and what they held
};

}  // namespace hitos
