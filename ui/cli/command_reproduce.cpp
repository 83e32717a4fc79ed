// hitos-cli reproduce: the synthetic experiments of the thesis, run again.

#include <fmt/core.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "hitos/base/error.hpp"
#include "hitos/workbench/reproduction.hpp"
#include "progress_line.hpp"

namespace hitos::cli {
namespace {

constexpr int kSomeFailed = 2;

struct CommandOptions {
    ReproductionOptions reproduction;
    std::string out;
    std::string report;
    std::string reading = readings().front().name;
    bool as_published = false;
    bool hypotheses = false;
    std::vector<std::string> world;
    std::vector<std::string> settings;
};

/// The reading that was asked for, with the changes of this call.
Reading reading_of(const CommandOptions& options) {
    Reading reading = options.as_published ? reading_as_published() : find_reading(options.reading);
    reading.world.insert(reading.world.end(), options.world.begin(), options.world.end());
    reading.settings.insert(reading.settings.end(), options.settings.begin(),
                            options.settings.end());
    if (!options.world.empty() || !options.settings.empty()) {
        reading.name += "-changed";
        reading.sentence += ", with changes of this call";
    }
    return reading;
}

/// Runs of one reading, told on a line of its own.
class Teller {
  public:
    StudyObserver observer() {
        return [this](const StudyProgress& progress) {
            if (!begun_) {
                line_->say(
                    fmt::format("{} runs to do, {} found done", progress.runs, progress.reused));
                begun_ = true;
            }
            if (!progress.failure.empty()) line_->say("run failed: " + progress.failure);
            finished_ = progress.finished;
            line_->show(progress.finished, progress.fraction,
                        fmt::format("run {} of {}: {}", progress.running_number, progress.runs,
                                    progress.running));
        };
    }
    void begin(const Reading& reading) {
        finish();
        line_.emplace("runs");
        line_->say("reading " + reading.name);
    }
    void finish() {
        if (begun_) line_->finish(finished_);
        begun_ = false;
    }

  private:
    std::optional<ProgressLine> line_{std::in_place, "runs"};
    bool begun_ = false;
    std::size_t finished_ = 0;
};

std::string names() {
    std::string text;
    for (const Reading& reading : readings()) {
        text += (text.empty() ? "" : ", ") + reading.name;
    }
    return text;
}

int reproduce(CommandOptions options) {
    Reading& reading = options.reproduction.reading;
    reading = reading_of(options);
    const bool plain = text_of(reading).empty();
    if (options.out.empty()) {
        options.out = plain ? "out/reproduction" : "out/reproduction-" + reading.name;
    }
    options.reproduction.out = options.out;
    Teller teller;
    options.reproduction.observer = teller.observer();
    const Reproduction result = hitos::reproduce(options.reproduction);
    std::vector<Reproduction> tried;
    if (options.hypotheses) {
        tried =
            try_readings(options.reproduction, [&](const Reading& next) { teller.begin(next); });
    }
    teller.finish();
    if (result.computed + result.reused == result.failures.size()) {
        throw Error("every run failed; the first: " + result.failures.front());
    }
    if (!options.report.empty()) {
        write_report(result, options.report, options.reproduction.out / "plots", tried);
    }
    if (!result.plot_problem.empty()) {
        fmt::print(stderr, "no plots: {}; their scripts are in {}\n", result.plot_problem,
                   (options.reproduction.out / "plots").string());
    }
    if (!tried.empty())
        write_report(result, options.reproduction.out / "reproduction.md",
                     options.reproduction.out / "plots", tried);
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
                        "Folder for the results, made if missing (default: out/reproduction, for a "
                        "reading out/reproduction-NAME)");
    command->add_option("--report", options->report,
                        "Write the document here too, with its pictures in a folder beside it");
    auto* reading =
        command->add_option("--reading", options->reading,
                            "Suppose this of the thesis's simulator and program: " + names());
    command
        ->add_flag("--as-published", options->as_published,
                   "The reading that agrees best with the thesis: " + reading_as_published().name)
        ->excludes(reading);
    command->add_flag("--hypotheses", options->hypotheses,
                      "Try every other reading too and set them side by side in the document");
    command
        ->add_option("--world", options->world,
                     "KEY=VALUE: change one value of the worlds (docs/simulation.md); may be "
                     "repeated")
        ->allow_extra_args(false);
    command
        ->add_option("--set", options->settings,
                     "KEY=VALUE: change one parameter beside the thesis's; may be repeated")
        ->allow_extra_args(false);
    command->callback([options] {
        const int status = reproduce(*options);
        if (status != 0) throw CLI::RuntimeError(status);
    });
}

}  // namespace hitos::cli
