#include "hitos/services/run/grid.hpp"

#include <algorithm>
#include <cmath>

#include "run/grid_parameters.hpp"

namespace hitos {
namespace {

/// Coordinates are held to a millionth of a cell and up to 2^32 cells from the world's origin, so
/// that moving them to the storage's origin is exact and never changes their cell.
constexpr double kFarthestCell = 0x1p32;
constexpr double kStepsPerCell = 0x1p20;
/// Least margin of new storage on a side that grew, where that does not make more of it than four
/// times what is needed and kSmallStorage cells.
constexpr std::int64_t kLeastMargin = 64;
constexpr std::int64_t kSmallStorage = std::int64_t{1} << 16;

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

/// One axis of a ray in cells of the storage, and how far apart neighbours along it lie there.
struct Axis {
    double from = 0.0;
    double to = 0.0;
    std::int64_t stride = 1;
};

/// How far the start lies from the border behind it, in the direction of the ray.
double way_in_cell(const Axis& axis) {
    const double above = axis.from - std::floor(axis.from);
    return axis.to < axis.from ? 1.0 - above : above;
}

/// Frees every cell that a ray passes, from its first to its last (Amanatides and Woo, 1987). The
/// walk goes from border to border along the longer axis `a`; a fixed-point number tells how far
/// the ray has come along `b` since the border behind it.
class RayEraser {
  public:
    RayEraser(float* cells, float miss, float lowest)
        : cells_(cells), miss_(miss), lowest_(lowest) {}

    void erase(const Axis& a, const Axis& b) const {
        const std::int64_t a_first = cell_of(a.from);
        const std::int64_t b_first = cell_of(b.from);
        const std::int64_t borders = std::abs(cell_of(a.to) - a_first);
        std::int64_t b_left = std::abs(cell_of(b.to) - b_first);
        const std::int64_t a_step = a.to < a.from ? -a.stride : a.stride;
        const std::int64_t b_step = b.to < b.from ? -b.stride : b.stride;

        const double length = std::abs(a.to - a.from);
        const double slope = length > 0.0 ? std::abs(b.to - b.from) / length : 0.0;
        const auto slope_fixed = std::llround(slope * static_cast<double>(kOne));
        // At least one unit below the border backwards, since a cell holds its lower border.
        std::int64_t way = std::llround((way_in_cell(b) + slope * (1.0 - way_in_cell(a))) *
                                        static_cast<double>(kOne)) -
                           (b.to < b.from ? 1 : 0);
        float* cell = cells_ + a_first * a.stride + b_first * b.stride;
        // In locals, since for all the compiler knows a cell could be a member.
        const float miss = miss_;
        const float lowest = lowest_;
        const auto erase_cell = [&cell, miss, lowest] { *cell = std::max(*cell + miss, lowest); };
        erase_cell();
        for (std::int64_t i = 0; i < borders; ++i) {
            if (way >= kOne) {
                way -= kOne;
                if (b_left > 0) {
                    --b_left;
                    cell += b_step;
                    erase_cell();
                }
            }
            way += slope_fixed;
            cell += a_step;
            erase_cell();
        }
        for (; b_left > 0; --b_left) {
            cell += b_step;
            erase_cell();
        }
    }

  private:
    float* cells_;
    float miss_;
    float lowest_;
};

CellArea with_cell(const CellArea& box, double u, double v) {
    const std::int64_t column = cell_of(u);
    const std::int64_t row = cell_of(v);
    return united(box, {column, row, column + 1, row + 1});
}

bool too_great(const CellArea& box) {
    const std::int64_t columns = box.end_column - box.first_column;
    const std::int64_t rows = box.end_row - box.first_row;
    return columns > kMostGridCells || rows > kMostGridCells / columns;
}

/// Of a box that is not too great.
std::int64_t cells_of(const CellArea& box) {
    return (box.end_column - box.first_column) * (box.end_row - box.first_row);
}

}  // namespace

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
    if (in_reach(laser_u, laser_v)) collect_rays(scan, pose_world_robot, laser);
    if (rays_.empty() || !keep_rays_that_fit(laser_u, laser_v)) return;

