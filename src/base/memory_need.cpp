// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/memory_need.hpp"

#include <fmt/format.h>
#include <sys/sysinfo.h>

#include <limits>

namespace hitos {

MemoryShortage::MemoryShortage(std::size_t bytes)
    : bytes_(bytes),
      words_(fmt::format("{} MB of memory are needed and this machine has {} MB", bytes / 1'000'000,
                         machine_memory() / 1'000'000)) {}

std::size_t machine_memory() {
    struct sysinfo info {};
    if (::sysinfo(&info) != 0) return std::numeric_limits<std::size_t>::max();
    return (info.totalram + info.totalswap) * info.mem_unit;
}

void require_memory(std::size_t bytes) {
    static const std::size_t memory = machine_memory();
    if (bytes > memory) throw MemoryShortage(bytes);
}

}  // namespace hitos
