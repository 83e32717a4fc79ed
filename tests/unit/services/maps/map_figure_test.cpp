// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/drawing/map_figure.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>
#include <vector>

#include "hitos/base/error.hpp"
#include "map_drawings.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::message_of;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

class MapFigureTest : public testing::Test {
  protected:
    VectorDrawing figure() const {
        return map_figure(
            {"log <1> & (2) \xc3\xa9", map_.map, map_.segments, map_.path, odometry_});
    }
    static const DrawnLayer* layer(const VectorDrawing& drawing, const std::string& name) {
        const auto found = std::ranges::find(drawing.layers, name, &DrawnLayer::name);
        return found == drawing.layers.end() ? nullptr : &*found;
    }
    test::SmallMap map_;
    Trajectory odometry_ = {{0.0, {0.0, 0.0, 0.0}}, {1.0, {100.0, 3.0, 0.0}}};
};

TEST_F(MapFigureTest, NoWayLeadsFromOneTourToTheNext) {
    ASSERT_EQ(layer(figure(), "path")->lines.size(), 1U);
    Trajectory second = map_.path;
    second.front().begins = true;
    map_.path.insert(map_.path.end(), second.begin(), second.end());
    odometry_ = map_.path;
    const VectorDrawing drawing = figure();
    EXPECT_EQ(layer(drawing, "path")->lines.size(), 2U);
    EXPECT_EQ(layer(drawing, "odometry")->lines.size(), 2U);
    EXPECT_EQ(layer(drawing, "start")->ellipses.size(), 1U);
    EXPECT_EQ(layer(drawing, "end")->lines.size(), 1U);
}

TEST_F(MapFigureTest, ShowsTheMapToScaleInItsFrame) {
    const VectorDrawing drawing = figure();
    const DrawnLayer* walls = layer(drawing, "lines");
    ASSERT_NE(walls, nullptr);
    ASSERT_EQ(walls->lines.size(), 3U);
    const auto length = [](const std::vector<Point2>& line) {
        return std::hypot(line[1].x - line[0].x, line[1].y - line[0].y);
    };
    const double mm_per_m = length(walls->lines[0]) / 2.0;
    EXPECT_NEAR(length(walls->lines[1]), 3.0 * mm_per_m, 1e-9);
    EXPECT_NEAR(length(walls->lines[2]), 4.0 * mm_per_m, 1e-9);
    EXPECT_GT(walls->lines[2][0].y, walls->lines[2][1].y) << "y of the paper grows downwards";
    EXPECT_LE(drawing.width, 85.0);
    // The odometry goes far out and is cut; everything else is inside.
    EXPECT_TRUE(layer(drawing, "odometry")->clipped);
    for (const char* name : {"lines", "path", "uncertainty"}) {
        for (const auto& line : layer(drawing, name)->lines) {
            for (const Point2& point : line) {
                EXPECT_GE(point.x, drawing.frame.low.x) << name;
                EXPECT_LE(point.x, drawing.frame.high.x) << name;
                EXPECT_GE(point.y, drawing.frame.low.y) << name;
                EXPECT_LE(point.y, drawing.frame.high.y) << name;
            }
        }
    }
    // The scale bar is as long as it says.
    const DrawnLayer* bar = layer(drawing, "scale-bar");
    const double bar_m = length(bar->lines[1]) / mm_per_m;
    const auto& words = layer(drawing, "legend")->texts;
    EXPECT_TRUE(std::ranges::any_of(words, [&](const DrawnText& text) {
        return text.text.ends_with(" m") && std::abs(std::stod(text.text) - bar_m) < 1e-9;
    }));
}

TEST_F(MapFigureTest, RegionsHoldTwoSigma) {
    const VectorDrawing drawing = figure();
    const DrawnLayer* regions = layer(drawing, "uncertainty");
    ASSERT_EQ(regions->lines.size(), 2U);  // of the line that is uncertain
    ASSERT_EQ(regions->ellipses.size(), 1U);
    const auto& wall = layer(drawing, "lines")->lines[0];
    const double mm_per_m = (wall[1].x - wall[0].x) / 2.0;
    const DrawnEllipse& ellipse = regions->ellipses[0];
    EXPECT_NEAR(std::abs(ellipse.first.x), 2.0 * 0.2 * mm_per_m, 1e-9);
    EXPECT_NEAR(std::abs(ellipse.second.y), 2.0 * 0.1 * mm_per_m, 1e-9);
    // At (-1, 2) the line is at t = 1 along itself, which grows to the left of its normal.
    const double sigma = std::sqrt(0.01 - 2.0 * 0.001 + 0.0004);
    const std::vector<Point2>& band = regions->lines[0];
    EXPECT_NEAR(std::abs(band.front().y - wall[0].y), 2.0 * sigma * mm_per_m, 1e-9);
    const auto& words = layer(drawing, "legend")->texts;
    EXPECT_TRUE(std::ranges::any_of(
        words, [](const DrawnText& text) { return text.text == "uncertainty, 2 \xcf\x83"; }));
}

