// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a world file that are lists of tables: commands, events, people, doors.
#pragma once

#include <toml++/toml.h>

#include <filesystem>

#include "hitos/simulation/worlds/world.hpp"

namespace hitos::world_lists {

/// The point that the node is, within kFarthest of the origin. `name` says whose, for the
/// FormatError of any other node.
Point2 read_point(const std::filesystem::path& path, const toml::node& node, const Message& name);

/// Each adds what the node lists to the world. They throw FormatError, with the line, for what it
/// cannot be.
void read_commands(World& world, const std::filesystem::path& path, const toml::node& node);
void read_events(World& world, const std::filesystem::path& path, const toml::node& node);
void read_people(World& world, const std::filesystem::path& path, const toml::node& node);
void read_landmarks(World& world, const std::filesystem::path& path, const toml::node& node);
void read_radii(World& world, const std::filesystem::path& path, const toml::node& node);
void read_doors(World& world, const std::filesystem::path& path, const toml::node& node);

/// Throws FormatError for events of doors that are not there, with the line.
void check_events(const World& world, const std::filesystem::path& path);

}  // namespace hitos::world_lists
