// The configurations that come with Hitos, by name.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "hitos/services/configuration/configuracion.hpp"

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

/// What a world has where nobody chooses.
inline constexpr std::string_view kWorldPreset = "simulated";

/// "simulated, thesis, …", for help texts and messages.
std::string preset_words();

/// Throws ConfigError that names the presets where there is none of that word.
const Preset& find_preset(std::string_view word);

/// The preset's parameters; it names no source. Throws ConfigError for a word that is none, and
/// FileError where its file did not come with the program.
Configuracion preset_configuration(std::string_view word);

}  // namespace hitos
