#include "hitos/services/drawing/scale_bar.hpp"

#include <cmath>
#include <initializer_list>

namespace hitos {

double round_length(double limit) {
    const double power = std::pow(10.0, std::floor(std::log10(limit)));
    for (const double factor : {5.0, 2.0}) {
        if (factor * power <= limit) return factor * power;
    }
    return power;
}

}  // namespace hitos
