// SPDX-License-Identifier: GPL-3.0-or-later
// Memory that is refused: HITOS_FAULT_MEMORY=NUMBER:BYTES[:lasting], the allocation of that number
// since main has begun, of those of so many bytes at least; with "lasting" those after it too.
#include <dlfcn.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "report.hpp"

extern "C" {
// The C library's own, by the names under which it keeps them.
// NOLINTBEGIN(readability-identifier-naming)
void* __libc_malloc(std::size_t bytes);
void* __libc_calloc(std::size_t count, std::size_t bytes);
void* __libc_realloc(void* old, std::size_t bytes);
void* __libc_memalign(std::size_t alignment, std::size_t bytes);
// NOLINTEND(readability-identifier-naming)
}

namespace hitos::faults {
namespace {

Order order;
std::atomic<long> allocations = 0;

[[gnu::constructor]] void take_order() {
    order = order_from("HITOS_FAULT_MEMORY");
}

[[gnu::destructor]] void tell_count() {
    if (order.given && order.number == 0) report("memory", allocations, "allocations", "");
}

std::atomic<bool> is_told = false;

/// cairo, the pixman beneath it and fontconfig may end the program where they are refused memory,
/// and nobody else may: that it was they is told.
void tell_library(const void* caller) {
    Dl_info found{};
    if (is_told || ::dladdr(caller, &found) == 0 || found.dli_fname == nullptr) return;
    for (const char* library : {"libcairo", "libpixman", "libfontconfig"}) {
        if (std::strstr(found.dli_fname, library) == nullptr) continue;
        is_told = true;
        report("refused", 0, library, "");
    }
}

/// Counts the allocation; whether it is refused to who called from there.
bool refused(std::size_t bytes, const void* caller) {
    if (!order.given || !in_main() || bytes < static_cast<std::size_t>(order.detail)) return false;
    const long number = ++allocations;
    if (order.number == 0 || number < order.number) return false;
    if (number > order.number && !order.lasting) return false;
    if (number == order.number) {
        std::array<char, 32> size{};
        const int length = std::snprintf(size.data(), size.size(), "%zu", bytes);
        report("hit", number, "allocation", {size.data(), static_cast<std::size_t>(length)});
    }
    tell_library(caller);
    errno = ENOMEM;
    return true;
}

}  // namespace
}  // namespace hitos::faults

using hitos::faults::refused;

extern "C" {

void* malloc(std::size_t bytes) noexcept {
    return refused(bytes, __builtin_return_address(0)) ? nullptr : __libc_malloc(bytes);
}

void* calloc(std::size_t count, std::size_t bytes) noexcept {
    return refused(count * bytes, __builtin_return_address(0)) ? nullptr
                                                               : __libc_calloc(count, bytes);
}

void* realloc(void* old, std::size_t bytes) noexcept {
    return refused(bytes, __builtin_return_address(0)) ? nullptr : __libc_realloc(old, bytes);
}

void* memalign(std::size_t alignment, std::size_t bytes) noexcept {
    return refused(bytes, __builtin_return_address(0)) ? nullptr
                                                       : __libc_memalign(alignment, bytes);
}

void* aligned_alloc(std::size_t alignment, std::size_t bytes) noexcept {
    return memalign(alignment, bytes);
}

int posix_memalign(void** out, std::size_t alignment, std::size_t bytes) noexcept {
    void* const block = memalign(alignment, bytes);
    if (block == nullptr) return ENOMEM;
    *out = block;
    return 0;
}
}
