// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/drawing/picture_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "picture_codecs.hpp"
#include "picture_drawing.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;

/// Pixels of our own maps: square kilometres at 5 cm take their cells two by two, and a few seconds
/// to write.
constexpr std::int64_t kMostOfMap = std::int64_t{1} << 27;
constexpr std::int64_t kMostForeign = 100'000'000;

/// At the scale 1 the picture's own pixels, which it holds no longer than that and nobody writes
/// to.
cv::Mat scaled(const Grid::Picture& picture, int scale) {
    if (scale < 1 || scale > kGreatestPictureScale) {
        throw ConfigError(
            "scale", HITOS_TEXT("Errors", "%1 is out of range; allowed: integers from 1 to %2"),
            scale, kGreatestPictureScale);
    }
    if (picture.width <= 0 || picture.height <= 0) {
        throw Error(
            message(HITOS_TEXT("Errors", "the grid map is empty: there is nothing to draw")));
    }
    const std::int64_t width = std::int64_t{picture.width} * scale;
    const std::int64_t height = std::int64_t{picture.height} * scale;
    if (width > drawing::kMostPixels / height) {
        throw Error(message(
            HITOS_TEXT(
                "Errors",
                "a picture of %1 x %2 pixels is too great; use a smaller scale or coarser cells"),
            width, height));
    }
    cv::Mat cells(picture.height, picture.width, CV_8UC1,
                  const_cast<std::uint8_t*>(picture.grey.data()));
    if (scale == 1) return cells;
    cv::Mat image;
    cv::resize(cells, image, cv::Size(static_cast<int>(width), static_cast<int>(height)), 0, 0,
               cv::INTER_NEAREST);
    return image;
}

/// side x side pixels become one.
MapImage joined(MapImage large, int side) {
    if (side <= 1) return large;
    const Grid::Picture& cells = large.picture;
    MapImage image;
    image.origin = large.origin;
    image.m_per_pixel = large.m_per_pixel * side;
    image.picture.width = (cells.width + side - 1) / side;
    image.picture.height = (cells.height + side - 1) / side;
    image.picture.grey.reserve(static_cast<std::size_t>(image.picture.width) *
                               static_cast<std::size_t>(image.picture.height));
    // Of large pictures most is unknown, which says nothing in a block, and is passed over.
    std::array<std::uint8_t, 32> unknown{};
    unknown.fill(kUnknownGrey);
    const auto width = static_cast<std::size_t>(cells.width);
    const auto across = static_cast<std::size_t>(side);
    for (int row = image.picture.height; row-- > 0;) {  // counted from below, as the origin is
        const int top = std::max(cells.height - (row + 1) * side, 0);
        const int bottom = cells.height - row * side;
        std::vector<drawing::Block> blocks(static_cast<std::size_t>(image.picture.width));
        for (int y = top; y < bottom; ++y) {
            const std::uint8_t* line = &cells.grey[static_cast<std::size_t>(y) * width];
            for (std::size_t x = 0; x < width;) {
                if (width - x >= unknown.size() &&
                    std::memcmp(line + x, unknown.data(), unknown.size()) == 0) {
                    x += unknown.size();
                    continue;
                }
                const std::size_t column = x / across;
                const std::size_t end = std::min((column + 1) * across, width);
                while (x < end) blocks[column].add(line[x++]);
            }
        }
        for (const drawing::Block& block : blocks) image.picture.grey.push_back(block.grey());
    }
    return image;
}

/// Who is told that a picture has more pixels than `most` has not made room for them.
drawing::Pixels decoded(const fs::path& path, std::uint64_t most) {
    std::optional<drawing::Pixels> pixels =
        drawing::decoded(input::read_text(path), [&](std::uint64_t width, std::uint64_t height) {
            if (width <= most / height) return;
            throw FormatError(path.string(), 0,
                              HITOS_TEXT("Errors", "has %1 x %2 pixels; expected at most %3"),
                              width, height, most);
        });
    if (!pixels) {
        throw FormatError(path.string(), 0,
                          HITOS_TEXT("Errors",
                                     "is no picture, or a damaged one; expected PNG, JPG, PGM or "
                                     "BMP that is not compressed"));
    }
    return *std::move(pixels);
}

