#include "picture_header.hpp"

#include <algorithm>
#include <charconv>

namespace hitos {
namespace {

/// Zero bytes stand for what is not there.
std::uint64_t number_at(std::string_view bytes, std::size_t at, std::size_t length, bool big) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < length; ++i) {
        const std::size_t place = at + (big ? i : length - 1 - i);
        const auto byte = place < bytes.size() ? static_cast<unsigned char>(bytes[place]) : 0U;
        value = value << 8U | byte;
    }
    return value;
}

PictureHeader bmp(std::string_view bytes) {
    constexpr std::uint64_t kOldHeader = 12;
    if (number_at(bytes, 14, 4, false) == kOldHeader) {
        return {number_at(bytes, 18, 2, false), number_at(bytes, 20, 2, false), true};
    }
    const auto rows = static_cast<std::int32_t>(number_at(bytes, 22, 4, false));
    const std::int64_t height = rows;  // negative: from above
    return {number_at(bytes, 18, 4, false), static_cast<std::uint64_t>(std::abs(height)), true};
}

/// The numbers of a PBM, PGM or PPM, with comments between them.
PictureHeader pnm(std::string_view bytes) {
    PictureHeader header;
    std::size_t at = 2;
    for (std::uint64_t* value : {&header.width, &header.height}) {
        for (; at < bytes.size(); ++at) {
            if (bytes[at] == '#') {
                at = std::min(bytes.find('\n', at), bytes.size() - 1);
            } else if (std::string_view(" \t\r\n\v\f").find(bytes[at]) == std::string_view::npos) {
                break;
            }
        }
        const std::string_view rest = bytes.substr(std::min(at, bytes.size()));
        const auto [stop, error] = std::from_chars(rest.data(), rest.data() + rest.size(), *value);
        if (error == std::errc::result_out_of_range) *value = UINT64_MAX;
        at += static_cast<std::size_t>(stop - rest.data());
    }
    return header;
}

/// The frame's segment tells the size; pixels come until a marker of the end.
PictureHeader jpeg(std::string_view bytes) {
    const auto is_frame = [](unsigned marker) {
        return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 &&
               marker != 0xCC;
    };
    PictureHeader header{0, 0, false};
    bool pixels = false;
    for (std::size_t at = 2; at + 1 < bytes.size();) {
        const auto marker = static_cast<unsigned char>(bytes[at + 1]);
        const bool is_marker = bytes[at] == '\xff' && marker != 0 && marker != 0xFF;
        if (!is_marker || (marker >= 0xD0 && marker <= 0xD8)) {
            at += is_marker ? 2 : 1;
            if (!pixels && !is_marker && bytes[at - 1] != '\xff') break;  // no segment
            continue;
        }
        if (marker == 0xD9) {
            header.whole = true;
            break;
        }
        if (is_frame(marker)) {
            header.height = number_at(bytes, at + 5, 2, true);
            header.width = number_at(bytes, at + 7, 2, true);
        }
        pixels = pixels || marker == 0xDA;
        at += 2 + std::max<std::uint64_t>(number_at(bytes, at + 2, 2, true), 2);
    }
    return header;
}

}  // namespace

std::optional<PictureHeader> picture_header(std::string_view bytes) {
    PictureHeader header;
    if (bytes.starts_with("\x89PNG\r\n\x1a\n")) {
        header = {number_at(bytes, 16, 4, true), number_at(bytes, 20, 4, true), true};
    } else if (bytes.starts_with("\xff\xd8")) {
        header = jpeg(bytes);
    } else if (bytes.starts_with("BM")) {
        header = bmp(bytes);
    } else if (bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6') {
        header = pnm(bytes);
    }
    if (header.width == 0 || header.height == 0) return std::nullopt;
    return header;
}

}  // namespace hitos
