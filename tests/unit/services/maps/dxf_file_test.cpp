// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/files/dxf_file.hpp"

#include <dl_creationadapter.h>
#include <dl_dxf.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>

#include "hitos/base/error.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::content;
using test::message_of;
using test::TempFolder;
using ::testing::HasSubstr;

struct Polyline {
    std::string layer;
    bool closed = false;
    std::vector<Point2> points;
};

/// Everything that dxflib finds in a drawing.
class Found final : public DL_CreationAdapter {
  public:
    std::set<std::string> layers;
    std::map<std::string, int> integers;
    std::map<std::string, Point2> points;
    std::vector<std::pair<std::string, DL_LineData>> lines;
    std::vector<std::pair<std::string, DL_PointData>> marks;
    std::vector<std::pair<std::string, DL_EllipseData>> ellipses;
    std::vector<Polyline> polylines;

    explicit Found(const std::string& text) {
        std::istringstream in(text);
        DL_Dxf().in(in, this);
    }
    void addLayer(const DL_LayerData& data) override { layers.insert(data.name); }
    void setVariableInt(const std::string& key, int value, int /*code*/) override {
        integers[key] = value;
    }
    void setVariableVector(const std::string& key, double x, double y, double /*z*/,
                           int /*code*/) override {
        points[key] = {x, y};
    }
    void addLine(const DL_LineData& data) override { lines.emplace_back(layer(), data); }
    void addPoint(const DL_PointData& data) override { marks.emplace_back(layer(), data); }
    void addEllipse(const DL_EllipseData& data) override { ellipses.emplace_back(layer(), data); }
    void addPolyline(const DL_PolylineData& data) override {
        polylines.push_back({layer(), (data.flags & 1) != 0, {}});
    }
    void addVertex(const DL_VertexData& data) override {
        polylines.back().points.push_back({data.x, data.y});
    }

  private:
    std::string layer() { return attributes.getLayer(); }
};

Eigen::Matrix2d covariance(double xx, double xy, double yy) {
    Eigen::Matrix2d c;
    c << xx, xy, xy, yy;
    return c;
}

/// A wall y = 2 with two segments, a slanted one, two corners, a path of three places.
struct Example {
    Recta slanted = line_through({4.0, -1.0}, {6.0, 0.5});
    LandmarkMap map = {{Recta{2.0, kPi / 2.0}, covariance(4e-4, 1e-5, 1e-6)},
                       {slanted, covariance(1e-4, 0.0, 1e-5)},
                       {Esquina{3.0, 2.0}, covariance(9e-4, 3e-4, 5e-4)},
                       {Esquina{-1.0, 2.0}}};
    std::vector<LineExtent> segments = {{0, {3.0, 2.0}, {1.0, 2.0}, 20},
                                        {0, {0.0, 2.0}, {-1.0, 2.0}, 20},
                                        {1, {4.0, -1.0}, {6.0, 0.5}, 20}};
    Trajectory path = {{0.0, {0.0, 0.0, 0.0}},
                       {0.2, {0.0, 0.0, 0.1}},
                       {0.4, {1.0 / 3.0, 0.25, 0.1}},
                       {0.6, {2.0, -3.0, 0.0}}};
};

TEST(DxfFile, HoldsEveryEntityOnItsLayer) {
    const TempFolder folder;
    const Example example;
    write_dxf(example.map, example.segments, example.path, folder / "map.dxf");
    EXPECT_EQ(folder.files(), 1U);
    const Found found(content(folder / "map.dxf"));
    EXPECT_THAT(found.layers, ::testing::IsSupersetOf({"LINES", "CORNERS", "PATH", "COVARIANCE"}));

    ASSERT_EQ(found.lines.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(found.lines[i].first, "LINES");
        EXPECT_NEAR(found.lines[i].second.x1, example.segments[i].a.x, 1e-12);
        EXPECT_NEAR(found.lines[i].second.y1, example.segments[i].a.y, 1e-12);
        EXPECT_NEAR(found.lines[i].second.x2, example.segments[i].b.x, 1e-12);
        EXPECT_NEAR(found.lines[i].second.y2, example.segments[i].b.y, 1e-12);
    }
    ASSERT_EQ(found.marks.size(), 2U);
    EXPECT_EQ(found.marks[0].first, "CORNERS");
    EXPECT_NEAR(found.marks[0].second.x, 3.0, 1e-12);
    EXPECT_NEAR(found.marks[1].second.x, -1.0, 1e-12);

    ASSERT_EQ(found.polylines.size(), 4U);  // the path and the bands of three segments
    EXPECT_EQ(found.polylines[0].layer, "PATH");
    EXPECT_FALSE(found.polylines[0].closed);
    ASSERT_EQ(found.polylines[0].points.size(), 3U) << "a turn on the spot is no new place";
    EXPECT_NEAR(found.polylines[0].points[1].x, 1.0 / 3.0, 1e-12);
    EXPECT_NEAR(found.polylines[0].points[2].y, -3.0, 1e-12);
}

