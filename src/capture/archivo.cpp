// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/archivo.hpp"

#include "hitos/base/error.hpp"
#include "hitos/base/translatable.hpp"
#include "line_reader.hpp"
#include "read_extent.hpp"

namespace hitos {

struct Archivo::Cursor {
    Cursor(const std::filesystem::path& file, FileExtent extent)
        : path(file), reader(file, std::move(extent)) {}
    std::filesystem::path path;
    LineReader reader;
};

Archivo::Archivo(std::filesystem::path path, const LogFormat& format, ReadOptions options)
    : Archivo(std::move(path), format, std::move(options), Part::whole) {}

Archivo::Archivo(std::filesystem::path path, const LogFormat& format, ReadOptions options,
                 Part part)
    : path_(std::move(path)), format_(format), options_(std::move(options)), part_(part) {
    std::vector<std::filesystem::path> files = {path_, path_};
    if (format_.files != nullptr) files = format_.files(path_);
    if (files.empty()) {
        throw FormatError(
            path_.string(), 0,
            HITOS_TEXT("Errors", "is of the format %1, but no tour by itself; expected %2"),
            format_.word, format_.purpose);
    }
    apart_ = files[0] != files[1];
    const FileExtent extent =
        part_ == Part::opening ? opening_extent(options_) : whole_extent(options_);
    scans_ = std::make_unique<Cursor>(files[0], extent);
    odometry_ = std::make_unique<Cursor>(files[1], extent);
    if (format_.classify != nullptr && format_.make_conversor != nullptr) return;
    throw ConfigError(
        "source.format",
        HITOS_TEXT("Errors",
                   "the format %1 says not which lines it wants or how they are read; "
                   "give its entry classify and make_conversor"),
        format_.word);
}

Archivo::~Archivo() = default;

std::optional<RawLine> Archivo::read_scan_line() {
    return read(*scans_, LineKind::scan);
}

std::optional<RawLine> Archivo::read_odometry_line() {
    return read(*odometry_, LineKind::odometry);
}

std::optional<RawLine> Archivo::read(Cursor& cursor, LineKind wanted) {
    const bool tells_damage = wanted == LineKind::scan || apart_;
    const auto note = [&](std::uint64_t number, Message reason) {
        // A line has a number in both files.
        const std::string file = cursor.path.filename().string();
        damage_.note(number, apart_ ? message("%1: %2", file, reason) : std::move(reason));
    };
    const bool is_live = options_.growth && part_ == Part::whole && wanted == LineKind::scan;
    while (std::optional<LineReader::Line> line = cursor.reader.next()) {
        if (is_live) options_.growth->note_passed(cursor.reader.consumed());
        if (!line->damage.empty()) {
            if (tells_damage) note(line->number, std::move(line->damage));
            continue;
        }
        if (line->text.empty() || line->text.front() == '#') continue;
        const LineKind kind = format_.classify(line->text);
        if (kind == wanted || kind == LineKind::both) {
            if (is_live) options_.growth->note_taken(cursor.reader.consumed());
            return RawLine{line->text, line->number, kind == LineKind::both};
        }
        const bool elsewhere = apart_ && kind != LineKind::other;  // a line of the other file
        if ((kind == LineKind::damaged || elsewhere) && tells_damage) {
            note(line->number,
                 message(HITOS_TEXT("Errors", "not a line of the format %1"), format_.word));
        }
    }
    return std::nullopt;
}

std::optional<double> Archivo::progress() const {
    if (options_.growth && !options_.growth->ended()) return std::nullopt;
    return scans_->reader.bytes().progress();
}

std::string Archivo::name() const {
    return path_.string();
}

std::vector<TourFinding> Archivo::findings() const {
    if (format_.doubts == nullptr) return {};
    return format_.doubts(*this, options_);
}

std::unique_ptr<Fuente> Archivo::reopen() const {
    return std::unique_ptr<Fuente>(new Archivo(path_, format_, options_, part_));
}

std::unique_ptr<Fuente> Archivo::opening() const {
    if (options_.opening_bytes == 0) return reopen();
    return std::unique_ptr<Fuente>(new Archivo(path_, format_, options_, Part::opening));
}

}  // namespace hitos
