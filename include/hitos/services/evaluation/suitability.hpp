// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a tour and its configuration suit each other, judged by what the run saw.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/features/control.hpp"
#include "hitos/services/configuration/configuracion.hpp"
#include "hitos/slam/slam_filter.hpp"

namespace hitos {

/// What a run shows of the match between tour and configuration; all 0 before the first scan.
struct SuitabilityFigures {
    double step_m = 0.0;     ///< mean way by odometry between scans, where the robot moved
    double scatter_m = 0.0;  ///< rms distance of the lines' points from their lines
    double unmatched = 0.0;  ///< share of observations that the best map did not know
    double empty = 0.0;      ///< share of the scans with points that show no feature
};

/// The preset that makes landmarks of trees and posts.
inline constexpr std::string_view kTreePreset = "trees";

/// A reason to take another configuration.
struct Advice {
    std::string_view text;    ///< translated in the context "Advice"; %1 stands for the figure
    std::string figure;       ///< with its unit: "0.54 m", "31 %"
    std::string_view preset;  ///< to try, or empty
    bool by_hand = false;     ///< of the changes by hand of the graph

    /// The text in English, with the preset to try.
    std::string words() const;
};

/// Adds up the figures step by step.
class Suitability {
  public:
    /// One scan: what was driven since the one before, whether it has `points`, what was seen, what
    /// became of it.
    void note(std::span<const Control> controls, bool points, const Observation& seen,
              std::span<const Association> associations);
    void clear() { *this = {}; }

    SuitabilityFigures figures() const;
    /// What speaks plainly against the configuration, if anything; nothing in the first scans,
    /// which say too little. `simulated` tours are given the presets for worlds.
    std::vector<Advice> advice(const Configuracion& configuration, bool simulated) const;

  private:
    std::uint64_t scans_ = 0;
    std::uint64_t with_points_ = 0;
    std::uint64_t empty_ = 0;
    std::uint64_t moves_ = 0;
    double way_m_ = 0.0;
    std::uint64_t points_ = 0;
    double distance2_m2_ = 0.0;
    std::uint64_t observed_ = 0;
    std::uint64_t matched_ = 0;
};

}  // namespace hitos
