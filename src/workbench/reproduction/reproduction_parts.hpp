// SPDX-License-Identifier: GPL-3.0-or-later
// What the reproductions of figures and of maps share: the thesis's worlds as they are driven
// through, how studies are run, documents with pictures beside them.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hitos/services/study/study.hpp"
#include "hitos/simulation/worlds/world.hpp"
#include "hitos/workbench/reproduction.hpp"

namespace hitos {

/// A shipped world with the noise of the reproduction and what the reading changes.
World thesis_world(const std::string& name, const Reading& reading);

/// Its tours, each with the noise of a run's seed.
StudySource driven_through(World world);

/// What tells its runs from those of another noise, reading or world: for Study::setting.
std::string world_setting(const World& world, const Reading& reading);

/// The call's reading with what the call changes beside it.
Reading whole_reading(const ReproductionOptions& options);

/// Runs them as one study in the folder of the call, which must be locked, and clears away what
/// stopped writers left there and in its folder of pictures.
std::vector<StudyOutcome> run_as_one(const std::vector<Study>& studies,
                                     const ReproductionOptions& options, const char* pictures);

/// The number in that format, where there is one.
std::string text_or(const std::optional<double>& number, const char* format, const char* otherwise);

/// Writes the document, and beside it, in a folder of its stem, those of the pictures that are
/// there; `text` is given the folder as the document names it.
void write_with_pictures(const std::filesystem::path& document,
                         const std::filesystem::path& pictures,
                         const std::vector<std::string>& stems,
                         const std::function<std::string(const std::string&)>& text);

}  // namespace hitos
