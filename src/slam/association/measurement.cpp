// SPDX-License-Identifier: GPL-3.0-or-later
#include "measurement.hpp"

namespace hitos {

void measure(const Observation& observation, const ObservationParams& params, Measurements& out,
             bool known) {
    Matrix2 fixed;
    fixed << params.var_rho_m2, 0.0, 0.0, params.var_theta_rad2;
    out.clear();
    for_each_kind([&]<class S>() {
        for (std::size_t i = 0; i < S::count(observation); ++i) {
            Measurement measured = S::observed(observation, i, fixed);
            if (!known) measured.identity = kNameless;
            out.add<S>(measured);
        }
    });
}

void note_reaches(const Observation& observation, bool sided, KindRow<SeenReach>& out) {
    out.clear();
    for_each_kind([&]<class S>() {
        for (std::size_t i = 0; i < S::count(observation); ++i) {
            SeenReach reach = S::reach(observation, i);
            reach.sided = sided;
            out.add<S>(reach);
        }
    });
}

}  // namespace hitos
