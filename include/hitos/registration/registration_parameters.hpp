// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of registration, one entry for each.
#pragma once

#include <span>

#include "hitos/base/parameter.hpp"
#include "hitos/registration/registration_params.hpp"

namespace hitos {

std::span<const Parameter<RegistrationParams>> registration_parameters();

}  // namespace hitos
