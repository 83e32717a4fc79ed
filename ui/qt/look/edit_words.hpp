// SPDX-License-Identifier: GPL-3.0-or-later
// Changes by hand of a run's graph, in words.
#pragma once

#include <QString>

#include "hitos/registration/graph_edit.hpp"

namespace hitos::window {

/// "Refused: scan 378 has not come back to 12", by the numbers that the window shows.
QString change_in_words(const GraphEdit& edit);

}  // namespace hitos::window
