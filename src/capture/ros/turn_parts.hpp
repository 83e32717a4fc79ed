// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a turn that could not be joined.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "hitos/capture/tour_finding.hpp"
#include "ros/laser_fan.hpp"

namespace hitos {

/// Watches what is handed out of each laser: a fan that changes from scan to scan, and never is a
/// turn, is a part of one that has not met the others.
class TurnParts {
  public:
    void note(const MountedScan& scan, const std::string& topic);
    void tell(std::vector<TourFinding>& found) const;

  private:
    struct Laser {
        Fan last;
        std::uint64_t scans = 0;
        std::uint64_t parts = 0;
        double apart_rad = 0.0;  ///< the ends of the last two that did not meet
    };
    std::map<std::string, Laser> lasers_;  ///< by topic
};

}  // namespace hitos