TEST_F(MapFigureTest, LegendNamesWhatIsThere) {
    for (ICaracteristica& landmark : map_.map) landmark.covariance.setZero();
    map_.map.pop_back();
    odometry_.clear();
    const std::string svg = svg_text(figure());
    EXPECT_THAT(svg, HasSubstr(">line landmarks<"));
    for (const char* absent : {"uncertainty", "corner", "odometry"}) {
        EXPECT_THAT(svg, Not(HasSubstr(absent)));
    }
}

TEST_F(MapFigureTest, NarrowOnesHaveRoomForTheirWords) {
    for (const double width_mm : {30.0, 36.0, 50.0, 60.0, 71.0, 85.0, 400.0}) {
        MapFigureContent content{"log", map_.map, map_.segments, map_.path, odometry_};
        content.style.width_mm = width_mm;
        content.style.heading.assign(90, 'W');
        const VectorDrawing drawing = map_figure(content);
        const std::string svg = svg_text(drawing);
        EXPECT_THAT(svg, Not(HasSubstr("nan"))) << width_mm;
        EXPECT_LT(drawing.width, width_mm + 1e-9) << width_mm;
        // Words of the legend have 20 mm at least, up to the next column or the edge.
        const auto& words = layer(drawing, "legend")->texts;
        for (const DrawnText& text : words) {
            double next = drawing.width;
            for (const DrawnText& other : words) {
                if (other.at.y == text.at.y && other.at.x > text.at.x) {
                    next = std::min(next, other.at.x);
                }
            }
            const double least = text.text.ends_with(" m") ? 8.0 : std::min(20.0, width_mm - 12.0);
            EXPECT_GT(next - text.at.x, least) << width_mm << text.text;
        }
        if (width_mm < 100.0) {
            EXPECT_THAT(layer(drawing, "heading")->texts[0].text, EndsWith("W\xe2\x80\xa6"));
        }
    }
}

TEST_F(MapFigureTest, NothingButAPlaceIsAFigureToo) {
    map_.map.clear();
    map_.segments.clear();
    map_.path.resize(1);
    odometry_.clear();
    const VectorDrawing drawing = figure();
    EXPECT_EQ(layer(drawing, "lines"), nullptr);
    EXPECT_NE(layer(drawing, "start"), nullptr);
    EXPECT_GT(drawing.height, 20.0);
}

TEST_F(MapFigureTest, FarRegionsDoNotShrinkTheMap) {
    const double before = figure().frame.high.x;
    const auto wall_mm = [this] {
        const VectorDrawing drawing = figure();
        const auto& wall = layer(drawing, "lines")->lines[0];
        return wall[1].x - wall[0].x;
    };
    const double sure = wall_mm();
    map_.map[2].covariance << 1e4, 0.0, 0.0, 1e4;
    EXPECT_GT(wall_mm(), 0.6 * sure);
    EXPECT_NEAR(figure().frame.high.x, before, 1e-9);
}

TEST_F(MapFigureTest, WhatIsNotFiniteIsRefused) {
    map_.map[2].value = Esquina{std::numeric_limits<double>::quiet_NaN(), 0.0};
    EXPECT_THAT(message_of<Error>([this] { figure(); }), HasSubstr("landmark 2"));
}

TEST_F(MapFigureTest, SvgEscapesAndRepeats) {
    const std::string svg = svg_text(figure());
    EXPECT_THAT(svg, HasSubstr("<title>log &lt;1&gt; &amp; (2) \xc3\xa9</title>"));
    EXPECT_THAT(svg, HasSubstr(R"(<g id="lines" fill="none" stroke="#000000")"));
    EXPECT_EQ(svg, svg_text(figure()));
}

TEST_F(MapFigureTest, PdfIsTheSameWheneverAndOnWhateverThreadItIsWritten) {
    const std::string pdf = pdf_text(figure());
    EXPECT_TRUE(pdf.starts_with("%PDF-1.4\n"));
    const auto has = [&](const char* text) { return pdf.find(text) != std::string::npos; };
    EXPECT_TRUE(has("00E9>")) << "the title is in UTF-16";
    EXPECT_TRUE(has("/FontFile")) << "letters are in the file";
    EXPECT_FALSE(has("Date"));
    std::vector<std::string> others(4);
    {
        std::vector<std::jthread> threads;
        for (std::string& other : others) {
            threads.emplace_back([&] { other = pdf_text(figure()); });
        }
    }
    for (const std::string& other : others) EXPECT_TRUE(other == pdf);
}

}  // namespace
}  // namespace hitos
