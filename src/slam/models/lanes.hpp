// SPDX-License-Identifier: GPL-3.0-or-later
// The filter of one landmark in plain numbers, for loops over many landmarks or particles that
// compilers make vector instructions of. One by one they give the same bits.
#pragma once

#include <cstddef>
#include <limits>

#include "hitos/base/elementary.hpp"

namespace hitos {

/// A pose of the robot in the world.
struct LanePose {
    double x;
    double y;
    double theta;
};

/// A measurement z with its covariance R.
struct LaneObservation {
    double z0;
    double z1;
    double r00;
    double r01;
    double r11;
};

/// What the quick rejection of an observation in a particle needs.
struct NearQuery {
    double z0;
    double cos_world;
    double sin_world;
    double r00;
    double r11;
    double slack;
};

/// The query with its direction, which is given in the robot's frame, turned by the heading.
HITOS_INLINE NearQuery turned(NearQuery query, double cosine, double sine) {
    const double cos_robot = query.cos_world;
    const double sin_robot = query.sin_world;
    query.cos_world = cos_robot * cosine - sin_robot * sine;
    query.sin_world = sin_robot * cosine + cos_robot * sine;
    return query;
}

/// What an observation says against the prediction: nu = z - h with the angle wrapped, H =
/// dh/d(state), P H' and Q = H P H' + R.
struct LaneInnovation {
    double nu0;
    double nu1;
    double ph00;
    double ph01;
    double ph10;
    double ph11;
    double q00;
    double q01;
    double q11;
};

/// P of two components, which stand behind the two of the state in columns.
struct LaneCovariance {
    double p00;
    double p01;
    double p11;

    HITOS_INLINE static LaneCovariance load(const double* from, std::size_t stride) {
        return {from[2 * stride], from[3 * stride], from[4 * stride]};
    }
    HITOS_INLINE void store(double* to, std::size_t stride) const {
        to[2 * stride] = p00;
        to[3 * stride] = p01;
        to[4 * stride] = p11;
    }
};

HITOS_INLINE LaneInnovation innovation_of(double nu0, double nu1, double h00, double h01,
                                          double h10, double h11, const LaneCovariance& p,
                                          const LaneObservation& z) {
    LaneInnovation result{nu0,
                          nu1,
                          p.p00 * h00 + p.p01 * h01,
                          p.p00 * h10 + p.p01 * h11,
                          p.p01 * h00 + p.p11 * h01,
                          p.p01 * h10 + p.p11 * h11,
                          0.0,
                          0.0,
                          0.0};
    result.q00 = h00 * result.ph00 + h01 * result.ph10 + z.r00;
    result.q01 = h00 * result.ph01 + h01 * result.ph11 + z.r01;
    result.q11 = h10 * result.ph01 + h11 * result.ph11 + z.r11;
    return result;
}

/// ln N(nu; 0, Q) [T table 3.1, line 6] and the squared Mahalanobis distance of nu [P eq 2].
struct Likelihood {
    double log_likelihood;
    double mahalanobis_squared;
};

/// The distance as nu' adj(Q) nu / det Q.
HITOS_INLINE Likelihood likelihood_of(const LaneInnovation& i) {
    const double det = i.q00 * i.q11 - i.q01 * i.q01;
    const double d2 =
        (i.q11 * i.nu0 * i.nu0 - 2.0 * i.q01 * i.nu0 * i.nu1 + i.q00 * i.nu1 * i.nu1) / det;
    constexpr double kLn2Pi = 0x1.d67f1c864beb4p0;
    // Where rounding has spoilt Q there is no likelihood.
    const double log_det =
        det > 0.0 ? elementary::log(det) : std::numeric_limits<double>::quiet_NaN();
    return {-kLn2Pi - 0.5 * log_det - 0.5 * d2, d2};
}

/// K = P H' Q^-1, state += K nu, P -= K Q K' (equal to (I - K H) P [T table 3.2]).
HITOS_INLINE void correct(double& state0, double& state1, LaneCovariance& p,
                          const LaneInnovation& i) {
    const double inverse = 1.0 / (i.q00 * i.q11 - i.q01 * i.q01);
    const double k00 = (i.ph00 * i.q11 - i.ph01 * i.q01) * inverse;
    const double k01 = (i.ph01 * i.q00 - i.ph00 * i.q01) * inverse;
    const double k10 = (i.ph10 * i.q11 - i.ph11 * i.q01) * inverse;
    const double k11 = (i.ph11 * i.q00 - i.ph10 * i.q01) * inverse;
    state0 += k00 * i.nu0 + k01 * i.nu1;
    state1 += k10 * i.nu0 + k11 * i.nu1;
    p.p00 -= k00 * i.ph00 + k01 * i.ph01;
    p.p01 -= k00 * i.ph10 + k01 * i.ph11;
    p.p11 -= k10 * i.ph10 + k11 * i.ph11;
}

}  // namespace hitos
