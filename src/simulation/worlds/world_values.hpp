// SPDX-License-Identifier: GPL-3.0-or-later
// Setting a world's values by key, for the two readers of them.
#pragma once

#include <string_view>

#include "hitos/base/message.hpp"
#include "hitos/simulation/worlds/world.hpp"
#include "hitos/simulation/worlds/world_key.hpp"

namespace hitos::world_values {

/// The key's description. Throws ConfigError that names near keys where there is none.
const WorldKey& find(std::string_view key);

/// What may stand there: "0 to 1 m", "a whole number, 1 to 1000".
Message allowed(const WorldKey& key);

/// Sets the value; throws ConfigError that says what is allowed.
void set_number(World& world, const WorldKey& key, double value);
void set_word(World& world, const WorldKey& key, std::string_view word);

}  // namespace hitos::world_values
