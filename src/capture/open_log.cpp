// SPDX-License-Identifier: GPL-3.0-or-later
// Which format a log has, and one clear error where it has none.
#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "formats/formats.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/archivo.hpp"
#include "line_reader.hpp"
#include "plain_decimal.hpp"
#include "read_extent.hpp"
#include "recordings/recording.hpp"
#include "recordings/unpack.hpp"

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
    std::uint64_t no_text = 0;         ///< lines that are not text
    std::uint64_t too_long = 0;        ///< lines longer than kLongestLine
    std::uint64_t commas = 0;          ///< lines of text with decimal commas
    std::uint64_t lower = 0;           ///< lines that would be claimed in capital letters
    std::string separated;             ///< what parts the words of a line that blanks would mend
    bool old_ends = false;             ///< lines end with CR alone
    std::uint64_t bytes = 0;
    std::string first_line;     ///< cut, for messages
    std::string raw_beginning;  ///< the first bytes of the file on disk or of what it unpacks to
    Message damage;             ///< of the compressed data
    bool gzip = false;
};

/// The place in the table of the format whose line or comment this is; nothing where no format, or
/// more than one, claims it.
std::optional<std::size_t> format_of_line(std::string_view text) {
    const std::vector<LogFormat>& formats = log_formats().entries();
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < formats.size(); ++i) {
        if (formats[i].claims == nullptr || !formats[i].claims(text)) continue;
        if (found) return std::nullopt;
        found = i;
    }
    return found;
}

/// More than one: a single field may be a list.
bool has_decimal_commas(std::string_view text) {
    int found = 0;
    for (Fields fields(text); found < 2 && !fields.at_end();) {
        if (input::has_decimal_comma(fields.take())) ++found;
    }
    return found == 2;
}

std::string replaced(std::string_view text, std::string_view what) {
    std::string out(text);
    for (std::size_t at = 0; (at = out.find(what, at)) != std::string::npos; ++at)
        out.replace(at, what.size(), " ");
    return out;
}

