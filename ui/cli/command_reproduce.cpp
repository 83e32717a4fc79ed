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
};

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

/// Whether there were any.
bool tell_failures(const Reproduction& result) {
    for (const std::string& failure : result.failures) {
        fmt::print(stderr, "failed: {}: {}\n", result.reading.name, failure);
    }
    return !result.failures.empty();
}

int reproduce(CommandOptions options) {
    Reading& reading = options.reproduction.reading;
    reading = options.as_published ? reading_as_published() : find_reading(options.reading);
    if (options.out.empty()) {
        options.out = "out/reproduction";
        if (!text_of(reading).empty()) options.out += "-" + reading.name;
    }
    options.reproduction.out = options.out;
    Teller teller;
    options.reproduction.observer = teller.observer();
    const Reproduction result = hitos::reproduce(options.reproduction);
    std::vector<Reproduction> tried;
    if (options.hypotheses) {
        tried = try_readings(options.reproduction, result,
                             [&](const Reading& next) { teller.begin(next); });
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
    fmt::print("{} runs done, {} found done, {} failed: {}\n",
               result.computed - result.failures.size(), result.reused, result.failures.size(),
               (options.reproduction.out / "reproduction.md").string());
    bool failed = tell_failures(result);
    for (const Reproduction& other : tried) failed = tell_failures(other) || failed;
    return failed ? kSomeFailed : 0;
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
        ->add_option("--world", options->reproduction.world,
                     "KEY=VALUE: change one value of the worlds (docs/simulation.md); may be "
                     "repeated")
        ->allow_extra_args(false);
    command
        ->add_option("--set", options->reproduction.settings,
                     "KEY=VALUE: change one parameter beside the thesis's; may be repeated")
        ->allow_extra_args(false);
    command->callback([options] {
        const int status = reproduce(*options);
        if (status != 0) throw CLI::RuntimeError(status);
    });
}

}  // namespace hitos::cli
