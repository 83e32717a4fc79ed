// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to say of a graph from a file.
#pragma once

#include <QString>

#include "workers/graph_solver.hpp"

namespace hitos::window {

/// How great it is and how it was solved; null: it is being read.
QString graph_words(const ShownGraph* graph, bool busy);

}  // namespace hitos::window
