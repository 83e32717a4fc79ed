// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_codecs.hpp"

#include <spng.h>
#include <turbojpeg.h>
#include <zlib.h>

#include <cstdlib>
#include <memory>
#include <new>
#include <opencv2/imgproc.hpp>
#include <type_traits>
#include <unordered_map>

#include "hitos/base/error.hpp"

namespace hitos::drawing {
namespace {

[[noreturn]] void cannot_encode() {
    throw Error(message(HITOS_TEXT("Errors", "the picture could not be encoded")));
}

using Png = std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)>;

Png png_context(int flags) {
    Png png(spng_ctx_new(flags), &spng_ctx_free);
    if (!png) throw std::bad_alloc();
    return png;
}

using Jpeg = std::unique_ptr<std::remove_pointer_t<tjhandle>, decltype(&tjDestroy)>;

Jpeg jpeg_context(tjhandle handle) {
    if (handle == nullptr) throw std::bad_alloc();
    return {handle, &tjDestroy};
}

/// Whether libspng is done. Throws std::bad_alloc.
bool is_done(int result) {
    if (result == SPNG_EMEM) throw std::bad_alloc();
    return result == 0;
}

/// The same of libjpeg-turbo, which has words for it alone.
bool is_done(const Jpeg& jpeg, int result) {
    if (result == 0) return true;
    if (std::string_view(tjGetErrorStr2(jpeg.get())).find("emory") != std::string_view::npos)
        throw std::bad_alloc();
    return false;
}

std::optional<Pixels> decoded_png(std::string_view bytes, const SizeCheck& check) {
    constexpr int kByte = 8;
    const Png png = png_context(0);
    spng_ihdr head{};
    spng_trns transparent{};
    if (!is_done(spng_set_png_buffer(png.get(), bytes.data(), bytes.size())) ||
        !is_done(spng_set_crc_action(png.get(), SPNG_CRC_ERROR, SPNG_CRC_DISCARD)) ||
        !is_done(spng_get_ihdr(png.get(), &head))) {
        return std::nullopt;
    }
    check(head.width, head.height);
    const bool alpha = head.color_type == SPNG_COLOR_TYPE_GRAYSCALE_ALPHA ||
                       head.color_type == SPNG_COLOR_TYPE_TRUECOLOR_ALPHA ||
                       is_done(spng_get_trns(png.get(), &transparent));
    const bool grey = head.color_type == SPNG_COLOR_TYPE_GRAYSCALE && head.bit_depth <= kByte;
    const spng_format format =
        grey ? (alpha ? SPNG_FMT_GA8 : SPNG_FMT_G8) : (alpha ? SPNG_FMT_RGBA8 : SPNG_FMT_RGB8);
    Pixels pixels =
        room_for(head.width, head.height, (grey ? 1 : 3) + (alpha ? 1 : 0), [](auto, auto) {});
    if (!is_done(spng_decode_image(png.get(), pixels.values.data(), pixels.values.size(), format,
                                   alpha ? SPNG_DECODE_TRNS : 0)) ||
        !is_done(spng_decode_chunks(png.get()))) {  // up to its end
        return std::nullopt;
    }
    return pixels;
}

/// Four inks, of which the files that there are hold what is left out.
Pixels of_inks(const Pixels& inks) {
    Pixels pixels{inks.width, inks.height, 3, {}};
    pixels.values.reserve(inks.values.size() / 4 * 3);
    for (std::size_t at = 0; at + 3 < inks.values.size(); at += 4) {
        for (std::size_t i = 0; i < 3; ++i) {
            pixels.values.push_back(
                static_cast<std::uint8_t>(inks.values[at + i] * inks.values[at + 3] / 255));
        }
    }
    return pixels;
}

std::optional<Pixels> decoded_jpeg(std::string_view bytes, const SizeCheck& check) {
    const Jpeg jpeg = jpeg_context(tjInitDecompress());
    const auto* begin = reinterpret_cast<const unsigned char*>(bytes.data());
    int width = 0;
    int height = 0;
    int sampling = 0;
    int colours = 0;
    if (!is_done(jpeg, tjDecompressHeader3(jpeg.get(), begin, bytes.size(), &width, &height,
                                           &sampling, &colours))) {
        return std::nullopt;
    }
    if (width <= 0 || height <= 0) return std::nullopt;  // the height may follow behind the pixels
    const bool inks = colours == TJCS_CMYK || colours == TJCS_YCCK;
    const int format = colours == TJCS_GRAY ? TJPF_GRAY : inks ? TJPF_CMYK : TJPF_RGB;
    Pixels pixels = room_for(static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height),
                             tjPixelSize[format], check);
    // Warned is of pixels that are guessed; small files of many passes would take hours.
    if (!is_done(jpeg, tjDecompress2(jpeg.get(), begin, bytes.size(), pixels.values.data(), width,
                                     0, height, format, TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS))) {
        return std::nullopt;
    }
    return inks ? of_inks(pixels) : std::move(pixels);
}

}  // namespace

Pixels room_for(std::uint64_t width, std::uint64_t height, int channels, const SizeCheck& check) {
    check(width, height);
    return {static_cast<int>(width), static_cast<int>(height), channels,
            std::vector<std::uint8_t>(width * height * static_cast<std::uint64_t>(channels))};
}

std::optional<Pixels> decoded(std::string_view bytes, const SizeCheck& check) {
    if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return decoded_png(bytes, check);
    if (bytes.starts_with("\xff\xd8")) return decoded_jpeg(bytes, check);
    if (bytes.starts_with("BM")) return decoded_bmp(bytes, check);
    return decoded_pnm(bytes, check);
}

