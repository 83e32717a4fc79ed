// SPDX-License-Identifier: GPL-3.0-or-later
// What of a log was skipped, and why.
#pragma once

#include "hitos/capture/tour_reader.hpp"

class QString;
class QWidget;

namespace hitos::window {

/// Opens a window with the damaged lines that the report names; the run goes on beside it.
void show_skipped_lines(QWidget* parent, const QString& file, const ReadReport& report);

}  // namespace hitos::window
