// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a grid may be written cell by cell.
#pragma once

#include "hitos/services/grid/grid.hpp"

namespace hitos {

/// Throws Error where a grid of many cells is next to empty, as one is that reaches to something
/// far off: a file of all its cells would be hundreds of megabytes of nothing. Pictures, which are
/// packed and shrunk, are not concerned.
void check_written_cells(const Grid& grid);

}  // namespace hitos
