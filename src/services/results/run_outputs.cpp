// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "corrected_tour.hpp"
#include "drawing/odometry_scans_picture.hpp"
#include "files/ieee_map_file.hpp"
#include "files/landmark_table.hpp"
#include "files/map_server_file.hpp"
#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/registration/graph_edit.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/drawing/map_figure.hpp"
#include "hitos/services/drawing/picture_file.hpp"
#include "hitos/services/files/dxf_file.hpp"
#include "hitos/services/files/g2o_file.hpp"
#include "hitos/services/files/segment_file.hpp"
#include "hitos/services/grid/grid_builder.hpp"
#include "json_input.hpp"
#include "run_graph.hpp"

namespace hitos {
namespace {

using Folder = std::filesystem::path;

constexpr char kNumber = RunOutput::kNumber;

std::string numbered(std::string name, const FinishedRun& finished) {
    const std::size_t at = name.find(kNumber);
    return at == std::string::npos
               ? name
               : name.replace(at, 1, std::to_string(*finished.run.options().grid_of));
}

/// `write` writes the files into a folder. What it returns, if anything, is why they are missing.
template <class Write>
RunOutput output(std::vector<std::string> names, Write write) {
    return {std::move(names), [write](const FinishedRun& finished, const Folder& folder) {
                if constexpr (std::is_void_v<decltype(write(finished, folder))>) {
                    write(finished, folder);
                    return Message();
                } else {
                    return write(finished, folder);
                }
            }};
}

/// One file.
template <class Write>
RunOutput one_file(const char* name, Write write) {
    return output({name}, [name, write](const FinishedRun& finished, const Folder& folder) {
        write(finished, folder / name);
    });
}

/// One file, of a text.
template <class Text>
RunOutput one_text(const char* name, Text text) {
    return one_file(name, [text](const FinishedRun& finished, const Folder& file) {
        write_file(file, text(finished));
    });
}

/// One file without which the run fails.
template <class Write>
RunOutput essential(const char* name, Write write) {
    RunOutput output = one_file(name, write);
    output.essential = true;
    return output;
}

RunOutput rereading(RunOutput output) {
    output.rereads = true;
    return output;
}

RunOutput where(std::function<bool(const FinishedRun&)> wanted, RunOutput output) {
    output.wanted = std::move(wanted);
    return output;
}

/// Where there is what only this option of a run gives.
RunOutput given(const char* option, std::function<bool(const FinishedRun&)> wanted,
                RunOutput output) {
    output.option = option;
    return where(std::move(wanted), std::move(output));
}

/// Where it is asked for, by the word or by one of its names.
RunOutput asked(const char* word, const char* purpose, RunOutput output) {
    output.word = word;
    output.purpose = purpose;
    return where(
        [word](const FinishedRun& finished) { return std::ranges::count(finished.also, word) > 0; },
        std::move(output));
}

/// Small grids are enlarged so that a picture can be looked at without tools.
int picture_scale(const Grid::Picture& picture) {
    constexpr int kWishedPixels = 1200;
    return std::clamp(kWishedPixels / std::max({picture.width, picture.height, 1}), 1, 4);
}

void end_where_asked(const FinishedRun& finished) {
    if (finished.stopped()) throw Error(left_out());
}

/// Of no more pixels than a screen shows, in about.
MapImage to_look_at(MapImage image) {
    constexpr double kPixels = 8.3e6;  // 3840 x 2160
    const double width = image.picture.width;
    const double height = image.picture.height;
    const double longest = std::max(width, height) * std::sqrt(kPixels / (width * height));
    return fitted(shrunk(std::move(image), static_cast<int>(std::max(longest, 1.0))), "jpg");
}

/// A picture of half the way would be taken for that of all of it; a single ray that ends anywhere
/// is no reason.
Message why_not_whole(const Grid& grid, const Trajectory& path) {
    constexpr std::uint64_t kFew = 100;
    if (kFew * grid.scans_left_out() <= path.size()) return {};
    return message(HITOS_TEXT("Errors",
                              "%1 of %2 scans lie beyond what a grid can hold (%3 million cells); "
                              "one of %4 m a cell holds them all (grid.resolution)"),
                   grid.scans_left_out(), path.size(), kMostGridCells / 1'000'000,
                   fmt::format("{:.2g}", 1.1 * grid.resolution_for_all()));
}

/// The grid as .png, a pixel a cell at least, and as .jpg to look at, with the path over it.
template <class MakeGrid, class PathOf>
RunOutput grid(const std::string& stem, MakeGrid make_grid, PathOf path_of) {
    const auto write = [stem, make_grid, path_of](const FinishedRun& finished,
                                                  const Folder& folder) {
        constexpr std::size_t kDrawnAtOnce = 4'000'000;  // pixels
        const Grid& grid = make_grid(finished);
        if (Message reason = why_not_whole(grid, path_of(finished)); !reason.empty()) return reason;
        MapImage image = map_image(grid);
        if (image.picture.grey.size() > kDrawnAtOnce) end_where_asked(finished);
        PictureStyle style;
        style.scale = picture_scale(image.picture);
        style.scale_bar = true;
        style.marks = finished.run.configuration().grid.path_marks;
        style.paths = lines_of(path_of(finished));
        write_picture(fitted(image, "png"), style, folder / numbered(stem + ".png", finished));
        write_picture(to_look_at(std::move(image)), style,
                      folder / numbered(stem + ".jpg", finished));
        return Message();
    };
    return output({stem + ".png", stem + ".jpg"}, write);
}

/// Of the scans that have a stamp; none where the log cannot be read any more.
void note_marks(const Algoritmo& run, std::vector<GraphEdit>& edits) {
    std::multimap<std::uint64_t, EditedScan*> named;
    for (GraphEdit& edit : edits) {
        for (EditedScan* scan : {&edit.scan, &edit.earlier})
            if (scan->stamp_s) named.emplace(scan->scan, scan);
    }
    try {
        const std::unique_ptr<TourReader> reader = run.reader().reopen();
        auto next = named.begin();
        for (std::uint64_t number = 0; next != named.end(); ++number) {
            const std::optional<Scan> scan = reader->next_scan();
            if (!scan) return;
            for (; next != named.end() && next->first == number; ++next)
                next->second->mark = scan->mark.value;
        }
    } catch (const FileError&) {
    }
}

std::string edits_text(const FinishedRun& finished) {
    const std::string source = finished.configuration.source.file;
    return ArchivoConfiguracion::edits_text(
        fmt::format("What was changed by hand in the graph of {}; hitos-cli run LOG --edits "
                    "edits.toml does it again. docs/formats.md says what each change does.",
                    on_one_line(Folder(source).filename().string())),
        finished.configuration.registration.edits);
}

const Trajectory& best_path(const FinishedRun& finished) {
    return finished.best;
}

const Trajectory& odometry_path(const FinishedRun& finished) {
    return finished.run.odometry_trajectory();
}

/// A map that is held is that of its own tour alone.
std::optional<std::uint64_t> held_scans(const FinishedRun& finished) {
    const std::vector<SecondTour> tours = finished.run.later_tours();
    if (tours.empty() || !finished.run.configuration().source.hold) return std::nullopt;
    return tours.back().begin;
}

Grid built(const FinishedRun& finished, Trajectory path) {
    if (const auto held = held_scans(finished)) path.resize(*held);
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

bool of_a_particle(const FinishedRun& finished) {
    return finished.run.options().grid_of.has_value();
}

Trajectory particle_path(const FinishedRun& finished) {
    return finished.run.trajectory_of(*finished.run.options().grid_of);
}

Message write_paths(const FinishedRun& finished, const Folder& folder) {
    const References& references = finished.references;
    // True walls hold the true path to the frame of the tour's start.
    std::optional<Pose> pose_reference_run;
    if (const auto& error = finished.summary.trajectory_error; references.walls.empty() && error) {
        pose_reference_run = error->pose_reference_estimate;
    }
    return write_paths_picture(
        {in_frame_of_run(*references.trajectory, finished.best, pose_reference_run),
         finished.run.odometry_trajectory(), finished.best, finished.map, finished.segments,
         references.walls},
        folder);
}

Message write_odometry_scans(const FinishedRun& finished, const Folder& folder) {
    OdometryScansPicture picture(finished.references.walls);
    const std::unique_ptr<TourReader> reader = finished.run.reader().reopen();
    for (const StampedPose& stamped : odometry_path(finished)) {
        const std::optional<Scan> scan = reader->next_scan();
        if (!scan) break;
        end_where_asked(finished);
        picture.add(*scan, stamped.pose);
    }
    return picture.write(folder);
}

VectorDrawing figure(const FinishedRun& finished) {
    return map_figure({Folder(finished.summary.source).filename().string(), finished.map,
                       finished.segments, finished.best, odometry_path(finished)});
}

/// Kind, box and size of each place; a picture of them over the map.
void write_changes(const FinishedRun& finished, const Folder& folder) {
    constexpr double kPixelsPerMm = 12.0;
    const std::vector<ChangedPlace> changes = finished.run.registration()->changes();
    std::string table = "change,low_x_m,low_y_m,high_x_m,high_y_m,points\n";
    for (const ChangedPlace& place : changes) {
        const Bounds box = place.bounds();
        fmt::format_to(std::back_inserter(table), "{},{:.3f},{:.3f},{:.3f},{:.3f},{}\n",
                       place.gone ? "gone" : "new", box.low.x, box.low.y, box.high.x, box.high.y,
                       place.points.size());
    }
    write_file(folder / "changes.csv", table);
    MapFigureStyle style;
    style.odometry = style.uncertainty = style.path = false;
    write_file(folder / "changes.png",
               png_text(map_figure({"changes", finished.map, finished.segments, finished.best,
                                    odometry_path(finished), changes, style}),
                        kPixelsPerMm));
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

/// Landmarks alone say nothing of what is free or occupied.
bool shows_space(const FinishedRun& finished) {
    return !finished.run.shows_landmarks_alone();
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
                      ArchivoConfiguracion::write(r.configuration, file, r.folder);
                  }),
        where(shows_space,
              grid(
                  "grid_best_steps", [](const Run& r) -> const Grid& { return r.run.step_grid(); },
                  best_path)),
        rereading(where(shows_space, whole_grid("grid_best", best_path))),
        rereading(where(shows_space, grid("grid_odometry", odometry_grid, odometry_path))),
        rereading(given("--grid-of #", of_a_particle,
                        whole_grid(std::string("grid_particle_") + kNumber, particle_path))),
        given(
            "--distances", [](const Run& r) { return !r.summary.distances.empty(); },
            one_text("distances.csv",
                     [](const Run& r) { return distances_csv(r.summary.distances); })),
        where(
            [](const Run& r) {
                return r.run.registration() != nullptr &&
                       !r.run.configuration().registration.edits.empty();
            },
            one_text("edits.toml", edits_text)),
        where(
            [](const Run& r) { return r.run.registration() != nullptr; },
            one_text("loops.csv", [](const Run& r) { return loops_csv(r.summary.quality.loops); })),
        where(
            [](const Run& r) {
                const std::vector<SecondTour> tours = r.run.later_tours();
                return !tours.empty() && tours.back().found.has_value();
            },
            output({"changes.csv", "changes.png"}, write_changes)),
        given(
            "--reference-trajectory",
            [](const Run& r) { return r.references.trajectory.has_value(); },
            output({"paths.png", "paths.gp"}, write_paths)),
        rereading(given(
            "--reference",
            [](const Run& r) { return !r.references.walls.empty() && shows_space(r); },
            output({"odometry_scans.png", "odometry_scans.gp"}, write_odometry_scans))),
        given(
            "--uncertainty", [](const Run& r) { return r.run.options().uncertainty; },
            output({"uncertainty.png", "uncertainty.csv", "uncertainty.dat", "uncertainty.gp"},
                   [](const Run& r, const Folder& folder) {
                       return write_uncertainty(r.run.uncertainty(), folder);
                   })),
        one_file("map.dxf", [](const Run& r,
                               const Folder& file) { write_dxf(r.map, r.segments, r.best, file); }),
        asked("svg", "the map as a figure for papers, to edit",
              one_text("map.svg", [](const Run& r) { return svg_text(figure(r)); })),
        asked("pdf", "the same figure, to include",
              one_text("map.pdf", [](const Run& r) { return pdf_text(figure(r)); })),
        rereading(asked("map-server", "occupancy grid for ROS's map_server",
                        output({"map.yaml", "map.pgm"}, write_map_server))),
        rereading(asked("ieee-1873", "landmarks and grid as map data of IEEE 1873-2015",
                        one_text("map.xml", map_data))),
        asked("landmarks", "every landmark with its covariance",
              one_text("landmarks.csv", [](const Run& r) { return landmark_table(r.map); })),
        asked("g2o", "the best hypothesis' poses, landmarks and measurements",
              one_text("graph.g2o", [](const Run& r) { return g2o_text(graph_of(r.run)); })),
        rereading(asked("carmen", "the tour as a CARMEN log with corrected poses",
                        one_file("corrected.log",
                                 [](const Run& r, const Folder& file) {
                                     write_corrected_tour(r.run, r.best, file);
                                 }))),
    };
}

}  // namespace

