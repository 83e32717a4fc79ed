// SPDX-License-Identifier: GPL-3.0-or-later
// Tells changed bytes from unchanged ones.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct XXH3_state_s;

namespace hitos {

/// XXH3, of 64 bits 32: for what is told from few others.
std::uint32_t short_digest(std::string_view bytes);

/// XXH3, 128 bits: tells changed input from unchanged; no protection against forgery.
class Digest {
  public:
    Digest();
    /// The length goes in too, so that two texts are never taken for one.
    Digest& add(std::string_view text);
    /// The content alone. Throws FileError where it cannot be read to its end.
    Digest& add_file(const std::filesystem::path& path);
    std::string text() const;

  private:
    struct StateRelease {
        void operator()(XXH3_state_s* state) const;
    };
    void mix(std::string_view bytes);
    std::unique_ptr<XXH3_state_s, StateRelease> state_;
};

}  // namespace hitos
