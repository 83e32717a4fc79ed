// SPDX-License-Identifier: GPL-3.0-or-later
#include "joint_association.hpp"

namespace hitos {

void JointAssociation::begin(double probability) {
    search_.begin(probability);
    logs_.clear();
    known_.clear();
}

bool JointAssociation::decide(const Associator& associator, std::span<Decision> decisions) {
    const bool whole = search_.run(distance_);
    for (std::size_t i = 0; i < search_.observations(); ++i) {
        if (const JointCandidate* pairing = search_.paired(i)) {
            decisions[i] = {Association::Outcome::matched, Association::Reason::together,
                            static_cast<std::uint32_t>(pairing->landmark), logs_[pairing->place]};
            continue;
        }
        double best_log = BestTwo::kNothing;
        for (const JointCandidate& candidate : search_.candidates(i)) {
            best_log = std::max(best_log, logs_[candidate.place]);
        }
        decisions[i] = search_.candidates(i).empty()
                           ? associator.fits_none()
                           : associator.kept_out(best_log, Association::Reason::left_over);
    }
    for (const auto& [i, decision] : known_) decisions[i] = decision;
    return whole;
}

}  // namespace hitos
