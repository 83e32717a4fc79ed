// Which format a log has, and one clear error where it has none.
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "formats.hpp"
#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "line_reader.hpp"

namespace hitos {
namespace {

/// The format is what most of the first kVotes lines that any format claims say; the search for
/// them ends after kProbeLines lines or kProbeBytes bytes.
constexpr std::uint64_t kVotes = 50;
constexpr std::uint64_t kProbeLines = 2000;
constexpr std::uint64_t kProbeBytes = std::uint64_t{64} << 20;

/// What the beginning of a file is made of.
struct Probe {
    std::array<std::uint64_t, kFormats.size()> votes{};
    std::uint64_t claimed = 0;  ///< lines that a format claims
    std::uint64_t text = 0;     ///< lines of text that are no comments
    std::uint64_t no_text = 0;  ///< lines that are not text, or too long
    std::uint64_t bytes = 0;
    std::string first_line;     ///< cut, for messages
    std::string raw_beginning;  ///< the first bytes of the file on disk or of what it unpacks to
    std::string damage;         ///< of the compressed data
    bool gzip = false;
};

Probe probe(const std::filesystem::path& path) {
    Probe result;
    {
        ByteStream bytes(path);
        std::array<char, 8> beginning{};
        const std::size_t got = bytes.read(beginning);
        result.raw_beginning.assign(beginning.data(), got);
    }
    LineReader reader(path);
    for (std::uint64_t lines = 0;
         lines < kProbeLines && reader.consumed() < kProbeBytes && result.claimed < kVotes;) {
        const std::optional<LineReader::Line> line = reader.next();
        if (!line) break;
        if (!line->damage.empty()) {
            ++result.no_text;
            ++lines;
            continue;
        }
        if (line->text.empty()) continue;
        const bool comment = line->text.front() == '#';
        if (!comment) {
            ++lines;
            ++result.text;
            constexpr std::size_t kShown = 40;
            if (result.first_line.empty()) result.first_line = line->text.substr(0, kShown);
        }
        const std::optional<LogFormat> format = format_of_line(line->text);
        if (!format) continue;
        ++result.claimed;
        ++result.votes[static_cast<std::size_t>(
            std::find(kFormats.begin(), kFormats.end(), *format) - kFormats.begin())];
    }
    result.bytes = reader.consumed();
    result.damage = reader.bytes().damage();
    result.gzip = reader.bytes().is_gzip();
    return result;
}

/// Names a well-known kind of file from its first bytes.
std::string known_kind(const std::string& beginning) {
    struct Magic {
        const char* bytes;
        const char* kind;
    };
    constexpr std::array kMagics = {
        Magic{"BZh", "bzip2 data; unpack them first"},
        Magic{"\xfd"
              "7zXZ",
              "xz data; unpack them first"},
        Magic{"\x28\xb5\x2f\xfd", "zstd data; unpack them first"},
        Magic{"PK\x03\x04", "a zip archive; unpack it first"},
        Magic{"#ROSBAG", "a ROS bag; convert it first, for example to CARMEN"},
        Magic{"\x89PNG", "a PNG picture"},
        Magic{"\xff\xd8\xff", "a JPEG picture"},
        Magic{"%PDF", "a PDF document"},
        Magic{"\x7f"
              "ELF",
              "a program"}};
    for (const Magic& magic : kMagics) {
        if (beginning.starts_with(magic.bytes)) return std::string("it is ") + magic.kind;
    }
    return "it holds control characters";
}

[[noreturn]] void refuse(const std::string& path, const Probe& found) {
    const std::string expected =
        ", expected a text log of Player, radish, normalized or CARMEN, plain or gzip";
    if (found.bytes == 0 && found.damage.empty()) {
        throw FormatError(
            path, 0, (found.gzip ? "is a gzip file that holds nothing" : "is empty") + expected);
    }
    if (found.text == 0 && !found.damage.empty()) {
        throw FormatError(path, 0, "is gzip, but " + found.damage + " before any line" + expected);
    }
    if (found.no_text > found.text || !known_kind(found.raw_beginning).starts_with("it holds")) {
        throw FormatError(path, 0,
                          std::string("is not text") + (found.gzip ? " once unpacked" : "") + ": " +
                              known_kind(found.raw_beginning) + expected);
    }
    if (found.text == 0) throw FormatError(path, 0, "holds nothing but comments" + expected);
    throw FormatError(path, 0,
                      "no line is one of a format that Hitos reads; the first is \"" +
                          found.first_line + "\"" + expected);
}

}  // namespace

std::unique_ptr<Archivo> open_log(const std::filesystem::path& path, LogFormat format) {
    const Probe found = probe(path);
    if (found.claimed == 0) refuse(path.string(), found);
    const auto most = std::max_element(found.votes.begin(), found.votes.end());
    const LogFormat likely = kFormats[static_cast<std::size_t>(most - found.votes.begin())];
    if (format == LogFormat::automatic) return make_archivo(likely, path);
    const auto said = static_cast<std::size_t>(std::find(kFormats.begin(), kFormats.end(), format) -
                                               kFormats.begin());
    if (found.votes[said] == 0) {
        const std::string name(to_string(likely));
        throw FormatError(path.string(), 0,
                          "is not in the format " + std::string(to_string(format)) +
                              " but looks like " + name + "; choose the format " + name +
                              " or auto");
    }
    return make_archivo(format, path);
}

}  // namespace hitos
