// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/workbench/presets.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/translatable.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/procesador.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/simulation/worlds/world.hpp"
#include "hitos/workbench/shipped_data.hpp"

namespace hitos {

namespace {

std::string_view preset_of_world(const std::string& path) {
    try {
        const World world = read_world(path);
        if (world.landmarks.told()) return kLandmarkPreset;
        if (world.landmarks.round()) return kTreePreset;
        // People, and what stands about as they do: it makes landmarks of its own.
        if (!world.walkers.empty()) return kRobotPreset;
    } catch (const Error&) {  // whoever opens it is told
    }
    return kWorldPreset;
}

/// Whether the first scan that shows anything shows landmarks.
bool shows_landmarks(std::unique_ptr<Fuente> log) {
    constexpr int kLookedAt = 20;
    Procesador reader(std::move(log), {});
    for (int i = 0; i < kLookedAt; ++i) {
        const std::optional<Scan> scan = reader.next_scan();
        if (!scan || !scan->empty()) return scan && !scan->landmarks.empty();
    }
    return false;
}

}  // namespace

std::span<const Preset> presets() {
    static const std::array table{
        Preset{"simulated", HITOS_TEXT("Preset", "Simulated tours"),
               HITOS_TEXT("Preset",
                          "FastSLAM for worlds of walls and their laser of 10 mm: lines fitted to "
                          "all points, noise that grows with the motion."),
               PresetPurpose::worlds},
        Preset{"thesis", HITOS_TEXT("Preset", "As the thesis"),
               HITOS_TEXT("Preset",
                          "FastSLAM with the parameters of the thesis's final experiments, on "
                          "worlds with a laser of 3 mm."),
               PresetPurpose::worlds},
        Preset{"ekf", HITOS_TEXT("Preset", "EKF-SLAM"),
               HITOS_TEXT("Preset",
                          "EKF-SLAM with lines by RANSAC, each with the covariance of its own "
                          "points, for worlds and exact lasers."),
               PresetPurpose::worlds},
        Preset{"paper", HITOS_TEXT("Preset", "As the paper"),
               HITOS_TEXT("Preset",
                          "EKF-SLAM to the letter of the paper that it comes from: lines alone, "
                          "one gate, noise in proportion to the way."),
               PresetPurpose::worlds},
        Preset{"recorded", HITOS_TEXT("Preset", "Recorded tours"),
               HITOS_TEXT("Preset",
                          "Scans registered with what was seen before, loops closed, FastSLAM "
                          "about that path: one configuration for every building."),
               PresetPurpose::logs},
        Preset{"recorded-fastslam1", HITOS_TEXT("Preset", "Recorded tours without registration"),
               HITOS_TEXT("Preset",
                          "FastSLAM 1.0 alone on logs of real robots: noise that grows with the "
                          "motion, gaps that end a line."),
               PresetPurpose::logs},
        Preset{"landmarks", HITOS_TEXT("Preset", "Landmarks with names"),
               HITOS_TEXT("Preset",
                          "FastSLAM for sensors that tell landmarks by themselves, posts or codes, "
                          "and say which one they see."),
               PresetPurpose::logs},
        Preset{"trees", HITOS_TEXT("Preset", "Trees and posts"),
               HITOS_TEXT("Preset",
                          "FastSLAM for parks and orchards: trees and posts as circles in the "
                          "scans of a laser that sees far."),
               PresetPurpose::worlds},
    };
    return table;
}

std::string preset_words() {
    std::vector<std::string_view> words;
    for (const Preset& preset : presets()) words.push_back(preset.word);
    return fmt::format("{}", fmt::join(words, ", "));
}

const Preset& find_preset(std::string_view word) {
    const auto found = std::ranges::find(presets(), word, &Preset::word);
    if (found != presets().end()) return *found;
    throw ConfigError("--preset", HITOS_TEXT("Errors", "found '%1', expected one of %2"), word,
                      preset_words());
}

Configuracion preset_configuration(std::string_view word) {
    return ArchivoConfiguracion::read(
        needed_file(fmt::format("config/{}.cfg", find_preset(word).word)));
}

std::string_view suited_preset(const std::string& source) {
    if (is_world_file(source)) return preset_of_world(source);
    if (source.empty()) return {};
    try {
        const LogFormat* format = recording_format(source);
        if (format == nullptr) {
            std::unique_ptr<Fuente> log = open_log(source);
            format = &log->format();
            if (format->landmarks && shows_landmarks(std::move(log))) return kLandmarkPreset;
        }
        if (format->of_robots) return kRobotPreset;
    } catch (const FileError&) {
        throw;  // else one that is read the next time is run with other values, and nobody is told
    } catch (const Error&) {  // whoever opens it is told
    }
    return {};
}

Configuracion suited_configuration(const std::string& source) {
    const std::string_view preset = suited_preset(source);
    return preset.empty() ? Configuracion() : preset_configuration(preset);
}

}  // namespace hitos
