#include "run_outputs.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "corrected_tour.hpp"
#include "drawing/map_figure.hpp"
#include "drawing/odometry_scans_picture.hpp"
#include "files/ieee_map_file.hpp"
#include "files/landmark_table.hpp"
#include "files/map_server_file.hpp"
#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/drawing/picture_file.hpp"
#include "hitos/services/files/dxf_file.hpp"
#include "hitos/services/files/segment_file.hpp"
#include "hitos/services/grid/grid_builder.hpp"
#include "json_input.hpp"
#include "run_graph.hpp"

namespace hitos {
namespace {

using Folder = std::filesystem::path;

const std::string kParticleGrid = "grid_particle_";

/// The same files of every run.
RunOutput of_files(const std::vector<std::string>& files) {
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
    RunOutput output = of_files({file});
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

void end_where_asked(const FinishedRun& finished) {
    if (finished.stopped()) throw Error(left_out());
}

/// The grid as .png and .jpg, with the path over it.
template <class MakeGrid, class PathOf>
RunOutput grid(const std::string& stem, MakeGrid make_grid, PathOf path_of) {
    RunOutput output = of_files({stem + ".png", stem + ".jpg"});
    output.write = [stem, make_grid, path_of](const FinishedRun& finished, const Folder& folder) {
        constexpr std::size_t kDrawnAtOnce = 4'000'000;  // pixels
        const Grid& grid = make_grid(finished);
        const MapImage image = map_image(grid);
        if (image.picture.grey.size() > kDrawnAtOnce) end_where_asked(finished);
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
    GridBuilder builder(finished.run.configuration().grid, finished.run.reader().reopen(),
                        std::move(path));
    while (builder.step()) end_where_asked(finished);
    return builder.take_grid();
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
    RunOutput output = of_files({"distances.csv"});
    output.wanted = [](const FinishedRun& finished) { return !finished.summary.distances.empty(); };
    output.write = [](const FinishedRun& finished, const Folder& folder) {
        write_file(folder / "distances.csv", distances_csv(finished.summary.distances));
        return Message();
    };
    return output;
}

RunOutput paths() {
    RunOutput output = of_files({"paths.png", "paths.gp"});
    output.wanted = [](const FinishedRun& finished) {
        return finished.references.trajectory.has_value();
    };
    output.write = [](const FinishedRun& finished, const Folder& folder) {
        const auto& [run, references, summary, best, map, segments, ahead, also, stop] = finished;
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
    RunOutput output = of_files({"odometry_scans.png", "odometry_scans.gp"});
    output.wanted = [](const FinishedRun& finished) { return !finished.references.walls.empty(); };
    output.write = [](const FinishedRun& finished, const Folder& folder) {
        OdometryScansPicture picture(finished.references.walls);
        const std::unique_ptr<TourReader> reader = finished.run.reader().reopen();
        for (const StampedPose& stamped : odometry_path(finished)) {
            const std::optional<Scan> scan = reader->next_scan();
            if (!scan) break;
            end_where_asked(finished);
            picture.add(*scan, stamped.pose);
        }
        return picture.write(folder);
    };
    return output;
}

RunOutput uncertainty() {
    RunOutput output =
        of_files({"uncertainty.png", "uncertainty.csv", "uncertainty.dat", "uncertainty.gp"});
    output.wanted = [](const FinishedRun& finished) { return finished.run.options().uncertainty; };
    output.write = [](const FinishedRun& finished, const Folder& folder) {
        return write_uncertainty(finished.run.uncertainty(), folder);
    };
    return output;
}

/// Files that are written where they are asked for, by the word or by one of their names.
template <class Write>
RunOutput asked(const char* word, const std::vector<std::string>& files, const char* purpose,
                Write write) {
    RunOutput output = of_files(files);
    output.word = word;
    output.purpose = purpose;
    output.names = files;
    output.wanted = [word](const FinishedRun& finished) {
        return std::ranges::count(finished.also, word) > 0;
    };
    output.write = [write](const FinishedRun& finished, const Folder& folder) {
        write(finished, folder);
        return Message();
    };
    return output;
}

/// One such file, of a text.
template <class Text>
RunOutput asked_text(const char* word, const char* file, const char* purpose, Text text) {
    return asked(word, {file}, purpose,
                 [file, text](const FinishedRun& finished, const Folder& folder) {
                     write_file(folder / file, text(finished));
                 });
}

VectorDrawing figure(const FinishedRun& finished) {
    return map_figure({finished.summary.source, finished.map, finished.segments, finished.best,
                       odometry_path(finished)});
}

void write_map_server(const FinishedRun& finished, const Folder& folder) {
    const Grid grid = built(finished, finished.best);
    write_file(folder / "map.pgm", map_server_pgm(grid));
    write_file(folder / "map.yaml", map_server_yaml(grid, "map.pgm"));
}

std::string map_data(const FinishedRun& finished) {
    const Grid grid = built(finished, finished.best);
    return ieee_map_xml({finished.summary.source, finished.summary.algorithm, finished.map,
                         finished.segments, grid});
}

RunOutput rereading(RunOutput output) {
    output.rereads = true;
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
        rereading(whole_grid("grid_best", best_path)),
        rereading(grid("grid_odometry", odometry_grid, odometry_path)),
        rereading(particle_grid()),
        distances(),
        paths(),
        rereading(odometry_scans()),
        uncertainty(),
        always("map.dxf", [](const Run& r,
                             const Folder& file) { write_dxf(r.map, r.segments, r.best, file); }),
        asked_text("svg", "map.svg", "the map as a figure for papers, to edit",
                   [](const Run& r) { return svg_text(figure(r)); }),
        asked_text("pdf", "map.pdf", "the same figure, to include",
                   [](const Run& r) { return pdf_text(figure(r)); }),
        rereading(asked("map-server", {"map.yaml", "map.pgm"},
                        "occupancy grid for ROS's map_server", write_map_server)),
        rereading(asked_text("ieee-1873", "map.xml",
                             "landmarks and grid as map data of IEEE 1873-2015", map_data)),
        asked_text("landmarks", "landmarks.csv", "every landmark with its covariance",
                   [](const Run& r) { return landmark_table(r.map); }),
        asked_text("g2o", "graph.g2o", "the best hypothesis' poses, landmarks and measurements",
                   [](const Run& r) { return g2o_text(graph_of(r.run)); }),
        rereading(asked("carmen", {"corrected.log"},
                        "the tour as a CARMEN log with corrected poses",
                        [](const Run& r, const Folder& folder) {
                            write_corrected_tour(r.run, r.best, folder / "corrected.log");
                        })),
    };
}

}  // namespace

Message left_out() {
    return marked(HITOS_TEXT("Errors", "the run was asked to end, and this takes long"));
}

const std::vector<RunOutput>& run_outputs() {
    static const std::vector<RunOutput> table = make_outputs();
    return table;
}

bool is_run_output(const std::string& name) {
    return std::ranges::any_of(run_outputs(),
                               [&name](const RunOutput& output) { return output.owns(name); });
}

}  // namespace hitos
