// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/drawing/contact_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "hitos/base/error.hpp"
#include "hitos/base/median.hpp"
#include "hitos/services/drawing/scale_bar.hpp"
#include "picture_drawing.hpp"

namespace hitos {
namespace {

constexpr int kSmallest = 9;    // PNG's hardest compression
constexpr int kLeastSide = 60;  // below it nothing can be seen
constexpr int kGap = 10;        // pixels between tiles and round the sheet
constexpr int kLine = 17;       // pixels of a line of words
constexpr double kTitleLetters = 16.0;
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
    int caption = 0;  // height of a tile's words
    int columns = 1;
    int rows = 1;
    int width() const { return columns * (tile_width + kGap) + kGap; }
    int head() const { return kGap + 2 * kLine; }
    int row_height() const { return tile_height + caption + kGap; }
    int height() const { return head() + rows * row_height() + 2 * kLine + kGap; }
};

/// `words`: the width of the widest caption [pixels].
Layout layout_of(const ContactSheet& sheet, const Window& window, int side, double words) {
    Layout layout;
    const double longest = std::max(window.width(), window.height());
    layout.pixels_per_m = side / longest;
    const int shortest = static_cast<int>(kShortestSide * side);
    const auto pixels = [&](double length_m) {
        return std::max(static_cast<int>(std::ceil(length_m * layout.pixels_per_m)), shortest);
    };
    layout.tile_width = std::max(pixels(window.width()), static_cast<int>(words) + 4);
    layout.tile_height = pixels(window.height());
    std::size_t lines = 1;
    for (const SheetTile& tile : sheet.tiles) lines = std::max(lines, tile.caption.size());
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

/// Draws the tile's map; its words become part of `words`.
void draw_tile(cv::Mat& image, const SheetTile& tile, const Window& window, const Layout& layout,
               const cv::Point& at, DrawnLayer& words) {
    constexpr int kRadius = 5;
    constexpr int kBorder = 1;
    cv::Mat picture = tile_picture(tile.map, window, layout);
    drawing::draw_paths(picture, {window.low, {0.0, picture.rows + 0.0}, layout.pixels_per_m},
                        tile.paths, 1.5, kRadius, PathMarks::cross_and_ring);
    cv::Mat framed = image(cv::Rect(at.x - kBorder, at.y - kBorder, picture.cols + 2 * kBorder,
                                    picture.rows + 2 * kBorder));
    cv::copyMakeBorder(picture, framed, kBorder, kBorder, kBorder, kBorder, cv::BORDER_CONSTANT,
                       cv::Scalar::all(120));
    const Point2 corner{static_cast<double>(at.x), static_cast<double>(at.y)};
    if (tile.map.picture.grey.empty()) {
        words.texts.push_back({{corner.x + kGap, corner.y + layout.tile_height / 2.0}, "no map"});
    }
    double line = corner.y + picture.rows + kLine - 3;
    for (const std::string& caption : tile.caption) {
        words.texts.push_back({{corner.x, line}, caption});
        line += kLine;
    }
}

}  // namespace

std::string encode_contact_sheet(const ContactSheet& sheet, std::string_view kind) {
    if (sheet.tiles.empty()) {
        throw Error(message(HITOS_TEXT("Errors", "there is no map to put on a sheet")));
    }
    const Window window = window_of(sheet.tiles);
    std::vector<std::string> captions;
    for (const SheetTile& tile : sheet.tiles) {
        std::ranges::copy(tile.caption, std::back_inserter(captions));
    }
    const double words_width = drawing::widest(captions, kPictureLetters);
    int side = std::max(sheet.tile_side, kLeastSide);
    Layout layout = layout_of(sheet, window, side, words_width);
    const auto too_great = [&] {
        return std::int64_t{layout.width()} * layout.height() > kMostSheetPixels;
    };
    constexpr int kStep = 20;
    while (too_great() && side - kStep >= kLeastSide) {
        side -= kStep;
        layout = layout_of(sheet, window, side, words_width);
    }
    if (too_great()) {
        throw Error(message(HITOS_TEXT("Errors", "%1 maps are too many for one sheet of %2 pixels"),
                            sheet.tiles.size(), kMostSheetPixels));
    }
    const std::string legend = "X start, O end, red: path of the map";
    const double title_width = drawing::widest({&sheet.title, 1}, kTitleLetters);
    const int width = std::max(layout.width(), static_cast<int>(title_width) + 2 * kGap);
    cv::Mat image(layout.height(), width, CV_8UC3, cv::Scalar::all(255));
    DrawnLayer title{"title", word_style(kBlack, kTitleLetters)};
    title.texts = {{{kGap, kGap + kLine}, sheet.title}};
    DrawnLayer words{"words", word_style(kBlack, kPictureLetters)};
    const Window shown = widened(window, layout);
    for (std::size_t i = 0; i < sheet.tiles.size(); ++i) {
        const int row = static_cast<int>(i) / layout.columns;
        const int column = static_cast<int>(i) % layout.columns;
        draw_tile(
            image, sheet.tiles[i], shown, layout,
            {kGap + column * (layout.tile_width + kGap), layout.head() + row * layout.row_height()},
            words);
    }
    VectorDrawing over;
    const Point2 foot{kGap, image.rows - kGap + 0.0};
    const double end =
        add_scale_bar(over, foot, layout.tile_width / 2.0, layout.pixels_per_m) + kGap;
    if (end + drawing::widest({&legend, 1}, kPictureLetters) < image.cols) {
        words.texts.push_back({{end, foot.y}, legend});
    }
    over.layers.push_back(std::move(title));
    over.layers.push_back(std::move(words));
    drawing::paint(image, over);
    return drawing::encoded(image, kind, kSmallest);
}

void write_contact_sheet(const ContactSheet& sheet, const std::filesystem::path& path) {
    drawing::write_encoded(
        path, [&](const std::string& kind) { return encode_contact_sheet(sheet, kind); });
}

}  // namespace hitos
