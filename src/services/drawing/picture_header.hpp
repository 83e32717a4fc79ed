// What the first bytes of a picture say, read before anybody makes room for its pixels.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace hitos {

struct PictureHeader {
    std::uint64_t width = 0;
    std::uint64_t height = 0;
    bool whole = true;  ///< false: breaks off, which no decoder of JPEG tells
};

/// Nothing for what is no PNG, JPEG, PBM, PGM, PPM or BMP with a size.
std::optional<PictureHeader> picture_header(std::string_view bytes);

}  // namespace hitos
