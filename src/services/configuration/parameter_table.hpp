// SPDX-License-Identifier: GPL-3.0-or-later
// The table behind parameters().
#pragma once

#include <vector>

#include "hitos/services/configuration/config_parameter.hpp"

namespace hitos {

/// Every parameter of Configuracion, group by group; keys of one TOML table stand together.
std::vector<ConfigParameter> make_parameter_table();

}  // namespace hitos
