// SPDX-License-Identifier: GPL-3.0-or-later
// Grid tiles as an image that is brought up to date tile by tile.
#pragma once

#include <QImage>
#include <array>
#include <memory>
#include <vector>

#include "canvas_view.hpp"
#include "hitos/services/grid/grid_tiles.hpp"

namespace hitos::window {

/// What a grid covers [m]; null where it is empty.
/// The grey that a cell's grey is shown in: itself, or in the dark one in the same order that is
/// calm for eyes used to it and keeps free and unknown apart (contrast 7 : 1).
std::uint8_t shade_of(std::uint8_t grey, bool dark);

QRectF bounds_of(const GridTiles& tiles);

/// Keeps the image at several resolutions, so that a picture far smaller than the grid is neither
/// slow nor without its walls.
class GridLayer {
  public:
    void set_tiles(const GridTiles& tiles);
    void clear();
    bool empty() const { return shown_.empty(); }
    QRectF bounds() const;
    void paint(QPainter& painter, const Scene& scene) const;

  private:
    static constexpr int kLevels = 4;

    void copy_tile(std::size_t place, const GridTile* tile);

    GridTiles shown_;
    std::array<QImage, kLevels> images_;  // grey; level n has one pixel for 2^n x 2^n cells
};

}  // namespace hitos::window
