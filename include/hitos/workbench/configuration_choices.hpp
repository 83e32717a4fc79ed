// SPDX-License-Identifier: GPL-3.0-or-later
// Single values that a user asks for, over a configuration.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hitos/capture/tour_finding.hpp"
#include "hitos/services/configuration/configuracion.hpp"

namespace hitos {

/// --set, --edits, --map, --localise, --world-set, --seed, --tour-seed and --threads.
struct ValueChoices {
    std::vector<std::string> assignments;  ///< "key=value"
    std::optional<std::uint64_t> seed = {};
    std::optional<int> threads = {};
    std::optional<std::uint64_t> tour_seed = {};
    std::string edits = {};  ///< file of the graph's changes by hand; empty: none
    std::vector<std::string> world_assignments = {};  ///< "key=value", of a world's values
    std::string map = {};   ///< folder of a run to go on with; empty: none
    std::string near = {};  ///< "x,y,degrees" in it; empty: anywhere
    bool localise = false;  ///< in that map, which stays as it is
};

/// The assignments over the configuration, in order, then the others; those of a world are put
/// behind what source.world_set says already. All checked. Throws ConfigError.
void choose_values(Configuracion& configuration, const ValueChoices& choices);

/// What a finding advises.
void take_up(const std::vector<SourceSetting>& settings, SourceParams& source);

/// --scan-topic, --odom-topic, --same-frames, --laser-pose and --scan-delay.
struct TopicChoices {
    std::string scan_topic = {};
    std::string odom_topic = {};
    std::string same_frames = {};
    std::string laser_pose = {};
    std::string scan_delay = {};  ///< seconds, or a clock's text

    /// Over what the configuration says, where they are given. Throws ConfigError.
    void choose(SourceParams& source) const;
};

/// Throws ConfigError where a choice is given that none of the sources heeds: --scan-topic,
/// --odom-topic and --same-frames are of ROS recordings, --world-set and --tour-seed of worlds.
/// What a configuration says beside them is for whatever source there is. Of one that is not there
/// whoever opens it is told.
void expect_used(const ValueChoices& values, const TopicChoices& topics,
                 const std::vector<std::string>& sources);

/// What is wrong with the text of a seed; empty: nothing. A number with a sign would else be taken
/// for a very great one.
std::string complaint_of_seed(const std::string& text);

}  // namespace hitos
