// SPDX-License-Identifier: GPL-3.0-or-later
// What the document of a reproduction says besides its figures.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "hitos/workbench/reproduction.hpp"

namespace hitos {

/// How the experiments were done.
std::string reproduction_introduction(const Reading& reading);
/// Where the outcome differs from the thesis's, by parameter, and which of the readings tried
/// explains it; computed from the rows. `tried` have the figures of the reproduction, or are none.
std::string differences_text(const Reproduction& reproduction, std::span<const Reproduction> tried);
/// The readings whose score is within three points of the best: those to be looked at more closely.
std::vector<Reading> close_readings(std::span<const Reproduction> tried);
/// The tables of the readings, first those with as many runs as the reproduction, then those with
/// more, and the summary of the one that is as published; empty without any.
std::string readings_text(const Reproduction& reproduction, std::span<const Reproduction> tried);

}  // namespace hitos
