// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/grid/grid.hpp"

#include <algorithm>
#include <cmath>

#include "grid_parameters.hpp"

namespace hitos {
namespace {

/// Coordinates are held to a millionth of a cell and up to 2^32 cells from the world's origin, so
/// that moving them to the storage's origin is exact and never changes their cell.
constexpr double kFarthestCell = 0x1p32;
constexpr double kStepsPerCell = 0x1p20;
/// Fixed-point 1 of the numbers that a ray is followed with.
constexpr std::int64_t kOne = std::int64_t{1} << 32;

bool in_reach(double u, double v) {
    return std::abs(u) < kFarthestCell && std::abs(v) < kFarthestCell;  // false for NaN
}

double in_cells(double metres, double resolution_m) {
    return std::round(metres / resolution_m * kStepsPerCell) / kStepsPerCell;
}

std::int64_t cell_of(double coordinate) {
    return static_cast<std::int64_t>(std::floor(coordinate));
}

/// The cell of a coordinate of the storage, which is not negative.
std::int64_t stored_cell_of(double coordinate) {
    return static_cast<std::int64_t>(coordinate);
}

/// std::llround() without a call, of what is not negative and below 2^53.
std::int64_t rounded(double value) {
    const auto whole = static_cast<std::int64_t>(value);
    return value - static_cast<double>(whole) >= 0.5 ? whole + 1 : whole;
}

/// One axis of a ray in cells of the storage, and how far apart neighbours along it lie: cells in
/// their tile, and tiles.
struct Axis {
    double from = 0.0;
    double to = 0.0;
    std::int64_t stride = 1;
    std::int64_t tile_stride = 1;
};

/// How far the start lies from the border behind it, in the direction of the ray.
double way_in_cell(const Axis& axis) {
    const double above = axis.from - static_cast<double>(stored_cell_of(axis.from));
    return axis.to < axis.from ? 1.0 - above : above;
}

/// The walk of a ray along one axis.
struct Steps {
    explicit Steps(const Axis& axis)
        : step(axis.to < axis.from ? -axis.stride : axis.stride),
          tile_step(axis.to < axis.from ? -axis.tile_stride : axis.tile_stride),
          left(std::abs(stored_cell_of(axis.to) - stored_cell_of(axis.from))) {
        const std::int64_t in_tile = stored_cell_of(axis.from) % kTileSide;
        in_this_tile = axis.to < axis.from ? in_tile : kTileSide - 1 - in_tile;
    }

    std::int64_t step;
    std::int64_t tile_step;
    std::int64_t left;          ///< steps to the ray's end
    std::int64_t in_this_tile;  ///< steps to the last cell of the tile
};

CellArea with_cell(const CellArea& box, double u, double v) {
    const std::int64_t column = cell_of(u);
    const std::int64_t row = cell_of(v);
    return united(box, {column, row, column + 1, row + 1});
}

/// Tiles count too: a ray alone has one for every 64 cells.
bool too_great(const CellArea& box) {
    const std::int64_t columns = box.end_column - box.first_column;
    const std::int64_t rows = box.end_row - box.first_row;
    if (columns > kMostGridCells || rows > kMostGridCells / columns) return true;
    const std::int64_t tile_columns = tile_of(box.end_column - 1) + 1 - tile_of(box.first_column);
    const std::int64_t tile_rows = tile_of(box.end_row - 1) + 1 - tile_of(box.first_row);
    constexpr std::int64_t kMostTiles = 2 * kMostGridCells / (std::int64_t{kTileSide} * kTileSide);
    return tile_columns > kMostTiles || tile_rows > kMostTiles / tile_columns;
}

}  // namespace

/// Frees every cell that a ray passes, from its first to its last (Amanatides and Woo, 1987). The
/// walk goes from border to border along the longer axis `a`; a fixed-point number tells how far
/// the ray has come along `b` since the border behind it.
class Grid::RayEraser {
  public:
    RayEraser(Tile* tiles, float miss, float lowest)
        : tiles_(tiles), miss_(miss), lowest_(lowest) {}

