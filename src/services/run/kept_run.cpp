#include "hitos/services/run/kept_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/maps/map_file.hpp"
#include "hitos/services/maps/segment_file.hpp"

namespace hitos {
namespace {

using nlohmann::json;

/// An error that the summary may lack.
std::optional<double> error_in(const json& summary, const char* table, const char* name) {
    if (!summary.contains(table)) return std::nullopt;
    return summary.at(table).at(name).get<double>();
}

/// What the summary tells of the run. Returns whether its map has landmarks.
bool read_summary(const std::filesystem::path& folder, KeptRun& run) {
    const std::filesystem::path file = folder / "summary.json";
    if (!std::filesystem::is_regular_file(file)) {
        throw FileError(
            folder.string(),
            message(HITOS_TEXT("Errors",
                               "is no folder of results: it has no summary.json; choose one that "
                               "Save all results or hitos-cli run --out has written")));
    }
    try {
        const json summary = json::parse(input::read_text(file));
        run.scans = summary.at("scans").get<std::uint64_t>();
        run.seconds = summary.at("run_seconds").get<double>();
        run.trajectory_error_m = error_in(summary, "trajectory_error", "ate_rmse_m");
        run.map_error_m = error_in(summary, "map_error", "mean_m");
        const json& counts = summary.at("landmarks");
        return counts.at("lines").get<int>() + counts.at("corners").get<int>() > 0;
    } catch (const json::exception& error) {
        throw FormatError(
            file.string(), 0,
            message(HITOS_TEXT("Errors", "is no summary of a run: %1"), error.what()));
    }
}

}  // namespace

KeptRun read_results(const std::filesystem::path& folder) {
    KeptRun run;
    const bool landmarks = read_summary(folder, run);
    run.finished = true;
    run.configuration = ArchivoConfiguracion::read(folder / "config.cfg");
    if (landmarks) run.map = read_map(folder / "map.txt");  // one without any is no map file
    const std::filesystem::path segments = folder / "segments.txt";
    run.line_extents = read_segments(segments);
    const auto lines =
        std::ranges::count(run.map, FeatureKind::line, [](const auto& one) { return one.kind(); });
    for (const LineExtent& extent : run.line_extents) {
        if (extent.landmark < lines) continue;
        throw FormatError(segments.string(), 0,
                          message(HITOS_TEXT("Errors",
                                             "has a segment of line %1, and map.txt beside it %2 "
                                             "lines; the folder mixes the files of several runs"),
                                  extent.landmark + 1, lines));
    }
    run.path = read_trajectory(folder / "trajectory.tum");
    run.odometry = read_trajectory(folder / "odometry.tum");
    return run;
}

std::vector<const ConfigParameter*> differences(const Configuracion& a, const Configuracion& b) {
    std::vector<const ConfigParameter*> found;
    for (const ConfigParameter& parameter : parameters()) {
        if (parameter.key == "source.file" || parameter.key == "run.threads") continue;
        if (!parameter.used_by(a) && !parameter.used_by(b)) continue;
        if (parameter.get(a) != parameter.get(b)) found.push_back(&parameter);
    }
    return found;
}

}  // namespace hitos
