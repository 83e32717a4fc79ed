// SPDX-License-Identifier: GPL-3.0-or-later
// What became of an observed feature, and why, in words.
#pragma once

#include <QString>

#include "hitos/slam/association_record.hpp"

namespace hitos::window {

/// "Matched with 5", "New: 7", "Ignored"; landmarks of the map by their places, from 1, or by their
/// identities. The map is that after so many scans, as the associations are.
QString outcome_words(const Association& association, const LandmarkMap& map, std::uint64_t scans);
/// A sentence.
QString reason_words(Association::Reason reason);
QString standing_words(Standing standing);

}  // namespace hitos::window
