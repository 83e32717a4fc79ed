// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two particle filters believe the same.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "fastslam/filtro_particulas.hpp"

namespace hitos {

/// All that a filter believes after a tour, to the last bit.
inline void expect_same(const FiltroParticulas& a, const FiltroParticulas& b,
                        std::size_t particles) {
    const std::vector<WeightedPose> ours = a.hypotheses();
    const std::vector<WeightedPose> theirs = b.hypotheses();
    for (std::size_t i = 0; i < particles; ++i) {
        ASSERT_EQ(ours[i].pose, theirs[i].pose) << i;
        ASSERT_EQ(ours[i].weight, theirs[i].weight) << i;
        const LandmarkMap map = a.map(i);
        const LandmarkMap other = b.map(i);
        ASSERT_EQ(map.size(), other.size());
        for (std::size_t k = 0; k < map.size(); ++k) {
            ASSERT_EQ(map[k].value, other[k].value);
            ASSERT_EQ(map[k].point(), other[k].point());
            ASSERT_EQ(map[k].covariance, other[k].covariance);
        }
    }
}

}  // namespace hitos
