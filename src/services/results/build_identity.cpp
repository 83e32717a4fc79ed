// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "hitos/services/results/results.hpp"
#include "source_digest.hpp"
#include "version.hpp"

namespace hitos {

// In a file of its own, which every change of any source compiles anew.
std::string build_identity() {
    return fmt::format("{} {}", kSourceDigest, kBuild);
}

}  // namespace hitos
