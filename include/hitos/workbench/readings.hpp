// SPDX-License-Identifier: GPL-3.0-or-later
// Readings of what the thesis leaves unsaid of its simulator and its program, to be tried.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/services/configuration/configuracion.hpp"
#include "hitos/simulation/worlds/world.hpp"

namespace hitos {

/// One reading: what it changes of the worlds and of the configurations of the plain reproduction.
struct Reading {
    std::string name;                        ///< as `hitos-cli reproduce --reading` says it
    std::string sentence;                    ///< what is supposed
    std::vector<std::string> world = {};     ///< "key=value" of world files
    std::vector<std::string> settings = {};  ///< "key=value" of configurations
    /// Thickness of the drawn walls in pixels of the thesis's pictures, which are 3.2 cm on its
    /// world of 40 x 20 m and 1.8 cm on those of 20 x 10 m [T 10.3.1]; 0: as `world` says.
    double wall_pixels = 0.0;
    /// The motion noise of the tables times this.
    double motion_factor = 1.0;
    /// The motion noise of the tables, and of the odometry, as variances: the thesis's words.
    bool variances = false;
};

/// All of them, the plain one first.
std::span<const Reading> readings();
/// Throws ConfigError ("--reading") that lists the names.
const Reading& find_reading(std::string_view name);
/// The one that agrees best with the thesis's figures.
const Reading& reading_as_published();

/// Throws ConfigError for what a world or a configuration refuses.
void apply(const Reading& reading, World& world);
void apply(const Reading& reading, Configuracion& configuration);
/// Everything that the reading changes, for the identity of runs; empty where it changes nothing.
std::string text_of(const Reading& reading);

}  // namespace hitos