MeanPicture mean_of(drawing::Pixels pixels) {
    MeanPicture result;
    result.grey = {pixels.width, pixels.height, {}};
    const auto channels = static_cast<std::size_t>(pixels.channels);
    if (channels == 1) {
        result.grey.grey = std::move(pixels.values);
        return result;
    }
    const std::size_t colours = channels % 2 == 0 ? channels - 1 : channels;  // the last is alpha
    for (std::size_t at = 0; at < pixels.values.size(); at += channels) {
        const auto begin = pixels.values.begin() + static_cast<std::ptrdiff_t>(at);
        const auto sum = static_cast<std::size_t>(
            std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(colours), 0));
        result.grey.grey.push_back(static_cast<std::uint8_t>((sum + colours / 2) / colours));
        if (colours < channels) result.alpha.push_back(pixels.values[at + colours]);
    }
    return result;
}

}  // namespace

MapImage map_image(const Grid& grid) {
    return {grid.picture(), grid.origin(), grid.resolution_m()};
}

MapImage shrunk(MapImage image, int longest_side) {
    const int longest = std::max(image.picture.width, image.picture.height);
    return joined(std::move(image), (longest + longest_side - 1) / longest_side);
}

MapImage fitted(MapImage image, std::string_view kind) {
    const std::int64_t width = image.picture.width;
    const std::int64_t height = image.picture.height;
    const auto fits = [&](std::int64_t side) {
        const std::int64_t columns = (width + side - 1) / side;
        const std::int64_t rows = (height + side - 1) / side;
        return std::max(columns, rows) <= drawing::longest_side(kind) &&
               columns * rows <= kMostOfMap;
    };
    int side = 1;
    while (!fits(side)) ++side;
    return joined(std::move(image), side);
}

std::string encode_picture(const MapImage& map, const PictureStyle& style, std::string_view kind) {
    cv::Mat image = scaled(map.picture, style.scale);
    const double pixels_per_m = style.scale / map.m_per_pixel;
    if (style.paths.empty()) {
        if (style.scale == 1 && style.scale_bar) image = image.clone();
    } else {
        cv::cvtColor(image, image, cv::COLOR_GRAY2BGR);
        constexpr int kRadius = 3;  // and a pixel for each of the scale
        drawing::draw_paths(image, {map.origin, {0.0, image.rows + 0.0}, pixels_per_m}, style.paths,
                            std::max(1.5, style.scale / 2.0), kRadius + style.scale, style.marks);
    }
    if (style.scale_bar) drawing::draw_scale_bar(image, pixels_per_m);
    return drawing::encoded(image, kind);
}

std::string encode_picture(const Grid& grid, const PictureStyle& style, std::string_view kind) {
    return encode_picture(map_image(grid), style, kind);
}

std::string encode_picture(const Grid::Picture& picture, std::string_view kind) {
    return drawing::encoded(scaled(picture, 1), kind);
}

void write_picture(const MapImage& map, const PictureStyle& style, const fs::path& path) {
    drawing::write_encoded(
        path, [&](const std::string& kind) { return encode_picture(map, style, kind); });
}

void write_picture(const Grid& grid, const PictureStyle& style, const fs::path& path) {
    drawing::write_encoded(
        path, [&](const std::string& kind) { return encode_picture(grid, style, kind); });
}

void write_picture(const Grid::Picture& picture, const fs::path& path) {
    drawing::write_encoded(path,
                           [&](const std::string& kind) { return encode_picture(picture, kind); });
}

Grid::Picture read_grey_picture(const fs::path& path) {
    return mean_of(decoded(path, kMostOfMap)).grey;
}

MeanPicture read_mean_picture(const fs::path& path) {
    return mean_of(decoded(path, kMostForeign));
}

}  // namespace hitos
