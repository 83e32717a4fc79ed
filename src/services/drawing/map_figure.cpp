// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/drawing/map_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "files/map_shapes.hpp"
#include "hitos/services/drawing/scale_bar.hpp"
#include "picture_drawing.hpp"

namespace hitos {
namespace {

// Of the paper [mm].
constexpr double kLeft = 12.0;
constexpr double kRight = 2.5;
constexpr double kTop = 2.5;
constexpr double kAxis = 8.5;        // below the frame: numbers and what they are
constexpr double kNarrowest = 58.0;  // so that the legend has room
constexpr double kSlenderest = 110.0 / 85.0;
constexpr double kLowest = 15.0;
constexpr double kText = 7.0 * 25.4 / 72.0;
constexpr double kLettersPerWidth = 20.0;  // pixels in which words are measured
constexpr double kTick = 1.0;
constexpr double kRow = 3.6;
constexpr double kSample = 6.0;
constexpr double kLetterHeight = 0.72;  // of capitals and figures, of the size
constexpr double kFigureWidth = 0.6;    // of the numbers of axes, at most and of the size
constexpr double kFinest = 0.03;        // a path's vertices that are nearer say nothing in print
constexpr double kFrameMargin = 0.04;   // of the frame around the map
constexpr double kRegions = 0.15;       // so much of the map's size may regions add to the frame

// Told apart by the colour-blind too (Okabe and Ito), and in grey by their widths and dashes.
constexpr Colour kGrey{120, 120, 120};
constexpr Colour kBlue{0, 114, 178};
constexpr Colour kVermilion{213, 94, 0};
constexpr Colour kGreen{0, 158, 115};
constexpr Colour kPurple{204, 121, 167};
constexpr Colour kPale{250, 205, 170};
constexpr Colour kPaleEdge{230, 159, 100};

const ShapeStyle kWallStyle = line_style(kBlack, 0.3);
const ShapeStyle kPathStyle = line_style(kBlue, 0.25);
const ShapeStyle kOdometryStyle = line_style(kGrey, 0.2, {1.0, 0.6});
const ShapeStyle kRegionStyle{kPale, kPaleEdge, 0.06};
const ShapeStyle kCornerStyle{.fill = kVermilion};
const ShapeStyle kGoneStyle{.fill = kPurple};
const ShapeStyle kNewStyle{.fill = kGreen};
const ShapeStyle kStartStyle{kGreen, kWhite, 0.15};
const ShapeStyle kEndStyle{kBlue, kWhite, 0.15};
const ShapeStyle kAxisStyle = line_style(kBlack, 0.15);
const ShapeStyle kWordStyle = word_style(kBlack, kText);
constexpr double kCornerRadius = 0.45;
constexpr double kEndRadius = 0.9;

DrawnLine square(const Point2& centre, double half) {
    return rectangle({centre.x - half, centre.y - half}, {centre.x + half, centre.y + half});
}

/// The part of the world that the frame shows, and where it lies on the paper.
struct View {
    Bounds world;
    double mm_per_m = 1.0;
    Bounds paper;

