// The options that say how a log is to be read, which both programs have.
#pragma once

#include <CLI/CLI.hpp>

#include "hitos/workbench/configuration_choices.hpp"

namespace hitos::manual {

void add_topic_options(CLI::App& program, TopicChoices& choices);

}  // namespace hitos::manual
