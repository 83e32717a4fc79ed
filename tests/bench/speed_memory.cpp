// SPDX-License-Identifier: GPL-3.0-or-later
// Counts what is asked of malloc by standing in its place: operator new, Eigen and TBB all end
// there.

#include <atomic>

#include "speed_measure.hpp"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HITOS_FOREIGN_MALLOC
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define HITOS_FOREIGN_MALLOC
#endif
#endif

namespace {

std::atomic<bool> counting = false;
std::atomic<std::int64_t> allocations = 0;
std::atomic<std::int64_t> live = 0;
std::atomic<std::int64_t> peak = 0;

}  // namespace

#ifndef HITOS_FOREIGN_MALLOC

#include <malloc.h>

#include <cerrno>

// What glibc's own malloc does under another name.
// NOLINTBEGIN(readability-identifier-naming)
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);
}
// NOLINTEND(readability-identifier-naming)

namespace {

void* note(void* block) {
    if (block == nullptr || !counting.load(std::memory_order_relaxed)) return block;
    allocations.fetch_add(1, std::memory_order_relaxed);
    const auto size = static_cast<std::int64_t>(malloc_usable_size(block));
    const std::int64_t now = live.fetch_add(size, std::memory_order_relaxed) + size;
    std::int64_t before = peak.load(std::memory_order_relaxed);
    while (before < now && !peak.compare_exchange_weak(before, now, std::memory_order_relaxed)) {
    }
    return block;
}

void note_end(void* block) {
    if (block == nullptr || !counting.load(std::memory_order_relaxed)) return;
    live.fetch_sub(static_cast<std::int64_t>(malloc_usable_size(block)), std::memory_order_relaxed);
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) noexcept {
    return note(__libc_malloc(size));
}
void* calloc(std::size_t count, std::size_t size) noexcept {
    return note(__libc_calloc(count, size));
}
void* realloc(void* block, std::size_t size) noexcept {
    note_end(block);
    return note(__libc_realloc(block, size));
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
    return note(__libc_memalign(alignment, size));
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
    return note(__libc_memalign(alignment, size));
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
    *block = note(__libc_memalign(alignment, size));
    return *block == nullptr ? ENOMEM : 0;
}
void free(void* block) noexcept {
    note_end(block);
    __libc_free(block);
}

}  // extern "C"

#endif

namespace speed {

bool can_count_memory() {
#ifdef HITOS_FOREIGN_MALLOC
    return false;
#else
    return true;
#endif
}

void start_counting_memory() {
    allocations = 0;
    live = 0;
    peak = 0;
    counting = true;
}

MemoryCount counted_memory() {
    return {allocations, live, peak};
}

}  // namespace speed
