// The descriptions of all parameters as translation sources.
#pragma once

#include <span>

namespace hitos::window {

std::span<const char* const> parameter_descriptions();

}  // namespace hitos::window
