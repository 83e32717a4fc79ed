// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/math/distributions/chi_squared.hpp>

#include "hitos/services/evaluation/nees.hpp"

namespace hitos {

NeesInterval nees_interval(int values, int degrees) {
    constexpr double kBeside = 0.025;  // on either side
    const double of = values;
    const boost::math::chi_squared sum(of * degrees);
    return {boost::math::quantile(sum, kBeside) / of,
            boost::math::quantile(boost::math::complement(sum, kBeside)) / of};
}

}  // namespace hitos
