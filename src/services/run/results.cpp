#include "hitos/services/run/results.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/evaluation/uncertainty.hpp"
#include "hitos/services/maps/dxf_file.hpp"
#include "hitos/services/maps/picture_file.hpp"
#include "hitos/services/maps/segment_file.hpp"
#include "hitos/services/run/grid_builder.hpp"
#include "hitos/slam/filters.hpp"
#include "version.hpp"

namespace hitos {
namespace {

using nlohmann::ordered_json;

ordered_json json_of(const MapError& error) {
    return {{"mean_m", error.mean_m},
            {"maximum_m", error.maximum_m},
            {"landmarks", error.landmarks},
            {"without_reference", error.without_reference},
            {"reference_landmarks", error.reference_landmarks},
            {"reference_found", error.reference_found}};
}

ordered_json json_of(const TrajectoryError& error) {
    return {{"ate_rmse_m", error.rmse_m},
            {"ate_mean_m", error.mean_m},
            {"ate_maximum_m", error.maximum_m},
            {"heading_rmse_rad", error.heading_rmse_rad},
            {"poses", error.poses}};
}

ordered_json json_of(const MeasuredDistance& measured) {
    ordered_json json{{"name", measured.distance.name}, {"true_m", measured.distance.true_m()}};
    if (measured.slam_m) {
        json["slam_m"] = *measured.slam_m;
        json["error_percent"] = *measured.error_percent();
    } else {
        json["missing"] = measured.missing;
    }
    return json;
}

/// Small grids are enlarged so that a picture can be looked at without tools.
int picture_scale(const Grid& grid) {
    constexpr int kWishedPixels = 1200;
    return std::clamp(kWishedPixels / std::max({grid.columns(), grid.rows(), 1}), 1, 4);
}

void write_grid(const Grid& grid, const Trajectory& path, const std::filesystem::path& stem) {
    PictureStyle style;
    style.scale = picture_scale(grid);
    style.scale_bar = true;
    for (const StampedPose& stamped : path) style.path.push_back({stamped.pose.x, stamped.pose.y});
    for (const char* extension : {".png", ".jpg"}) {
        write_picture(grid, style, std::filesystem::path(stem).concat(extension));
    }
}

}  // namespace

std::string version() {
    return kVersion;
}

RunSummary summarize(const Algoritmo& run, const References& references) {
    RunSummary summary;
    summary.source = run.reader().name();
    summary.format = run.reader().format();
    summary.scans = run.steps();
    summary.duration_s = run.duration_s();
    summary.algorithm = find_parameter("filter.algorithm").text(run.configuration());
    const FilterParams& filter = run.configuration().filter;
    summary.particles =
        slam_algorithms().reads(filter.algorithm, "filter.particles") ? filter.particles : 0;
    summary.seed = run.configuration().run.seed;
    summary.lines = run.filter().best_count(FeatureKind::line);
    summary.corners = run.filter().best_count(FeatureKind::corner);
    summary.report = run.report();
    const LandmarkMap map = run.filter().best_map();
    if (references.map) {
        summary.map_error = map_error(map, *references.map);
        summary.aligned_map_error = aligned_map_error(map, *references.map);
    }
    summary.distances = measure_distances(map, references.distances);
    if (references.trajectory) {
        summary.trajectory_error = trajectory_error(run.best_trajectory(), *references.trajectory);
        summary.odometry_error =
            trajectory_error(run.odometry_trajectory(), *references.trajectory);
    }
    return summary;
}

std::string to_json(const RunSummary& summary, double seconds) {
    ordered_json skipped = ordered_json::array();
    for (const ReadReport::Skip& skip : summary.report.examples) {
        skipped.push_back({{"line", skip.line}, {"reason", skip.reason}});
    }
    ordered_json json{
        {"hitos_version", version()},
        {"source", summary.source},
        {"format", summary.format},
        {"seed", summary.seed},
        {"algorithm", summary.algorithm},
        {"scans", summary.scans},
        {"duration_s", summary.duration_s},
        {"run_seconds", seconds},
        {"scans_per_second", seconds > 0.0 ? static_cast<double>(summary.scans) / seconds : 0.0},
        {"landmarks", {{"lines", summary.lines}, {"corners", summary.corners}}},
        {"log",
         {{"odometry_readings", summary.report.odometry},
          {"duplicate_scans", summary.report.duplicate_scans},
          {"stamps_backwards", summary.report.stamps_backwards},
          {"skipped_lines", summary.report.skipped},
          {"skipped_examples", skipped}}}};
    if (summary.particles > 0) json["particles"] = summary.particles;
    if (summary.map_error) json["map_error"] = json_of(*summary.map_error);
    if (summary.aligned_map_error) {
        json["map_error_aligned"] = json_of(summary.aligned_map_error->error);
    }
    if (summary.trajectory_error) json["trajectory_error"] = json_of(*summary.trajectory_error);
    if (summary.odometry_error) json["odometry_error"] = json_of(*summary.odometry_error);
    for (const MeasuredDistance& measured : summary.distances)
        json["distances"].push_back(json_of(measured));
    // Text from a damaged log may be no UTF-8: replace what is not instead of failing.
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

void prepare_output_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error || !std::filesystem::is_directory(folder)) {
        throw FileError(folder.string(), "cannot make this output folder: " +
                                             (error ? error.message() : "a file is in its place") +
                                             "; give another with --out");
    }
    // Destroyed without commit, the probe leaves nothing behind.
    AtomicFile(folder / "summary.json").write("");
}

RunSummary write_results(const Algoritmo& run, const References& references, double seconds,
                         const std::filesystem::path& folder) {
    RunSummary summary = summarize(run, references);
    const Trajectory best = run.best_trajectory();
    const LandmarkMap map = run.filter().best_map();
    const std::vector<LineExtent> segments = run.line_extents().of(map, best);
    write_map(map, folder / "map.txt");
    write_segments(map, segments, folder / "segments.txt");
    write_trajectory(best, folder / "trajectory.tum");
    write_trajectory(run.odometry_trajectory(), folder / "odometry.tum");
    write_grid(run.step_grid(), best, folder / "grid_best_steps");
    write_grid(build_grid(run.configuration().grid, run.reader(), best), best,
               folder / "grid_best");
    write_grid(build_grid(run.configuration().grid, run.reader(), run.odometry_trajectory()),
               run.odometry_trajectory(), folder / "grid_odometry");
    // What an earlier run left would not belong to this map.
    for (const char* name : {"distances.csv", "paths.png", "paths.gp", "uncertainty.csv",
                             "uncertainty.png", "uncertainty.dat", "uncertainty.gp"}) {
        std::error_code ignored;
        std::filesystem::remove(folder / name, ignored);
    }
    if (!summary.distances.empty()) {
        write_file(folder / "distances.csv", distances_csv(summary.distances));
    }
    const auto drawn = [&](const char* picture, const std::string& failure) {
        if (!failure.empty()) summary.not_drawn.push_back(std::string(picture) + ": " + failure);
    };
    if (references.trajectory) {
        drawn("paths.png", write_paths_picture(
                               {in_frame_of_run(*references.trajectory, best),
                                run.odometry_trajectory(), best, map, segments, references.walls},
                               folder));
    }
    if (run.options().uncertainty) {
        drawn("uncertainty.png", write_uncertainty(run.uncertainty(), folder));
    }
    write_dxf(map, segments, best, folder / "map.dxf");
    ArchivoConfiguracion::write(run.configuration(), folder / "config.cfg");
    write_file(folder / "summary.json", to_json(summary, seconds));
    return summary;
}

}  // namespace hitos
