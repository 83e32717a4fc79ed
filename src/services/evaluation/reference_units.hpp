// SPDX-License-Identifier: GPL-3.0-or-later
// Units that references come in instead of metres.
#pragma once

#include <array>
#include <string_view>

#include "hitos/base/translatable.hpp"

namespace hitos {

struct ReferenceUnit {
    double per_metre = 1.0;
    std::string_view of_trajectory;  ///< says that one is in it, and how many times too large
    std::string_view of_map;         ///< likewise, and how many landmarks lie near
};

inline constexpr std::array kReferenceUnits{
    ReferenceUnit{
        1000.0,
        HITOS_TEXT("Advice",
                   "The reference trajectory is %1 times as large as the path: it is in "
                   "millimetres; divide its positions by 1000. Errors against it are none "
                   "of the path's."),
        HITOS_TEXT("Advice",
                   "The reference map is in millimetres, where metres are expected: %1 of "
                   "the landmarks lie within a metre of one of it as it is.")},
    ReferenceUnit{
        100.0,
        HITOS_TEXT("Advice",
                   "The reference trajectory is %1 times as large as the path: it is in "
                   "centimetres; divide its positions by 100. Errors against it are none "
                   "of the path's."),
        HITOS_TEXT("Advice",
                   "The reference map is in centimetres, where metres are expected: %1 of "
                   "the landmarks lie within a metre of one of it as it is.")},
    ReferenceUnit{
        1.0 / 0.3048,
        HITOS_TEXT("Advice",
                   "The reference trajectory is %1 times as large as the path: it is in "
                   "feet; multiply its positions by 0.3048. Errors against it are none of "
                   "the path's."),
        HITOS_TEXT("Advice",
                   "The reference map is in feet, where metres are expected: %1 of the "
                   "landmarks lie within a metre of one of it as it is.")}};

}  // namespace hitos
