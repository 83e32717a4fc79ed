// SPDX-License-Identifier: GPL-3.0-or-later
// How the window begins: what its command line names is opened in it.
#pragma once

#include "actions/command_line.hpp"

namespace hitos::window {

class MainWindow;
class Session;

/// Whether somebody looks, who can be told what is wrong and goes on without it.
enum class Audience { somebody, nobody };

/// Opens the log, configuration, results, graph and distances that are named; a user who names none
/// is offered ways to begin. Throws hitos::Error where nobody looks.
void open_named(MainWindow& window, const CommandLine& line, Audience audience);

/// Opens the study and starts the run that are asked for, in a window that is there.
void begin(MainWindow& window, Session& session, const CommandLine& line);

}  // namespace hitos::window
