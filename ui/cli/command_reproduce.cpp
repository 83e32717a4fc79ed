// hitos-cli reproduce: the synthetic experiments of the thesis, run again.

#include <fmt/core.h>

#include <memory>
#include <string>

#include "commands.hpp"
#include "hitos/base/error.hpp"
#include "hitos/workbench/reproduction.hpp"
#include "progress_line.hpp"

namespace hitos::cli {
namespace {

constexpr int kSomeFailed = 2;

struct CommandOptions {
    ReproductionOptions reproduction;
    std::string out = "out/reproduction";
    std::string report;
    std::string reading = "plain";
    bool as_published = false;
    double wall_pixels = 0.0;
    double motion_factor = 1.0;
    bool variances = false;
    std::vector<std::string> world;
    std::vector<std::string> settings;
};

int reproduce(CommandOptions options) {
    options.reproduction.out = options.out;
    Reading& reading = options.reproduction.reading;
    reading = options.as_published ? reading_as_published() : find_reading(options.reading);
    reading.world.insert(reading.world.end(), options.world.begin(), options.world.end());
    reading.settings.insert(reading.settings.end(), options.settings.begin(),
                            options.settings.end());
    if (options.wall_pixels > 0.0) reading.wall_pixels = options.wall_pixels;
    reading.motion_factor *= options.motion_factor;
    reading.variances |= options.variances;
    ProgressLine line("runs");
    bool begun = false;
    std::size_t finished = 0;
    options.reproduction.observer = [&](const StudyProgress& progress) {
        if (!begun) {
            line.say(fmt::format("{} runs to do, {} found done", progress.runs, progress.reused));
            begun = true;
        }
        if (!progress.failure.empty()) line.say("run failed: " + progress.failure);
        finished = progress.finished;
        line.show(progress.finished, progress.fraction,
                  fmt::format("run {} of {}: {}", progress.running_number, progress.runs,
                              progress.running));
    };
    const Reproduction result = hitos::reproduce(options.reproduction);
    if (begun) line.finish(finished);
    if (result.computed + result.reused == result.failures.size()) {
        throw Error("every run failed; the first: " + result.failures.front());
    }
    if (!options.report.empty()) {
        write_report(result, options.report, options.reproduction.out / "plots");
    }
    if (!result.plot_problem.empty()) {
        fmt::print(stderr, "no plots: {}; their scripts are in {}\n", result.plot_problem,
                   (options.reproduction.out / "plots").string());
    }
    fmt::print("{} runs done, {} found done, {} failed: {}\n",
               result.computed - result.failures.size(), result.reused, result.failures.size(),
               (options.reproduction.out / "reproduction.md").string());
    for (const std::string& failure : result.failures) {
        fmt::print(stderr, "failed: {}\n", failure);
    }
    return result.failures.empty() ? 0 : kSomeFailed;
}

}  // namespace

void add_reproduce(CLI::App& program) {
    auto options = std::make_shared<CommandOptions>();
    CLI::App* command = program.add_subcommand(
        "reproduce", "Run the synthetic experiments of the thesis again and compare");
    command->footer(
        "Writes reproduction.csv, reproduction.md and plots/. Stopped, it goes on where it was "
        "when\n"
        "it is started again. See docs/reproduction.md.");
    command
        ->add_option(
            "--only", options->reproduction.only,
            "Only these figures: a number (10.85), a world or a parameter; may be repeated")
        ->allow_extra_args(false);
    command->add_option("--runs", options->reproduction.runs,
                        "Runs of each value, with seeds from 1 (default: 5)");
    command
        ->add_option("--threads", options->reproduction.threads,
                     "Runs at a time (default: as many as the machine has); results do not depend "
                     "on it")
        ->check(CLI::NonNegativeNumber);
    command->add_option("--out", options->out,
                        "Folder for the results, made if missing (default: out/reproduction)");
    command->add_option("--report", options->report,
                        "Write the document here too, with its pictures in a folder beside it");
    command->add_option("--reading", options->reading, "reading");
    command->add_flag("--as-published", options->as_published, "best reading");
    command->add_option("--wall-pixels", options->wall_pixels, "");
    command->add_option("--motion-factor", options->motion_factor, "");
    command->add_flag("--variances", options->variances, "");
    command->add_option("--world", options->world, "")->allow_extra_args(false);
    command->add_option("--set", options->settings, "")->allow_extra_args(false);
    command->callback([options] {
        const int status = reproduce(*options);
        if (status != 0) throw CLI::RuntimeError(status);
    });
}

}  // namespace hitos::cli
