// SPDX-License-Identifier: GPL-3.0-or-later
// The options that say how a log is to be read and into which map, which both programs have.
#pragma once

#include <CLI/CLI.hpp>

#include "hitos/workbench/configuration_choices.hpp"

namespace hitos::manual {

void add_topic_options(CLI::App& program, TopicChoices& choices);
/// The map of an earlier run.
void add_map_options(CLI::App& program, ValueChoices& choices);

}  // namespace hitos::manual