    void erase(const Axis& a, const Axis& b) const {
        Steps along_a(a);
        Steps along_b(b);
        const double length = std::abs(a.to - a.from);
        const double slope = length > 0.0 ? std::abs(b.to - b.from) / length : 0.0;
        const auto slope_fixed = rounded(slope * static_cast<double>(kOne));
        // At least one unit below the border backwards, since a cell holds its lower border.
        std::int64_t way =
            rounded((way_in_cell(b) + slope * (1.0 - way_in_cell(a))) * static_cast<double>(kOne)) -
            (b.to < b.from ? 1 : 0);
        const std::int64_t a_first = stored_cell_of(a.from);
        const std::int64_t b_first = stored_cell_of(b.from);
        Tile* tile =
            tiles_ + a_first / kTileSide * a.tile_stride + b_first / kTileSide * b.tile_stride;
        float* cell =
            cells_of(*tile) + a_first % kTileSide * a.stride + b_first % kTileSide * b.stride;
        // In locals, since for all the compiler knows a cell could be a member.
        const float miss = miss_;
        const float lowest = lowest_;
        const auto erase_cell = [&cell, miss, lowest] { *cell = std::max(*cell + miss, lowest); };
        const auto into_next_tile = [&cell, &tile](Steps& along) {
            const std::ptrdiff_t last = cell - tile->data();
            tile += along.tile_step;
            cell = cells_of(*tile) + (last - (kTileSide - 1) * along.step);
            along.in_this_tile = kTileSide - 1;
        };
        const auto erase_along_b = [&] {
            --along_b.left;
            if (along_b.in_this_tile > 0) {
                --along_b.in_this_tile;
                cell += along_b.step;
            } else {
                into_next_tile(along_b);
            }
            erase_cell();
        };
        const auto pass_border_of_b = [&] {
            if (way >= kOne) {
                way -= kOne;
                if (along_b.left > 0) erase_along_b();
            }
            way += slope_fixed;
        };
        erase_cell();
        for (;;) {
            const std::int64_t here = std::min(along_a.left, along_a.in_this_tile);
            for (std::int64_t i = 0; i < here; ++i) {
                pass_border_of_b();
                cell += along_a.step;
                erase_cell();
            }
            along_a.left -= here;
            if (along_a.left == 0) break;
            pass_border_of_b();
            into_next_tile(along_a);
            --along_a.left;
            erase_cell();
        }
        while (along_b.left > 0) erase_along_b();
    }

    static float* cells_of(Tile& tile) {
        if (tile.empty()) [[unlikely]] {
            make_room(tile);
        }
        return tile.data();
    }

  private:
    // Not within the walk, whose registers it would take.
    [[gnu::noinline]] static void make_room(Tile& tile) {
        tile.assign(std::size_t{kTileSide} * kTileSide, 0.0F);
    }

