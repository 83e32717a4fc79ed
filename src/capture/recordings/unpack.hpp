// SPDX-License-Identifier: GPL-3.0-or-later
// Compressed parts of recordings.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "recordings/byte_source.hpp"

namespace hitos {

/// What `packed`, which must live longer, unpacks to: "bz2", "lz4" (frames) or "zstd". Memory does
/// not depend on the data's size; a zstd window above 32 MiB is refused. Reading throws FormatError
/// where the data are damaged or end early. Throws FormatError for another compression.
std::unique_ptr<ByteSource> make_unpacker(std::string_view compression, ByteSource& packed);

/// The file, or what it unpacks to where it is zstd, as rosbag2 leaves it (compression mode FILE).
/// Of data that are damaged or end early what comes before. Throws FileError, also where there is
/// no room to unpack it.
RegularFile open_unpacked(const std::filesystem::path& path, FileExtent extent = {});

/// The first bytes of that, at most so many. Throws FileError, and FormatError where not even they
/// can be unpacked.
std::string unpacked_beginning(const std::filesystem::path& path, std::size_t most);

}  // namespace hitos