TEST(DxfFile, NoWayLeadsFromOneTourToTheNext) {
    Example example;
    Trajectory second = example.path;
    second.front().begins = true;
    for (StampedPose& pose : second) pose.pose.x += 20.0;
    example.path.insert(example.path.end(), second.begin(), second.end());
    const Found found(dxf_text(example.map, example.segments, example.path));
    ASSERT_EQ(found.polylines.size(), 5U);
    for (std::size_t tour = 0; tour < 2; ++tour) {
        EXPECT_EQ(found.polylines[tour].layer, "PATH");
        ASSERT_EQ(found.polylines[tour].points.size(), 3U);
        EXPECT_NEAR(found.polylines[tour].points[1].x, 1.0 / 3.0 + 20.0 * static_cast<double>(tour),
                    1e-12);
    }
}

TEST(DxfFile, DrawsThreeSigmaOfCorners) {
    const Example example;
    const Found found(dxf_text(example.map, example.segments, example.path));
    ASSERT_EQ(found.ellipses.size(), 1U) << "the other corner has no covariance";
    const auto& [layer, ellipse] = found.ellipses[0];
    EXPECT_EQ(layer, "COVARIANCE");
    EXPECT_NEAR(ellipse.cx, 3.0, 1e-12);
    EXPECT_NEAR(ellipse.angle2 - ellipse.angle1, 2.0 * kPi, 1e-9);
    // Every point of it is 3 sigma away by the covariance.
    const Eigen::Matrix2d inverse = example.map[2].covariance.inverse();
    for (int k = 0; k < 13; ++k) {
        const double angle = 0.5 * k;
        const Eigen::Vector2d major(ellipse.mx, ellipse.my);
        const Eigen::Vector2d minor = ellipse.ratio * Eigen::Vector2d(-ellipse.my, ellipse.mx);
        const Eigen::Vector2d p = std::cos(angle) * major + std::sin(angle) * minor;
        EXPECT_NEAR(std::sqrt(p.dot(inverse * p)), 3.0, 1e-6);
    }
}

TEST(DxfFile, DrawsThreeSigmaAcrossLines) {
    const Example example;
    const Found found(dxf_text(example.map, example.segments, example.path));
    for (std::size_t i = 0; i < 3; ++i) {
        const Polyline& band = found.polylines[i + 1];
        EXPECT_EQ(band.layer, "COVARIANCE");
        EXPECT_TRUE(band.closed);
        const auto& landmark = example.map[static_cast<std::size_t>(example.segments[i].landmark)];
        const auto& line = std::get<Recta>(landmark.value);
        std::size_t above = 0;
        for (const Point2& point : band.points) {
            // Numerically: how far the line at this place moves with rho and theta.
            const double across = signed_distance(line, point);
            above += across > 0.0 ? 1U : 0U;
            const Point2 on{point.x - across * std::cos(line.theta),
                            point.y - across * std::sin(line.theta)};
            constexpr double kStep = 1e-6;
            const Eigen::Vector2d gradient((signed_distance({line.rho + kStep, line.theta}, on) -
                                            signed_distance({line.rho - kStep, line.theta}, on)) /
                                               (2.0 * kStep),
                                           (signed_distance({line.rho, line.theta + kStep}, on) -
                                            signed_distance({line.rho, line.theta - kStep}, on)) /
                                               (2.0 * kStep));
            EXPECT_NEAR(std::abs(across),
                        3.0 * std::sqrt(gradient.dot(landmark.covariance * gradient)), 1e-7);
        }
        EXPECT_EQ(above * 2, band.points.size());
    }
}