/// What would make a line of it that no format claims.
void note_mend(Probe& result, std::string_view text) {
    for (const std::string_view mark : {",", ";", "|", "\xc2\xa0"}) {
        if (!result.separated.empty() || text.find(mark) == std::string_view::npos) continue;
        if (format_of_line(replaced(text, mark))) result.separated = mark;
    }
    std::string capital(text);
    const auto end = std::ranges::find_if(capital, [](char c) { return plain::is_blank(c); });
    std::transform(capital.begin(), end, capital.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
    if (capital != text && format_of_line(capital)) ++result.lower;
}

/// Old Macs ended lines with CR alone.
bool has_old_ends(std::string_view beginning) {
    const std::size_t first = beginning.find('\r');
    // Behind the last one that was read there may be the other half of an end.
    return first != std::string_view::npos && first + 1 < beginning.size() &&
           beginning.find('\n') == std::string_view::npos;
}

Probe probe(const std::filesystem::path& path, const FileExtent& extent) {
    Probe result;
    result.votes.resize(log_formats().entries().size());
    {
        ByteStream bytes(path, extent);
        std::string beginning(1U << 16U, '\0');
        beginning.resize(bytes.read(beginning));
        constexpr std::size_t kKnown = 8;
        result.raw_beginning = beginning.substr(0, kKnown);
        result.old_ends = has_old_ends(beginning);
    }
    LineReader reader(path, extent);
    for (std::uint64_t lines = 0;
         lines < kProbeLines && reader.consumed() < kProbeBytes && result.claimed < kVotes;) {
        const std::optional<LineReader::Line> line = reader.next();
        if (!line) break;
        if (!line->damage.empty()) {
            ++(line->too_long ? result.too_long : result.no_text);
            ++lines;
            continue;
        }
        if (line->text.empty()) continue;
        const bool comment = line->text.front() == '#';
        if (!comment) {
            ++lines;
            ++result.text;
            constexpr std::size_t kShown = 40;
            if (has_decimal_commas(line->text)) ++result.commas;
            if (result.first_line.empty()) result.first_line = line->text.substr(0, kShown);
        }
        const std::optional<std::size_t> format = format_of_line(line->text);
        if (!format) {
            // Asked only of a file that none claims.
            if (!comment && result.claimed == 0) note_mend(result, line->text);
            continue;
        }
        ++result.claimed;
        ++result.votes[*format];
    }
    result.bytes = reader.consumed();
    result.damage = reader.bytes().damage();
    result.gzip = reader.bytes().is_gzip();
    return result;
}

/// A well-known kind of file by its first bytes; empty where it is none.
Message known_kind(const std::string& beginning) {
    struct Magic {
        const char* bytes;
        const char* kind;
    };
    constexpr std::array kMagics = {
        Magic{"BZh", HITOS_TEXT("Errors", "it is bzip2 data; unpack them first")},
        Magic{"\xfd"
              "7zXZ",
              HITOS_TEXT("Errors", "it is xz data; unpack them first")},
        Magic{"\x28\xb5\x2f\xfd", HITOS_TEXT("Errors", "it is zstd data; unpack them first")},
        Magic{"PK\x03\x04", HITOS_TEXT("Errors", "it is a zip archive; unpack it first")},
        Magic{"#ROSBAG", HITOS_TEXT("Errors", "it is a ROS bag; unpack it first")},
        Magic{"\x89MCAP", HITOS_TEXT("Errors", "it is an MCAP recording; unpack it first")},
        Magic{"\x89PNG", HITOS_TEXT("Errors", "it is a PNG picture")},
        Magic{"\xff\xd8\xff", HITOS_TEXT("Errors", "it is a JPEG picture")},
        Magic{"%PDF", HITOS_TEXT("Errors", "it is a PDF document")},
        Magic{"\x7f"
              "ELF",
              HITOS_TEXT("Errors", "it is a program")}};
    const auto zero = [&](std::size_t at) { return beginning.at(at) == '\0'; };
    const bool wide =
        beginning.starts_with("\xff\xfe") || beginning.starts_with("\xfe\xff") ||
        (beginning.size() == 8 && zero(0) == zero(2) && zero(2) == zero(4) && zero(4) == zero(6) &&
         zero(1) == zero(3) && zero(3) == zero(5) && zero(5) == zero(7) && zero(0) != zero(1));
    if (wide) return message(HITOS_TEXT("Errors", "it is UTF-16 text; save it as UTF-8"));
    for (const Magic& magic : kMagics) {
        if (beginning.starts_with(magic.bytes)) return marked(magic.kind);
    }
    return {};
}

Message problem_of(const Probe& found) {
    if (found.bytes == 0 && found.damage.empty()) {
        return found.gzip ? message(HITOS_TEXT("Errors", "is a gzip file that holds nothing"))
                          : message(HITOS_TEXT("Errors", "is empty"));
    }
    if (found.text == 0 && !found.damage.empty()) {
        return message(HITOS_TEXT("Errors", "is gzip, but %1 before any line"), found.damage);
    }
    const Message kind = known_kind(found.raw_beginning);
    if (found.no_text > found.text || !kind.empty()) {
        const Message what =
            kind.empty() ? message(HITOS_TEXT("Errors", "it holds control characters")) : kind;
        return found.gzip ? message(HITOS_TEXT("Errors", "is not text once unpacked: %1"), what)
                          : message(HITOS_TEXT("Errors", "is not text: %1"), what);
    }
    if (found.too_long > found.text) {
        return message(HITOS_TEXT("Errors", "holds lines longer than 1 MiB"));
    }
    if (found.text == 0) return message(HITOS_TEXT("Errors", "holds nothing but comments"));
    if (!found.separated.empty()) {
        return message(HITOS_TEXT("Errors",
                                  "no line is one of a format that Hitos reads, but would be with "
                                  "blanks in the place of %1; the first is \"%2\""),
                       input::in_quotes(found.separated), found.first_line);
    }
    if (found.lower > 0) {
        return message(HITOS_TEXT("Errors",
                                  "no line is one of a format that Hitos reads, but would be with "
                                  "its name in capital letters; the first is \"%1\""),
                       found.first_line);
    }
    return message(
        HITOS_TEXT("Errors", "no line is one of a format that Hitos reads; the first is \"%1\""),
        found.first_line);
}

[[noreturn]] void refuse_unknown(const std::string& path, const Probe& found) {
    throw FormatError(path, 0, HITOS_TEXT("Errors", "%1, expected a log (%2); text may be gzip"),
                      problem_of(found), log_formats().either());
}

[[noreturn]] void refuse_commas(const std::string& path, const Probe& found) {
    throw FormatError(
        path, 0,
        HITOS_TEXT("Errors",
                   "is written with decimal commas, as programs do under the settings of some "
                   "languages; expected decimal points, as sed -E 's/([0-9]),([0-9])/\\1.\\2/g' "
                   "makes of them; the first line is \"%1\""),
        found.first_line);
}

[[noreturn]] void refuse_old_ends(const std::string& path) {
    throw FormatError(path, 0,
                      HITOS_TEXT("Errors",
                                 "has lines that end with CR alone, as old Macs wrote them; "
                                 "expected LF or CR LF, as tr '\\r' '\\n' makes of them"));
}

/// Drawings are where worlds come from, but no tours.
void refuse_drawing(const std::filesystem::path& path, const Probe& found) {
    const std::string& beginning = found.raw_beginning;
    if (beginning.starts_with("AC10")) {
        throw FormatError(path.string(), 0,
                          HITOS_TEXT("Errors",
                                     "is a DWG drawing, no log; save it as DXF, of which hitos-cli "
                                     "world makes a world"));
    }
    const bool text = found.first_line == "0" && beginning.find("\nSE") != std::string::npos;
    const bool commented = found.first_line == "999" && path.extension() == ".dxf";
    if (!text && !commented && !beginning.starts_with("AutoCAD ")) return;
    throw FormatError(path.string(), 0,
                      HITOS_TEXT("Errors",
                                 "is a DXF drawing, no log; hitos-cli world makes a world of it, "
                                 "in which a tour can be driven"));
}

[[noreturn]] void refuse_format(const std::string& path, std::string_view said,
                                const LogFormat& likely) {
    throw FormatError(
        path, 0,
        HITOS_TEXT("Errors",
                   "is not in the format %1 but looks like %2; choose the format %2 or auto"),
        said, likely.word);
}

/// Whether it is a recording that is compressed as a whole.
bool is_unpacked_first(const std::filesystem::path& path) {
    std::array<char, 16> found{};
    const std::size_t got = RegularFile(path).read_at(0, found);
    return !std::string_view(found.data(), got).starts_with(unpacked_beginning(path, 4));
}

/// What came in live, or does, stands in the file as it is read.
void refuse_growth(const std::string& path, const LogFormat& format, bool compressed,
                   const ReadOptions& options) {
    const bool live = options.growth != nullptr || options.opening_bytes > 0;
    if (!live || (format.may_grow && !compressed)) return;
    throw FileError(
        path, compressed ? message(HITOS_TEXT("Errors",
                                              "is compressed; a log that is followed while it is "
                                              "written is plain text or MCAP"))
                         : message(HITOS_TEXT("Errors",
                                              "is of the format %1; a log that is followed while "
                                              "it is written is text in one file, or MCAP"),
                                   format.word));
}

}  // namespace

