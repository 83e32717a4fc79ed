// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "key_graph.hpp"

namespace hitos::test {

/// Keys a metre apart on a straight line; variances of a step as given.
inline KeyGraph line_of(std::size_t count, double variance_m2, double variance_rad2) {
    KeyGraph graph;
    for (std::size_t i = 0; i < count; ++i) {
        KeyScan scan;
        scan.travelled_m = static_cast<double>(i);
        scan.variance_m2 = variance_m2;
        scan.variance_rad2 = variance_rad2;
        graph.add({{static_cast<double>(i), 0.0, 0.0}, i}, scan);
    }
    return graph;
}

}  // namespace hitos::test
