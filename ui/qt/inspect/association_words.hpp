// What became of an observed feature, and why, in words.
#pragma once

#include <QString>

#include "hitos/slam/association_record.hpp"

namespace hitos::window {

/// "Matched with landmark 5", "New landmark 7", "Ignored".
QString outcome_words(const Association& association);
/// A sentence.
QString reason_words(Association::Reason reason);
QString standing_words(Standing standing);

}  // namespace hitos::window