Configuracion written_configuration(const Algoritmo& run, const Trajectory& best) {
    Configuracion configuration = run.configuration();
    // A log's name may be of any bytes, the text of a configuration may not.
    configuration.source.file = in_utf8(configuration.source.file);
    std::string& changes = configuration.registration.edits;
    if (run.registration() == nullptr || changes.empty()) return configuration;
    std::vector<GraphEdit> edits = parse_graph_edits(changes);
    for (GraphEdit& edit : edits) {
        for (EditedScan* scan : {&edit.scan, &edit.earlier}) {
            if (scan->scan < best.size() && (scan == &edit.scan || edit.of_two()))
                scan->stamp_s = best[scan->scan].time_s;
        }
    }
    note_marks(run, edits);
    changes = text_of(edits);
    return configuration;
}

Message left_out() {
    return marked(HITOS_TEXT("Errors", "the run was asked to end, and this takes long"));
}

const std::vector<RunOutput>& run_outputs() {
    static const std::vector<RunOutput> table = make_outputs();
    return table;
}

std::vector<std::string> RunOutput::files(const FinishedRun& finished) const {
    std::vector<std::string> files = names;
    for (std::string& file : files) file = numbered(std::move(file), finished);
    return files;
}

namespace {

/// Whether the file has that name, in which there may be a number, which it gives.
bool is_named(const std::string& file, const std::string& name, std::string* number = nullptr) {
    const std::size_t at = name.find(kNumber);
    if (at == std::string::npos) return file == name;
    const std::string rest = name.substr(at + 1);
    if (file.size() < at + rest.size() || !file.starts_with(name.substr(0, at)) ||
        !file.ends_with(rest)) {
        return false;
    }
    if (number != nullptr) *number = file.substr(at, file.size() - at - rest.size());
    return true;
}

}  // namespace

bool RunOutput::owns(const std::string& file) const {
    return std::ranges::any_of(names,
                               [&](const std::string& name) { return is_named(file, name); });
}

std::string RunOutput::option_of(const std::string& file) const {
    const std::size_t at = option.find(kNumber);
    if (at == std::string::npos) return option;
    std::string number;
    for (const std::string& name : names) {
        if (is_named(file, name, &number)) break;
    }
    return std::string(option).replace(at, 1, number);
}

bool is_run_output(const std::string& name) {
    return std::ranges::any_of(run_outputs(),
                               [&name](const RunOutput& output) { return output.owns(name); });
}

}  // namespace hitos
