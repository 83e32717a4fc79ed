// hitos-cli compare: finished runs side by side.

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "commands.hpp"
#include "hitos/base/atomic_file.hpp"
#include "hitos/base/folder_entries.hpp"
#include "hitos/base/input_files.hpp"
#include "hitos/services/results/run_comparison.hpp"
#include "report.hpp"

namespace hitos::cli {
namespace {

constexpr const char* kStandardOutput = "-";

struct CompareOptions {
    std::vector<std::string> runs;
    std::string form = "markdown";
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

void compare(const CompareOptions& options) {
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
    report.end();
}

}  // namespace

void add_compare(CLI::App& program) {
    auto options = std::make_shared<CompareOptions>();
    CLI::App* command = program.add_subcommand(
        "compare", "Set finished runs side by side: settings that differ, and their figures");
    command->add_option("runs", options->runs, "Folders of runs")->required()->expected(1, -1);
    command
        ->add_option("--as", options->form, "Form of the table: markdown (default), latex or csv")
        ->check(CLI::IsMember({"markdown", "latex", "csv"}));
    command->add_option("--out", options->out,
                        "File for the table, in place of standard output (-)");
    add_report_option(*command, options->json);
    command->callback([options] { compare(*options); });
}

}  // namespace hitos::cli
