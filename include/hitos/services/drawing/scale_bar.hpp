// What the scale bars of all pictures share.
#pragma once

namespace hitos {

/// The greatest of 1, 2, 5 times a power of ten that is at most `limit` > 0.
double round_length(double limit);

}  // namespace hitos
