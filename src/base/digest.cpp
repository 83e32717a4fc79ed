// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/digest.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <fstream>
#include <new>

#include "hitos/base/error.hpp"

namespace hitos {

std::uint32_t short_digest(std::string_view bytes) {
    return static_cast<std::uint32_t>(XXH3_64bits(bytes.data(), bytes.size()));
}

void Digest::StateRelease::operator()(XXH3_state_s* state) const {
    XXH3_freeState(state);
}

Digest::Digest() : state_(XXH3_createState()) {
    if (!state_) throw std::bad_alloc();
    XXH3_128bits_reset(state_.get());
}

void Digest::mix(std::string_view bytes) {
    XXH3_128bits_update(state_.get(), bytes.data(), bytes.size());
}

Digest& Digest::add(std::string_view text) {
    mix(std::to_string(text.size()));
    mix(":");
    mix(text);
    return *this;
}

Digest& Digest::add_file(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw FileError(path.string(), HITOS_TEXT("Errors", "cannot be read"));
    std::string buffer(std::size_t{1} << 16, '\0');
    while (file.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) ||
           file.gcount() > 0) {
        mix(std::string_view(buffer).substr(0, static_cast<std::size_t>(file.gcount())));
    }
    if (file.bad()) {
        throw FileError(path.string(), HITOS_TEXT("Errors", "cannot be read to its end"));
    }
    return *this;
}

std::string Digest::text() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
    return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace hitos
