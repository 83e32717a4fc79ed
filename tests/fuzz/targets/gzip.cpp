// SPDX-License-Identifier: GPL-3.0-or-later
// Packed files: logs, which are streamed, and the texts that are read whole.
#include <zlib.h>

#include <string>

#include "hitos/base/text_input.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/procesador.hpp"
#include "laws.hpp"
#include "targets.hpp"
#include "tour_laws.hpp"

namespace hitos::fuzz {
namespace {

constexpr std::string_view kGzipMagic = "\x1f\x8b";

std::string packed(std::string_view text) {
    z_stream stream{};
    constexpr int kGzipWindow = 15 + 16;
    constexpr int kMemoryLevel = 8;
    require(deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, kGzipWindow, kMemoryLevel,
                         Z_DEFAULT_STRATEGY) == Z_OK,
            "zlib packs");
    std::string bytes(deflateBound(&stream, text.size()), '\0');
    std::string source(text);  // zlib's input is not const
    stream.next_in = reinterpret_cast<Bytef*>(source.data());
    stream.avail_in = static_cast<uInt>(source.size());
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
    stream.avail_out = static_cast<uInt>(bytes.size());
    const int result = deflate(&stream, Z_FINISH);
    bytes.resize(stream.total_out);
    deflateEnd(&stream);
    require(result == Z_STREAM_END, "zlib packs to the end");
    return bytes;
}

std::optional<Tour> tour_of(std::string_view bytes) {
    const std::filesystem::path& file = file_of(bytes);
    return unless_refused([&] {
        Procesador reader(open_log(file));
        return read_tour(reader);
    });
}

/// A plain file and the same packed give the same.
bool check_plain(std::string_view text) {
    const std::optional<Tour> plain = tour_of(text);
    const std::string bytes = packed(text);
    const std::optional<Tour> unpacked = tour_of(bytes);
    require(plain.has_value() == unpacked.has_value(), "a log may be packed");
    if (plain) {
        require(plain->scans == unpacked->scans && plain->odometry == unpacked->odometry &&
                    plain->report.skipped == unpacked->report.skipped,
                "a packed log gives what the plain one gives");
    }
    // As editors save it: without its mark, say.
    const auto as_plain = unless_refused([&] { return input::read_text(file_of(text)); });
    const auto as_packed = unless_refused([&] { return input::read_text(file_of(bytes)); });
    require(as_plain == as_packed, "a packed text is the plain one");
    return plain.has_value();
}

}  // namespace

bool check_gzip(std::string_view input) {
    if (!input.starts_with(kGzipMagic)) return check_plain(input);
    const auto text = unless_refused([&] { return input::read_text(file_of(input)); });
    const std::optional<Tour> tour = tour_of(input);
    if (tour) require_sound(*tour);
    return text.has_value() || tour.has_value();
}

}  // namespace hitos::fuzz
