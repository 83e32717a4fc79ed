// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_drawing.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <opencv2/core/utility.hpp>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/services/drawing/scale_bar.hpp"
#include "picture_codecs.hpp"

namespace hitos {
namespace drawing {
namespace {

// OpenCV's own threads gain nothing here, and where the system cannot start one it waits for it
// without end (4.6).
[[maybe_unused]] const bool kWithoutItsThreads = [] {
    cv::setNumThreads(1);
    return true;
}();

constexpr double kFarthest = 4e6;  // pixels; cairo's numbers overflow at 2^23
constexpr Colour kPathRed{255, 0, 0};
constexpr Colour kStartGreen{0, 160, 0};
constexpr Colour kEndBlue{0, 64, 255};

std::string lower(std::string_view text) {
    std::string out(text);
    for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return out;
}

bool fits_a_picture(const Point2& pixel) {
    return std::abs(pixel.x) < kFarthest && std::abs(pixel.y) < kFarthest;
}

DrawnLayer mark(const Point2& at, double radius, PathMarks marks, bool start) {
    const Colour colour = start ? kStartGreen : kEndBlue;
    DrawnLayer layer{start ? "start" : "end", {.fill = colour}};
    if (marks == PathMarks::cross_and_ring) layer.style = line_style(colour, 2.5);
    if (marks == PathMarks::cross_and_ring && start) {
        layer.lines = {{{at.x - radius, at.y - radius}, {at.x + radius, at.y + radius}},
                       {{at.x - radius, at.y + radius}, {at.x + radius, at.y - radius}}};
    } else {
        layer.ellipses = {disc(at, radius)};
    }
    return layer;
}

std::string kind_from(const std::filesystem::path& path) {
    const std::string extension = lower(path.extension().string());
    if (extension != ".png" && extension != ".jpg" && extension != ".jpeg") {
        throw FileError(
            path.string(),
            HITOS_TEXT("Errors",
                       "found the extension \"%1\"; pictures are written as .png, .jpg or .jpeg"),
            path.extension().string());
    }
    return extension.substr(1);
}

bool is_jpeg(const std::string& word) {
    return word == "jpg" || word == "jpeg";
}

}  // namespace

int longest_side(std::string_view kind) {
    constexpr int kOfJpeg = 65500;   // the limit of libjpeg
    constexpr int kOfPng = 1000000;  // the limit of libpng, unless it is told another
    return is_jpeg(lower(kind)) ? kOfJpeg : kOfPng;
}

void draw_path(cv::Mat& image, const Placement& placement, const std::vector<Point2>& path,
               double width, double radius, PathMarks marks) {
    if (path.empty()) return;
    DrawnLayer red{"path", line_style(kPathRed, width)};
    red.lines.emplace_back();
    for (const Point2& point : path) {
        const Point2 pixel = placement.at(point);
        if (fits_a_picture(pixel)) {
            red.lines.back().push_back(pixel);
        } else if (!red.lines.back().empty()) {
            red.lines.emplace_back();
        }
    }
    VectorDrawing drawing;
    drawing.layers.push_back(std::move(red));
    for (const bool start : {true, false}) {
        const Point2 at = placement.at(start ? path.front() : path.back());
        if (fits_a_picture(at)) drawing.layers.push_back(mark(at, radius, marks, start));
    }
    paint(image, drawing);
}

void draw_scale_bar(cv::Mat& image, double pixels_per_m) {
    constexpr int kLeastSide = 80;
    constexpr int kMargin = 6;
    constexpr int kInside = 4;
    constexpr int kHeight = 26;
    if (image.cols < kLeastSide || image.rows < kLeastSide) return;
    VectorDrawing bar;
    const double end =
        add_scale_bar(bar, {kInside, kHeight - kInside}, image.cols / 4.0, pixels_per_m);
    const int width = std::min(static_cast<int>(std::ceil(end)) + kInside, image.cols - kMargin);
    cv::Mat corner = image(cv::Rect(kMargin, image.rows - kMargin - kHeight, width, kHeight));
    corner.setTo(cv::Scalar::all(255));
    paint(corner, bar);
}

std::string encoded(const cv::Mat& image, std::string_view kind, std::optional<int> compression) {
    const std::string word = lower(kind);
    const bool jpeg = is_jpeg(word);
    if (!jpeg && word != "png") {
        throw ConfigError(
            "kind",
            HITOS_TEXT("Errors", "\"%1\" is no kind of picture; allowed: one of png, jpg, jpeg"),
            kind);
    }
    if (jpeg && std::max(image.cols, image.rows) > longest_side(word)) {
        throw Error(message(HITOS_TEXT("Errors",
                                       "JPG holds at most %1 pixels a side and the picture has %2 "
                                       "x %3; write PNG instead"),
                            longest_side(word), image.cols, image.rows));
    }
    return jpeg ? jpeg_of(image) : png_of(image, compression);
}

void write_encoded(const std::filesystem::path& path,
                   const std::function<std::string(const std::string& kind)>& encode) {
    const std::string kind = kind_from(path);
    std::string bytes;
    try {
        bytes = encode(kind);
    } catch (const Error& error) {
        throw FileError(path.string(), error.message());
    }
    write_file(path, bytes);
}

}  // namespace drawing

namespace {

std::string pixels_of(const VectorDrawing& drawing, double scale, std::string_view kind) {
    const auto pixels = [&](double units) {
        return static_cast<int>(std::clamp(std::round(units * scale), 1.0,
                                           static_cast<double>(drawing::longest_side(kind))));
    };
    cv::Mat image(pixels(drawing.height), pixels(drawing.width), CV_8UC3, cv::Scalar::all(255));
    drawing::paint(image, drawing, scale);
    return drawing::encoded(image, kind);
}

}  // namespace

std::string png_text(const VectorDrawing& drawing, double scale) {
    return pixels_of(drawing, scale, "png");
}

void write_picture(const VectorDrawing& drawing, const std::filesystem::path& path) {
    drawing::write_encoded(path,
                           [&](const std::string& kind) { return pixels_of(drawing, 1.0, kind); });
}

}  // namespace hitos
