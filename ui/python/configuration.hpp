// SPDX-License-Identifier: GPL-3.0-or-later
// Configurations as Python gives them.
#pragma once

#include <string>

#include "bindings.hpp"
#include "hitos/services/configuration/configuracion.hpp"

namespace hitos::python {

/// A value as texts of parameters say it: 0.1, 100, on, "recorded".
std::string text_of(const py::handle& value);

/// A dict of a world's values, or None, as source.world_set says it.
std::string world_set_of(const py::object& values);

/// What a run of the source has: a Configuration or a dict of values as they are; None or a dict
/// begins with the defaults, for a world with the preset for worlds.
Configuracion configuration_from(const py::object& given, const std::string& source);

}  // namespace hitos::python
