#include "run_outputs.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "../maps/odometry_scans_picture.hpp"
#include "hitos/base/atomic_file.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/maps/dxf_file.hpp"
#include "hitos/services/maps/picture_file.hpp"
#include "hitos/services/maps/segment_file.hpp"
#include "hitos/services/run/grid_builder.hpp"
#include "json_input.hpp"

namespace hitos {
namespace {

using Folder = std::filesystem::path;

const std::string kParticleGrid = "grid_particle_";

/// The same files of every run.
RunOutput named(const std::vector<std::string>& files) {
    RunOutput output;
    output.files = [files](const FinishedRun&) { return files; };
    output.owns = [files](const std::string& name) {
        return std::find(files.begin(), files.end(), name) != files.end();
    };
    return output;
}

/// One file, of every run.
template <class Write>
RunOutput always(const char* file, Write write) {
    RunOutput output = named({file});
    output.write = [file, write](const FinishedRun& finished, const Folder& folder) {
        write(finished, folder / file);
        return Message();
    };
    return output;
}

/// A file without which the run fails.
template <class Write>
RunOutput essential(const char* file, Write write) {
    RunOutput output = always(file, write);
    output.essential = true;
    return output;
}

/// Small grids are enlarged so that a picture can be looked at without tools.
int picture_scale(const Grid::Picture& picture) {
    constexpr int kWishedPixels = 1200;
    return std::clamp(kWishedPixels / std::max({picture.width, picture.height, 1}), 1, 4);
}

/// The grid as .png and .jpg, with the path over it.
template <class MakeGrid, class PathOf>
RunOutput grid(const std::string& stem, MakeGrid make_grid, PathOf path_of) {
    RunOutput output = named({stem + ".png", stem + ".jpg"});
    output.write = [stem, make_grid, path_of](const FinishedRun& finished, const Folder& folder) {
        const Grid& grid = make_grid(finished);
        const MapImage image = map_image(grid);
        PictureStyle style;
        style.scale = picture_scale(image.picture);
        style.scale_bar = true;
        for (const StampedPose& stamped : path_of(finished)) {
            style.path.push_back({stamped.pose.x, stamped.pose.y});
        }
        for (const char* kind : {"png", "jpg"}) {
            write_picture(fitted(image, kind), style, folder / (stem + "." + kind));
        }
        return Message();
    };
    return output;
}

const Trajectory& best_path(const FinishedRun& finished) {
    return finished.best;
}

const Trajectory& odometry_path(const FinishedRun& finished) {
    return finished.run.odometry_trajectory();
}

Grid built(const FinishedRun& finished, Trajectory path) {
    return build_grid(finished.run.configuration().grid, finished.run.reader(), std::move(path));
}

/// The grid of the whole tour along a path.
template <class PathOf>
RunOutput whole_grid(const std::string& stem, PathOf path_of) {
    return grid(
        stem, [path_of](const FinishedRun& finished) { return built(finished, path_of(finished)); },
        path_of);
}

Grid odometry_grid(const FinishedRun& finished) {
    if (finished.odometry_grid != nullptr) {
        if (auto grid = finished.odometry_grid->take(finished.run.steps())) return *std::move(grid);
    }
    return built(finished, odometry_path(finished));
}

/// The name has the particle's number.
RunOutput particle_grid() {
    const auto stem = [](std::size_t particle) { return kParticleGrid + std::to_string(particle); };
    RunOutput output;
    output.files = [stem](const FinishedRun& finished) {
        const std::size_t particle = *finished.run.options().grid_of;
        return std::vector{stem(particle) + ".png", stem(particle) + ".jpg"};
    };
    output.owns = [](const std::string& name) {
        return name.starts_with(kParticleGrid) &&
               (name.ends_with(".png") || name.ends_with(".jpg"));
    };
    output.wanted = [](const FinishedRun& finished) {
        return finished.run.options().grid_of.has_value();
    };
    output.write = [stem](const FinishedRun& finished, const Folder& folder) {
        const std::size_t particle = *finished.run.options().grid_of;
        return whole_grid(
                   stem(particle),
                   [particle](const FinishedRun& run) { return run.run.trajectory_of(particle); })
            .write(finished, folder);
    };
    return output;
}

RunOutput distances() {
    RunOutput output = named({"distances.csv"});
    output.wanted = [](const FinishedRun& finished) { return !finished.summary.distances.empty(); };
    output.write = [](const FinishedRun& finished, const Folder& folder) {
        write_file(folder / "distances.csv", distances_csv(finished.summary.distances));
        return Message();
    };
    return output;
}

RunOutput paths() {
    RunOutput output = named({"paths.png", "paths.gp"});
    output.wanted = [](const FinishedRun& finished) {
        return finished.references.trajectory.has_value();
    };
    output.write = [](const FinishedRun& finished, const Folder& folder) {
        const auto& [run, references, summary, best, map, segments, ahead] = finished;
        // True walls hold the true path to the frame of the tour's start.
        std::optional<Pose> pose_reference_run;
        if (references.walls.empty() && summary.trajectory_error) {
            pose_reference_run = summary.trajectory_error->pose_reference_estimate;
        }
        return write_paths_picture(
            {in_frame_of_run(*references.trajectory, best, pose_reference_run),
             run.odometry_trajectory(), best, map, segments, references.walls},
            folder);
    };
    return output;
}

RunOutput odometry_scans() {
    RunOutput output = named({"odometry_scans.png", "odometry_scans.gp"});
    output.wanted = [](const FinishedRun& finished) { return !finished.references.walls.empty(); };
    output.write = [](const FinishedRun& finished, const Folder& folder) {
        OdometryScansPicture picture(finished.references.walls);
        const std::unique_ptr<TourReader> reader = finished.run.reader().reopen();
        for (const StampedPose& stamped : odometry_path(finished)) {
            const std::optional<Scan> scan = reader->next_scan();
            if (!scan) break;
            picture.add(*scan, stamped.pose);
        }
        return picture.write(folder);
    };
    return output;
}

RunOutput uncertainty() {
    RunOutput output =
        named({"uncertainty.png", "uncertainty.csv", "uncertainty.dat", "uncertainty.gp"});
    output.wanted = [](const FinishedRun& finished) { return finished.run.options().uncertainty; };
    output.write = [](const FinishedRun& finished, const Folder& folder) {
        return write_uncertainty(finished.run.uncertainty(), folder);
    };
    return output;
}

std::vector<RunOutput> make_outputs() {
    using Run = FinishedRun;
    return {
        essential("map.txt", [](const Run& r, const Folder& file) { write_map(r.map, file); }),
        essential(
            "segments.txt",
            [](const Run& r, const Folder& file) { write_segments(r.map, r.segments, file); }),
        essential("trajectory.tum",
                  [](const Run& r, const Folder& file) { write_trajectory(r.best, file); }),
        essential("trajectory_online.tum",
                  [](const Run& r, const Folder& file) {
                      write_trajectory(r.run.online_trajectory(), file);
                  }),
        essential(
            "odometry.tum",
            [](const Run& r, const Folder& file) { write_trajectory(odometry_path(r), file); }),
        essential("config.cfg",
                  [](const Run& r, const Folder& file) {
                      Configuracion configuration = r.run.configuration();
                      // A log's name may be of any bytes, the text of a configuration may not.
                      configuration.source.file = in_utf8(configuration.source.file);
                      ArchivoConfiguracion::write(configuration, file);
                  }),
        grid(
            "grid_best_steps", [](const Run& r) -> const Grid& { return r.run.step_grid(); },
            best_path),
        whole_grid("grid_best", best_path),
        grid("grid_odometry", odometry_grid, odometry_path),
        particle_grid(),
        distances(),
        paths(),
        odometry_scans(),
        uncertainty(),
        always("map.dxf", [](const Run& r,
                             const Folder& file) { write_dxf(r.map, r.segments, r.best, file); }),
    };
}

}  // namespace

const std::vector<RunOutput>& run_outputs() {
    static const std::vector<RunOutput> table = make_outputs();
    return table;
}

bool is_run_output(const std::string& name) {
    return std::ranges::any_of(run_outputs(),
                               [&name](const RunOutput& output) { return output.owns(name); });
}

}  // namespace hitos