    Tile* tiles_;
    float miss_;
    float lowest_;
};

CellArea united(const CellArea& a, const CellArea& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {std::min(a.first_column, b.first_column), std::min(a.first_row, b.first_row),
            std::max(a.end_column, b.end_column), std::max(a.end_row, b.end_row)};
}

Grid::Grid(const GridParams& params) : params_(params) {
    check_all(grid_parameters(), params);
}

void Grid::add(const Scan& scan, const Pose& pose_world_robot) {
    const Pose laser = compose(pose_world_robot, scan.fan.pose_robot_laser);
    const double laser_u = in_cells(laser.x, params_.resolution_m);
    const double laser_v = in_cells(laser.y, params_.resolution_m);
    rays_.clear();
    last_change_ = {};
    if (in_reach(laser_u, laser_v)) {
        collect_rays(scan, pose_world_robot, laser);
    } else {
        ++scans_left_out_;
    }
    if (rays_.empty() || !keep_rays_that_fit(laser_u, laser_v)) return;

    last_change_ = extent(laser_u, laser_v);
    // From here on coordinates are those of the storage.
    const double base_u = static_cast<double>(first_column_) - static_cast<double>(column_offset_);
    const double base_v = static_cast<double>(first_row_) - static_cast<double>(row_offset_);
    const double from_u = laser_u - base_u;
    const double from_v = laser_v - base_v;
    hits_.clear();
    for (Ray& ray : rays_) {
        ray.u -= base_u;
        ray.v -= base_v;
        if (!ray.hit) continue;
        float* const cell = cell_at(ray.u, ray.v);
        hits_.push_back({cell, *cell});
    }
    const auto limit = static_cast<float>(params_.log_odds_limit);
    const RayEraser eraser(tiles_.data(), static_cast<float>(params_.log_odds_miss), -limit);
    for (const Ray& ray : rays_) {
        const Axis u{from_u, ray.u, 1, 1};
        const Axis v{from_v, ray.v, kTileSide, static_cast<std::int64_t>(tile_columns_)};
        if (std::abs(ray.u - from_u) >= std::abs(ray.v - from_v)) {
            eraser.erase(u, v);
        } else {
            eraser.erase(v, u);
        }
    }
    // What was hit gets back what it held before any ray of this scan passed it.
    for (const Hit& hit : hits_) *hit.cell = hit.before;
    const auto gain = static_cast<float>(params_.log_odds_hit);
    for (const Hit& hit : hits_) *hit.cell = std::min(*hit.cell + gain, limit);
}

/// Fills `rays_` with the rays whose ends are finite and in reach.
void Grid::collect_rays(const Scan& scan, const Pose& pose_world_robot,
                        const Pose& pose_world_laser) {
    const double c = std::cos(pose_world_robot.theta);
    const double s = std::sin(pose_world_robot.theta);
    for (const Point2& point : scan.points) {
        double x = pose_world_robot.x + c * point.x - s * point.y;
        double y = pose_world_robot.y + s * point.x + c * point.y;
        bool hit = true;
        if (params_.max_range_m > 0.0) {
            const double dx = x - pose_world_laser.x;
            const double dy = y - pose_world_laser.y;
            const double range = std::hypot(dx, dy);
            if (range > params_.max_range_m) {
                const double part = params_.max_range_m / range;
                x = pose_world_laser.x + part * dx;
                y = pose_world_laser.y + part * dy;
                hit = false;
            }
        }
        const double u = in_cells(x, params_.resolution_m);
        const double v = in_cells(y, params_.resolution_m);
        if (in_reach(u, v)) rays_.push_back({u, v, hit});
    }
}

/// The cells of the laser and of the rays' ends.
CellArea Grid::extent(double laser_u, double laser_v) const {
    Ray least{laser_u, laser_v};
    Ray greatest = least;
    for (const Ray& ray : rays_) {
        least.u = std::min(least.u, ray.u);
        least.v = std::min(least.v, ray.v);
        greatest.u = std::max(greatest.u, ray.u);
        greatest.v = std::max(greatest.v, ray.v);
    }
    return with_cell(with_cell({}, least.u, least.v), greatest.u, greatest.v);
}

/// Makes room for the rays; where the grid would be too great, for those that fit, in their order.
/// False where not even the laser fits; the grid is then as before.
bool Grid::keep_rays_that_fit(double laser_u, double laser_v) {
    CellArea box = with_cell(area(), laser_u, laser_v);
    CellArea all = united(box, extent(laser_u, laser_v));
    if (too_great(all)) {
        ++scans_left_out_;
        wanted_ = united(wanted_, all);
        if (too_great(box)) return false;
        std::erase_if(rays_, [&](const Ray& ray) {
            const CellArea with = with_cell(box, ray.u, ray.v);
            if (too_great(with)) return true;
            box = with;
            return false;
        });
        if (rays_.empty()) return false;
        all = box;
    }
    hold(all);
    return true;
}

double Grid::resolution_for_all() const {
    constexpr double kStep = 1.25;
    CellArea all = united(wanted_, area());
    double times = 1.0;
    const auto scaled = [&](std::int64_t cell) {
        return static_cast<std::int64_t>(std::floor(static_cast<double>(cell) / times));
    };
    CellArea coarser = all;
    while (!coarser.empty() && too_great(coarser)) {
        times *= kStep;
        coarser = {scaled(all.first_column), scaled(all.first_row), scaled(all.end_column) + 1,
                   scaled(all.end_row) + 1};
    }
    return times * params_.resolution_m;
}

CellArea Grid::area() const {
    return {first_column_, first_row_, first_column_ + columns_, first_row_ + rows_};
}

/// Makes `box`, which holds the bounds, the new bounds. The table of tiles grows by a quarter on
/// each side that needs it, so that the cost of growing stays in proportion to the area.
void Grid::hold(const CellArea& box) {
    const std::int64_t old_column =
        tile_of(first_column_ - static_cast<std::int64_t>(column_offset_));
    const std::int64_t old_row = tile_of(first_row_ - static_cast<std::int64_t>(row_offset_));
    const CellArea old{old_column, old_row, old_column + static_cast<std::int64_t>(tile_columns_),
                       old_row + static_cast<std::int64_t>(tile_rows_)};
    CellArea table{tile_of(box.first_column), tile_of(box.first_row),
                   tile_of(box.end_column - 1) + 1, tile_of(box.end_row - 1) + 1};
    if (empty() || united(old, table) != old) {
        if (!empty()) {
            const std::int64_t more_columns = 1 + (table.end_column - table.first_column) / 4;
            const std::int64_t more_rows = 1 + (table.end_row - table.first_row) / 4;
            if (table.first_column < old.first_column) table.first_column -= more_columns;
            if (table.end_column > old.end_column) table.end_column += more_columns;
            if (table.first_row < old.first_row) table.first_row -= more_rows;
            if (table.end_row > old.end_row) table.end_row += more_rows;
            table = united(old, table);
        }
        const auto columns = static_cast<std::size_t>(table.end_column - table.first_column);
        const auto rows = static_cast<std::size_t>(table.end_row - table.first_row);
        std::vector<Tile> tiles(columns * rows);
        for (std::size_t row = 0; row < tile_rows_; ++row) {
            const auto from = tiles_.begin() + static_cast<std::ptrdiff_t>(row * tile_columns_);
            const std::int64_t to =
                (old.first_row - table.first_row + static_cast<std::int64_t>(row)) *
                    static_cast<std::int64_t>(columns) +
                old.first_column - table.first_column;
            std::move(from, from + static_cast<std::ptrdiff_t>(tile_columns_), tiles.begin() + to);
        }
        tiles_ = std::move(tiles);
        tile_columns_ = columns;
        tile_rows_ = rows;
    } else {
        table = old;
    }
    first_column_ = box.first_column;
    first_row_ = box.first_row;
    columns_ = static_cast<int>(box.end_column - box.first_column);
    rows_ = static_cast<int>(box.end_row - box.first_row);
    column_offset_ = static_cast<std::size_t>(box.first_column - table.first_column * kTileSide);
    row_offset_ = static_cast<std::size_t>(box.first_row - table.first_row * kTileSide);
}

/// Of coordinates in the storage.
float* Grid::cell_at(double u, double v) {
    const std::int64_t column = stored_cell_of(u);
    const std::int64_t row = stored_cell_of(v);
    Tile& tile = tiles_[static_cast<std::size_t>(row / kTileSide) * tile_columns_ +
                        static_cast<std::size_t>(column / kTileSide)];
    return RayEraser::cells_of(tile) + row % kTileSide * kTileSide + column % kTileSide;
}

std::int64_t Grid::seen_cells() const {
    std::size_t sum = 0;
    for (const Tile& tile : tiles_) sum += tile.size();
    return static_cast<std::int64_t>(sum);
}

std::size_t Grid::bytes() const {
    return tiles_.size() * sizeof(Tile) + static_cast<std::size_t>(seen_cells()) * sizeof(float);
}

void Grid::clear() {
    *this = Grid(params_);
}

Point2 Grid::origin() const {
    return {static_cast<double>(first_column_) * params_.resolution_m,
            static_cast<double>(first_row_) * params_.resolution_m};
}

std::uint8_t grey_of(float log_odds) {
    if (log_odds == 0.0F) return kUnknownGrey;
    constexpr double kFree = 255.0;
    const double free = 1.0 / (1.0 + std::exp(static_cast<double>(log_odds)));
    const double grey = free < 0.5 ? kUnknownGrey * 2.0 * free
                                   : kUnknownGrey + (kFree - kUnknownGrey) * (2.0 * free - 1.0);
    return static_cast<std::uint8_t>(std::lround(grey));
}

Grid::Picture Grid::picture() const {
    Picture picture{columns_, rows_, {}};
    picture.grey.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    std::uint8_t* out = picture.grey.data();
    float last = 0.0F;  // most cells equal their neighbour: the exponential is worth remembering
    std::uint8_t grey = grey_of(last);
    for (int row = rows_ - 1; row >= 0; --row) {
        const std::size_t y = static_cast<std::size_t>(row) + row_offset_;
        const std::size_t end = static_cast<std::size_t>(columns_) + column_offset_;
        for (std::size_t x = column_offset_; x < end;) {
            constexpr std::size_t kSide = kTileSide;
            const std::size_t count = std::min(kSide - x % kSide, end - x);
            const Tile& tile = tiles_[y / kSide * tile_columns_ + x / kSide];
            if (tile.empty()) std::fill_n(out, count, kUnknownGrey);
            for (std::size_t i = 0; !tile.empty() && i < count; ++i) {
                const float value = tile[y % kSide * kSide + x % kSide + i];
                if (value != last) {
                    last = value;
                    grey = grey_of(value);
                }
                out[i] = grey;
            }
            out += count;
            x += count;
        }
    }
    return picture;
}

}  // namespace hitos
