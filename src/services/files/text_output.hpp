// What the writers of small text files share.
#pragma once

namespace hitos {

/// Zero without its sign; every other value as it is.
inline double without_sign_of_zero(double value) {
    return value == 0.0 ? 0.0 : value;
}

}  // namespace hitos
