// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli study: one log, values of parameters, several runs of each.

#include <fmt/core.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "commands.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/process.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "options.hpp"
#include "study_console.hpp"

namespace hitos::cli {
namespace {

struct StudyArguments {
    ConfigurationOptions configuration;
    StudyRunOptions runs;
    std::string log;
    SourceOptions source;
    std::string reference;
    std::vector<std::string> vary;
    std::string shard;
    std::string out;
};

struct MergeOptions {
    std::string out;
    std::vector<std::string> shards;
    SummaryForm form;
};

void require(const std::string& value, const char* name, const char* what) {
    if (value.empty()) {
        throw ConfigError("study", verbatim(fmt::format("{} is missing: {}", name, what)));
    }
}

StudyShard shard_of(const StudyArguments& options) {
    if (!options.shard.empty()) return parse_shard(options.shard);
    return scheduler_shard(process_environment()).value_or(StudyShard{});
}

int study(StudyArguments options) {
    require(options.log, "LOG", "the log file to study");
    require(options.out, "--out", "the folder for the results");
    options.runs.first_seed = options.configuration.values.seed.value_or(1);
    options.runs.threads = options.configuration.values.threads.value_or(0);

    Study study;
    if (options.log == "-") {
        throw ConfigError("study", verbatim("reads its log for every run and goes on with it "
                                            "another day; found standard input, give a file"));
    }
    const std::string source = source_named(options.log);
    const std::string_view suited = suited_preset(options.configuration, source);
    study.configuration = load(options.configuration, suited);
    fmt::print(stderr, "{}", suited_words(suited, source));
    study.configuration.source.file = source;
    options.source.choose(study.configuration.source);
    std::vector<std::string> sources{source};
    for (const std::string& assignment : options.vary) {
        const StudyParameter& varied =
            study.parameters.emplace_back(parse_study_parameter(assignment));
        if (varied.keys.front() != "source.file") continue;
        for (const StudyValue& value : varied.values) sources.push_back(value.front());
    }
    expect_used(options.configuration.values, options.source.topics, sources);
    check_values(study.configuration, study.parameters);
    study.layout = study_in_folder(options.out);
    apply(options.runs, options.reference, study);
    return conduct(study, options.runs, shard_of(options));
}

int merge(const MergeOptions& options) {
    const StudyLayout layout = study_in_folder(options.out);
    std::vector<StudyLayout> shards;
    for (const std::string& folder : options.shards) shards.push_back(study_in_folder(folder));
    return report(merge_study(layout, shards), layout, options.form);
}

/// The exit status of a command that has said all there is to say.
void leave(int status) {
    if (status != 0) throw CLI::RuntimeError(status);
}

std::string figures_list() {
    std::string text;
    for (const Measure* measure : taken_measures()) {
        if (!measure->detail) text += fmt::format("  {:<20} {}\n", measure->word, measure->purpose);
    }
    text.pop_back();
    return text;
}

void add_merge(CLI::App& study) {
    auto options = std::make_shared<MergeOptions>();
    CLI::App* command = study.add_subcommand(
        "merge", "Put the shards of a study together: tables and plots as one process makes them");
    command->add_option("out", options->out, "Folder of the whole study")
        ->required()
        ->check(&complaint_of_output);
    command->add_option("shards", options->shards,
                        "Folders of the shards, where each had its own (default: all of them "
                        "wrote to OUT)");
    add_summary_form(*command, options->form);
    command->callback([options] { leave(merge(*options)); });
}

}  // namespace

void add_study(CLI::App& program) {
    auto options = std::make_shared<StudyArguments>();
    CLI::App* command = program.add_subcommand(
        "study", "Run values of parameters several times each and measure the maps");
    command->footer(
        "A study that was stopped goes on where it was when it is started again. In a Slurm or\n"
        "Grid Engine job array every task does its shard. See docs/studies.md, docs/cluster.md.\n\n"
        "Figures of every run, where there is what they are measured against:\n" +
        figures_list());
    command->add_option("log", options->log,
                        "Log, plain or .gz, ROS recording or world to simulate");
    add_source_options(*command, options->source);
    command->add_option("--reference", options->reference,
                        "Reference map to measure against (without: the paths and how crisp the "
                        "grid maps are)");
    command
        ->add_option("--vary", options->vary,
                     "Values of a parameter, e.g. split_merge.dmax=0.01,0.02 or p=10:100:10 or "
                     "sensor=0.04/0.00122,0.01/0.0006; given twice: every pair")
        ->type_name("NAME=VALUES")
        ->allow_extra_args(false);
    add_study_options(*command, options->runs);
    add_configuration_options(*command, options->configuration);
    command->get_option("--seed")->description("First seed of each value (default: 1)");
    command->get_option("--threads")
        ->description("Runs at a time, " + allowed_threads() +
                      " (default: 0, as many as the machine has); results do not depend on it");
    command->add_option("--shard", options->shard,
                        "Do part i of n only, e.g. 2/8 (default: what the job array says, else "
                        "all); study merge puts the parts together");
    command->add_option("--out", options->out, "Folder for the results, made if missing")
        ->check(&complaint_of_output);
    add_merge(*command);
    command->callback([options, command] {
        if (!command->got_subcommand("merge")) leave(study(*options));
    });
}

}  // namespace hitos::cli
