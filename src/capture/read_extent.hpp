// SPDX-License-Identifier: GPL-3.0-or-later
// How much of its file a source reads, as the options say.
#pragma once

#include "hitos/capture/tour_reader.hpp"
#include "regular_file.hpp"

namespace hitos {

/// What is decided before the first scan is decided by this; all, where the log did not come in
/// live.
inline FileExtent opening_extent(const ReadOptions& options) {
    return options.opening_bytes > 0 ? FileExtent{options.opening_bytes} : FileExtent{};
}

/// All of it, also what is still to come.
inline FileExtent whole_extent(const ReadOptions& options) {
    return {.growth = options.growth};
}

}  // namespace hitos
