// SPDX-License-Identifier: GPL-3.0-or-later
// The configurations that come with Hitos, by name.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "hitos/services/configuration/configuracion.hpp"
#include "hitos/services/evaluation/suitability.hpp"

namespace hitos {

/// What a preset is for.
enum class PresetPurpose { worlds, logs };

/// One of config/*.cfg.
struct Preset {
    std::string_view word;     ///< "simulated": what --preset takes, and config/simulated.cfg
    std::string_view label;    ///< translated in the context "Preset"
    std::string_view purpose;  ///< a sentence, translated in the context "Preset"
    PresetPurpose made_for = PresetPurpose::worlds;
};

/// All of them, the one for a first try at the front.
std::span<const Preset> presets();

/// The word that leaves the choice to the source; no preset has it.
inline constexpr std::string_view kAutoPreset = "auto";

/// What a world has where nobody chooses, what the recording of a robot has, what either has whose
/// sensor tells landmarks by itself; a world of trees has kTreePreset.
inline constexpr std::string_view kWorldPreset = "simulated";
inline constexpr std::string_view kRobotPreset = "recorded";
inline constexpr std::string_view kLandmarkPreset = "landmarks";

/// The preset of a world file, of a log whose first scans are of landmarks, or of a log or
/// recording whose beginning is of a format that robots write. Empty where the source is another
/// log, or is none, which whoever opens it is told: the defaults. Throws FileError where it cannot
/// be read.
std::string_view suited_preset(const std::string& source);

/// The parameters of the suited preset, else the defaults; they name no source. Throws FileError
/// where the source cannot be read, or the preset's file did not come with the program.
Configuracion suited_configuration(const std::string& source);

/// "simulated, thesis, …", for help texts and messages.
std::string preset_words();

/// Throws ConfigError that names the presets where there is none of that word.
const Preset& find_preset(std::string_view word);

/// The preset's parameters; it names no source. Throws ConfigError for a word that is none, and
/// FileError where its file did not come with the program.
Configuracion preset_configuration(std::string_view word);

}  // namespace hitos
