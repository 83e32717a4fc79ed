// SPDX-License-Identifier: GPL-3.0-or-later
// Range limits of lasers that leave hardly a reading, or are swapped.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "hitos/capture/tour_finding.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "ros/laser_fan.hpp"

namespace hitos {

/// Watches the scans of each laser as they are received.
class RangeLimits {
  public:
    void note(const MountedScan& scan, const std::string& topic);
    void tell(const ReadOptions& options, std::vector<TourFinding>& found) const;

  private:
    struct Laser {
        std::uint64_t readings = 0;
        std::uint64_t too_near = 0;
        std::uint64_t walls_beyond = 0;
        double farthest_m = 0.0;
        double least_m = 0.0;
        double greatest_m = 0.0;
        bool swapped = false;
    };
    std::map<std::string, Laser> lasers_;  ///< by topic
};

}  // namespace hitos
