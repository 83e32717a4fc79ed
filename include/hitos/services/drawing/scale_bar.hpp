// SPDX-License-Identifier: GPL-3.0-or-later
// What the scale bars of all pictures share.
#pragma once

#include "hitos/services/drawing/vector_drawing.hpp"

namespace hitos {

/// Size of the letters in pictures [pixels].
inline constexpr double kPictureLetters = 12.0;

/// The greatest of 1, 2, 5 times a power of ten that is at most `limit` > 0.
double round_length(double limit);

/// Adds a black bar of a round length, at most `longest` pixels, with that length in words above
/// it. Returns the x at which the longer of the two ends.
double add_scale_bar(VectorDrawing& drawing, const Point2& lower_left, double longest,
                     double pixels_per_m);

}  // namespace hitos
