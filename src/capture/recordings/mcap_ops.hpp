// SPDX-License-Identifier: GPL-3.0-or-later
// What a reader and a writer of MCAP both know [mcap.dev/spec].
#pragma once

#include <cstdint>
#include <string_view>

namespace hitos {

/// What the file begins and ends with.
inline constexpr std::string_view kMcapMagic{"\x89MCAP0\r\n", 8};

/// The kinds of records.
enum class McapOp : std::uint8_t {
    none = 0x00,  ///< no record is of this kind
    header = 0x01,
    footer = 0x02,
    schema = 0x03,
    channel = 0x04,
    message = 0x05,
    chunk = 0x06,
    message_index = 0x07,
    chunk_index = 0x08,
    statistics = 0x0b,
    metadata = 0x0c,
    metadata_index = 0x0d,
    summary_offset = 0x0e,
    data_end = 0x0f
};

}  // namespace hitos
