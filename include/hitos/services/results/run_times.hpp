// SPDX-License-Identifier: GPL-3.0-or-later
// Where the processor time of a run goes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hitos/registration/registration.hpp"
#include "hitos/services/run/stage_seconds.hpp"

namespace hitos {

/// Where the processor time of a run went [s].
struct RunTimes {
    /// What one output took.
    struct File {
        std::string name;  ///< of the output's first file
        double seconds = 0.0;
    };
    double before = 0.0;  ///< until the run was there: the log was looked through
    StageSeconds stages{};
    std::optional<RegistrationClock::Seconds> registration;  ///< parts of its stage
    double judging = 0.0;                                    ///< what the summary says of the run
    std::vector<File> files;
    double all = 0.0;  ///< of the whole program until then, with its other threads
};

}  // namespace hitos
