// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in the folder that a run is to write into.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "hitos/services/configuration/configuracion.hpp"

namespace hitos::cli {

/// Throws FileError where the folder holds the results of another run: of another source or with
/// other parameters than the configuration's, threads aside, or of one that cannot be known; or a
/// file of nobody's run that this one, with the outputs `also`, would write over; or, of the same
/// run, files that this one, with these `options`, would not write.
void refuse_another_run(const std::filesystem::path& folder, const Configuracion& configuration,
                        std::span<const std::string> also, std::span<const std::string> options);

/// Of a run that was stopped: whether the folder holds one to its tour's end, of which it does not
/// take the place. Says so.
bool tell_kept(const std::filesystem::path& folder);

}  // namespace hitos::cli
