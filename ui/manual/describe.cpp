// SPDX-License-Identifier: GPL-3.0-or-later
#include "describe.hpp"

#include <filesystem>
#include <string>

#include "command.hpp"
#include "completions.hpp"
#include "hitos/base/atomic_file.hpp"
#include "hitos/base/text_input.hpp"
#include "pages.hpp"

namespace hitos::manual {
namespace {

namespace fs = std::filesystem;

std::string prose_of(const std::string& page, const fs::path& folder) {
    const fs::path file = folder / (page + ".md");
    return fs::exists(file) ? input::read_text(file) : "";
}

void describe(const CLI::App& app, const fs::path& folder, const fs::path& prose) {
    const Command program = command_of(app);
    for (const char* part : {"man", "bash", "fish"}) fs::create_directories(folder / part);
    for (const Command* command : whole_family(program)) {
        const std::string page = page_name(*command);
        write_file(folder / "man" / (page + ".1"), command_page(*command, prose_of(page, prose)));
        if (command->below == "parameters") {
            write_file(folder / "man" / "hitos.cfg.5",
                       configuration_page(prose_of("hitos.cfg", prose)));
        }
    }
    write_file(folder / "bash" / program.words, bash_completion(program));
    write_file(folder / "fish" / (program.words + ".fish"), fish_completion(program));
}

}  // namespace

void add_description(CLI::App& program) {
    CLI::Option* prose = program.add_option("--prose")->group("");
    program
        .add_option_function<std::string>("--describe",
                                          [&program, prose](const std::string& folder) {
                                              describe(program, folder, prose->as<std::string>());
                                              throw CLI::Success();
                                          })
        ->group("");
}

}  // namespace hitos::manual
