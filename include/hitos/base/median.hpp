// SPDX-License-Identifier: GPL-3.0-or-later
// The middle of a sample.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hitos {

/// The greater of the two middle values where there are two; 0 of none.
template <class Number>
Number median(std::vector<Number> values) {
    if (values.empty()) return Number{};
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

}  // namespace hitos
