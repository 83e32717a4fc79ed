// SPDX-License-Identifier: GPL-3.0-or-later
// Elementary functions made of additions, multiplications, divisions and choices alone, each
// correctly rounded by IEEE 754: the same bits on every machine and by every instruction set, which
// a C library does not promise. They have no branches, so that compilers make vector instructions
// of loops over them (vectorised.hpp). Errors are at most about one unit in the last place, of
// angle_of() three; the series are Taylor's. Compiled with -ffp-contract=off, as what links Hitos
// is.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace hitos::elementary {

// Functions of this header are inlined whatever their size: a call would end the vectors.
#define HITOS_INLINE [[gnu::always_inline]] inline

/// The nearest whole number of |x| < 2^51, even where two are as near; what is added leaves no room
/// for fractions.
inline constexpr double kNoFractions = 0x1.8p52;
HITOS_INLINE double nearest_whole(double x) {
    return (x + kNoFractions) - kNoFractions;
}

/// first + x (second + x (…)), by Horner's rule.
template <class... Rest>
HITOS_INLINE double polynomial(double x, double first, Rest... rest) {
    if constexpr (sizeof...(rest) == 0) {
        return first;
    } else {
        return polynomial(x, rest...) * x + first;
    }
}

/// The angle modulo 2 pi in (-pi, pi], for |angle| < 2^30; beyond, its error grows with its turns.
HITOS_INLINE double wrap(double angle) {
    constexpr double kHalf = std::numbers::pi;
    constexpr double kWhole = 2.0 * kHalf;
    const double turned = angle - nearest_whole(angle * (1.0 / kWhole)) * kWhole;
    // Rounding may have chosen the turn beside.
    const double low = turned <= -kHalf ? turned + kWhole : turned;
    return low > kHalf ? low - kWhole : low;
}

/// Both of one angle.
struct SineCosine {
    double sine;
    double cosine;
};

/// Of |x| < 2^20: x less a multiple of pi/2, whose three parts of 33 bits leave a remainder that is
/// exact to the last bit, then the series of both.
HITOS_INLINE SineCosine sine_cosine(double x) {
    constexpr double kMost = 0x1.921fb544p0;
    constexpr double kLess = 0x1.0b4611a6p-34;
    constexpr double kLeast = 0x1.3198a2e037073p-69;
    const double shifted = x * (2.0 / std::numbers::pi) + kNoFractions;
    const auto quarter = std::bit_cast<std::uint64_t>(shifted);  // its last two bits
    const double quarters = shifted - kNoFractions;
    const double most = x - quarters * kMost;
    const double less = quarters * kLess;
    const double r = most - less;
    const double rounded_off = ((most - r) - less) - quarters * kLeast;
    const double r2 = r * r;
    const double sine = r + (r * r2 *
                                 polynomial(r2, -1.0 / 6.0, 1.0 / 120.0, -1.0 / 5040.0,
                                            1.0 / 362880.0, -1.0 / 39916800.0, 1.0 / 6227020800.0,
                                            -1.0 / 1307674368000.0, 1.0 / 355687428096000.0) +
                             rounded_off);
    const double half = 0.5 * r2;
    const double rest = 1.0 - half;
    const double cosine =
        rest + (((1.0 - rest) - half) +
                (r2 * r2 *
                     polynomial(r2, 1.0 / 24.0, -1.0 / 720.0, 1.0 / 40320.0, -1.0 / 3628800.0,
                                1.0 / 479001600.0, -1.0 / 87178291200.0, 1.0 / 20922789888000.0) -
                 r * rounded_off));
    const bool odd = (quarter & 1U) != 0;
    const auto sine_bits = std::bit_cast<std::uint64_t>(odd ? cosine : sine);
    const auto cosine_bits = std::bit_cast<std::uint64_t>(odd ? sine : cosine);
    return {std::bit_cast<double>(sine_bits ^ ((quarter & 2U) << 62U)),
            std::bit_cast<double>(cosine_bits ^ (((quarter + 1U) & 2U) << 62U))};
}

// ln 2 in two parts, of which the first has zeros at its end: its products with exponents are
// exact.
inline constexpr double kLn2Most = 0x1.62e42fefa38p-1;
inline constexpr double kLn2Rest = 0x1.ef35793c7673p-45;

