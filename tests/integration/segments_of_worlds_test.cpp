// SPDX-License-Identifier: GPL-3.0-or-later
// The segments of a finished map against the walls that were there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/workbench/open_tour.hpp"

namespace hitos {
namespace {

double distance(const std::pair<Point2, Point2>& segment, const Point2& p) {
    const auto& [a, b] = segment;
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double square = dx * dx + dy * dy;
    const double t =
        square > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

double nearest(const Walls& walls, const Point2& p) {
    double least = 1e9;
    for (const auto& wall : walls) least = std::min(least, distance(wall, p));
    return least;
}

/// The share of the length of `some` that lies within `reach` of `others`.
double share_near(const Walls& some, const Walls& others, double reach) {
    constexpr double kStep = 0.02;
    int all = 0;
    int near = 0;
    for (const auto& [a, b] : some) {
        const int steps = std::max(1, static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / kStep));
        for (int i = 0; i <= steps; ++i) {
            const double t = static_cast<double>(i) / steps;
            ++all;
            near += nearest(others, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}) < reach ? 1 : 0;
        }
    }
    return static_cast<double>(near) / all;
}

struct Mapped {
    Walls walls;
    Walls segments;
};

Mapped mapped(const std::string& world) {
    const std::filesystem::path source = HITOS_SOURCE_DIR;
    Configuracion configuration = ArchivoConfiguracion::read(source / "config/thesis.cfg");
    configuration.extraction.split_merge.fit = LineFit::least_squares;
    configuration.source.file = (source / "data/worlds" / (world + ".toml")).string();
    auto reader = open_tour(configuration.source);
    Mapped result{reader->truth()->walls, {}};
    Algoritmo run(configuration, std::move(reader), {.step_grid = false});
    while (run.step()) {
    }
    for (const LineExtent& segment :
         run.line_extents().of(run.filter().best_map(), run.best_trajectory())) {
        result.segments.emplace_back(segment.a, segment.b);
    }
    return result;
}

class SegmentsOfWorld : public testing::TestWithParam<const char*> {};

TEST_P(SegmentsOfWorld, CoverTheWallsAndNothingElse) {
    const Mapped map = mapped(GetParam());
    constexpr double kReach = 0.4;  // m, of the map's own errors
    EXPECT_GT(share_near(map.walls, map.segments, kReach), 0.97);
    EXPECT_GT(share_near(map.segments, map.walls, kReach), 0.97);
}

INSTANTIATE_TEST_SUITE_P(All, SegmentsOfWorld,
                         testing::Values("recinto", "lineamedia", "bigloop", "bigloop2", "iusiani"),
                         [](const auto& world) { return std::string(world.param); });

TEST(SegmentsOfDoors, LeaveEveryDoorOpen) {
    const Mapped map = mapped("usc-sal");
    EXPECT_GT(share_near(map.walls, map.segments, 0.4), 0.97);
    // The middles of the ten doors of 1.2 m.
    Walls doors;
    for (const double x : {2.0, 9.0, 16.0, 23.0}) {
        doors.push_back({{x, -1.2}, {x, -1.2}});
        doors.push_back({{x, 6.2}, {x, 6.2}});
    }
    doors.push_back({{29.0, 2.5}, {29.0, 2.5}});
    doors.push_back({{-1.2, 2.5}, {-1.2, 2.5}});
    for (const auto& door : doors) {
        EXPECT_GT(nearest(map.segments, door.first), 0.3) << door.first.x << " " << door.first.y;
    }
}

}  // namespace
}  // namespace hitos
