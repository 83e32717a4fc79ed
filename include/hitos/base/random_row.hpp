// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers of many streams at once.
#pragma once

#include <cstddef>
#include <cstdint>

#include "hitos/base/random_stream.hpp"

namespace hitos {

/// The streams of one seed, purpose and step whose indices follow each other.
struct RandomRow {
    std::uint64_t seed = 0;
    RandomPurpose purpose = RandomPurpose::motion;
    std::uint64_t step = 0;
    std::uint32_t first = 0;  ///< index

    RandomStream stream(std::size_t i) const {
        return {seed, purpose, step, first + static_cast<std::uint32_t>(i)};
    }
};

/// Three independent standard normal draws of each stream: what its first normal_pair() gives, and
/// the first of its second.
struct NormalRow {
    static constexpr std::size_t kMost = 64;
    alignas(64) double n0[kMost];  // NOLINT(*-avoid-c-arrays): vector registers load from these
    alignas(64) double n1[kMost];  // NOLINT(*-avoid-c-arrays)
    alignas(64) double n2[kMost];  // NOLINT(*-avoid-c-arrays)
};

/// Draws for `count` streams, at most NormalRow::kMost.
void draw_normals(const RandomRow& row, std::size_t count, NormalRow& normals);

}  // namespace hitos
