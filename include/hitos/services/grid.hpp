// Occupancy grids in log-odds [T 2.5.4].
#pragma once

#include <cstdint>
#include <vector>

#include "hitos/capture/scan.hpp"

namespace hitos {

struct GridParams {
    double resolution_m = 0.05;      ///< side of a cell
    double log_odds_hit = 0.85;      ///< added to the cell a ray ends in
    double log_odds_miss = -0.4;     ///< added to the cells a ray passes
    double log_odds_limit = 5.0;     ///< greatest absolute value of a cell
    double max_range_m = 0.0;        ///< rays are drawn up to it; 0: whole
};

/// A grid that grows as needed. Cell (column, row) covers
/// [origin + column * resolution, origin + (column + 1) * resolution) in x, likewise rows in y.
class Grid {
  public:
    explicit Grid(const GridParams& params = {});

    /// Adds a scan taken from `pose_world_robot`: every ray frees the cells it passes and occupies
    /// the one it ends in; within one scan no cell that was hit is freed. Non-finite poses and
    /// points are left out.
    void add(const Scan& scan, const Pose& pose_world_robot);
    void clear();

    bool empty() const { return cells_.empty(); }
    int columns() const { return columns_; }
    int rows() const { return rows_; }
    Point2 origin() const;  ///< world coordinates of the lower left corner [m]
    double resolution_m() const { return params_.resolution_m; }
    float log_odds(int column, int row) const {
        return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                      static_cast<std::size_t>(column)];
    }
    bool known(int column, int row) const { return log_odds(column, row) != 0.0F; }

    /// 8-bit grey picture, row 0 at the top (greatest y): white free, black occupied, 205 unknown.
    struct Picture {
        int width = 0;
        int height = 0;
        std::vector<std::uint8_t> grey;
    };
    Picture picture() const;

    /// Counts additions; a view that saw the same number needs no new picture.
    std::uint64_t revision() const { return revision_; }

  private:
    struct CellIndex {
        std::int64_t column;
        std::int64_t row;
    };
    bool grow_to(double min_x, double min_y, double max_x, double max_y);

    GridParams params_;
    std::vector<float> cells_;  // row-major from the lower left
    int columns_ = 0;
    int rows_ = 0;
    std::int64_t first_column_ = 0;  // cell index of column 0, counted from the world's origin
    std::int64_t first_row_ = 0;
    std::uint64_t revision_ = 0;
    std::vector<std::size_t> hits_;  // scratch: cells hit by the scan being added
};

}  // namespace hitos
