// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/features/line_methods.hpp"

#include "ransac_lines.hpp"
#include "split_and_merge.hpp"

namespace hitos {

Registry<LineMethodEntry>& line_methods() {
    static Registry<LineMethodEntry> registry("line method", "features.method",
                                              {split_and_merge_method(), ransac_method()});
    return registry;
}

}  // namespace hitos
