// What helps where the odometry does not say how the robot moved.
#pragma once

#include "hitos/base/message.hpp"

namespace hitos {

inline Message take_it_from_scans() {
    return marked(HITOS_TEXT("Errors",
                             "take how it moved from the scans, where they show enough for that: "
                             "--set source.odometry=scans"));
}

}  // namespace hitos
