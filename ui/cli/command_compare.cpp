// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli compare: finished runs side by side; the first scan in which two runs differ.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/folder_entries.hpp"
#include "hitos/base/input_files.hpp"
#include "hitos/base/plural.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/services/results/run_comparison.hpp"
#include "hitos/services/run/step_hashes.hpp"
#include "report.hpp"

namespace hitos::cli {
namespace {

constexpr const char* kStandardOutput = "-";
constexpr const char* kForm = "markdown";

struct CompareOptions {
    std::vector<std::string> runs;
    std::string form = kForm;
    std::string out;
    bool json = false;
};

const std::map<std::string, std::string (*)(const TextTable&)>& forms() {
    static const std::map<std::string, std::string (*)(const TextTable&)> by_word{
        {"markdown", &markdown}, {"latex", &latex}, {"csv", &csv}};
    return by_word;
}

/// A table in the place of a run's own file would end the run.
void check_out(const CompareOptions& options) {
    std::vector<std::filesystem::path> inputs;
    for (const std::string& run : options.runs) {
        std::error_code told_later;
        for (const auto& entry : folder_entries(run, told_later)) inputs.push_back(entry.path());
    }
    const std::filesystem::path out = options.out;
    check_apart({&out, 1}, inputs);
}

constexpr int kDiffer = 2;  // the program's status

/// Two files that run --hashes has written.
void compare_hashes(const CompareOptions& options) {
    if (!options.out.empty() || options.form != kForm) {
        throw ConfigError(options.out.empty() ? "--as" : "--out",
                          verbatim("is for folders of runs; of two tables of hashes one line tells "
                                   "where they differ"));
    }
    const std::vector<std::string>& names = options.runs;
    if (names.size() != 2) {
        throw Error(verbatim(fmt::format(
            "found {}; expected two that hitos-cli run --hashes has written, or folders",
            plural(names.size(), "file"))));
    }
    const std::optional<StepDifference> found = first_difference(
        input::read_text(names[0]), names[0], input::read_text(names[1]), names[1]);
    Report report(options.json);
    report.object() = {{"same", !found}};
    if (!found) {
        report.say("the same after every scan, to the last bit\n");
    } else {
        report.object().update({{"scan", found->scan}, {"part", found->part}});
        if (found->part == "scan") {
            report.say("the same up to scan {}, where one of them ends\n", found->scan);
        } else {
            report.say("they differ from scan {} on, first in: {}\n", found->scan, found->part);
        }
    }
    report.end();
    if (found) throw CLI::RuntimeError(kDiffer);
}

void compare(const CompareOptions& options) {
    if (std::ranges::any_of(options.runs, [](const std::string& run) {
            return std::filesystem::is_regular_file(run);
        })) {
        compare_hashes(options);
        return;
    }
    if (!options.out.empty() && options.out != kStandardOutput) check_out(options);
    const RunComparison comparison =
        compare_runs(std::vector<std::filesystem::path>(options.runs.begin(), options.runs.end()));
    Report report(options.json);
    TextTable table = comparison_table(comparison);
    // For people the narrower way; programs know the columns by their names.
    if (options.form != "csv" && table.rows.size() < table.head.size()) table = transposed(table);
    const std::string text = forms().at(options.form)(table);
    if (options.out.empty() || options.out == kStandardOutput) {
        report.say("{}", text);
    } else {
        write_file(options.out, text);
    }
    report.object() = parsed_object(comparison_json(comparison));
    for (const ComparedRun& one : comparison.runs) {
        for (const std::string& doubt : one.run.reference_doubts)
            report.warn(fmt::format("{}: {}", one.name, doubt));
    }
    report.end();
}

}  // namespace

void add_compare(CLI::App& program) {
    auto options = std::make_shared<CompareOptions>();
    CLI::App* command = program.add_subcommand(
        "compare", "Set finished runs side by side: settings that differ, and their figures");
    command
        ->add_option("runs", options->runs,
                     "Folders of runs; or two files that run --hashes has written: the first scan "
                     "in which they differ, and status 2 where they do")
        ->required()
        ->expected(1, -1);
    command
        ->add_option("--as", options->form, "Form of the table: markdown (default), latex or csv")
        ->check(CLI::IsMember({"markdown", "latex", "csv"}));
    command->add_option("--out", options->out,
                        "File for the table, in place of standard output (-)");
    add_report_option(*command, options->json);
    command->callback([options] { compare(*options); });
}

}  // namespace hitos::cli