    Point2 at(const Point2& p) const {
        return {paper.low.x + (p.x - world.low.x) * mm_per_m,
                paper.high.y - (p.y - world.low.y) * mm_per_m};
    }
    /// The same without the frame's corner: of a difference.
    Point2 turned(const Point2& d) const { return {d.x * mm_per_m, -d.y * mm_per_m}; }
};

/// Great maps have thinner lines, so that both walls of a corridor are seen.
double weight_in(const View& view) {
    return std::clamp(view.mm_per_m, 0.5, 1.0);
}

void widen(double& low, double& high, double size) {
    const double more = (size - (high - low)) / 2.0;
    if (more <= 0.0) return;
    low -= more;
    high += more;
}

/// The map and its path, with the regions as far as they are not much greater than that.
Bounds shown_of(const MapShapes& shapes) {
    Bounds box;
    for (const auto& [a, b] : shapes.lines) {
        box.hold(a);
        box.hold(b);
    }
    for (const Point2& corner : shapes.corners) box.hold(corner);
    for (const auto& path : shapes.paths)
        for (const Point2& place : path) box.hold(place);
    if (box.empty) box.hold({});
    const double more = kRegions * std::max({box.high.x - box.low.x, box.high.y - box.low.y, 1.0});
    if (!shapes.box.empty) {
        box = {{std::max(shapes.box.low.x, box.low.x - more),
                std::max(shapes.box.low.y, box.low.y - more)},
               {std::min(shapes.box.high.x, box.high.x + more),
                std::min(shapes.box.high.y, box.high.y + more)},
               false};
    }
    return box;
}

View view_of(const MapShapes& shapes, const MapFigureStyle& style) {
    const double left = style.axes ? kLeft : kRight;
    const double top = kTop + (style.heading.empty() ? 0.0 : kRow);
    const double widest = std::max(style.width_mm - left - kRight, kLowest);
    const double highest = style.width_mm * kSlenderest;
    View view;
    view.world = shown_of(shapes);
    Bounds& world = view.world;
    constexpr double kLeast = 1.0;  // m
    const double wide = std::max((world.high.x - world.low.x) * (1.0 + 2.0 * kFrameMargin), kLeast);
    const double high = std::max((world.high.y - world.low.y) * (1.0 + 2.0 * kFrameMargin), kLeast);
    view.mm_per_m = std::min(widest / wide, highest / high);
    const Point2 size{std::max(wide * view.mm_per_m, std::min(kNarrowest, widest)),
                      std::max(high * view.mm_per_m, kLowest)};
    widen(world.low.x, world.high.x, size.x / view.mm_per_m);
    widen(world.low.y, world.high.y, size.y / view.mm_per_m);
    view.paper = {{left, top}, {left + size.x, top + size.y}, false};
    return view;
}

/// A path on paper, without the vertices that nobody could see.
std::vector<DrawnLine> thinned(const Trajectory& path, const View& view) {
    std::vector<DrawnLine> lines;
    for (const std::vector<Point2>& places : lines_of(path)) {
        DrawnLine line;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Point2 next = view.at(places[i]);
            const bool last = i + 1 == places.size();
            if (!std::isfinite(next.x) || !std::isfinite(next.y)) continue;
            const bool seen = line.empty() ||
                              std::hypot(next.x - line.back().x, next.y - line.back().y) >= kFinest;
            if (seen || (last && line.size() < 2)) line.push_back(next);
        }
        if (!line.empty()) lines.push_back(std::move(line));
    }
    return lines;
}

/// Without those of one place.
std::vector<DrawnLine> longer_than_a_place(std::vector<DrawnLine> lines) {
    std::erase_if(lines, [](const DrawnLine& line) { return line.size() < 2; });
    return lines;
}

std::string axis_number(double value) {
    const std::string words = fmt::format("{:g}", std::abs(value) < 1e-9 ? 0.0 : std::abs(value));
    return value < -1e-9 ? "\xe2\x88\x92" + words : words;  // a minus sign
}

/// Of a number in UTF-8.
std::size_t letters_of(const std::string& number) {
    return static_cast<std::size_t>(
        std::ranges::count_if(number, [](char c) { return (c & 0xC0) != 0x80; }));
}

/// From one number of an axis to the next [m]: some six on the way, where they have room.
double tick_step(double length_mm, double least_mm, double mm_per_m) {
    constexpr double kTicks = 6.0;
    constexpr double kFurthest = 14.0;  // mm
    const double step = std::clamp(length_mm / kTicks, least_mm, kFurthest) / mm_per_m;
    const double below = round_length(step);  // 1, 2 or 5 times a power of ten
    return below < step ? round_length(2.5 * below * (1.0 + 1e-9)) : below;
}

void add_axes(const View& view, VectorDrawing& drawing) {
    constexpr double kAbreast = 8.0;  // mm
    constexpr double kOneAboveTheOther = 5.0;
    double step = tick_step(view.paper.high.x - view.paper.low.x, kAbreast, view.mm_per_m);
    DrawnLayer ticks{"axes", kAxisStyle};
    DrawnLayer words{"axis-numbers", kWordStyle};
    const Bounds& paper = view.paper;
    const double half = kLetterHeight * kText / 2.0;
    for (double k = std::ceil(view.world.low.x / step); k * step <= view.world.high.x; ++k) {
        const double x = view.at({k * step, 0.0}).x;
        ticks.lines.push_back({{x, paper.high.y}, {x, paper.high.y + kTick}});
        words.texts.push_back(
            {{x, paper.high.y + kTick + 0.6 + 2.0 * half}, axis_number(k * step), Anchor::middle});
    }
    std::size_t longest = 0;
    step = tick_step(view.paper.high.y - view.paper.low.y, kOneAboveTheOther, view.mm_per_m);
    for (double k = std::ceil(view.world.low.y / step); k * step <= view.world.high.y; ++k) {
        const double y = view.at({0.0, k * step}).y;
        const std::string text = axis_number(k * step);
        ticks.lines.push_back({{paper.low.x - kTick, y}, {paper.low.x, y}});
        words.texts.push_back({{paper.low.x - kTick - 0.6, y + half}, text, Anchor::end});
        longest = std::max(longest, letters_of(text));
    }
    words.texts.push_back({{(paper.low.x + paper.high.x) / 2.0, paper.high.y + kAxis - 1.4},
                           "x [m]",
                           Anchor::middle});
    words.texts.push_back(
        {{paper.low.x - kTick - kFigureWidth * kText * static_cast<double>(longest) - 2.4,
          (paper.low.y + paper.high.y) / 2.0},
         "y [m]",
         Anchor::middle,
         true});
    DrawnLayer frame{"frame", kAxisStyle};
    frame.closed = true;
    frame.lines = {rectangle(paper.low, paper.high)};
    drawing.layers.push_back(std::move(frame));
    drawing.layers.push_back(std::move(ticks));
    drawing.layers.push_back(std::move(words));
}

/// As much of the words as is no wider [mm], by whole letters of UTF-8.
std::string shortened(std::string words, double width) {
    const auto wide = [&](const std::string& text) {
        return drawing::widest({&text, 1}, kLettersPerWidth) * kText / kLettersPerWidth > width;
    };
    if (!wide(words)) return words;
    while (!words.empty() && wide(words + "\xe2\x80\xa6")) {
        do {
            words.pop_back();
        } while (!words.empty() && (words.back() & 0xC0) == 0x80);
    }
    return words + "\xe2\x80\xa6";
}

/// What a layer of the map is called in the legend, and a sample of it around (0, 0).
struct Legend {
    std::string words;
    DrawnLayer sample;
};

/// The layers of the map, lowest first, each with its line of the legend; those with nothing to
/// draw are left out.
class Layers {
  public:
    /// `weight`: of lines, by the widths that styles state.
    Layers(VectorDrawing& drawing, std::vector<Legend>& legend, double weight)
        : drawing_(drawing), legend_(legend), weight_(weight) {}

