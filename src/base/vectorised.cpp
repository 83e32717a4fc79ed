// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/vectorised.hpp"

#include <algorithm>
#include <atomic>

namespace hitos {
namespace {

std::atomic<VectorTarget> in_use = widest_vectors();  // NOLINT(*-avoid-non-const-global-variables)

}  // namespace

VectorTarget widest_vectors() {
#if defined(__x86_64__) && !defined(HITOS_ONE_KIND_OF_VECTORS)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl")) {
        return VectorTarget::avx512;
    }
    if (__builtin_cpu_supports("avx2")) return VectorTarget::avx2;
#endif
    return VectorTarget::sse2;
}

VectorTarget vectors_in_use() {
    return in_use.load(std::memory_order_relaxed);
}

VectorTarget use_vectors(VectorTarget target) {
    in_use = std::min(target, widest_vectors());
    return in_use;
}

}  // namespace hitos
