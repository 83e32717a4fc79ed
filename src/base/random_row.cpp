// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/random_row.hpp"

#include <array>

#include "hitos/base/vectorised.hpp"

namespace hitos {
namespace {

struct Words {
    std::uint32_t w0;
    std::uint32_t w1;
    std::uint32_t w2;
    std::uint32_t w3;
};

HITOS_INLINE std::uint32_t high_product(std::uint32_t a, std::uint32_t b) {
    return static_cast<std::uint32_t>((std::uint64_t{a} * b) >> 32U);
}

/// Philox4x32-10 (Salmon et al., SC11, section 4.3 and table of constants in its Random123).
HITOS_INLINE Words philox(Words c, std::uint32_t k0, std::uint32_t k1) {
    constexpr int kRounds = 10;
#pragma GCC unroll 10
    for (int round = 0; round < kRounds; ++round) {
        const std::uint32_t high0 = high_product(c.w0, PHILOX_M4x32_0);
        const std::uint32_t high2 = high_product(c.w2, PHILOX_M4x32_1);
        c = {high2 ^ c.w1 ^ k0, c.w2 * PHILOX_M4x32_1, high0 ^ c.w3 ^ k1, c.w0 * PHILOX_M4x32_0};
        k0 += PHILOX_W32_0;
        k1 += PHILOX_W32_1;
    }
    return c;
}

/// As RandomStream::uniform(): a word in the last bits of 2^52 is a whole number.
HITOS_INLINE double uniform(std::uint32_t word) {
    const std::uint64_t bits = std::uint64_t{word} | std::bit_cast<std::uint64_t>(0x1p52);
    return ((std::bit_cast<double>(bits) - 0x1p52) + 0.5) * 0x1p-32;
}

/// The first words of `count` streams that follow each other.
HITOS_INLINE void draw_words(Words start, std::uint32_t k0, std::uint32_t k1, std::uint32_t count,
                             std::uint32_t* w0, std::uint32_t* w1, std::uint32_t* w2,
                             std::uint32_t* w3) {
    HITOS_LANES
    for (std::uint32_t i = 0; i < count; ++i) {
        const Words drawn = philox({start.w0, start.w1 + i, start.w2, start.w3}, k0, k1);
        w0[i] = drawn.w0;
        w1[i] = drawn.w1;
        w2[i] = drawn.w2;
        w3[i] = drawn.w3;
    }
}

HITOS_INLINE void normals_of(const std::uint32_t* w0, const std::uint32_t* w1,
                             const std::uint32_t* w2, const std::uint32_t* w3, std::uint32_t count,
                             double* n0, double* n1, double* n2) {
    HITOS_LANES
    for (std::uint32_t i = 0; i < count; ++i) {
        const NormalPair first_two = normal_pair(uniform(w0[i]), uniform(w1[i]));
        n0[i] = first_two.one;
        n1[i] = first_two.other;
        n2[i] = normal_pair(uniform(w2[i]), uniform(w3[i])).one;
    }
}

}  // namespace

void draw_normals(const RandomRow& row, std::size_t count, NormalRow& normals) {
    const RandomStream first = row.stream(0);
    const auto& counter = first.counter();
    const auto& key = first.key();
    // The lanes beyond `count` are computed too: whole vectors.
    const auto lanes = static_cast<std::uint32_t>((count + 15) / 16 * 16);
    alignas(64) std::array<std::array<std::uint32_t, NormalRow::kMost>, 4> words;
    vectorised([&]() HITOS_INLINED {
        draw_words({counter[0], counter[1], counter[2], counter[3]}, key[0], key[1], lanes,
                   words[0].data(), words[1].data(), words[2].data(), words[3].data());
        normals_of(words[0].data(), words[1].data(), words[2].data(), words[3].data(), lanes,
                   normals.n0, normals.n1, normals.n2);
    });
}

}  // namespace hitos