const LogFormat* recording_format(const std::filesystem::path& path) {
    std::error_code error;
    const bool folder = std::filesystem::is_directory(path, error);
    const std::string beginning = folder ? "" : unpacked_beginning(path, 16);
    for (const LogFormat& format : log_formats().entries()) {
        if (format.open == nullptr) continue;
        if (folder ? format.folders : format.begins(beginning)) return &format;
    }
    return nullptr;
}

std::unique_ptr<Fuente> open_log(const std::filesystem::path& path, std::string_view format,
                                 const ReadOptions& options) {
    checked_log_format(format, "source.format");
    if (const LogFormat* recording = recording_format(path)) {
        if (format != kAutoFormat && format != recording->word) {
            refuse_format(path.string(), format, *recording);
        }
        refuse_growth(path.string(), *recording, recording->may_grow && is_unpacked_first(path),
                      options);
        return recording->open(path, *recording, options);
    }
    const Probe found = probe(path, opening_extent(options));
    if (found.old_ends && found.no_text == 0) refuse_old_ends(path.string());
    refuse_drawing(path, found);
    if (2 * found.commas > found.text) refuse_commas(path.string(), found);
    if (found.claimed == 0) refuse_unknown(path.string(), found);
    const std::vector<LogFormat>& formats = log_formats().entries();
    const auto most = std::ranges::max_element(found.votes) - found.votes.begin();
    const LogFormat& likely = formats[static_cast<std::size_t>(most)];
    const LogFormat& said = format == kAutoFormat ? likely : log_formats().find(format);
    if (found.votes[static_cast<std::size_t>(&said - formats.data())] == 0) {
        refuse_format(path.string(), said.word, likely);
    }
    refuse_growth(path.string(), said, found.gzip, options);
    return std::make_unique<Archivo>(path, said, options);
}

bool is_recording(const std::filesystem::path& path) {
    try {
        return recording_format(path) != nullptr;
    } catch (const Error&) {  // whoever opens it is told
        return false;
    }
}

bool is_recording_folder(const std::filesystem::path& folder) {
    return is_rosbag2_folder(folder);
}

namespace {

/// SQLite's log of changes beside a file is read with it, also where it appears later.
std::vector<std::filesystem::path> with_changes(std::vector<std::filesystem::path> files) {
    const std::size_t count = files.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (files[i].extension() == ".db3") files.emplace_back(files[i].string() + "-wal");
    }
    return files;
}

}  // namespace

std::vector<std::filesystem::path> log_files(const std::filesystem::path& path) {
    for (const LogFormat& format : log_formats().entries()) {
        if (format.files == nullptr) continue;
        std::vector<std::filesystem::path> files = format.files(path);
        if (!files.empty()) return files;
    }
    std::error_code error;
    const bool metadata = path.filename() == kRosbag2Metadata;
    if (!metadata && !std::filesystem::is_directory(path, error)) return with_changes({path});
    try {
        std::vector<std::filesystem::path> files = with_changes(rosbag2_files(path));
        // What it says decides what is read, also where it appears later.
        files.push_back((metadata ? path.parent_path() : path) / kRosbag2Metadata);
        return files;
    } catch (const Error&) {  // whoever opens it is told
        return {path};
    }
}

}  // namespace hitos