    last_change_ = with_cell({}, laser_u, laser_v);
    for (const Ray& ray : rays_) last_change_ = with_cell(last_change_, ray.u, ray.v);
    // From here on coordinates are those of the storage.
    const double base_u = static_cast<double>(first_column_) - static_cast<double>(column_offset_);
    const double base_v = static_cast<double>(first_row_) - static_cast<double>(row_offset_);
    const double from_u = laser_u - base_u;
    const double from_v = laser_v - base_v;
    const auto stride = static_cast<std::int64_t>(stride_);
    hits_.clear();
    for (Ray& ray : rays_) {
        ray.u -= base_u;
        ray.v -= base_v;
        if (!ray.hit) continue;
        const auto cell = static_cast<std::size_t>(cell_of(ray.v) * stride + cell_of(ray.u));
        hits_.push_back({cell, cells_[cell]});
    }
    const auto limit = static_cast<float>(params_.log_odds_limit);
    const RayEraser eraser(cells_.data(), static_cast<float>(params_.log_odds_miss), -limit);
    for (const Ray& ray : rays_) {
        const Axis u{from_u, ray.u, 1};
        const Axis v{from_v, ray.v, stride};
        if (std::abs(ray.u - from_u) >= std::abs(ray.v - from_v)) {
            eraser.erase(u, v);
        } else {
            eraser.erase(v, u);
        }
    }
    // What was hit gets back what it held before any ray of this scan passed it.
    for (const Hit& hit : hits_) cells_[hit.cell] = hit.before;
    const auto gain = static_cast<float>(params_.log_odds_hit);
    for (const Hit& hit : hits_) cells_[hit.cell] = std::min(cells_[hit.cell] + gain, limit);
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

/// Makes room for the rays; where the grid would be too great, for those that fit, in their order.
/// False where not even the laser fits; the grid is then as before.
bool Grid::keep_rays_that_fit(double laser_u, double laser_v) {
    CellArea box = with_cell(area(), laser_u, laser_v);
    if (too_great(box)) return false;
    CellArea all = box;
    for (const Ray& ray : rays_) all = with_cell(all, ray.u, ray.v);
    if (too_great(all)) {
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

CellArea Grid::area() const {
    return {first_column_, first_row_, first_column_ + columns_, first_row_ + rows_};
}

/// Makes `box`, which holds the bounds, the new bounds. Storage grows by a quarter on each side
/// that needs it, so that the cost of growing stays in proportion to the area.
void Grid::hold(const CellArea& box) {
    const CellArea old = area();
    CellArea storage{first_column_ - static_cast<std::int64_t>(column_offset_),
                     first_row_ - static_cast<std::int64_t>(row_offset_), 0, 0};
    storage.end_column = storage.first_column + static_cast<std::int64_t>(stride_);
    storage.end_row =
        storage.first_row + (stride_ == 0 ? 0 : static_cast<std::int64_t>(cells_.size() / stride_));
    const bool fits = !empty() && box.first_column >= storage.first_column &&
                      box.first_row >= storage.first_row && box.end_column <= storage.end_column &&
                      box.end_row <= storage.end_row;
    if (!fits) {
        std::int64_t margin_columns =
            std::max(kLeastMargin, (box.end_column - box.first_column) / 4);
        std::int64_t margin_rows = std::max(kLeastMargin, (box.end_row - box.first_row) / 4);
        CellArea greater;
        do {
            greater = box;
            if (empty() || box.first_column < old.first_column) {
                greater.first_column -= margin_columns;
            }
            if (empty() || box.end_column > old.end_column) greater.end_column += margin_columns;
            if (empty() || box.first_row < old.first_row) greater.first_row -= margin_rows;
            if (empty() || box.end_row > old.end_row) greater.end_row += margin_rows;
            margin_columns /= 2;
            margin_rows /= 2;
        } while (too_great(greater) || cells_of(greater) > 4 * cells_of(box) + kSmallStorage);

        const auto new_stride = static_cast<std::size_t>(greater.end_column - greater.first_column);
        const auto new_rows = static_cast<std::size_t>(greater.end_row - greater.first_row);
        std::vector<float> cells(new_stride * new_rows, 0.0F);
        const auto column_shift = static_cast<std::size_t>(first_column_ - greater.first_column);
        const auto row_shift = static_cast<std::size_t>(first_row_ - greater.first_row);
        for (std::size_t row = 0; row < static_cast<std::size_t>(rows_); ++row) {
            std::copy_n(cells_.data() + (row + row_offset_) * stride_ + column_offset_, columns_,
                        cells.data() + (row + row_shift) * new_stride + column_shift);
        }
        cells_ = std::move(cells);
        stride_ = new_stride;
        storage = greater;
    }
    first_column_ = box.first_column;
    first_row_ = box.first_row;
    columns_ = static_cast<int>(box.end_column - box.first_column);
    rows_ = static_cast<int>(box.end_row - box.first_row);
    column_offset_ = static_cast<std::size_t>(box.first_column - storage.first_column);
    row_offset_ = static_cast<std::size_t>(box.first_row - storage.first_row);
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
    const double free = 1.0 / (1.0 + std::exp(static_cast<double>(log_odds)));
    return static_cast<std::uint8_t>(std::lround(255.0 * free));
}

Grid::Picture Grid::picture() const {
    Picture picture{columns_, rows_, {}};
    picture.grey.reserve(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    float last = 0.0F;  // most cells equal their neighbour: the exponential is worth remembering
    std::uint8_t grey = grey_of(last);
    for (int row = rows_ - 1; row >= 0; --row) {
        for (int column = 0; column < columns_; ++column) {
            const float value = log_odds(column, row);
            if (value != last) {
                last = value;
                grey = grey_of(value);
            }
            picture.grey.push_back(grey);
        }
    }
    return picture;
}

}  // namespace hitos
