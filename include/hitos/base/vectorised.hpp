// SPDX-License-Identifier: GPL-3.0-or-later
// Loops compiled for several instruction sets, of which the machine's best is run.
#pragma once

#if defined(__x86_64__)
#include <emmintrin.h>
#endif

#include <cstddef>
#include <cstdint>

#include "hitos/base/elementary.hpp"

namespace hitos {

/// Vector instructions of x86-64; every machine has the first. Elsewhere all three are the same.
enum class VectorTarget : std::uint8_t { sse2, avx2, avx512 };

/// The widest that this machine has.
VectorTarget widest_vectors();
/// What loops run on: the widest, or what use_vectors() said.
VectorTarget vectors_in_use();
/// For tests and benchmarks: from now on loops run on `target`, or on the widest where the machine
/// does not have it. Returns what they run on. Results are the same to the last bit.
VectorTarget use_vectors(VectorTarget target);

#if defined(__x86_64__)
#if defined(__clang__)
#define HITOS_AVX512 "avx512f,avx512dq,avx512bw,avx512vl"
#else
#define HITOS_AVX512 "avx512f,avx512dq,avx512bw,avx512vl,prefer-vector-width=512"
#endif
template <class Body>
[[gnu::target(HITOS_AVX512)]] void run_avx512(const Body& body) {
    body();
}
template <class Body>
[[gnu::target("avx2")]] void run_avx2(const Body& body) {
    body();
}
#endif

/// A bit for each of eight numbers, 1 where it is above 0.
HITOS_INLINE std::uint64_t positive_of_eight(const double* numbers) {
    std::uint64_t bits = 0;
#if defined(__x86_64__)
    const __m128d zero = _mm_setzero_pd();
    for (std::size_t i = 0; i < 8; i += 2) {
        const __m128d above = _mm_cmpgt_pd(_mm_loadu_pd(numbers + i), zero);
        bits |= static_cast<std::uint64_t>(_mm_movemask_pd(above)) << i;
    }
#else
    for (std::size_t i = 0; i < 8; ++i) bits |= static_cast<std::uint64_t>(numbers[i] > 0.0) << i;
#endif
    return bits;
}

/// Calls `body`, a lambda that is marked HITOS_INLINED, as it is compiled for the vectors in use.
/// Its loops should be marked HITOS_LANES: their rounds are independent of each other.
template <class Body>
void vectorised(const Body& body) {
#if defined(__x86_64__) && !defined(HITOS_ONE_KIND_OF_VECTORS)
    const VectorTarget target = vectors_in_use();
    if (target == VectorTarget::avx512) return run_avx512(body);
    if (target == VectorTarget::avx2) return run_avx2(body);
#endif
    body();
}

#define HITOS_INLINED __attribute__((always_inline))
#if defined(__clang__)
#define HITOS_LANES  // it compares addresses first
#else
#define HITOS_LANES _Pragma("GCC ivdep")
#endif

}  // namespace hitos
