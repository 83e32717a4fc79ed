// SPDX-License-Identifier: GPL-3.0-or-later
#include "ros/range_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "remedies.hpp"

namespace hitos {

void RangeLimits::note(const MountedScan& scan, const std::string& topic) {
    Laser& laser = lasers_[topic];
    laser.readings += scan.readings;
    laser.too_near += scan.too_near;
    laser.walls_beyond += scan.walls_beyond.count;
    laser.farthest_m = std::max(laser.farthest_m, scan.walls_beyond.farthest_m);
    laser.least_m = scan.least_range_m;
    laser.greatest_m = scan.fan.max_range_m;
    laser.swapped = laser.swapped || scan.swapped_limits;
}

void RangeLimits::tell(const ReadOptions& options, std::vector<TourFinding>& found) const {
    constexpr double kMost = 0.8;
    constexpr double kNoLimit = 10.0;  // times what is said: of no such laser
    const auto metres = [](double range) { return fmt::format("{:.4g}", range); };
    for (const auto& [topic, laser] : lasers_) {
        const double share =
            static_cast<double>(laser.too_near) / static_cast<double>(laser.readings);
        if (laser.swapped) {
            found.push_back(
                {TourFinding::Kind::blind_laser,
                 0.0,
                 message(
                     HITOS_TEXT("Errors",
                                "%1 says that its least range is %2 m and its greatest %3 m; they "
                                "are taken the other way round, as no reading lies between them"),
                     topic, metres(laser.greatest_m), metres(laser.least_m)),
                 {{marked(HITOS_TEXT(
                     "Errors",
                     "let the driver say range_min and range_max the right way round"))}}});
        } else if (share > kMost) {
            found.push_back(
                {TourFinding::Kind::blind_laser,
                 share,
                 message(HITOS_TEXT("Errors",
                                    "%1 % of the readings of %2 are nearer than the least range of "
                                    "%3 m that it says, and are no points"),
                         std::lround(100.0 * share), topic, metres(laser.least_m)),
                 {{marked(HITOS_TEXT("Errors", "let the driver say the laser's own range_min"))}}});
        }
        const double beyond =
            static_cast<double>(laser.walls_beyond) / static_cast<double>(laser.readings);
        if (laser.swapped || options.max_range_m > 0.0 || !(beyond > WallsBeyond::kMost)) continue;
        found.push_back(
            {TourFinding::Kind::blind_laser,
             beyond,
             message(HITOS_TEXT("Errors",
                                "%1 % of the readings of %2 lie beyond the greatest range of %3 m "
                                "that it says, where they go on from ray to ray as walls do, and "
                                "are no points"),
                     std::lround(100.0 * beyond), topic, metres(laser.greatest_m)),
             {laser.farthest_m > kNoLimit * laser.greatest_m
                  ? Remedy{marked(HITOS_TEXT(
                        "Errors", "look what they are: intensities, or of another unit"))}
                  : Remedy{marked(HITOS_TEXT("Errors", "take them")),
                           set("source.max_range", metres(std::ceil(laser.farthest_m)))}}});
    }
}

}  // namespace hitos
