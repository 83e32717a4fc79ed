// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <vector>

#include "base64.hpp"
#include "files/map_shapes.hpp"
#include "hitos/base/error.hpp"
#include "hitos/services/files/tour_time.hpp"

namespace hitos::live {
namespace {

constexpr std::size_t kMostPoses = 2000;    // of a message
constexpr std::size_t kMostRegions = 1000;  // of landmarks, those seen last
constexpr double kGreatest = 1e9;           // [m], as drawings of maps have it
constexpr double kSigmas2 = 2.4477;         // of two dimensions, that hold 95 %
constexpr double kSigmas1 = 1.9600;         // of one

using Out = std::back_insert_iterator<std::string>;

bool tellable(const Point2& p) {
    return std::abs(p.x) <= kGreatest && std::abs(p.y) <= kGreatest;
}
bool tellable(const Pose& pose) {
    return tellable(Point2{pose.x, pose.y}) && std::isfinite(pose.theta);
}
Pose told(const Pose& pose) {
    return tellable(pose) ? pose : Pose{};
}

std::string time_text(const Snapshot& snapshot) {
    constexpr std::uint64_t kSecond = 1000000000;
    const std::uint64_t ns = time_ns(snapshot);
    return fmt::format(R"({{"sec":{},"nsec":{}}})", ns / kSecond, ns % kSecond);
}
void put_point(Out out, const Point2& p) {
    fmt::format_to(out, R"({{"x":{:.4f},"y":{:.4f},"z":0}})", p.x, p.y);
}
void put_orientation(Out out, double theta_rad) {
    fmt::format_to(out, R"({{"x":0,"y":0,"z":{:.6f},"w":{:.6f}}})", std::sin(0.5 * theta_rad),
                   std::cos(0.5 * theta_rad));
}
void put_pose(std::string& text, const Pose& pose) {
    const Out out(text);
    text += R"({"position":)";
    put_point(out, {pose.x, pose.y});
    text += R"(,"orientation":)";
    put_orientation(out, pose.theta);
    text += '}';
}

/// {"timestamp":…,"frame_id":"map": what most messages begin with.
std::string begin_of(const Snapshot& snapshot, const char* frame) {
    return fmt::format(R"({{"timestamp":{},"frame_id":"{}")", time_text(snapshot), frame);
}

/// Every so many of them, by powers of two, so that most stay where they were as they grow.
std::size_t stride_of(std::size_t count) {
    std::size_t stride = 1;
    while (count / stride >= kMostPoses) stride *= 2;
    return stride;
}

std::string poses_text(const Snapshot& snapshot, std::size_t count,
                       const std::function<Pose(std::size_t)>& pose_of) {
    std::string text = begin_of(snapshot, "map") + R"(,"poses":[)";
    const std::size_t stride = stride_of(count);
    const auto put = [&](const Pose& pose) {
        if (!tellable(pose)) return;
        if (text.back() != '[') text += ',';
        put_pose(text, pose);
    };
    for (std::size_t i = 0; i < count; i += stride) put(pose_of(i));
    if (count > 0 && (count - 1) % stride != 0) put(pose_of(count - 1));
    return text + "]}";
}

enum class LineKind { loop = 1, list = 2 };

struct Colour {
    double r = 0.0;
    double g = 0.0;
    double b = 0.0;
    double a = 1.0;
};
constexpr Colour kLineColour{0.20, 0.55, 0.95, 1.0};
constexpr Colour kCornerColour{0.95, 0.55, 0.15, 1.0};
constexpr Colour kRegionColour{0.55, 0.55, 0.60, 0.8};
constexpr Colour kRobotColour{0.85, 0.25, 0.75, 1.0};
constexpr Colour kClosedColour{0.20, 0.75, 0.35, 1.0};
constexpr Colour kRefusedColour{0.85, 0.30, 0.30, 0.5};

/// A thing of a scene, which takes the place of the one that had its name before.
class Entity {
  public:
    Entity(const Snapshot& snapshot, const char* id)
        : text_(begin_of(snapshot, "map") +
                fmt::format(R"(,"id":"{}","lifetime":{{"sec":0,"nsec":0}},"frame_locked":true,)"
                            R"("metadata":[],"arrows":[],"cubes":[],"spheres":[],"cylinders":[],)"
                            R"("triangles":[],"texts":[],"models":[],"lines":[)",
                            id)) {}

