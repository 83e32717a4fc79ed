// SPDX-License-Identifier: GPL-3.0-or-later
// What was wrong with a log, in words for the terminal.
#pragma once

#include <string>

#include "hitos/capture/tour_reader.hpp"

namespace hitos::cli {

/// A line for each kind of damage; empty where there is none.
std::string damage_text(const ReadReport& report);

}  // namespace hitos::cli