TEST(DxfFile, IsInMetresWithItsExtents) {
    const Example example;
    const Found found(dxf_text(example.map, example.segments, example.path));
    EXPECT_EQ(found.integers.at("$INSUNITS"), 6);
    EXPECT_EQ(found.integers.at("$MEASUREMENT"), 1);
    const Point2 low = found.points.at("$EXTMIN");
    const Point2 high = found.points.at("$EXTMAX");
    // The path reaches lowest; the band of y = 2 highest, by 3 sigma at x = -1 or 3.
    EXPECT_NEAR(low.y, -3.0, 1e-12);
    EXPECT_NEAR(low.x, -1.0, 1e-12);
    const double sigma_at_3 = std::sqrt(4e-4 + 2.0 * 3.0 * 1e-5 + 9.0 * 1e-6);
    EXPECT_NEAR(high.y, 2.0 + std::max(3.0 * sigma_at_3, 3.0 * std::sqrt(5e-4)), 1e-9);
    EXPECT_GT(high.x, 6.0);
    EXPECT_LT(high.x, 6.1);
}

TEST(DxfFile, OfAnEmptyMapIsADrawingWithoutEntities) {
    const Found found(dxf_text({}, {}, {}));
    EXPECT_EQ(found.lines.size() + found.marks.size() + found.polylines.size(), 0U);
    EXPECT_TRUE(found.layers.contains("LINES"));
}

TEST(DxfFile, RefusesWhatCannotBeDrawnAndLeavesTheOldFile) {
    const TempFolder folder;
    const auto file = folder.put("map.dxf", "old");
    Example example;
    const auto refusal = [&] {
        return message_of<Error>(
            [&] { write_dxf(example.map, example.segments, example.path, file); });
    };
    example.segments[1].landmark = 2;
    EXPECT_THAT(refusal(), HasSubstr("segment 1 belongs to landmark 2, which is no line"));
    example = {};
    example.segments[2].b.x = std::numeric_limits<double>::infinity();
    EXPECT_THAT(refusal(), HasSubstr("an end of segment 2"));
    example = {};
    example.map[2].value = Esquina{std::numeric_limits<double>::quiet_NaN(), 0.0};
    EXPECT_THAT(refusal(), HasSubstr("landmark 2"));
    example = {};
    example.path[3].pose.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(refusal(), HasSubstr("the path"));
    EXPECT_EQ(content(file), "old");
    // A covariance that is not finite costs its region, not the drawing.
    example = {};
    example.map[2].covariance(0, 0) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(Found(dxf_text(example.map, example.segments, example.path)).ellipses.empty());
    EXPECT_THROW(write_dxf(example.map, example.segments, example.path, folder / "no/map.dxf"),
                 FileError);
}

TEST(DxfFile, RefusesCoordinatesThatNoDrawingHolds) {
    const auto text_of = [](const Example& example) {
        return dxf_text(example.map, example.segments, example.path);
    };
    Example example;
    example.segments[0].a.y = -1e250;
    EXPECT_THAT(message_of<Error>([&] { text_of(example); }),
                HasSubstr("an end of segment 0 is at"));
    // A region that is out of bounds is left out, the landmark is not.
    example = {};
    example.map[0].covariance = covariance(1e300, 0.0, 1e300);
    example.map[2].covariance = covariance(1e300, 0.0, 1e300);
    const Found found(text_of(example));
    EXPECT_TRUE(found.ellipses.empty());
    EXPECT_EQ(found.lines.size(), Example().segments.size());
    EXPECT_LT(found.points.at("$EXTMAX").x, 1e3);
}

TEST(DxfFile, IsTheSameForTheSameMap) {
    const Example example;
    EXPECT_EQ(dxf_text(example.map, example.segments, example.path),
              dxf_text(example.map, example.segments, example.path));
}

}  // namespace
}  // namespace hitos
