// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid_layer.hpp"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cstring>
#include <span>

namespace hitos::window {
namespace {

/// Half the side: the mean, drawn towards the darkest so that thin walls stay.
void halve(const std::uint8_t* from, std::ptrdiff_t side, std::uint8_t* to) {
    const std::ptrdiff_t half = side / 2;
    for (std::ptrdiff_t y = 0; y < half; ++y) {
        for (std::ptrdiff_t x = 0; x < half; ++x) {
            const std::uint8_t* cell = from + 2 * y * side + 2 * x;
            const int sum = cell[0] + cell[1] + cell[side] + cell[side + 1];
            const int least = std::min({cell[0], cell[1], cell[side], cell[side + 1]});
            to[y * half + x] = static_cast<std::uint8_t>((sum / 4 + least) / 2);
        }
    }
}

QImage in_the_dark(QImage image) {
    std::array<std::uint8_t, 256> shades{};
    for (std::size_t grey = 0; grey < shades.size(); ++grey)
        shades[grey] = shade_of(static_cast<std::uint8_t>(grey), true);
    for (int y = 0; y < image.height(); ++y) {
        const std::span line(image.scanLine(y), static_cast<std::size_t>(image.width()));
        std::ranges::transform(line, line.begin(), [&](std::uint8_t grey) { return shades[grey]; });
    }
    return image;
}

}  // namespace

void GridLayer::clear() {
    shown_ = {};
    for (QImage& image : images_) image = {};
}

void GridLayer::set_tiles(const GridTiles& tiles) {
    if (tiles.empty()) {
        clear();
        return;
    }
    const bool same_place = shown_.first_column == tiles.first_column &&
                            shown_.first_row == tiles.first_row &&
                            shown_.columns == tiles.columns && shown_.rows == tiles.rows;
    if (!same_place) {
        for (int level = 0; level < kLevels; ++level) {
            QImage& image = images_[static_cast<std::size_t>(level)];
            image = QImage((tiles.columns * kTileSide) >> level, (tiles.rows * kTileSide) >> level,
                           QImage::Format_Grayscale8);
            image.fill(kUnknownGrey);
        }
    }
    const GridTiles before = same_place ? shown_ : GridTiles{};
    shown_ = tiles;
    for (std::size_t i = 0; i < tiles.tiles.size(); ++i) {
        if (!tiles.tiles[i] || (same_place && before.tiles[i] == tiles.tiles[i])) continue;
        copy_tile(i, tiles.tiles[i].get());
    }
}

void GridLayer::copy_tile(std::size_t place, const GridTile* tile) {
    const int column = static_cast<int>(place) % shown_.columns;
    const int row = static_cast<int>(place) / shown_.columns;
    std::array<std::uint8_t, std::size_t{kTileSide}* kTileSide> level_grey = tile->grey;
    std::array<std::uint8_t, std::size_t{kTileSide} * kTileSide> half{};
    for (int level = 0; level < kLevels; ++level) {
        QImage& image = images_[static_cast<std::size_t>(level)];
        const int side = kTileSide >> level;
        // Images have their first row at the top, tiles at the bottom.
        for (int y = 0; y < side; ++y) {
            const int line = image.height() - 1 - (row * side + y);
            std::memcpy(image.scanLine(line) + static_cast<std::ptrdiff_t>(column) * side,
                        level_grey.data() + static_cast<std::ptrdiff_t>(y) * side,
                        static_cast<std::size_t>(side));
        }
        halve(level_grey.data(), side, half.data());
        level_grey = half;
    }
}

std::uint8_t shade_of(std::uint8_t grey, bool dark) {
    if (!dark) return grey;
    constexpr int kUnknown = 48;
    constexpr int kFree = 190;
    constexpr int kMost = 255;
    const int shade = grey <= kUnknownGrey ? kUnknown * grey / kUnknownGrey
                                           : kUnknown + (kFree - kUnknown) * (grey - kUnknownGrey) /
                                                            (kMost - kUnknownGrey);
    return static_cast<std::uint8_t>(shade);
}

QRectF bounds_of(const GridTiles& tiles) {
    if (tiles.empty()) return {};
    const double r = tiles.resolution_m;
    return {QPointF(static_cast<double>(tiles.area.first_column) * r,
                    static_cast<double>(tiles.area.first_row) * r),
            QPointF(static_cast<double>(tiles.area.end_column) * r,
                    static_cast<double>(tiles.area.end_row) * r)};
}

QRectF GridLayer::bounds() const {
    return bounds_of(shown_);
}

void GridLayer::paint(QPainter& painter, const Scene& scene) const {
    if (shown_.empty()) return;
    const double scale = painter.deviceTransform().m11() * scene.pixels_per_m * shown_.resolution_m;
    int level = 0;
    while (level + 1 < kLevels && scale * (1 << level) < 0.5) ++level;
    const QImage& image = images_[static_cast<std::size_t>(level)];
    const double cell = shown_.resolution_m * (1 << level);
    const double left = static_cast<double>(shown_.first_column * kTileSide) * shown_.resolution_m;
    const double top =
        static_cast<double>((shown_.first_row + shown_.rows) * kTileSide) * shown_.resolution_m;
    // Only what is in sight: the part of the image under the scene.
    const QRectF seen = scene.to_screen.inverted().mapRect(QRectF(QPointF(), scene.size));
    QRectF part(QPointF((seen.left() - left) / cell, (top - seen.bottom()) / cell),
                QPointF((seen.right() - left) / cell, (top - seen.top()) / cell));
    const QRect pixels = part.toAlignedRect().intersected(image.rect());
    if (pixels.isEmpty()) return;
    const bool turned = scene.to_screen.type() > QTransform::TxScale;
    QRectF target = pixels;
    painter.save();
    painter.setRenderHint(QPainter::SmoothPixmapTransform, turned || scale * (1 << level) < 1.0);
    if (turned) {
        painter.setTransform(QTransform(cell, 0.0, 0.0, -cell, left, top) * scene.to_screen, true);
    } else {
        target = scene.to_screen.mapRect(QRectF(left + pixels.left() * cell,
                                                top - (pixels.top() + pixels.height()) * cell,
                                                pixels.width() * cell, pixels.height() * cell));
    }
    if (scene.colours.dark) {
        painter.drawImage(target, in_the_dark(image.copy(pixels)));
    } else {
        painter.drawImage(target, image, pixels);
    }
    painter.restore();
}

}  // namespace hitos::window
