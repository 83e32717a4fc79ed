// SPDX-License-Identifier: GPL-3.0-or-later
// Negative evidence: which landmarks a scan looks through.
#pragma once

#include <cstdint>
#include <vector>

#include "hitos/capture/scan.hpp"
#include "models/sensor.hpp"

namespace hitos {

/// What a scan says of a landmark that was not found in it.
enum class Sight {
    unknown,  ///< out of view, behind something, or in too few rays to tell
    missing   ///< rays pass through where it should be
};

/// A scan as rays from the laser, the same for all particles. A ray without a reading says nothing:
/// it may have met nothing as well as a wall that does not reflect.
class FreeSpace {
  public:
    /// Replaces what it knew; of a dense scan every second, third, ... reading is taken.
    void set(const Scan& scan);
    /// Of the laser in the world where the robot is at `pose`.
    Pose laser(const Pose& pose) const { return compose(pose, mounting_); }

    /// Whether rays that meet the line inside its extent pass through it: nine tenths at the least,
    /// and five, of those that nothing hides. Nothing is known of a line whose extent is not.
    Sight sight(const Pose& laser, const Recta& line, const Extent& extent) const;
    /// Whether all rays that pass the corner nearby go beyond it, and two at the least.
    Sight sight(const Pose& laser, const Esquina& corner, const Extent& extent) const;

  private:
    struct Ray {
        double cosine = 1.0;  ///< of its bearing in the laser's frame
        double sine = 0.0;
        double range = 0.0;
    };
    std::vector<Ray> rays_;
    Pose mounting_;
};

}  // namespace hitos
