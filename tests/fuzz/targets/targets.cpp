#include "targets.hpp"

#include <array>

namespace hitos::fuzz {

std::span<const Target> targets() {
    static constexpr std::array kTargets{
        Target{"player", check_player},
        Target{"radish", check_radish},
        Target{"normalized", check_normalized},
        Target{"carmen", check_carmen},
        Target{"gzip", check_gzip},
        Target{"configuration", check_configuration},
        Target{"world", check_world},
        Target{"drawing", check_drawing},
        Target{"map", check_map},
        Target{"segments", check_segments},
        Target{"distances", check_distances},
        Target{"trajectory", check_trajectory},
        Target{"study_plan", check_study_plan},
        Target{"study_record", check_study_record},
        Target{"summary", check_summary},
        Target{"assignment", check_assignment},
        Target{"study_values", check_study_values},
        Target{"figures", check_figures},
    };
    return kTargets;
}

}  // namespace hitos::fuzz