    void add(LineKind kind, const std::vector<Point2>& points, const Colour& colour) {
        if (points.empty() || !std::ranges::all_of(points, [](auto& p) { return tellable(p); })) {
            return;
        }
        if (text_.back() != '[') text_ += ',';
        text_ += fmt::format(R"({{"type":{},"pose":)", static_cast<int>(kind));
        put_pose(text_, {});
        text_ += R"(,"thickness":2,"scale_invariant":true,"points":[)";
        for (const Point2& point : points) {
            if (text_.back() != '[') text_ += ',';
            put_point(Out(text_), point);
        }
        text_ += fmt::format(R"(],"color":{{"r":{},"g":{},"b":{},"a":{}}},"colors":[],)"
                             R"("indices":[]}})",
                             colour.r, colour.g, colour.b, colour.a);
    }
    std::string text() const { return text_ + "]}"; }

  private:
    std::string text_;
};

std::string scene(std::initializer_list<const Entity*> entities) {
    std::string text = R"({"deletions":[],"entities":[)";
    for (const Entity* entity : entities) {
        if (text.back() != '[') text += ',';
        text += entity->text();
    }
    return text + "]}";
}

std::vector<Point2> loop_of(const MapEllipse& ellipse) {
    constexpr int kPoints = 24;
    const Point2& a = ellipse.major;
    std::vector<Point2> points;
    points.reserve(kPoints);
    for (int i = 0; i < kPoints; ++i) {
        const double c = std::cos(2.0 * kPi * i / kPoints);
        const double s = ellipse.ratio * std::sin(2.0 * kPi * i / kPoints);
        points.push_back(
            {ellipse.centre.x + c * a.x - s * a.y, ellipse.centre.y + c * a.y + s * a.x});
    }
    return points;
}

void put_float(std::string& bytes, double value) {
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    for (const unsigned shift : {0U, 8U, 16U, 24U}) {
        bytes += static_cast<char>(static_cast<unsigned char>(bits >> shift));
    }
}

/// Of the landmarks that were not seen lately nothing is known.
LandmarkMap with_late_regions(const LandmarkMap& map) {
    LandmarkMap shown = map;
    if (shown.size() <= kMostRegions) return shown;
    std::vector<std::uint32_t> seen;
    seen.reserve(shown.size());
    for (const ICaracteristica& landmark : shown) seen.push_back(landmark.last_seen);
    const auto at = seen.begin() + static_cast<std::ptrdiff_t>(kMostRegions - 1);
    std::ranges::nth_element(seen, at, std::greater<>());
    std::size_t left = kMostRegions;
    for (ICaracteristica& landmark : shown) {
        if (landmark.last_seen < *at || left == 0) {
            landmark.covariance.setZero();
        } else {
            --left;
        }
    }
    return shown;
}

}  // namespace

std::string run_message(const LiveState& state) {
    const Snapshot& snapshot = state.snapshot;
    const auto lines =
        std::ranges::count(snapshot.best_map, FeatureKind::line, &ICaracteristica::kind);
    std::string text =
        fmt::format(R"({{"timestamp":{},"scans":{},"lines":{},"corners":{},"particles":{})",
                    time_text(snapshot), snapshot.steps, lines,
                    std::ssize(snapshot.best_map) - lines, snapshot.hypotheses.size());
    if (!snapshot.best_trajectory.empty()) {
        const auto& path = snapshot.best_trajectory;
        text += fmt::format(R"(,"tour_s":{:.3f})", tour_duration_s(path));
    }
    if (state.behind_s) text += fmt::format(R"(,"behind_s":{:.3f})", *state.behind_s);
    return text + "}";
}

std::string tf_message(const LiveState& state) {
    const Pose pose = told(state.snapshot.best_pose);
    std::string text = fmt::format(
        R"({{"timestamp":{},"parent_frame_id":"map","child_frame_id":"robot","translation":)",
        time_text(state.snapshot));
    put_point(Out(text), {pose.x, pose.y});
    text += R"(,"rotation":)";
    put_orientation(Out(text), pose.theta);
    return text + "}";
}

std::string pose_message(const LiveState& state) {
    std::string text = begin_of(state.snapshot, "map") + R"(,"pose":)";
    put_pose(text, told(state.snapshot.best_pose));
    return text + "}";
}

std::string path_message(const LiveState& state) {
    const Trajectory& path = state.snapshot.best_trajectory;
    std::string text =
        poses_text(state.snapshot, path.size(), [&](std::size_t i) { return path[i].pose; });
    std::vector<std::size_t> begins;
    for (std::size_t i = 1; i < path.size(); ++i)
        if (path[i].begins) begins.push_back((i - 1) / stride_of(path.size()) + 1);
    if (begins.empty()) return text;
    text.pop_back();
    return text + fmt::format(R"(,"begins":[{}]}})", fmt::join(begins, ","));
}

std::string particles_message(const LiveState& state) {
    const std::vector<WeightedPose>& particles = state.snapshot.hypotheses;
    if (particles.size() < 2) return {};
    return poses_text(state.snapshot, particles.size(),
                      [&](std::size_t i) { return particles[i].pose; });
}

std::string covariance_message(const LiveState& state) {
    const Snapshot& snapshot = state.snapshot;
    const Pose mean = told(snapshot.mean_pose);
    Entity entity(snapshot, "pose");
    ICaracteristica place;
    place.value = Esquina{mean.x, mean.y};
    place.covariance = snapshot.pose_covariance.topLeftCorner<2, 2>();
    for (const MapEllipse& ellipse : map_shapes({place}, {}, {}, kSigmas2).ellipses) {
        entity.add(LineKind::loop, loop_of(ellipse), kRobotColour);
    }
    constexpr double kArm = 0.5;  // [m]: where the heading may point
    const double variance = snapshot.pose_covariance(2, 2);
    if (variance > 0.0 && std::isfinite(variance)) {
        const double turn = std::min(kSigmas1 * std::sqrt(variance), kPi);
        const Point2 robot{mean.x, mean.y};
        const Point2 end{kArm, 0.0};
        entity.add(LineKind::list,
                   {robot, transform(Pose{mean.x, mean.y, mean.theta + turn}, end), robot,
                    transform(Pose{mean.x, mean.y, mean.theta - turn}, end)},
                   kRobotColour);
    }
    return scene({&entity});
}

std::string landmarks_message(const LiveState& state) {
    const Snapshot& snapshot = state.snapshot;
    Entity lines(snapshot, "lines");
    Entity corners(snapshot, "corners");
    Entity regions(snapshot, "regions");
    try {
        const LandmarkMap map = with_late_regions(snapshot.best_map);
        const MapShapes shapes = map_shapes(map, snapshot.line_extents, {}, kSigmas2);
        std::vector<Point2> ends;
        ends.reserve(2 * shapes.lines.size());
        for (const auto& [a, b] : shapes.lines) ends.insert(ends.end(), {a, b});
        lines.add(LineKind::list, ends, kLineColour);
        constexpr double kArm = 0.1;  // [m] of the crosses
        std::vector<Point2> crosses;
        crosses.reserve(4 * shapes.corners.size());
        for (const Point2& p : shapes.corners) {
            crosses.insert(
                crosses.end(),
                {{p.x - kArm, p.y}, {p.x + kArm, p.y}, {p.x, p.y - kArm}, {p.x, p.y + kArm}});
        }
        corners.add(LineKind::list, crosses, kCornerColour);
        for (const MapEllipse& ellipse : shapes.ellipses) {
            regions.add(LineKind::loop, loop_of(ellipse), kRegionColour);
        }
        for (const auto& band : map_shapes(map, snapshot.line_extents, {}, kSigmas1).bands) {
            regions.add(LineKind::loop, band, kRegionColour);
        }
    } catch (const Error&) {
        // A map that has flown apart cannot be drawn: the run itself will say so.
    }
    return scene({&lines, &corners, &regions});
}

std::string loops_message(const LiveState& state) {
    std::vector<Point2> closed;
    std::vector<Point2> refused;
    for (const RunLoop& loop : state.snapshot.loops) {
        const Point2 later{loop.scan.pose.x, loop.scan.pose.y};
        const Point2 earlier{loop.earlier.pose.x, loop.earlier.pose.y};
        std::vector<Point2>& ends = loop.closed() ? closed : refused;
        if (tellable(later) && tellable(earlier)) ends.insert(ends.end(), {later, earlier});
    }
    Entity closed_loops(state.snapshot, "closed");
    Entity refused_loops(state.snapshot, "refused");
    closed_loops.add(LineKind::list, closed, kClosedColour);
    refused_loops.add(LineKind::list, refused, kRefusedColour);
    return scene({&closed_loops, &refused_loops});
}

std::string scan_message(const LiveState& state) {
    std::string bytes;
    bytes.reserve(8 * state.snapshot.scan.points.size());
    for (const Point2& point : state.snapshot.scan.points) {
        if (!tellable(point)) continue;
        put_float(bytes, point.x);
        put_float(bytes, point.y);
    }
    std::string text = begin_of(state.snapshot, "robot") + R"(,"pose":)";
    put_pose(text, {});
    text += R"(,"point_stride":8,"fields":[{"name":"x","offset":0,"type":7},)"
            R"({"name":"y","offset":4,"type":7}],"data":")";
    text += base64(bytes);
    return text + "\"}";
}