/// Natural logarithm of a normal x > 0: of 2^k (1 + f), with 1 + f in [sqrt(1/2), sqrt 2),
/// k ln 2 + 2 artanh(f / (2 + f)).
HITOS_INLINE double log(double x) {
    constexpr auto kRootOfHalf = std::bit_cast<std::uint64_t>(0.5 * std::numbers::sqrt2);
    constexpr std::uint64_t kShift = 1024;  // that keeps exponents positive
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t k = ((bits - kRootOfHalf) + (kShift << 52U)) >> 52U;
    const auto exponent =
        std::bit_cast<double>(k | std::bit_cast<std::uint64_t>(0x1p52)) - (0x1p52 + 1024.0);
    const auto f = std::bit_cast<double>(bits - ((k - kShift) << 52U)) - 1.0;
    const double s = f / (2.0 + f);
    const double s2 = s * s;
    // f is exact, so what is taken from it may be rounded.
    const double taken = s * (f - 2.0 * s2 *
                                      polynomial(s2, 1.0 / 3.0, 1.0 / 5.0, 1.0 / 7.0, 1.0 / 9.0,
                                                 1.0 / 11.0, 1.0 / 13.0, 1.0 / 15.0, 1.0 / 17.0,
                                                 1.0 / 19.0, 1.0 / 21.0, 1.0 / 23.0));
    return exponent * kLn2Most + (f - (taken - exponent * kLn2Rest));
}

/// e^x of x <= 700; 0 below -708, where it is less than the least normal number.
HITOS_INLINE double exp(double x) {
    constexpr double kLeast = -708.0;
    const double held = x < kLeast ? kLeast : x;
    const double shifted = held * std::numbers::log2e + kNoFractions;
    const double power = shifted - kNoFractions;
    const double r = (held - power * kLn2Most) - power * kLn2Rest;
    const double near_one =
        1.0 + (r + r * r *
                       polynomial(r, 0.5, 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0, 1.0 / 720.0,
                                  1.0 / 5040.0, 1.0 / 40320.0, 1.0 / 362880.0, 1.0 / 3628800.0,
                                  1.0 / 39916800.0, 1.0 / 479001600.0, 1.0 / 6227020800.0));
    const auto scaled = std::bit_cast<double>(std::bit_cast<std::uint64_t>(near_one) +
                                              (std::bit_cast<std::uint64_t>(shifted) << 52U));
    return x < kLeast ? 0.0 : scaled;
}

/// The angle of (x, y) in [-pi, pi]; 0 of (0, 0). The smaller over the greater coordinate is the
/// tangent of an angle in [0, pi/4], of which the nearest multiple of pi/16 is taken by the formula
/// of the tangent of a difference, so that there is one division.
HITOS_INLINE double angle_of(double y, double x) {
    // tan(k pi/16), k from 1 to 3, and tan((2k - 1) pi/32), k from 1 to 4
    constexpr double kTan1 = 0x1.975f5e0553158p-3;
    constexpr double kTan2 = 0x1.a827999fcef32p-2;
    constexpr double kTan3 = 0x1.561b82ab7f990p-1;
    constexpr double kFrom1 = 0x1.936bb8c5b2da2p-4;
    constexpr double kFrom2 = 0x1.36a08355c63dcp-2;
    constexpr double kFrom3 = 0x1.11ab7190834ecp-1;
    constexpr double kFrom4 = 0x1.a43002ae42850p-1;
    constexpr double kStep = std::numbers::pi / 16.0;
    const double ax = x < 0.0 ? -x : x;
    const double ay = y < 0.0 ? -y : y;
    const double great = ax > ay ? ax : ay;
    const double small = ax > ay ? ay : ax;
    double tangent = 0.0;
    double base = 0.0;
    tangent = small > kFrom1 * great ? kTan1 : tangent;
    base = small > kFrom1 * great ? 1.0 : base;
    tangent = small > kFrom2 * great ? kTan2 : tangent;
    base = small > kFrom2 * great ? 2.0 : base;
    tangent = small > kFrom3 * great ? kTan3 : tangent;
    base = small > kFrom3 * great ? 3.0 : base;
    tangent = small > kFrom4 * great ? 1.0 : tangent;
    base = small > kFrom4 * great ? 4.0 : base;
    const double below = great + tangent * small;
    const double t = below > 0.0 ? (small - tangent * great) / below : 0.0;
    const double t2 = t * t;
    double angle =
        base * kStep + (t + t * t2 *
                                polynomial(t2, -1.0 / 3.0, 1.0 / 5.0, -1.0 / 7.0, 1.0 / 9.0,
                                           -1.0 / 11.0, 1.0 / 13.0, -1.0 / 15.0, 1.0 / 17.0));
    angle = ay > ax ? 0.5 * std::numbers::pi - angle : angle;
    angle = x < 0.0 ? std::numbers::pi - angle : angle;
    return y < 0.0 ? -angle : angle;
}

}  // namespace hitos::elementary
