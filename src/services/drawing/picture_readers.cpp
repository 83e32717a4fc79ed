// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures that are little more than their bytes: PBM, PGM and PPM (netpbm's pages pbm(5), pgm(5)
// and ppm(5)), and BMP (Microsoft, "Bitmap Storage").
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>

#include "picture_codecs.hpp"

namespace hitos::drawing {
namespace {

constexpr int kOfByte = 255;

/// The numbers of a netpbm picture in letters, with comments between them.
class Numbers {
  public:
    explicit Numbers(std::string_view bytes) : rest_(bytes) {}

    /// Nothing at the end, or where something else is. Too large a one is the greatest.
    std::optional<std::uint64_t> next() {
        skip_blanks();
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error == std::errc::invalid_argument) return std::nullopt;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return error == std::errc{} ? value : UINT64_MAX;
    }
    /// Of a PBM in letters, whose bits may stand without blanks.
    std::optional<std::uint64_t> next_bit() {
        skip_blanks();
        if (rest_.empty() || (rest_[0] != '0' && rest_[0] != '1')) return std::nullopt;
        const std::uint64_t bit = rest_[0] == '1' ? 1 : 0;
        rest_.remove_prefix(1);
        return bit;
    }
    /// Behind the one blank that ends the head.
    std::string_view raster() const { return rest_.substr(std::min<std::size_t>(rest_.size(), 1)); }

  private:
    void skip_blanks() {
        while (!rest_.empty()) {
            if (rest_[0] == '#') {
                rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
            } else if (std::string_view(" \t\r\n\v\f").find(rest_[0]) != std::string_view::npos) {
                rest_.remove_prefix(1);
            } else {
                return;
            }
        }
    }

    std::string_view rest_;
};

std::uint8_t scaled(std::uint64_t value, std::uint64_t most) {
    return static_cast<std::uint8_t>((std::min(value, most) * kOfByte + most / 2) / most);
}

std::uint64_t little_endian(std::string_view bytes, std::size_t at, std::size_t length) {
    std::uint64_t value = 0;
    for (std::size_t i = length; i-- > 0;) {
        const auto byte = static_cast<unsigned char>(at + i < bytes.size() ? bytes[at + i] : 0);
        value = value << 8U | byte;
    }
    return value;
}

bool fill_from_letters(Pixels& pixels, Numbers& numbers, bool bits, std::uint64_t most) {
    for (std::uint8_t& value : pixels.values) {
        const std::optional<std::uint64_t> number = bits ? numbers.next_bit() : numbers.next();
        if (!number) return false;
        value = bits ? (*number == 0 ? kOfByte : 0) : scaled(*number, most);
    }
    return true;
}

bool fill_from_bits(Pixels& pixels, std::string_view raster) {
    const auto width = static_cast<std::size_t>(pixels.width);
    const std::size_t step = (width + 7) / 8;
    if (raster.size() / step < static_cast<std::size_t>(pixels.height)) return false;
    for (std::size_t i = 0; i < pixels.values.size(); ++i) {
        const std::size_t column = i % width;
        const auto byte = static_cast<unsigned char>(raster[i / width * step + column / 8]);
        const bool black = ((byte >> (7 - column % 8)) & 1) != 0;
        pixels.values[i] = black ? 0 : kOfByte;
    }
    return true;
}

bool fill_from_bytes(Pixels& pixels, std::string_view raster, std::uint64_t most) {
    const std::size_t each = most > kOfByte ? 2 : 1;
    if (raster.size() / each < pixels.values.size()) return false;
    for (std::size_t i = 0; i < pixels.values.size(); ++i) {
        std::uint64_t value = 0;
        for (std::size_t k = 0; k < each; ++k)
            value = value << 8U | static_cast<unsigned char>(raster[i * each + k]);
        pixels.values[i] = scaled(value, most);
    }
    return true;
}

}  // namespace

std::optional<Pixels> decoded_pnm(std::string_view bytes, const SizeCheck& check) {
    constexpr std::uint64_t kGreatestMost = 65535;
    if (bytes.size() < 3 || bytes[0] != 'P' || bytes[1] < '1' || bytes[1] > '6')
        return std::nullopt;
    const int kind = bytes[1] - '0';
    const bool bits = kind == 1 || kind == 4;
    Numbers numbers(bytes.substr(2));
    const std::optional<std::uint64_t> width = numbers.next();
    const std::optional<std::uint64_t> height = numbers.next();
    const std::optional<std::uint64_t> most = bits ? 1 : numbers.next();
    if (!width || !height || *width == 0 || *height == 0) return std::nullopt;
    Pixels pixels = room_for(*width, *height, kind % 3 == 0 ? 3 : 1, check);
    if (!most || *most == 0 || *most > kGreatestMost) return std::nullopt;
    const bool whole = kind < 4 ? fill_from_letters(pixels, numbers, bits, *most)
                       : bits   ? fill_from_bits(pixels, numbers.raster())
                                : fill_from_bytes(pixels, numbers.raster(), *most);
    if (!whole) return std::nullopt;
    return pixels;
}

std::optional<Pixels> decoded_bmp(std::string_view bytes, const SizeCheck& check) {
    constexpr std::size_t kFileHead = 14;
    constexpr std::size_t kOldHead = 12;
    const std::uint64_t head = little_endian(bytes, kFileHead, 4);
    const bool old = head == kOldHead;
    const std::uint64_t width = little_endian(bytes, 18, old ? 2 : 4);
    const auto rows = old ? static_cast<std::int32_t>(little_endian(bytes, 20, 2))
                          : static_cast<std::int32_t>(little_endian(bytes, 22, 4));
    const auto height = static_cast<std::uint64_t>(std::abs(std::int64_t{rows}));
    const std::uint64_t bits = little_endian(bytes, old ? 24 : 28, 2);
    const std::uint64_t compression = old ? 0 : little_endian(bytes, 30, 4);
    if (width == 0 || height == 0) return std::nullopt;
    Pixels pixels = room_for(width, height, 3, check);
    constexpr std::array<std::uint64_t, 5> kBits{1, 4, 8, 24, 32};
    if (compression != 0 || std::ranges::find(kBits, bits) == kBits.end()) return std::nullopt;
    const std::size_t raster = little_endian(bytes, 10, 4);
    const std::size_t step = (width * bits + 31) / 32 * 4;
    if (raster >= bytes.size() || (bytes.size() - raster) / step < height) return std::nullopt;
    const std::size_t table = kFileHead + head;
    const std::size_t entry = old ? 3 : 4;
    for (std::size_t i = 0; i < width * height; ++i) {
        const std::size_t column = i % width;
        const std::size_t row = i / width;
        const std::size_t line = raster + (rows < 0 ? row : height - 1 - row) * step;
        std::size_t at = line + column * bits / 8;
        if (bits <= 8) {  // blue, green and red stand in a table
            const auto byte = static_cast<unsigned char>(bytes[at]);
            const std::size_t low = 8 - bits - column * bits % 8;
            at = table + entry * ((byte >> low) & ((1U << bits) - 1U));
            if (at + 3 > raster) return std::nullopt;
        }
        for (std::size_t k = 0; k < 3; ++k)
            pixels.values[3 * i + k] = static_cast<std::uint8_t>(bytes[at + 2 - k]);
    }
    return pixels;
}

}  // namespace hitos::drawing
