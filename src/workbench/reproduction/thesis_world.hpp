// The thesis's worlds as the reproduction drives through them.
#pragma once

#include <string>

#include "hitos/services/study/study.hpp"
#include "hitos/simulation/worlds/world.hpp"
#include "hitos/workbench/readings.hpp"

namespace hitos {

/// A shipped world with the noise of the reproduction and what the reading changes.
World thesis_world(const std::string& name, const Reading& reading);

/// Its tours, each with the noise of a run's seed.
StudySource driven_through(World world);

/// What tells its runs from those of another noise, reading or world: for Study::setting.
std::string world_setting(const World& world, const Reading& reading);

}  // namespace hitos
