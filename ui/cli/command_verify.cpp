// hitos-cli verify: whether a folder of results is whole.

#include <fmt/core.h>

#include <memory>
#include <string>
#include <vector>

#include "commands.hpp"
#include "hitos/services/run/results_check.hpp"

namespace hitos::cli {
namespace {

void tell(const std::vector<std::string>& files, const char* what) {
    for (const std::string& file : files) fmt::print("{}: {}\n", file, what);
}

void verify(const std::string& folder) {
    const ResultsCheck check = check_results(folder);
    tell(check.missing, "missing");
    tell(check.changed, "changed since it was written, or of another run");
    tell(check.left_over, "left over: not of this run");
    if (!check.whole()) throw CLI::RuntimeError(1);
    fmt::print("whole: {} files as they were written\n", check.files);
}

}  // namespace

void add_verify(CLI::App& program) {
    auto folder = std::make_shared<std::string>();
    CLI::App* command = program.add_subcommand(
        "verify", "Check a folder of results: files missing, changed or left over");
    command->footer("Ends with status 0 where all files are as run wrote them, else with 1.");
    command->add_option("folder", *folder, "Folder that run or Save all results has written")
        ->required();
    command->callback([folder] { verify(*folder); });
}

}  // namespace hitos::cli
