#include "hitos/services/drawing/paths_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hitos/services/drawing/gnuplot.hpp"

namespace hitos {
namespace {

constexpr double kSlack = 0.5;  // s, between stamps that are the same moment

void hold(Bounds& bounds, const Trajectory& path) {
    for (const StampedPose& stamped : path) bounds.hold({stamped.pose.x, stamped.pose.y});
}

/// A named block of data in a script: places in a row.
std::string path_block(const char* name, const Trajectory& path) {
    std::string text = fmt::format("${} << EOD\n", name);
    for (const StampedPose& stamped : path) {
        text += fmt::format("{:.4f} {:.4f}\n", stamped.pose.x, stamped.pose.y);
    }
    return text + "EOD\n";
}

void add_pair(std::string& text, const Point2& a, const Point2& b) {
    text += fmt::format("{:.4f} {:.4f}\n{:.4f} {:.4f}\n\n", a.x, a.y, b.x, b.y);
}

std::string paths_script(const PathsPicture& picture) {
    Bounds frame;
    hold(frame, picture.truth);
    hold(frame, picture.estimate);
    hold(frame, picture.odometry);
    std::string walls = "$walls << EOD\n";
    for (const auto& [a, b] : picture.walls) {
        add_pair(walls, a, b);
        frame.hold(a);
        frame.hold(b);
    }
    std::string segments = "$segments << EOD\n";
    for (const LineExtent& segment : picture.segments) {
        add_pair(segments, segment.a, segment.b);
        frame.hold(segment.a);
        frame.hold(segment.b);
    }
    std::string corners = "$corners << EOD\n";
    bool any_corner = false;
    for (const ICaracteristica& landmark : picture.map) {
        const auto* corner = std::get_if<Esquina>(&landmark.value);
        if (corner == nullptr) continue;
        corners += fmt::format("{:.4f} {:.4f}\n", corner->x, corner->y);
        frame.hold({corner->x, corner->y});
        any_corner = true;
    }
    const double margin =
        0.03 * std::max(frame.high.x - frame.low.x, frame.high.y - frame.low.y) + 0.2;
    const double width = frame.high.x - frame.low.x + 2.0 * margin;
    const double height = frame.high.y - frame.low.y + 2.0 * margin;
    constexpr double kLongest = 1300.0;  // pixels
    constexpr double kLeast = 360.0;
    constexpr double kAround = 130.0;  // for axes and legend
    const double scale = kLongest / std::max(width, height);
    std::string script = path_block("truth", picture.truth) +
                         path_block("odometry", picture.odometry) +
                         path_block("estimate", picture.estimate) + walls + "EOD\n" + segments +
                         "EOD\n" + corners + "EOD\n";
    script += fmt::format(
        "set terminal pngcairo size {:.0f},{:.0f}\n"
        "set output 'paths.png'\n"
        "set size ratio -1\nset xrange [{:.3f}:{:.3f}]\nset yrange [{:.3f}:{:.3f}]\n"
        "set xlabel 'x (m)'\nset ylabel 'y (m)'\nset grid lc rgb '#e0e0e0'\n"
        "set key below horizontal\nplot ",
        std::max(width * scale, kLeast) + kAround, std::max(height * scale, kLeast) + kAround,
        frame.low.x - margin, frame.high.x + margin, frame.low.y - margin, frame.high.y + margin);
    if (!picture.walls.empty()) {
        script += "$walls with lines lw 5 lc rgb '#c8c8c8' title 'true walls', ";
    }
    if (!picture.segments.empty()) {
        script += "$segments with lines lw 2 lc rgb '#1a9641' title 'map: segments', ";
    }
    if (any_corner) {
        script += "$corners with points pt 6 ps 1.2 lw 1.5 lc rgb '#d7191c' title 'map: corners', ";
    }
    // What a log is compared with is another program's answer; only a world knows the truth.
    const char* reference = picture.walls.empty() ? "reference" : "true path";
    script += fmt::format("$truth with lines lw 4 lc rgb '#0000ff' title '{}', ", reference);
    script +=
        "$odometry with lines lw 2 lc rgb '#ff00ff' title 'odometry', "
        "$estimate with lines lw 1.5 lc rgb '#000000' title 'estimated path'\n";
    return script;
}

}  // namespace

Trajectory in_frame_of_run(const Trajectory& reference, const Trajectory& run,
                           const std::optional<Pose>& pose_reference_run) {
    if (reference.empty() || run.empty()) return {};
    const double begin = run.front().time_s;
    const auto first = std::ranges::min_element(
        reference, {}, [&](const StampedPose& pose) { return std::abs(pose.time_s - begin); });
    if (!(std::abs(first->time_s - begin) <= kSlack)) return {};
    const Pose pose_run_reference = pose_reference_run
                                        ? inverse(*pose_reference_run)
                                        : compose(run.front().pose, inverse(first->pose));
    Trajectory moved;
    for (const StampedPose& stamped : reference) {
        if (stamped.time_s < first->time_s || stamped.time_s > run.back().time_s + kSlack) continue;
        moved.push_back({stamped.time_s, compose(pose_run_reference, stamped.pose)});
    }
    return moved;
}

Message write_paths_picture(const PathsPicture& picture, const std::filesystem::path& folder) {
    Message refusal;
    if (picture.truth.empty()) {
        refusal = message(HITOS_TEXT(
            "Errors", "no pose of the reference trajectory is as old as the first scan"));
    } else if (picture.estimate.empty()) {
        refusal = message(HITOS_TEXT("Errors", "nothing was estimated"));
    }
    const std::vector<PlotFile> files = {
        {"paths.gp", refusal.empty() ? paths_script(picture) : ""}};
    const std::vector<std::string> pictures = {"paths.png"};
    return draw_pictures(folder, files, "paths.gp", pictures, refusal);
}

}  // namespace hitos
