// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli presets: the configurations that come with Hitos.

#include <memory>

#include "commands.hpp"
#include "hitos/workbench/presets.hpp"
#include "report.hpp"

namespace hitos::cli {

void add_presets(CLI::App& program) {
    CLI::App* command =
        program.add_subcommand("presets", "List the configurations for --preset and their purpose");
    auto json = std::make_shared<bool>(false);
    add_report_option(*command, *json);
    command->callback([json] {
        Report report(*json);
        for (const Preset& preset : presets()) {
            const char* made_for = preset.made_for == PresetPurpose::worlds ? "worlds" : "logs";
            report.say("{:<10} {:<7} {}\n", preset.word, made_for, preset.purpose);
            report.object()["presets"].push_back(
                {{"name", preset.word}, {"made_for", made_for}, {"purpose", preset.purpose}});
        }
        report.end();
    });
}

}  // namespace hitos::cli
