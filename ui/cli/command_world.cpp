// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli world: a world from what shows walls, and whether it can be driven.

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "commands.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/input_files.hpp"
#include "hitos/base/plural.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "hitos/simulation/drawings/dxf_walls.hpp"
#include "hitos/simulation/drive/world_check.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "hitos/workbench/world_import.hpp"
#include "options.hpp"
#include "report.hpp"

namespace hitos::cli {
namespace {

struct WorldOptions {
    std::string source;
    std::string out;
    std::string start;
    std::string unit;
    ImportOptions import;
    bool json = false;
};

Pose parse_start(const std::string& text) {
    std::array<double, 3> values{};
    std::string_view rest = text;
    bool good = true;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t comma = rest.find(',');
        const auto value = input::parse_number(rest.substr(0, comma));
        good = good && value && std::abs(*value) <= kFarthest &&
               (comma == std::string_view::npos) == (i + 1 == values.size());
        values[i] = value.value_or(0.0);
        rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
    }
    if (!good) {
        throw ConfigError(
            "--start",
            verbatim(fmt::format("found \"{}\", expected X,Y,DEG: metres and degrees", text)));
    }
    return {values[0], values[1], wrap_angle(values[2] * (kPi / 180.0))};
}

/// Metres per unit.
double parse_unit(const std::string& text) {
    const auto unit = std::ranges::find(kDrawingUnits, text, &DrawingUnit::word);
    if (unit != kDrawingUnits.end()) return unit->metres;
    const auto value = input::parse_number(text);
    if (value && *value > 0.0 && std::isfinite(*value)) return *value;
    throw ConfigError("--unit", verbatim(fmt::format("found \"{}\", expected mm, cm, m, in, ft or "
                                                     "the metres of a unit, more than 0",
                                                     text)));
}

/// The size of what walls and landmarks enclose, from where to where.
void tell_size(const World& world, Report& report) {
    Bounds box;
    for (const WallSegment& wall : world.walls) {
        box.hold(wall.a);
        box.hold(wall.b);
    }
    for (const Point2& mark : world.landmarks.at) box.hold(mark);
    if (box.empty) return;
    const double width = box.high.x - box.low.x;
    const double height = box.high.y - box.low.y;
    report.say("size: {:.3f} m x {:.3f} m, from ({:.3f}, {:.3f}) to ({:.3f}, {:.3f})\n", width,
               height, box.low.x, box.low.y, box.high.x, box.high.y);
    report.object()["size_m"] = {width, height};
    report.object()["low_m"] = {box.low.x, box.low.y};
}

/// What became of a drawing.
void tell(const char* name, const std::vector<Message>& messages, Report& report) {
    report.object()[name] = nlohmann::ordered_json::array();
    for (const Message& message : messages) {
        report.object()[name].push_back(message.english());
        if (std::string_view(name) == "warnings") {
            report.warn(message.english());
        } else {
            report.say("{}\n", message.english());
        }
    }
}

void make_world(WorldOptions options) {
    const std::filesystem::path source = source_named(options.source);
    const std::filesystem::path out = options.out;
    if (!options.start.empty()) options.import.start = parse_start(options.start);
    if (!options.unit.empty()) options.import.unit_m = parse_unit(options.unit);
    if (out.empty() && wall_source(source) != WallSource::world) {
        throw ConfigError("world", verbatim("found nothing to write; give --out WORLD.toml"));
    }
    if (!out.empty() && !is_world_file(out)) {
        throw ConfigError("--out", verbatim(fmt::format("found \"{}\", expected a name that ends "
                                                        "in .toml",
                                                        options.out)));
    }
    const std::vector<std::filesystem::path> inputs =
        is_world_file(source) ? tour_files(source.string()) : std::vector{source};
    check_apart({&out, 1}, inputs);
    ImportReport made;
    WorldText text = import_world(source, out, options.import, &made);
    if (!out.empty()) text.save(out);

    const World& world = text.world();
    const WorldCheck check = check_world(world);
    Report report(options.json);
    report.say("{}: {} in {}\n", on_one_line(out.empty() ? source.string() : options.out),
               plural(world.walls.size(), "wall"), plural(text.walls().size(), "polyline"));
    report.object() = {{"source", source.string()},
                       {"file", options.out},
                       {"walls", world.walls.size()},
                       {"polylines", text.walls().size()},
                       {"lines_left_out", made.left_out},
                       {"good", check.good()},
                       {"start_free", check.start_free},
                       {"closed", check.closed()},
                       {"has_tour", check.has_tour},
                       {"tour_hits_no_wall", check.has_tour && check.tour_problem.empty()}};
    tell_size(world, report);
    // Of a drawing that the world names, or that it is made of.
    made.notes.insert(made.notes.end(), world.drawing_notes.begin(), world.drawing_notes.end());
    tell("notes", made.notes, report);
    if (!world.walls.empty()) report.object()["nearest_wall_m"] = check.nearest_m;
    report.object()["check"] = nlohmann::ordered_json::array();
    for (const Message& sentence : sentences_of(check, world)) {
        report.say("{}\n", sentence.english());
        report.object()["check"].push_back(sentence.english());
    }
    tell("warnings", made.warnings, report);
    if (made.left_out > 0) {
        report.note(fmt::format("{} of the map left out: without two corners there are no ends",
                                plural(made.left_out, "line")));
    }
    report.end();
}

}  // namespace

void add_world(CLI::App& program) {
    auto options = std::make_shared<WorldOptions>();
    CLI::App* command = program.add_subcommand(
        "world", "Make a world of a drawing, a map, a run or a picture, and check it");
    command
        ->add_option("source", options->source,
                     "DXF drawing, map file, folder or segments.txt of a run, YAML file of "
                     "map_server, picture, or world (.toml)")
        ->required();
    command->add_option("--out", options->out,
                        "World file to write (.toml); a world that is only checked needs none");
    command
        ->add_option("--tolerance", options->import.tolerance_m,
                     "How far a picture's cells lie from straight walls [m] (default: two cells), "
                     "or a map's corners from its lines (default: 0.05)")
        ->check(positive());
    command
        ->add_option("--resolution", options->import.resolution_m,
                     "Metres of a pixel, of a picture without a YAML file")
        ->check(positive());
    command->add_option("--layer", options->import.layer,
                        "Layers of a drawing that are walls, apart by commas (default: all that "
                        "are shown)");
    command->add_option("--unit", options->unit,
                        "Unit of a drawing: mm, cm, m, in, ft or the metres of one (default: as "
                        "it says, else m)");
    command->add_option("--start", options->start,
                        "Where the robot starts: X,Y,DEG [m, degrees] (default: 0,0,0)");
    add_report_option(*command, options->json);
    command->callback([options] { make_world(*options); });
}

}  // namespace hitos::cli
