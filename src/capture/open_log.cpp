// Which format a log has, and one clear error where it has none.
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

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
    std::vector<std::uint64_t> votes;  ///< of each format of the table
    std::uint64_t claimed = 0;         ///< lines that a format claims
    std::uint64_t text = 0;            ///< lines of text that are no comments
    std::uint64_t no_text = 0;         ///< lines that are not text, or too long
    std::uint64_t bytes = 0;
    std::string first_line;     ///< cut, for messages
    std::string raw_beginning;  ///< the first bytes of the file on disk or of what it unpacks to
    std::string damage;         ///< of the compressed data
    bool gzip = false;
};

/// The place in the table of the format whose line or comment this is; nothing where no format, or
/// more than one, claims it.
std::optional<std::size_t> format_of_line(std::string_view text) {
    const std::vector<LogFormat>& formats = log_formats().entries();
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < formats.size(); ++i) {
        if (!formats[i].claims(text)) continue;
        if (found) return std::nullopt;
        found = i;
    }
    return found;
}

Probe probe(const std::filesystem::path& path) {
    Probe result;
    result.votes.resize(log_formats().entries().size());
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
        const std::optional<std::size_t> format = format_of_line(line->text);
        if (!format) continue;
        ++result.claimed;
        ++result.votes[*format];
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
        ", expected a text log (" + log_formats().words(" or ") + "), plain or gzip";
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

std::unique_ptr<Archivo> open_log(const std::filesystem::path& path, std::string_view format) {
    checked_log_format(format, "source.format");
    const Probe found = probe(path);
    if (found.claimed == 0) refuse(path.string(), found);
    const std::vector<LogFormat>& formats = log_formats().entries();
    const auto most = std::ranges::max_element(found.votes) - found.votes.begin();
    const LogFormat& likely = formats[static_cast<std::size_t>(most)];
    if (format == kAutoFormat) return std::make_unique<Archivo>(path, likely);
    const LogFormat& said = log_formats().find(format);
    if (found.votes[static_cast<std::size_t>(&said - formats.data())] == 0) {
        throw FormatError(path.string(), 0,
                          "is not in the format " + said.word + " but looks like " + likely.word +
                              "; choose the format " + likely.word + " or auto");
    }
    return std::make_unique<Archivo>(path, said);
}

}  // namespace hitos
