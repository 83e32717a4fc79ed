// SPDX-License-Identifier: GPL-3.0-or-later
// Memory that is asked for in large pieces.
#pragma once

#include <cstddef>
#include <new>
#include <string>

namespace hitos {

/// More memory is needed than there is. Where the system hands out more than it has, nothing else
/// says so before it ends the process.
class MemoryShortage : public std::bad_alloc {
  public:
    explicit MemoryShortage(std::size_t bytes);
    const char* what() const noexcept override { return words_.c_str(); }
    std::size_t bytes() const { return bytes_; }

  private:
    std::size_t bytes_;
    std::string words_;
};

/// What this machine has, with its swap [bytes].
std::size_t machine_memory();

/// To be called before a piece that grows with the map or the particles is asked for. Throws
/// MemoryShortage where so many bytes are more than the machine has.
void require_memory(std::size_t bytes);

}  // namespace hitos
