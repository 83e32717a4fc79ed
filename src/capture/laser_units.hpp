// SPDX-License-Identifier: GPL-3.0-or-later
// Units in which lasers' drivers may tell ranges by mistake.
#pragma once

#include <array>

#include "hitos/base/translatable.hpp"

namespace hitos {

struct LengthUnit {
    double metres;
    const char* name;  ///< to be translated
};

inline constexpr LengthUnit kMillimetre{0.001, HITOS_TEXT("Errors", "millimetres")};
inline constexpr LengthUnit kCentimetre{0.01, HITOS_TEXT("Errors", "centimetres")};
inline constexpr std::array kLengthUnits{
    LengthUnit{0.0001, HITOS_TEXT("Errors", "tenths of a millimetre")}, kMillimetre, kCentimetre,
    LengthUnit{0.0254, HITOS_TEXT("Errors", "inches")},
    LengthUnit{0.3048, HITOS_TEXT("Errors", "feet")}};

/// So much more of the points has to fit by the odometry than if it had driven nowhere, for a scale
/// of the ranges to be known by it.
inline constexpr double kWayShown = 0.1;

}  // namespace hitos