std::string grid_message(const LiveState& state) {
    const GridTiles& grid = state.snapshot.step_grid;
    if (grid.empty() || grid.area.empty()) return {};
    constexpr std::int64_t kMostCells = std::int64_t{1} << 22;
    const std::int64_t width = grid.area.end_column - grid.area.first_column;
    const std::int64_t height = grid.area.end_row - grid.area.first_row;
    std::int64_t side = 1;  // of a cell that is told, in cells
    const auto parts = [&side](std::int64_t cells) { return (cells + side - 1) / side; };
    while (parts(width) * parts(height) > kMostCells) side *= 2;
    const std::int64_t columns = parts(width);
    std::string cells(static_cast<std::size_t>(columns * parts(height)),
                      static_cast<char>(kUnknownGrey));
    for (std::size_t i = 0; i < grid.tiles.size(); ++i) {
        if (!grid.tiles[i]) continue;
        const auto at = static_cast<std::int64_t>(i);
        // Of the tile's lower left cell, from the area's.
        const std::int64_t left =
            (grid.first_column + at % grid.columns) * kTileSide - grid.area.first_column;
        const std::int64_t low =
            (grid.first_row + at / grid.columns) * kTileSide - grid.area.first_row;
        for (std::int64_t y = std::max<std::int64_t>(-low, 0);
             y < std::min<std::int64_t>(kTileSide, height - low); ++y) {
            for (std::int64_t x = std::max<std::int64_t>(-left, 0);
                 x < std::min<std::int64_t>(kTileSide, width - left); ++x) {
                const std::uint8_t grey =
                    grid.tiles[i]->grey[static_cast<std::size_t>(y * kTileSide + x)];
                if (grey == kUnknownGrey) continue;
                char& cell =
                    cells[static_cast<std::size_t>((low + y) / side * columns + (left + x) / side)];
                const auto told_grey = static_cast<std::uint8_t>(cell);
                if (told_grey == kUnknownGrey || grey < told_grey) cell = static_cast<char>(grey);
            }
        }
    }
    std::string text = begin_of(state.snapshot, "map") + R"(,"pose":)";
    put_pose(text, {static_cast<double>(grid.area.first_column) * grid.resolution_m,
                    static_cast<double>(grid.area.first_row) * grid.resolution_m, 0.0});
    const double cell_m = static_cast<double>(side) * grid.resolution_m;
    text += fmt::format(R"(,"column_count":{},"cell_size":{{"x":{},"y":{}}},"row_stride":{},)"
                        R"("cell_stride":1,"fields":[{{"name":"grey","offset":0,"type":1}}],)"
                        R"("data":")",
                        columns, cell_m, cell_m, columns);
    text += base64(cells);
    return text + "\"}";
}

}  // namespace hitos::live
