#include "hitos/services/drawing/contact_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "hitos/base/error.hpp"
#include "hitos/base/median.hpp"
#include "hitos/services/drawing/scale_bar.hpp"
#include "picture_drawing.hpp"

namespace hitos {
namespace {

constexpr int kSmallest = 9;       // PNG's hardest compression
constexpr int kLeastSide = 60;     // below it nothing can be seen
constexpr int kGap = 10;           // pixels between tiles and round the sheet
constexpr int kLine = 17;          // pixels of a line of words
constexpr double kLetters = 0.42;  // OpenCV's measure of a font
constexpr double kTitleLetters = 0.55;
constexpr double kShortestSide = 0.3;  // of a tile, as a part of the longer one: words need room

/// The piece of the world that every tile shows.
struct Window {
    Point2 low;
    Point2 high;
    double width() const { return high.x - low.x; }
    double height() const { return high.y - low.y; }
};

/// All maps, but no further than most of them reach by a third of their size.
Window window_of(const std::vector<SheetTile>& tiles) {
    std::vector<double> left;
    std::vector<double> bottom;
    std::vector<double> right;
    std::vector<double> top;
    for (std::vector<double>* side : {&left, &bottom, &right, &top}) side->reserve(tiles.size());
    for (const SheetTile& tile : tiles) {
        const MapImage& map = tile.map;
        if (map.picture.grey.empty()) continue;
        left.push_back(map.origin.x);
        bottom.push_back(map.origin.y);
        right.push_back(map.origin.x + map.picture.width * map.m_per_pixel);
        top.push_back(map.origin.y + map.picture.height * map.m_per_pixel);
    }
    if (left.empty()) return {{-1.0, -1.0}, {1.0, 1.0}};
    const Window most{{median(left), median(bottom)}, {median(right), median(top)}};
    constexpr double kThird = 1.0 / 3.0;
    const double further = kThird * std::max({most.width(), most.height(), 1.0});
    const auto least = [](const std::vector<double>& v) { return *std::ranges::min_element(v); };
    const auto greatest = [](const std::vector<double>& v) { return *std::ranges::max_element(v); };
    return {{std::max(least(left), most.low.x - further),
             std::max(least(bottom), most.low.y - further)},
            {std::min(greatest(right), most.high.x + further),
             std::min(greatest(top), most.high.y + further)}};
}

/// Sizes in pixels.
struct Layout {
    double pixels_per_m = 1.0;
    int tile_width = 0;
    int tile_height = 0;
    int caption = 0;
    int columns = 1;
    int rows = 1;
    int width() const { return columns * (tile_width + kGap) + kGap; }
    int head() const { return kGap + 2 * kLine; }
    int row_height() const { return tile_height + caption + kGap; }
    int height() const { return head() + rows * row_height() + 2 * kLine + kGap; }
};

Layout layout_of(const ContactSheet& sheet, const Window& window, int side) {
    Layout layout;
    const double longest = std::max(window.width(), window.height());
    layout.pixels_per_m = side / longest;
    const int shortest = static_cast<int>(kShortestSide * side);
    const auto pixels = [&](double length_m) {
        return std::max(static_cast<int>(std::ceil(length_m * layout.pixels_per_m)), shortest);
    };
    layout.tile_width = pixels(window.width());
    layout.tile_height = pixels(window.height());
    std::size_t lines = 1;
    for (const SheetTile& tile : sheet.tiles) {
        lines = std::max(lines, tile.caption.size());
        for (const std::string& words : tile.caption) {
            layout.tile_width =
                std::max(layout.tile_width, drawing::size_of_words(words, kLetters).width + 4);
        }
    }
    layout.caption = static_cast<int>(lines) * kLine + 4;
    const auto count = static_cast<int>(sheet.tiles.size());
    const double square = std::sqrt(static_cast<double>(count) * layout.row_height() /
                                    (layout.tile_width + kGap) * 1.4);
    layout.columns = std::clamp(
        sheet.columns > 0 ? sheet.columns : static_cast<int>(std::lround(square)), 1, count);
    layout.rows = (count + layout.columns - 1) / layout.columns;
    return layout;
}

/// The window with what the tile is larger than it, on both sides alike.
Window widened(const Window& window, const Layout& layout) {
    const double x = (layout.tile_width / layout.pixels_per_m - window.width()) / 2.0;
    const double y = (layout.tile_height / layout.pixels_per_m - window.height()) / 2.0;
    return {{window.low.x - x, window.low.y - y}, {window.high.x + x, window.high.y + y}};
}

/// Few greys make a small file, and the eye does not tell more in a small map.
std::uint8_t coarse_grey(std::uint8_t grey) {
    if (grey == kUnknownGrey) return grey;
    constexpr int kStep = 17;  // 255 is a multiple
    return static_cast<std::uint8_t>((grey + kStep / 2) / kStep * kStep);
}

/// The map's pixels laid on those of the tile.
cv::Mat tile_picture(const MapImage& map, const Window& window, const Layout& layout) {
    cv::Mat grey(layout.tile_height, layout.tile_width, CV_8UC1, cv::Scalar::all(kUnknownGrey));
    const auto along = [&](int pixel, double from, double origin) {
        return static_cast<int>(
            std::floor((from + pixel / layout.pixels_per_m - origin) / map.m_per_pixel));
    };
    for (int y = 0; y < grey.rows; ++y) {
        const int from_below = grey.rows - 1 - y;
        const int low = along(from_below, window.low.y, map.origin.y);
        const int high = std::max(along(from_below + 1, window.low.y, map.origin.y), low + 1);
        for (int x = 0; x < grey.cols; ++x) {
            const int left = along(x, window.low.x, map.origin.x);
            const int right = std::max(along(x + 1, window.low.x, map.origin.x), left + 1);
            drawing::Block block;
            for (int row = std::max(low, 0); row < std::min(high, map.picture.height); ++row) {
                const auto line = static_cast<std::size_t>(map.picture.height - 1 - row) *
                                  static_cast<std::size_t>(map.picture.width);
                for (int column = std::max(left, 0); column < std::min(right, map.picture.width);
                     ++column) {
                    block.add(map.picture.grey[line + static_cast<std::size_t>(column)]);
                }
            }
            grey.at<std::uint8_t>(y, x) = coarse_grey(block.grey());
        }
    }
    cv::Mat colours;
    cv::cvtColor(grey, colours, cv::COLOR_GRAY2BGR);
    return colours;
}

void draw_tile(cv::Mat& image, const SheetTile& tile, const Window& window, const Layout& layout,
               const cv::Point& at) {
    constexpr int kRadius = 5;
    cv::Mat picture = tile_picture(tile.map, window, layout);
    const drawing::Frame frame(window.low, layout.pixels_per_m, picture.rows);
    drawing::draw_path(picture, frame, tile.path, 1, kRadius, PathMarks::cross_and_ring);
    if (tile.map.picture.grey.empty()) {
        drawing::draw_words(picture, "no map", {kGap, layout.tile_height / 2}, kLetters);
    }
    picture.copyTo(image(cv::Rect(at.x, at.y, picture.cols, picture.rows)));
    cv::rectangle(image, cv::Rect(at.x - 1, at.y - 1, picture.cols + 2, picture.rows + 2),
                  cv::Scalar::all(120), 1);
    int line = at.y + picture.rows + kLine - 3;
    for (const std::string& words : tile.caption) {
        drawing::draw_words(image, words, {at.x, line}, kLetters);
        line += kLine;
    }
}

void draw_bar(cv::Mat& image, const Layout& layout) {
    constexpr int kThickness = 4;
    const double length_m = round_length(layout.tile_width / 2.0 / layout.pixels_per_m);
    const int length = std::max(1, static_cast<int>(std::lround(length_m * layout.pixels_per_m)));
    const int y = image.rows - kGap - kThickness;
    cv::rectangle(image, cv::Rect(kGap, y, length, kThickness), cv::Scalar::all(0), cv::FILLED);
    drawing::draw_words(image, fmt::format("{:g} m", length_m), {kGap, y - 5}, kLetters);
    const std::string legend = "X start, O end, red: path of the map";
    const int width = drawing::size_of_words(legend, kLetters).width;
    if (length + 3 * kGap + width < image.cols) {
        drawing::draw_words(image, legend, {length + 2 * kGap, y + kThickness}, kLetters);
    }
}

}  // namespace

std::string encode_contact_sheet(const ContactSheet& sheet, std::string_view kind) {
    if (sheet.tiles.empty()) {
        throw Error(message(HITOS_TEXT("Errors", "there is no map to put on a sheet")));
    }
    const Window window = window_of(sheet.tiles);
    int side = std::max(sheet.tile_side, kLeastSide);
    Layout layout = layout_of(sheet, window, side);
    const auto too_great = [&] {
        return std::int64_t{layout.width()} * layout.height() > kMostSheetPixels;
    };
    constexpr int kStep = 20;
    while (too_great() && side - kStep >= kLeastSide) {
        side -= kStep;
        layout = layout_of(sheet, window, side);
    }
    if (too_great()) {
        throw Error(message(HITOS_TEXT("Errors", "%1 maps are too many for one sheet of %2 pixels"),
                            sheet.tiles.size(), kMostSheetPixels));
    }
    cv::Mat image(layout.height(),
                  std::max(layout.width(),
                           drawing::size_of_words(sheet.title, kTitleLetters).width + 2 * kGap),
                  CV_8UC3, cv::Scalar::all(255));
    drawing::draw_words(image, sheet.title, {kGap, kGap + kLine}, kTitleLetters);
    const Window shown = widened(window, layout);
    for (std::size_t i = 0; i < sheet.tiles.size(); ++i) {
        const int row = static_cast<int>(i) / layout.columns;
        const int column = static_cast<int>(i) % layout.columns;
        draw_tile(image, sheet.tiles[i], shown, layout,
                  {kGap + column * (layout.tile_width + kGap),
                   layout.head() + row * layout.row_height()});
    }
    draw_bar(image, layout);
    return drawing::encoded(image, kind, kSmallest);
}

void write_contact_sheet(const ContactSheet& sheet, const std::filesystem::path& path) {
    drawing::write_encoded(
        path, [&](const std::string& kind) { return encode_contact_sheet(sheet, kind); });
}

}  // namespace hitos
