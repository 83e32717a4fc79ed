// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli reproduce: the synthetic experiments of the thesis, run again.

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/plural.hpp"
#include "hitos/base/process.hpp"
#include "hitos/workbench/reproduction.hpp"
#include "hitos/workbench/reproduction_maps.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "options.hpp"
#include "report.hpp"
#include "study_console.hpp"

namespace hitos::cli {
namespace {

struct ReproduceArguments {
    ReproductionOptions reproduction;
    std::string out;
    std::string report;
    std::string reading = readings().front().name;
    bool as_published = false;
    bool hypotheses = false;
    bool json = false;
};

std::string reading_names() {
    std::string text;
    for (const Reading& reading : readings()) {
        text += (text.empty() ? "" : ", ") + reading.name;
    }
    return text;
}

/// Whether there were any.
bool tell_failures(const Reproduction& result) {
    for (const std::string& failure : result.failures) {
        fmt::print(stderr, "failed: {}: {}\n", result.reading.name, failure);
    }
    return !result.failures.empty();
}

/// The figures with tables of errors.
int reproduce_tables(ReproduceArguments options, Report& report) {
    StudyTeller teller;
    options.reproduction.observer = teller.observer();
    const Reproduction result = hitos::reproduce(options.reproduction);
    std::vector<Reproduction> tried;
    if (options.hypotheses) {
        tried = try_readings(options.reproduction, result,
                             [&](const Reading& next) { teller.begin("reading " + next.name); });
    }
    teller.finish();
    if (result.computed + result.reused == result.failures.size()) {
        throw Error(verbatim("every run failed; the first: " + result.failures.front()));
    }
    if (!options.report.empty()) {
        write_report(result, options.report, options.reproduction.out / "plots", tried);
    }
    if (!result.plot_problem.empty()) {
        fmt::print(stderr, "no plots: {}; their scripts are in {}\n", result.plot_problem,
                   (options.reproduction.out / "plots").string());
    }
    const std::string document = (options.reproduction.out / "reproduction.md").string();
    const std::size_t done = result.computed - result.failures.size();
    report.say("{} done, {} found done, {} failed: {}\n", plural(done, "run"), result.reused,
               result.failures.size(), document);
    report.object()["tables"] = {{"document", document},
                                 {"figures", document.substr(0, document.size() - 2) + "csv"},
                                 {"runs_done", done},
                                 {"runs_found_done", result.reused},
                                 {"failures", result.failures}};
    bool failed = tell_failures(result);
    for (const Reproduction& other : tried) failed = tell_failures(other) || failed;
    return failed ? kSomeFailed : 0;
}

/// "docs/reproduction.md" gives "docs/reproduction-maps.md".
std::filesystem::path maps_report(const std::filesystem::path& report) {
    return report.parent_path() / (report.stem().string() + "-maps" + report.extension().string());
}

/// The experiments that are shown by maps and counts.
int reproduce_experiments(const ReproduceArguments& options, const std::vector<std::string>& only,
                          Report& report) {
    ReproductionOptions maps = options.reproduction;
    maps.only = only;
    StudyTeller teller;
    maps.observer = teller.observer();
    const MapReproduction result = reproduce_maps(maps);
    teller.finish();
    if (!options.report.empty() && !result.experiments.empty()) {
        write_map_report(result, maps_report(options.report), maps.out / "maps");
    }
    const std::string document = (maps.out / "reproduction-maps.md").string();
    const std::size_t done = result.computed - result.failures.size();
    report.say("{} shown by maps and counts done, {} found done, {} failed: {}\n",
               plural(done, "run"), result.reused, result.failures.size(), document);
    nlohmann::ordered_json times = nlohmann::ordered_json::array();
    for (const ParticleTime& time : result.times) {
        report.say("{:4} particles: {:.3f} s for {}\n", time.particles, time.cpu_seconds,
                   plural(time.scans, "scan"));
        times.push_back({{"particles", time.particles},
                         {"cpu_seconds", time.cpu_seconds},
                         {"scans", time.scans}});
    }
    report.object()["maps"] = {{"document", document},
                               {"figures", document.substr(0, document.size() - 2) + "csv"},
                               {"runs_done", done},
                               {"runs_found_done", result.reused},
                               {"failures", result.failures},
                               {"left_out", result.left_out},
                               {"times", times}};
    if (!result.left_out.empty()) {
        report.say("{} experiments on recorded tours left out, the first: {}\n",
                   result.left_out.size(), result.left_out.front());
    }
    for (const std::string& failure : result.failures) {
        fmt::print(stderr, "failed: {}\n", failure);
    }
    return result.failures.empty() ? 0 : kSomeFailed;
}

bool names_figure(const std::string& word) {
    return std::ranges::any_of(read_thesis_figures(needed_file("data/results.csv")),
                               [&](const ThesisFigure& figure) { return figure.is_named(word); });
}

/// A word of --only may name figures with tables, experiments shown by maps, or both.
int reproduce(ReproduceArguments options) {
    Reading& reading = options.reproduction.reading;
    reading = options.as_published ? reading_as_published() : find_reading(options.reading);
    if (options.out.empty()) {
        options.out = "out/reproduction";
        if (!text_of(reading).empty()) options.out += "-" + reading.name;
    }
    options.reproduction.out = options.out;
    const std::vector<std::string> words = std::exchange(options.reproduction.only, {});
    std::vector<std::string> maps;
    for (const std::string& word : words) {
        const bool shown = names_experiment(word);
        if (shown) maps.push_back(word);
        if (!shown || names_figure(word)) options.reproduction.only.push_back(word);
    }
    const StopSource stop;
    options.reproduction.stop = stop.token();
    try {
        int status = 0;
        Report report(options.json);
        if (words.empty() || !options.reproduction.only.empty()) {
            status = reproduce_tables(options, report);
        }
        if (words.empty() || !maps.empty()) {
            status = std::max(status, reproduce_experiments(options, maps, report));
        }
        report.end();
        return status;
    } catch (const StudyStopped& stopped) {
        fmt::print(stderr, "{}; the same command goes on with the rest\n", stopped.what());
        return StopByRequest::status();
    }
}

}  // namespace

void add_reproduce(CLI::App& program) {
    auto options = std::make_shared<ReproduceArguments>();
    CLI::App* command = program.add_subcommand(
        "reproduce", "Run the synthetic experiments of the thesis again and compare");
    command->footer(
        "Writes reproduction.csv, reproduction.md and plots/ for the figures with errors, and\n"
        "reproduction-maps.csv, reproduction-maps.md and maps/ for those shown by grid maps and\n"
        "counts. Stopped, it goes on where it was when it is started again. See\n"
        "docs/reproduction.md and docs/reproduction-maps.md.");
    command
        ->add_option(
            "--only", options->reproduction.only,
            "Only these figures: a number (10.85), a world or a parameter; may be repeated")
        ->allow_extra_args(false);
    command->add_option("--runs", options->reproduction.runs,
                        "Runs of each value of the figures with errors, with seeds from 1: 1 to "
                        "10000 (default: 5); "
                        "those of grid maps have a number of their own");
    command
        ->add_option("--threads", options->reproduction.threads,
                     "Runs at a time (default: as many as the machine has); results do not depend "
                     "on it")
        ->check(CLI::Range(0, 256));
    command
        ->add_option("--out", options->out,
                     "Folder for the results, made if missing (default: out/reproduction, for a "
                     "reading out/reproduction-NAME)")
        ->check(&complaint_of_output);
    command
        ->add_option("--report", options->report,
                     "Write the document here too, and that of the maps as …-maps.md, each "
                     "with its pictures in a folder beside it")
        ->check(&complaint_of_output);
    command->add_option("--logs", options->reproduction.logs,
                        "Folder of recorded tours, NAME.log.gz with NAME.gt.tum.gz, to put the "
                        "questions of the thesis's recorded tours to (aces, freiburg-101)");
    auto* reading = command->add_option(
        "--reading", options->reading,
        "Suppose this of the thesis's simulator and program: " + reading_names());
    command
        ->add_flag("--as-published", options->as_published,
                   "The reading that agrees best with the thesis: " + reading_as_published().name)
        ->excludes(reading);
    command->add_flag("--hypotheses", options->hypotheses,
                      "Try every other reading too and set them side by side in the document");
    command
        ->add_option("--world", options->reproduction.world,
                     "KEY=VALUE: change one value of the worlds (docs/simulation.md); may be "
                     "repeated")
        ->allow_extra_args(false);
    command
        ->add_option("--set", options->reproduction.settings,
                     "KEY=VALUE: change one parameter beside the thesis's; may be repeated")
        ->allow_extra_args(false);
    add_report_option(*command, options->json);
    command->callback([options] {
        const int status = reproduce(*options);
        if (status != 0) throw CLI::RuntimeError(status);
    });
}

}  // namespace hitos::cli
