// SPDX-License-Identifier: GPL-3.0-or-later
// What a run writes only where it is asked to.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hitos {

/// A file that a run writes where it is asked for, or several that belong together.
struct OptionalOutput {
    std::string word;                ///< by which it is asked for
    std::vector<std::string> files;  ///< by each of which it is too
    std::string purpose;             ///< half a sentence for help texts
};

/// All of them, in the order in which they are written.
std::vector<OptionalOutput> optional_outputs();

/// The words of what a list names with commas between, each once: "map.svg,g2o", or "all". Throws
/// ConfigError of `option` for a name that none has, with the nearest ones and with all there are.
std::vector<std::string> chosen_outputs(std::string_view list, const std::string& option);

}  // namespace hitos
