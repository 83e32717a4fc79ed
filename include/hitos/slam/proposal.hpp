// SPDX-License-Identifier: GPL-3.0-or-later
// Where a particle filter draws its particles' new poses [T table 3.2].
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "hitos/base/random_row.hpp"
#include "hitos/base/registry.hpp"
#include "hitos/slam/params.hpp"
#include "hitos/slam/slam_filter.hpp"

namespace hitos {

/// A particle's map, for the proposals of Hitos that heed landmarks
/// (src/slam/models/map_store.hpp).
class ParticleMap;

/// A particle before it moves.
struct Hypothesis {
    Pose pose;  ///< of the robot in the world
    const ParticleMap& map;
};

/// A drawn pose. Where it is not drawn from the motion model, `log_weight` says what that does to
/// the particle's weight: ln of the motion model's density over the proposal's.
struct ProposedPose {
    Pose pose;
    double log_weight = 0.0;
};

/// The distribution from which particles draw.
class Proposal {
  public:
    virtual ~Proposal() = default;

    /// Begins a step: what is the same for all particles is done here, once. At the `first` step
    /// there is nothing to be uncertain about, and draw() draws no noise: it would only turn the
    /// map. `input` is valid until the step's last draw.
    virtual void begin(const SlamInput& input, bool first) = 0;

    /// Draws for one particle; called from several threads at a time.
    virtual ProposedPose draw(const Hypothesis& before, RandomStream& random) const = 0;

    /// The same for at most NormalRow::kMost particles at once, each with its stream, where neither
    /// maps nor weights play a part. False, and the poses as they were, where that is not so.
    virtual bool draw_row(std::span<Pose> /*poses*/, const RandomRow& /*row*/) const {
        return false;
    }
};

/// A proposal as parameters name it.
struct ProposalEntry : RegistryEntry {
    std::function<std::unique_ptr<Proposal>(const FilterParams&)> make;
};

/// Those that the program knows: "motion", "posterior" and what was added.
Registry<ProposalEntry>& proposals();

}  // namespace hitos
