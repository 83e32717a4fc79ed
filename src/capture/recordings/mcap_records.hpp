// SPDX-License-Identifier: GPL-3.0-or-later
// How MCAP's records are put together [mcap.dev/spec].
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "recordings/mcap_ops.hpp"
#include "recordings/mcap_out.hpp"

namespace hitos {

static_assert(std::endian::native == std::endian::little);

template <class Number>
void put(std::string& out, Number value) {
    std::array<char, sizeof value> raw{};
    std::memcpy(raw.data(), &value, sizeof value);
    out.append(raw.data(), raw.size());
}

inline void put_text(std::string& out, std::string_view text) {
    put(out, static_cast<std::uint32_t>(text.size()));
    out += text;
}

/// A length of so many bytes and what it counts.
template <class Length, class Fill>
void put_counted(std::string& out, const Fill& fill) {
    const std::size_t begin = out.size();
    put(out, Length{0});
    fill();
    const auto length = static_cast<Length>(out.size() - begin - sizeof(Length));
    std::memcpy(out.data() + begin, &length, sizeof length);
}

template <class Fill>
void put_record(std::string& out, McapOp op, const Fill& fill) {
    put(out, op);
    put_counted<std::uint64_t>(out, fill);
}

inline void put_words(std::string& out, const McapWords& words) {
    put_counted<std::uint32_t>(out, [&] {
        for (const auto& [key, value] : words) {
            put_text(out, key);
            put_text(out, value);
        }
    });
}

}  // namespace hitos
