// SPDX-License-Identifier: GPL-3.0-or-later
// PNG and JPG by their own libraries, and the simple kinds of pictures that are read besides.
// OpenCV's codecs would bring a hundred libraries of maps and databases with them, which every
// start of a program had to load.
#pragma once

#include <cstdint>
#include <functional>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hitos::drawing {

/// Rows from the top, of each pixel so many bytes: grey, grey and alpha, RGB, or RGBA.
struct Pixels {
    int width = 0;
    int height = 0;
    int channels = 0;
    std::vector<std::uint8_t> values;
};

/// Told a picture's width and height before there is room for its pixels; throws where they are too
/// many.
using SizeCheck = std::function<void(std::uint64_t width, std::uint64_t height)>;

/// What the first bytes say: PNG, JPG, PBM, PGM, PPM or BMP. Nothing where it is none of them,
/// breaks off, or has pixels that would be guessed. Values of more than 8 bits become 8.
std::optional<Pixels> decoded(std::string_view bytes, const SizeCheck& check);

/// Bytes of grey (CV_8UC1) or of colours as OpenCV has them (CV_8UC3: blue, green, red).
/// `compression` is 0 to 9; nothing: what is fast. Throws Error where it cannot be.
std::string png_of(const cv::Mat& image, std::optional<int> compression);
std::string jpeg_of(const cv::Mat& image);

/// Of a PBM, PGM or PPM, and of a BMP that is not compressed.
std::optional<Pixels> decoded_pnm(std::string_view bytes, const SizeCheck& check);
std::optional<Pixels> decoded_bmp(std::string_view bytes, const SizeCheck& check);

/// All pixels are still 0.
Pixels room_for(std::uint64_t width, std::uint64_t height, int channels, const SizeCheck& check);

}  // namespace hitos::drawing
