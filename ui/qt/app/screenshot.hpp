// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the window for documents and tests.
#pragma once

#include "actions/command_line.hpp"

namespace hitos::window {

class MainWindow;
class Session;

/// Runs the steps, waits until everything is drawn, and writes the picture. Throws hitos::Error.
void take_screenshot(MainWindow& window, Session& session, const CommandLine& line);

}  // namespace hitos::window
