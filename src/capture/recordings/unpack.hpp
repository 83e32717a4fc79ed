// Compressed parts of recordings.
#pragma once

#include <memory>
#include <string_view>

#include "recordings/byte_source.hpp"

namespace hitos {

/// What `packed`, which must live longer, unpacks to: "bz2", "lz4" (frames) or "zstd". Memory does
/// not depend on the data's size; a zstd window above 32 MiB is refused. Reading throws FormatError
/// where the data are damaged or end early. Throws FormatError for another compression.
std::unique_ptr<ByteSource> make_unpacker(std::string_view compression, ByteSource& packed);

}  // namespace hitos
