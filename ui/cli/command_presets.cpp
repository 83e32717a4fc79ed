// hitos-cli presets: the configurations that come with Hitos.

#include <fmt/core.h>

#include "commands.hpp"
#include "hitos/workbench/presets.hpp"

namespace hitos::cli {

void add_presets(CLI::App& program) {
    CLI::App* command =
        program.add_subcommand("presets", "List the configurations for --preset and their purpose");
    command->callback([] {
        for (const Preset& preset : presets())
            fmt::print("{:<10} {:<7} {}\n", preset.word,
                       preset.made_for == PresetPurpose::worlds ? "worlds" : "logs",
                       preset.purpose);
    });
}

}  // namespace hitos::cli
