// SPDX-License-Identifier: GPL-3.0-or-later
// The one place that decides what a source is, a log or a world to simulate, and what is known of
// it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "hitos/registration/graph_edit.hpp"
#include "hitos/services/configuration/configuracion.hpp"
#include "hitos/services/results/results.hpp"
#include "hitos/simulation/worlds/world.hpp"

namespace hitos {

/// A world file (.toml) is simulated, with the values of source.world_set over its own; anything
/// else is a log. The seed of a world's noise is source.tour_seed, else the world's own, else
/// `run_seed`. Throws what open_source(), read_world() and set_world_value() throw, and ConfigError
/// where a world is to be read in the format of a log. Where source.map names the results of a run,
/// that run's tour, as it was read, comes before it (make_joined_tour()); FileError where they are
/// none, FormatError where expect_results_unchanged() throws it.
std::unique_ptr<TourReader> open_tour(const SourceParams& source, std::uint64_t run_seed = 1);
/// With the configuration's seed. Throws what check_held_map() throws besides.
std::unique_ptr<TourReader> open_tour(const Configuracion& configuration);

/// What a run was run with, to go on with its map: without what is of its tour alone but the
/// changes by hand, which its map is made of. Throws what open_tour() throws of source.map.
Configuracion configuration_to_go_on(const std::string& map);

/// A warning where the tour is one that the map it goes on with (source.map), or a map before that,
/// was made of: by its content, not its name. Else empty.
Message doubt_of_going_on(const SourceParams& source, std::uint64_t run_seed = 1);

/// The changes by hand that either this configuration has or the run of its map, not both, and that
/// name scans of the map's own tour alone: by them that map is another one. Throws what open_tour()
/// throws of source.map.
std::vector<GraphEdit> changes_of_map(const Configuracion& configuration);
/// Throws ConfigError where there are such and the map is to stay as it is (source.hold).
void check_held_map(const Configuracion& configuration);

/// The world of such a source as it is simulated: with the values of source.world_set and the seed.
/// Throws what read_world() and set_world_value() throw.
World open_world(const SourceParams& source, std::uint64_t run_seed = 1);

/// The files by whose content the tour of that source is known: the log, or the world and the
/// drawing of its walls.
std::vector<std::filesystem::path> tour_files(const std::string& file);
/// The same with those of the tours before it.
std::vector<std::filesystem::path> tour_files(const SourceParams& source);

/// Puts the truth that the tour knows where the references name nothing else: its path, and its
/// walls for pictures.
void add_truth(References& references, const std::optional<Truth>& truth);

}  // namespace hitos