    /// `lines` and `discs` are the sample.
    void add(DrawnLayer layer, std::string words, std::vector<DrawnLine> lines,
             std::vector<DrawnEllipse> discs = {}) {
        if (layer.lines.empty() && layer.ellipses.empty()) return;
        layer.clipped = true;
        layer.style.line_width *= weight_;
        DrawnLayer sample{"legend-" + layer.name, layer.style,      false,
                          layer.closed,           std::move(lines), std::move(discs)};
        legend_.push_back({std::move(words), std::move(sample)});
        drawing_.layers.push_back(std::move(layer));
    }

  private:
    VectorDrawing& drawing_;
    std::vector<Legend>& legend_;
    double weight_;
};

void add_changes(std::span<const ChangedPlace> changes, const View& view, Layers& layers) {
    const double radius = 0.8 * kCornerRadius * weight_in(view);
    for (const bool gone : {true, false}) {
        DrawnLayer layer{gone ? "gone" : "new", gone ? kGoneStyle : kNewStyle};
        for (const ChangedPlace& place : changes) {
            if (place.gone != gone) continue;
            for (const Point2& point : place.points)
                layer.ellipses.push_back(disc(view.at(point), radius));
        }
        layers.add(std::move(layer), gone ? "gone" : "new", {}, {disc({}, radius)});
    }
}

void add_map(const MapFigureContent& content, const MapShapes& shapes, const View& view,
             Layers& layers) {
    DrawnLayer regions{"uncertainty", kRegionStyle};
    regions.closed = true;
    for (const auto& band : shapes.bands) {
        DrawnLine& line = regions.lines.emplace_back();
        for (const Point2& point : band) line.push_back(view.at(point));
    }
    for (const MapEllipse& ellipse : shapes.ellipses) {
        const Point2 minor{-ellipse.ratio * ellipse.major.y, ellipse.ratio * ellipse.major.x};
        regions.ellipses.push_back(
            {view.at(ellipse.centre), view.turned(ellipse.major), view.turned(minor)});
    }
    const std::vector<DrawnLine> stroke{{{-kSample / 2.0, 0.0}, {kSample / 2.0, 0.0}}};
    const MapFigureStyle& style = content.style;
    if (style.landmarks && style.uncertainty)
        layers.add(std::move(regions), fmt::format("uncertainty, {:g} \xcf\x83", kFigureSigmas),
                   {rectangle({-kSample / 2.0, -0.7}, {kSample / 2.0, 0.7})});

    DrawnLayer odometry{"odometry", kOdometryStyle};
    odometry.lines = longer_than_a_place(thinned(content.odometry, view));
    if (style.odometry) layers.add(std::move(odometry), "odometry alone", stroke);

    DrawnLayer path{"path", kPathStyle};
    const std::vector<DrawnLine> driven = thinned(content.path, view);
    path.lines = longer_than_a_place(driven);
    if (style.path) layers.add(std::move(path), "estimated path", stroke);

    DrawnLayer walls{"lines", kWallStyle};
    for (const auto& [a, b] : shapes.lines) walls.lines.push_back({view.at(a), view.at(b)});
    if (style.landmarks) layers.add(std::move(walls), "line landmarks", stroke);

    DrawnLayer corners{"corners", kCornerStyle};
    const double radius = kCornerRadius * weight_in(view);
    for (const Point2& corner : shapes.corners) {
        corners.ellipses.push_back(disc(view.at(corner), radius));
    }
    if (style.landmarks) layers.add(std::move(corners), "corner landmarks", {}, {disc({}, radius)});
    add_changes(content.changes, view, layers);

    if (driven.empty() || !style.path) return;
    DrawnLayer start{"start", kStartStyle};
    start.ellipses.push_back(disc(driven.front().front(), kEndRadius));
    layers.add(std::move(start), "start", {}, {disc({}, kEndRadius)});
    if (driven.size() < 2 && driven.front().size() < 2) return;
    DrawnLayer end{"end", kEndStyle};
    end.closed = true;
    end.lines.push_back(square(driven.back().back(), kEndRadius - 0.1));
    layers.add(std::move(end), "end", {square({}, kEndRadius - 0.1)});
}

/// Two columns below the axes, one where two have no room, the scale bar in the last place.
void add_legend(const View& view, std::vector<Legend>& entries, VectorDrawing& drawing) {
    const double top = drawing.height;
    constexpr double kLeastColumn = 34.0;  // mm, for the longest words
    constexpr double kWordsOfBar = 16.0;
    const double room = view.paper.high.x - 1.0;
    const std::size_t columns = room < 2.0 * kLeastColumn ? 1 : 2;
    const double column = room / static_cast<double>(columns);
    const std::size_t rows = (entries.size() + columns) / columns;
    const auto place = [&](std::size_t i) {
        const bool second = i >= rows;
        return Point2{1.0 + (second ? column : 0.0),
                      top + (static_cast<double>(i % rows) + 0.5) * kRow};
    };
    const double down = kLetterHeight * kText / 2.0;
    DrawnLayer words{"legend", kWordStyle};
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const Point2 at = place(i);
        DrawnLayer& sample = entries[i].sample;
        const auto move = [&](Point2& p) { p = {p.x + at.x + 1.0 + kSample / 2.0, p.y + at.y}; };
        for (DrawnLine& line : sample.lines) std::ranges::for_each(line, move);
        for (DrawnEllipse& ellipse : sample.ellipses) move(ellipse.centre);
        words.texts.push_back({{at.x + kSample + 2.5, at.y + down}, entries[i].words});
        drawing.layers.push_back(std::move(sample));
    }
    const Point2 at = place(entries.size());
    const double length = round_length(std::max(column - kWordsOfBar, 4.0) / view.mm_per_m);
    const double end = at.x + 1.0 + length * view.mm_per_m;
    DrawnLayer bar{"scale-bar", line_style(kBlack, 0.4)};
    bar.lines = {{{at.x + 1.0, at.y - 0.9}, {at.x + 1.0, at.y + 0.9}},
                 {{at.x + 1.0, at.y}, {end, at.y}},
                 {{end, at.y - 0.9}, {end, at.y + 0.9}}};
    words.texts.push_back({{end + 1.5, at.y + down}, axis_number(length) + " m"});
    drawing.layers.push_back(std::move(bar));
    drawing.layers.push_back(std::move(words));
    drawing.height = top + static_cast<double>(rows) * kRow + 1.0;
}

}  // namespace

VectorDrawing map_figure(const MapFigureContent& content) {
    const MapFigureStyle& style = content.style;
    const MapShapes shapes = map_shapes(content.map, content.segments, content.path, kFigureSigmas);
    const View view = view_of(shapes, style);
    VectorDrawing drawing;
    drawing.title = content.title;
    drawing.width = view.paper.high.x + kRight;
    drawing.frame = view.paper;
    std::vector<Legend> legend;
    Layers layers(drawing, legend, weight_in(view));
    add_map(content, shapes, view, layers);
    drawing.height = view.paper.high.y + (style.axes ? kAxis : kRight);
    if (style.axes) add_axes(view, drawing);
    if (style.legend) add_legend(view, legend, drawing);
    if (!style.heading.empty()) {
        DrawnLayer heading{"heading", kWordStyle};
        const std::string words = shortened(style.heading, drawing.width - 2.0);
        heading.texts.push_back(
            {{drawing.width / 2.0, kTop + kLetterHeight * kText}, words, Anchor::middle});
        drawing.layers.push_back(std::move(heading));
    }
    return drawing;
}

}  // namespace hitos
