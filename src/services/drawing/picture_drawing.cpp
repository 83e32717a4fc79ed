// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_drawing.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <opencv2/core/utility.hpp>
#include <utility>

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

/// What is coloured in no more colours than a palette has room for beside all greys: the edges of
/// lines have hundreds, of which nobody sees so many.
void use_few_colours(cv::Mat& image) {
    constexpr int kStep = 32;
    const auto rounded = [](std::uint8_t value) {
        return static_cast<std::uint8_t>(std::min((value + kStep / 2) / kStep * kStep, 255));
    };
    for (int y = 0; y < image.rows; ++y) {
        auto* const row = image.ptr<cv::Vec3b>(y);
        for (int x = 0; x < image.cols; ++x) {
            cv::Vec3b& colour = row[x];
            if (colour[0] == colour[1] && colour[1] == colour[2]) continue;
            for (int i = 0; i < 3; ++i) colour[i] = rounded(colour[i]);
        }
    }
}

/// A path in the tiles of a picture that it passes: most of a large one is left alone.
class PathTiles {
  public:
    /// `beside`: pixels that a line reaches to either side.
    PathTiles(const cv::Size& size, double beside) : size_(size), beside_(beside) {}

    /// The next step; it goes on from the last one where it begins at its end.
    void add(const Point2& from, const Point2& to) {
        Bounds bounds;
        bounds.hold(from);
        bounds.hold(to);
        for_each(bounds, [&](std::vector<std::vector<Point2>>& lines) {
            if (lines.empty() || lines.back().back() != from) lines.push_back({from});
            lines.back().push_back(to);
        });
    }
    void touch(const Point2& at, double radius) {
        Bounds bounds;
        bounds.hold({at.x - radius, at.y - radius});
        bounds.hold({at.x + radius, at.y + radius});
        for_each(bounds, [](std::vector<std::vector<Point2>>& /*lines*/) {});
    }

    /// The lines in this style, and `over` over them.
    void paint(cv::Mat& image, const ShapeStyle& style, const std::vector<DrawnLayer>& over) {
        for (auto& [place, lines] : tiles_) {
            const Point2 corner{place.second * kSide + 0.0, place.first * kSide + 0.0};
            cv::Mat tile = image(cv::Rect(place.second * kSide, place.first * kSide, kSide, kSide) &
                                 cv::Rect({}, image.size()));
            VectorDrawing drawing;
            DrawnLayer path{"path", style};
            path.lines = std::move(lines);
            drawing.layers.push_back(std::move(path));
            drawing.layers.insert(drawing.layers.end(), over.begin(), over.end());
            drawing::paint(tile, drawing, 1.0, corner);
            use_few_colours(tile);
        }
    }

  private:
    static constexpr int kSide = 256;

    template <class Do>
    void for_each(const Bounds& bounds, const Do& with) {
        const auto tile = [](double pixel) { return static_cast<int>(std::floor(pixel / kSide)); };
        const int last_row = (size_.height - 1) / kSide;
        const int last_column = (size_.width - 1) / kSide;
        for (int row = std::max(tile(bounds.low.y - beside_), 0);
             row <= std::min(tile(bounds.high.y + beside_), last_row); ++row) {
            for (int column = std::max(tile(bounds.low.x - beside_), 0);
                 column <= std::min(tile(bounds.high.x + beside_), last_column); ++column) {
                with(tiles_[{row, column}]);
            }
        }
    }

    cv::Size size_;
    double beside_;
    std::map<std::pair<int, int>, std::vector<std::vector<Point2>>> tiles_;  // by row and column
};

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

void draw_paths(cv::Mat& image, const Placement& placement,
                const std::vector<std::vector<Point2>>& paths, double width, double radius,
                PathMarks marks) {
    if (paths.empty()) return;
    PathTiles tiles(image.size(), width);
    for (const std::vector<Point2>& path : paths) {
        std::optional<Point2> last;
        for (const Point2& point : path) {
            const Point2 pixel = placement.at(point);
            const bool fits = fits_a_picture(pixel);
            if (fits && last) tiles.add(*last, pixel);
            last = fits ? std::optional(pixel) : std::nullopt;
        }
    }
    std::vector<DrawnLayer> ends;
    for (const bool start : {true, false}) {
        const Point2 at = placement.at(start ? paths.front().front() : paths.back().back());
        if (!fits_a_picture(at)) continue;
        ends.push_back(mark(at, radius, marks, start));
        tiles.touch(at, radius);
    }
    tiles.paint(image, line_style(kPathRed, width), ends);
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
