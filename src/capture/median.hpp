// The middle of a sample.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hitos {

/// The greater of the two middle values where there are two; 0 of none.
inline double median(std::vector<float> values) {
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return static_cast<double>(*middle);
}

}  // namespace hitos
