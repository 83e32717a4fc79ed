// What runs and studies are measured against.
#pragma once

#include <filesystem>
#include <optional>

#include "bindings.hpp"
#include "hitos/services/results/results.hpp"

namespace hitos::python {

/// A path from a TUM file or an N x 4 array; nothing from None.
std::optional<Trajectory> reference_trajectory_of(const py::object& given);

References references_of(const std::optional<std::filesystem::path>& map,
                         const py::object& trajectory,
                         const std::optional<std::filesystem::path>& distances);

}  // namespace hitos::python
