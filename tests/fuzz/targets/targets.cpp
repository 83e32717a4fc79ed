// SPDX-License-Identifier: GPL-3.0-or-later
#include "targets.hpp"

#include <array>

namespace hitos::fuzz {

std::span<const Target> targets() {
    static constexpr std::array kTargets{
        // Those that are fed least in a second first, so that the others can make up for them.
        Target{"assignment", check_assignment},
        Target{"study_values", check_study_values},
        Target{"study_plan", check_study_plan},
        Target{"study_record", check_study_record},
        Target{"summary", check_summary},
        Target{"drawing", check_drawing},
        Target{"world", check_world},
        Target{"world_edits", check_world_edits},
        Target{"gzip", check_gzip},
        Target{"rosbag", check_rosbag},
        Target{"mcap", check_mcap},
        Target{"db3", check_db3},
        Target{"foxglove", check_foxglove},
        Target{"player", check_player},
        Target{"radish", check_radish},
        Target{"carmen", check_carmen},
        Target{"normalized", check_normalized},
        Target{"configuration", check_configuration},
        Target{"figures", check_figures},
        Target{"graph", check_graph},
        Target{"picture", check_picture},
        Target{"map_server", check_map_server},
        Target{"distances", check_distances},
        Target{"relations", check_relations},
        Target{"segments", check_segments},
        Target{"trajectory", check_trajectory},
        Target{"map", check_map},
    };
    return kTargets;
}

}  // namespace hitos::fuzz
