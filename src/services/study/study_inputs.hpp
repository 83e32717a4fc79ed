// SPDX-License-Identifier: GPL-3.0-or-later
// The files that a study's runs are made of.
#pragma once

#include <filesystem>
#include <vector>

#include "hitos/services/study/study.hpp"

namespace hitos::study {

/// Log by log, where the log is what varies.
std::vector<std::vector<std::filesystem::path>> input_files(const Study& study);
/// Those of all logs.
std::vector<std::filesystem::path> all_input_files(const Study& study);

}  // namespace hitos::study
