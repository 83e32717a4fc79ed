// SPDX-License-Identifier: GPL-3.0-or-later
// The greatest of many readings, and whether they are a code for "no return".
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace hitos {

/// Counts readings within half a metre of the greatest one, by the millimetre.
class GreatestRanges {
  public:
    /// Of that ray of its scan [m]; one that is not finite is none.
    void note(double range_m, std::size_t ray);

    /// What they are, and how many.
    struct Code {
        double range_m = 0.0;   ///< greatest
        double least_m = 0.0;   ///< that counts as the same, to three millimetres
        std::size_t times = 0;  ///< how often it came
    };
    /// The greatest, where it is repeated as no real distance would be. A code comes over and over,
    /// on many rays. A far corner seen by a robot at rest repeats its distance too, but on a ray or
    /// two, and a far wall repeats others just below.
    std::optional<Code> code() const;

    /// The same of lasers each of whose rays has a code of its own, as after a calibration: where a
    /// quarter of the rays repeat their greatest reading, to a millimetre, and hardly anything just
    /// below it. The greatest and least of these codes, and how often they came.
    std::optional<Code> codes_of_rays() const;

    /// How many readings lie beyond, by whole decimetres.
    std::size_t beyond(double range_m) const;

  private:
    struct OfRay {
        double greatest_m = 0.0;
        std::size_t times = 0;
        std::size_t below = 0;  ///< within half a metre
    };
    std::vector<OfRay> by_ray_;
    struct Counted {
        double range_m = 0.0;  ///< greatest
        double least_m = 0.0;
        std::size_t times = 0;
        std::set<std::size_t> rays = {};  ///< some of them
    };
    std::map<long, Counted> by_millimetre_;
    std::map<long, std::size_t> by_decimetre_;
};

}  // namespace hitos
