// SPDX-License-Identifier: GPL-3.0-or-later
// Observations of one scan that would make two landmarks of one wall.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "association.hpp"
#include "measurement.hpp"

namespace hitos {

/// Pieces of one wall that the merge of collinear pieces left apart. Where both are new, the second
/// belongs to the landmark that the first makes: with two, every later observation would be
/// ambiguous. Twins are what the association rule could not tell apart though it knew one of them
/// to the last bit: the one seen from the other is plausible, and its likelihood is above
/// `ambiguity_ratio` of the best there is. Both are of one scan, so the pose plays no part, and one
/// comparison serves every hypothesis.
class ScanTwins {
  public:
    /// `has_p0`: plausible is what is likelier than p0, where the method asks for that; else what
    /// lies inside the gate.
    ScanTwins(const AssociationParams& params, bool has_p0);

    /// Compares the observations of a scan with each other. Replaces what it knew. Where lines are
    /// bounded the `reaches` of the observations tell which may be pieces of one wall.
    void find(const Measurements& seen, const KindRow<SeenReach>* reaches = nullptr);
    /// The first twin before `observation` (places in the row of all kinds) that is new too.
    template <class IsNew>
    std::optional<std::size_t> of(std::size_t observation, const IsNew& is_new) const {
        for (const auto& [first, second] : pairs_) {
            if (second == observation && is_new(first)) return first;
        }
        return std::nullopt;
    }

  private:
    bool plausible(const Likelihood& close) const;

    double margin_;
    double log_p0_;
    double gate_;
    double log_ratio_;
    bool by_likelihood_;
    std::vector<std::pair<std::size_t, std::size_t>> pairs_;  // in the order of both
};

}  // namespace hitos
