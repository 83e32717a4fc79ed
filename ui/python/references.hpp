// SPDX-License-Identifier: GPL-3.0-or-later
// What runs and studies are measured against.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "bindings.hpp"
#include "hitos/services/results/results.hpp"

namespace hitos::python {

/// A map from a file, a path from a TUM file or an N x 4 array, distances from a file; files are
/// taken for what they hold. Nothing from None.
References references_of(const std::optional<std::filesystem::path>& map,
                         const py::object& trajectory,
                         const std::optional<std::filesystem::path>& distances = {});

/// Warns in Python's way.
void warn(const std::string& words);
void tell(const Advice& doubt);

}  // namespace hitos::python
