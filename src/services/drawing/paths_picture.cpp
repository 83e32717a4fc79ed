// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/drawing/paths_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "hitos/services/drawing/gnuplot.hpp"

namespace hitos {
namespace {

constexpr double kSlack = 0.5;  // s, between stamps that are the same moment

std::string paths_script(const PathsPicture& picture) {
    PlotLayer walls{"walls", "lines lw 5 lc rgb '#c8c8c8' title 'true walls'", {}};
    for (const auto& [a, b] : picture.walls) walls.lines.push_back({a, b});
    PlotLayer segments{"segments", "lines lw 2 lc rgb '#1a9641' title 'map: segments'", {}};
    for (const LineExtent& segment : picture.segments) {
        segments.lines.push_back({segment.a, segment.b});
    }
    PlotLayer corners{
        "corners", "points pt 6 ps 1.2 lw 1.5 lc rgb '#d7191c' title 'map: corners'", {}};
    for (const ICaracteristica& landmark : picture.map) {
        const auto* corner = std::get_if<Esquina>(&landmark.value);
        if (corner != nullptr) corners.lines.push_back({{corner->x, corner->y}});
    }
    // What a log is compared with is another program's answer; only a world knows the truth.
    const char* reference = picture.walls.empty() ? "reference" : "true path";
    const std::array layers{
        std::move(walls),
        std::move(segments),
        std::move(corners),
        PlotLayer{"truth", fmt::format("lines lw 4 lc rgb '#0000ff' title '{}'", reference),
                  lines_of(picture.truth)},
        PlotLayer{"odometry", "lines lw 2 lc rgb '#ff00ff' title 'odometry'",
                  lines_of(picture.odometry)},
        PlotLayer{"estimate", "lines lw 1.5 lc rgb '#000000' title 'estimated path'",
                  lines_of(picture.estimate)}};
    return place_script("paths.png", layers);
}

}  // namespace

Trajectory in_frame_of_run(const Trajectory& reference, const Trajectory& run,
                           const std::optional<Pose>& pose_reference_run) {
    if (reference.empty() || run.empty()) return {};
    const auto nearest = [&](const StampedPose& own) {
        return std::ranges::min_element(reference, {}, [&](const StampedPose& pose) {
            return std::abs(pose.time_s - own.time_s);
        });
    };
    // Of several tours, one behind the other, it may be the truth of a later one alone.
    const auto begins = std::ranges::find_if(run, [&](const StampedPose& own) {
        const bool first = &own == &run.front();
        return (first || own.begins) && std::abs(nearest(own)->time_s - own.time_s) <= kSlack;
    });
    if (begins == run.end()) return {};
    const auto first = nearest(*begins);
    const Pose pose_run_reference = pose_reference_run
                                        ? inverse(*pose_reference_run)
                                        : compose(begins->pose, inverse(first->pose));
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
