// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/results/kept_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <system_error>

#include "hitos/base/error.hpp"
#include "hitos/registration/graph_edit.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/services/files/segment_file.hpp"
#include "json_input.hpp"
#include "loop_json.hpp"
#include "results_summary.hpp"
#include "written_files.hpp"

namespace hitos {
namespace {

RunFigures figures_in(const nlohmann::json& summary) {
    RunFigures figures;
    for (const Measure& measure : run_measures().entries()) {
        const nlohmann::json::json_pointer place(measure.place);
        if (measure.place.empty() || !summary.contains(place) || summary.at(place).is_null())
            continue;
        figures[measure] = summary.at(place).get<double>();
    }
    return figures;
}

/// The files of a run that read_results() reads.
constexpr std::array kRead{"config.cfg", "map.txt", "odometry.tum", "segments.txt",
                           "trajectory.tum"};

void expect_unchanged(const nlohmann::json& summary, const std::filesystem::path& folder) {
    for (const WrittenFile& file : files_named(summary, folder / kSummaryFile)) {
        if (std::ranges::count(kRead, file.name) == 0 || is_unchanged(file, folder)) continue;
        throw FormatError(
            (folder / file.name).string(), 0,
            HITOS_TEXT("Errors",
                       "is not the file that summary.json beside it names: it is missing, was "
                       "changed or is of another run; hitos-cli verify names all such files"));
    }
}

std::vector<SecondTour> later_tours_in(const nlohmann::json& quality, const std::string& file) {
    std::vector<SecondTour> tours;
    if (!quality.contains("later_tours")) return tours;
    for (const nlohmann::json& told : quality.at("later_tours")) {
        SecondTour& tour = tours.emplace_back();
        tour.begin = whole_number<std::uint64_t>(told, "begin", file, 1) - 1;
        tour.laid_from = tour.begin;
        const auto take = [&](const char* name, auto& scan) {
            if (told.contains(name)) scan = whole_number<std::uint64_t>(told, name, file, 1) - 1;
        };
        take("found", tour.found);
        take("found_beside", tour.beside);
        take("laid_from", tour.laid_from);
    }
    return tours;
}

/// What the summary tells of the run. Returns whether its map has landmarks.
bool read_summary(const std::filesystem::path& folder, KeptRun& run) {
    const std::string file = (folder / kSummaryFile).string();
    return with_summary(folder, [&](const nlohmann::json& summary) {
        run.scans = whole_number<std::uint64_t>(summary, "scans", file);
        run.finished = summary.value("finished", true);
        run.seconds = summary.at("run_seconds").get<double>();
        run.figures = figures_in(summary);
        if (summary.contains("reference_doubts"))
            summary.at("reference_doubts").get_to(run.reference_doubts);
        expect_unchanged(summary, folder);
        const nlohmann::json& counts = summary.at("landmarks");
        const bool landmarks = whole_number<int>(counts, "lines", file) > 0 ||
                               whole_number<int>(counts, "corners", file) > 0;
        run.path = read_trajectory(folder / "trajectory.tum");
        if (summary.contains("quality")) {
            run.loops = read_loops(summary.at("quality"), run.path, file);
            run.later_tours = later_tours_in(summary.at("quality"), file);
        }
        return landmarks;
    });
}

/// Changes by hand are the same with and without the stamps and marks of their scans.
bool same_value(const ConfigParameter& parameter, const Configuracion& a, const Configuracion& b) {
    if (parameter.get(a) == parameter.get(b)) return true;
    return parameter.key == kGraphEditsKey &&
           std::ranges::equal(parse_graph_edits(a.registration.edits),
                              parse_graph_edits(b.registration.edits), same_change);
}

}  // namespace

KeptRun read_results(const std::filesystem::path& folder) {
    KeptRun run;
    const bool landmarks = read_summary(folder, run);
    run.configuration = ArchivoConfiguracion::read(folder / "config.cfg");
    if (landmarks) run.map = read_map(folder / "map.txt");  // one without any is no map file
    const std::filesystem::path segments = folder / "segments.txt";
    run.line_extents = read_segments(segments);
    const auto lines =
        std::ranges::count(run.map, FeatureKind::line, [](const auto& one) { return one.kind(); });
    for (const LineExtent& extent : run.line_extents) {
        if (extent.landmark < lines) continue;
        throw FormatError(segments.string(), 0,
                          HITOS_TEXT("Errors",
                                     "has a segment of line %1, and map.txt beside it %2 lines; "
                                     "the folder mixes the files of several runs"),
                          extent.landmark + 1, lines);
    }
    run.odometry = read_trajectory(folder / "odometry.tum");
    return run;
}

void expect_results_unchanged(const std::filesystem::path& folder) {
    with_summary(folder, [&](const nlohmann::json& summary) {
        expect_unchanged(summary, folder);
        return 0;
    });
}

bool same_tour(const KeptRun& a, const KeptRun& b) {
    return a.drive == b.drive && same_log(a.configuration, b.configuration);
}

bool same_log(const Configuracion& a, const Configuracion& b) {
    // A file holds no bytes that are no UTF-8.
    if (in_utf8(a.source.file) == in_utf8(b.source.file)) return true;
    std::error_code none;
    if (std::filesystem::equivalent(a.source.file, b.source.file, none)) return true;
    return std::filesystem::weakly_canonical(a.source.file, none) ==
           std::filesystem::weakly_canonical(b.source.file, none);
}

std::vector<const ConfigParameter*> differences(const Configuracion& a, const Configuracion& b) {
    std::vector<const ConfigParameter*> found;
    for (const ConfigParameter& parameter : parameters()) {
        if (parameter.key == "source.file" || parameter.key == "run.threads") continue;
        if (!parameter.used_by(a) && !parameter.used_by(b)) continue;
        if (!same_value(parameter, a, b)) found.push_back(&parameter);
    }
    return found;
}

}  // namespace hitos