namespace {

/// Colours by number, of pictures that have few: a third of the bytes to compress.
class Palette {
  public:
    /// Nothing where it has more than a palette holds.
    static std::optional<Palette> of(const cv::Mat& image) {
        if (image.type() != CV_8UC3) return std::nullopt;
        Palette palette;
        for (int y = 0; y < image.rows; ++y) {
            const auto* const row = image.ptr<cv::Vec3b>(y);
            for (int x = 0; x < image.cols; ++x) {
                if (x > 0 && row[x] == row[x - 1]) continue;
                if (palette.numbers_.try_emplace(key(row[x]), palette.numbers_.size()).second &&
                    !palette.add(row[x])) {
                    return std::nullopt;
                }
            }
        }
        return palette;
    }

    spng_plte& colours() { return colours_; }
    void number(const cv::Mat& row, cv::Mat& numbers) const {
        numbers.create(1, row.cols, CV_8UC1);
        const auto* const colours = row.ptr<cv::Vec3b>();
        std::uint8_t* const out = numbers.ptr();
        for (int x = 0; x < row.cols; ++x) {
            out[x] = x > 0 && colours[x] == colours[x - 1]
                         ? out[x - 1]
                         : static_cast<std::uint8_t>(numbers_.at(key(colours[x])));
        }
    }

  private:
    static std::uint32_t key(const cv::Vec3b& colour) {
        return static_cast<std::uint32_t>(colour[0] | colour[1] << 8 | colour[2] << 16);
    }
    bool add(const cv::Vec3b& colour) {
        constexpr std::uint32_t kMost = 256;
        if (colours_.n_entries == kMost) return false;
        colours_.entries[colours_.n_entries++] = {colour[2], colour[1], colour[0], 255};
        return true;
    }

    spng_plte colours_{};
    std::unordered_map<std::uint32_t, std::size_t> numbers_;
};

/// Row by row: large pictures are not copied whole.
bool encode_rows(const Png& png, const cv::Mat& image, const std::optional<Palette>& palette) {
    cv::Mat row;
    for (int y = 0; y < image.rows; ++y) {
        if (palette) {
            palette->number(image.row(y), row);
        } else if (image.channels() > 1) {
            cv::cvtColor(image.row(y), row, cv::COLOR_BGR2RGB);
        } else {
            row = image.row(y);
        }
        const int result = spng_encode_row(png.get(), row.data, row.total() * row.elemSize());
        if (result != SPNG_EOI && !is_done(result)) return false;
    }
    return true;
}

}  // namespace

std::string png_of(const cv::Mat& image, std::optional<int> compression) {
    const Png png = png_context(SPNG_CTX_ENCODER);
    spng_ihdr head{};
    head.width = static_cast<std::uint32_t>(image.cols);
    head.height = static_cast<std::uint32_t>(image.rows);
    head.bit_depth = 8;
    std::optional<Palette> palette = Palette::of(image);
    head.color_type = image.channels() == 1 ? SPNG_COLOR_TYPE_GRAYSCALE
                      : palette             ? SPNG_COLOR_TYPE_INDEXED
                                            : SPNG_COLOR_TYPE_TRUECOLOR;
    // Maps are of long runs of one grey.
    const auto set = [&](spng_option option, int value) {
        return is_done(spng_set_option(png.get(), option, value));
    };
    const bool whole =
        set(SPNG_ENCODE_TO_BUFFER, 1) &&
        set(SPNG_FILTER_CHOICE, palette ? SPNG_FILTER_CHOICE_NONE : SPNG_FILTER_CHOICE_SUB) &&
        set(SPNG_IMG_COMPRESSION_STRATEGY, Z_RLE) &&
        set(SPNG_IMG_COMPRESSION_LEVEL, compression.value_or(Z_BEST_SPEED)) &&
        is_done(spng_set_ihdr(png.get(), &head)) &&
        (!palette || is_done(spng_set_plte(png.get(), &palette->colours()))) &&
        is_done(spng_encode_image(png.get(), nullptr, 0, SPNG_FMT_PNG,
                                  SPNG_ENCODE_PROGRESSIVE | SPNG_ENCODE_FINALIZE)) &&
        encode_rows(png, image, palette);
    std::size_t size = 0;
    int error = 0;
    const std::unique_ptr<void, decltype(&std::free)> bytes(
        whole ? spng_get_png_buffer(png.get(), &size, &error) : nullptr, &std::free);
    if (!bytes) cannot_encode();
    return {static_cast<const char*>(bytes.get()), size};
}

std::string jpeg_of(const cv::Mat& image) {
    constexpr int kQuality = 95;
    const Jpeg jpeg = jpeg_context(tjInitCompress());
    const bool grey = image.channels() == 1;
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    const int result =
        tjCompress2(jpeg.get(), image.data, image.cols, static_cast<int>(image.step[0]), image.rows,
                    grey ? TJPF_GRAY : TJPF_BGR, &bytes, &size, grey ? TJSAMP_GRAY : TJSAMP_420,
                    kQuality, TJFLAG_ACCURATEDCT);
    const std::unique_ptr<unsigned char, decltype(&tjFree)> held(bytes, &tjFree);
    if (!is_done(jpeg, result)) cannot_encode();
    return {reinterpret_cast<const char*>(bytes), size};
}

}  // namespace hitos::drawing
