// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/registration/graph_edit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <system_error>
#include <utility>

#include "hitos/base/text_input.hpp"

namespace hitos {
namespace {

/// In the order of GraphEdit::Kind.
constexpr std::array<std::string_view, 6> kWords{"refuse", "close", "fix", "slip", "wall", "point"};
constexpr double kMostScans = 1e15;
constexpr double kFarthest = 1e6;         // [m]; no tour is longer
constexpr double kFarthestDrawn = 1e8;    // [m]; no survey's coordinates are greater
constexpr std::size_t kMostEdits = 1000;  // each is compared with every other

Message of_change(std::size_t number, const Message& why) {
    return message(HITOS_TEXT("Errors", "change %1: %2"), number, why);
}

/// Of what the changes are: of the scans of a tour, as a configuration names them, or of the poses
/// of a graph, in the lines of a file.
struct Origin {
    const PlacedEdits* file = nullptr;  ///< none: of scans

    bool of_scans() const { return file == nullptr; }
    [[noreturn]] void fail(std::size_t number, const Message& why) const {
        if (!of_scans()) throw wrong_edit(*file, number, why);
        throw ConfigError(kGraphEditsKey, of_change(number, why));
    }
};

/// "812@65.25~9f3a1c2b"
std::optional<EditedScan> scan_of(std::string_view word) {
    const std::size_t at = word.find('@');
    const auto number = input::parse_number(word.substr(0, at));
    if (!number || !(*number >= 1.0 && *number <= kMostScans) || *number != std::floor(*number)) {
        return std::nullopt;
    }
    EditedScan scan{static_cast<std::uint64_t>(*number) - 1};
    if (at == std::string_view::npos) return scan;
    const std::size_t mark = std::min(word.find('~', at), word.size());
    scan.stamp_s = input::parse_number(word.substr(at + 1, mark - at - 1));
    if (!scan.stamp_s || !std::isfinite(*scan.stamp_s)) return std::nullopt;
    if (mark == word.size()) return scan;
    const std::string_view digits = word.substr(mark + 1);
    constexpr int kHexadecimal = 16;
    const char* const end = digits.data() + digits.size();
    const auto read = std::from_chars(digits.data(), end, scan.mark, kHexadecimal);
    if (read.ec != std::errc() || read.ptr != end || scan.mark == 0) return std::nullopt;
    return scan;
}

std::optional<EditedScan> vertex_of(std::string_view word) {
    const auto id = input::parse_whole(word);
    return id ? std::optional(EditedScan{*id}) : std::nullopt;
}

/// A number of a change, and how great it may be.
struct Number {
    double* value;
    double greatest;
};

/// In the order of the text.
std::vector<Number> numbers_of(GraphEdit& edit) {
    constexpr double kTurn = 2.0 * kPi;
    std::vector<Number> numbers;
    const auto add = [&](Point2& at, double greatest) {
        numbers.push_back({&at.x, greatest});
        numbers.push_back({&at.y, greatest});
    };
    if (edit.has_pose())
        return {{&edit.pose.x, kFarthest}, {&edit.pose.y, kFarthest}, {&edit.pose.theta, kTurn}};
    if (edit.kind == GraphEdit::Kind::wall) numbers.push_back({&edit.bearing, kTurn});
    if (edit.kind == GraphEdit::Kind::point) add(edit.seen, kFarthest);
    if (edit.anchors()) add(edit.left, kFarthestDrawn);
    if (edit.kind == GraphEdit::Kind::wall) add(edit.right, kFarthestDrawn);
    return numbers;
}

GraphEdit edit_of(std::string_view text, std::size_t number, const Origin& of) {
    const auto expected = [&] {
        return of.of_scans()
                   ? message(HITOS_TEXT("Errors",
                                        "found %1; expected \"refuse SCAN EARLIER\", \"close SCAN "
                                        "EARLIER X Y THETA\", \"fix SCAN X Y THETA\", \"slip "
                                        "SCAN\", \"wall SCAN BEARING X1 Y1 X2 Y2\" or \"point SCAN "
                                        "DX DY X Y\", scans counted from 1, as SCAN@STAMP where "
                                        "the stamp is to be held, X and Y in metres, THETA and "
                                        "BEARING in rad from -2 pi to 2 pi"),
                             input::in_quotes(text))
                   : message(HITOS_TEXT("Errors",
                                        "found %1; expected \"refuse A B\", \"close A B X Y "
                                        "THETA\", \"fix A X Y THETA\" or \"slip A\", A and B "
                                        "ids of poses, X and Y in metres, THETA in rad from "
                                        "-2 pi to 2 pi"),
                             input::in_quotes(text));
    };
    const std::vector<std::string_view> words = input::fields(text);
    const auto kind = words.empty() ? std::nullopt : edit_kind_of(words.front());
    if (!kind) of.fail(number, expected());
    GraphEdit edit{*kind, {}};
    const std::vector<Number> numbers = numbers_of(edit);
    const std::size_t count = 2U + (edit.of_two() ? 1U : 0U) + numbers.size();
    if (words.size() != count) of.fail(number, expected());
    std::size_t next = 1;
    const auto take_scan = [&] {
        const std::string_view word = words[next++];
        const auto scan = of.of_scans() ? scan_of(word) : vertex_of(word);
        if (!scan) of.fail(number, expected());
        return *scan;
    };
    edit.scan = take_scan();
    if (edit.of_two()) edit.earlier = take_scan();
    for (const Number& wanted : numbers) {
        const std::string_view word = words[next++];
        if (input::has_decimal_comma(word)) {
            of.fail(number,
                    message(HITOS_TEXT("Errors",
                                       "found %1, with a decimal comma; expected a decimal point"),
                            input::in_quotes(word)));
        }
        const auto read = input::parse_number(word);
        if (!read || !(std::abs(*read) <= wanted.greatest)) of.fail(number, expected());
        *wanted.value = *read;
    }
    return edit;
}

std::string text_of(const EditedScan& scan) {
    if (!scan.stamp_s) return fmt::format("{}", scan.scan + 1);
    return scan.mark == 0 ? fmt::format("{}@{}", scan.scan + 1, *scan.stamp_s)
                          : fmt::format("{}@{}~{:08x}", scan.scan + 1, *scan.stamp_s, scan.mark);
}

/// Of poses, which have no order, those of one pair too.
bool contradict(const GraphEdit& a, const GraphEdit& b, const Origin& of) {
    return contradict(a, b) || (!of.of_scans() && a.of_two() && b.of_two() &&
                                a.scan.scan == b.earlier.scan && a.earlier.scan == b.scan.scan);
}

/// Of scans, which have an order, begin where the map does and see walls.
void check_of_scans(const GraphEdit& edit, std::size_t number, const Origin& of) {
    if (edit.of_two() && edit.earlier.scan >= edit.scan.scan) {
        of.fail(number, message(HITOS_TEXT("Errors",
                                           "scan %1 is said to come back to scan %2; expected an "
                                           "earlier one"),
                                edit.scan.scan + 1, edit.earlier.scan + 1));
    }
    if (edit.kind == GraphEdit::Kind::wall) {
        const double length_m = std::hypot(edit.right.x - edit.left.x, edit.right.y - edit.left.y);
        if (length_m < kShortestWall) {
            of.fail(number, message(HITOS_TEXT("Errors",
                                               "the wall of the drawing has no direction, it is %1 "
                                               "m long; expected two places on it, %2 m apart at "
                                               "least"),
                                    length_m, kShortestWall));
        }
    }
    if (!edit.of_two() && !edit.anchors() && edit.scan.scan == 0) {
        of.fail(number, marked(HITOS_TEXT("Errors",
                                          "the first scan is where the map begins: it can "
                                          "neither be fixed elsewhere nor slip")));
    }
}

void check(std::span<const GraphEdit> edits, const Origin& of) {
    for (std::size_t i = 0; i < edits.size(); ++i) {
        const GraphEdit& edit = edits[i];
        if (of.of_scans()) check_of_scans(edit, i + 1, of);
        if (edit.of_two() && edit.earlier.scan == edit.scan.scan) {
            of.fail(i + 1, message(HITOS_TEXT("Errors", "names pose %1 twice; expected two poses"),
                                   edit.scan.scan));
        }
        const std::span before = edits.first(i);
        const auto other = std::ranges::find_if(
            before, [&](const GraphEdit& one) { return contradict(one, edit, of); });
        if (other == before.end()) continue;
        const std::ptrdiff_t number = other - before.begin() + 1;
        of.fail(i + 1,
                of.of_scans()
                    ? message(HITOS_TEXT("Errors", "is of the same scans as change %1"), number)
                    : message(HITOS_TEXT("Errors", "is of the same poses as change %1"), number));
    }
}

/// With a blank between, where there are any already.
void append_words(std::string& words, std::string_view more) {
    if (!words.empty() && !more.empty()) words += ' ';
    words += more;
}

void read(std::string_view text, PlacedEdits& into, const Origin& of) {
    std::vector<GraphEdit>& edits = into.edits;
    std::string above;  // comments on lines of their own, of the change that follows
    text = input::without_mark(text);
    for (std::uint64_t number = 1; const auto line = input::next_line(text); ++number) {
        const std::size_t sign = std::min(line->find('#'), line->size());
        std::string_view rest = line->substr(0, sign);
        const std::size_t before = edits.size();
        const std::string comment(input::trimmed(line->substr(std::min(sign + 1, line->size()))));
        if (input::trimmed(*line).empty()) above.clear();
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find(';'), rest.size());
            const std::string_view change = input::trimmed(rest.substr(0, end));
            rest.remove_prefix(std::min(end + 1, rest.size()));
            if (change.empty()) continue;
            into.lines.push_back(number);
            if (edits.size() == kMostEdits) {
                of.fail(kMostEdits + 1,
                        message(HITOS_TEXT("Errors", "found more than %1 changes"), kMostEdits));
            }
            edits.push_back(edit_of(change, edits.size() + 1, of));
        }
        if (edits.size() == before) {
            append_words(above, comment);
            continue;
        }
        append_words(above, comment);
        edits.back().comment = on_one_line(std::exchange(above, {}));
    }
    check(edits, of);
}

}  // namespace

std::string_view word_of(GraphEdit::Kind kind) {
    return kWords.at(static_cast<std::size_t>(kind));
}

std::optional<GraphEdit::Kind> edit_kind_of(std::string_view word) {
    const auto found = std::ranges::find(kWords, word);
    if (found == kWords.end()) return std::nullopt;
    return static_cast<GraphEdit::Kind>(found - kWords.begin());
}

std::vector<GraphEdit> parse_graph_edits(std::string_view text) {
    PlacedEdits edits;
    read(text, edits, {});
    return std::move(edits.edits);
}

PlacedEdits parse_vertex_edits(std::string_view text, const std::string& name) {
    PlacedEdits edits{name};
    read(text, edits, {&edits});
    return edits;
}

FormatError wrong_edit(const PlacedEdits& edits, std::size_t number, const Message& why) {
    return {edits.file, edits.lines.at(number - 1), of_change(number, why)};
}

std::string text_of(std::span<const GraphEdit> edits) {
    std::string text;
    for (GraphEdit edit : edits) {
        if (!text.empty() && text.back() != '\n') text += "; ";
        text += fmt::format("{} {}", word_of(edit.kind), text_of(edit.scan));
        if (edit.of_two()) text += " " + text_of(edit.earlier);
        for (const Number& number : numbers_of(edit)) text += fmt::format(" {}", *number.value);
        if (!edit.comment.empty()) text += " # " + edit.comment + "\n";
    }
    return text;
}

void check_graph_edits(std::span<const GraphEdit> edits) {
    check(edits, {});
}

bool contradict(const GraphEdit& a, const GraphEdit& b) {
    if (a.of_two() && b.of_two())
        return a.scan.scan == b.scan.scan && a.earlier.scan == b.earlier.scan;
    // A scan sees several walls.
    return a.kind == b.kind && a.scan.scan == b.scan.scan && a.bearing == b.bearing &&
           a.seen == b.seen;
}

bool same_change(const GraphEdit& a, const GraphEdit& b) {
    return a.kind == b.kind && a.scan.scan == b.scan.scan && a.earlier.scan == b.earlier.scan &&
           a.pose == b.pose && a.bearing == b.bearing && a.seen == b.seen && a.left == b.left &&
           a.right == b.right;
}

bool has_change(std::span<const GraphEdit> edits, const GraphEdit& edit) {
    return std::ranges::any_of(edits, [&](const GraphEdit& one) { return same_change(one, edit); });
}

std::uint64_t untouched_scans(std::span<const GraphEdit> before, std::span<const GraphEdit> after,
                              std::span<const std::uint64_t> keys) {
    // A key for its own sake, which no change makes one.
    const auto is_key = [&](std::uint64_t scan) {
        return std::ranges::binary_search(keys, scan) &&
               std::ranges::none_of(before, [&](const GraphEdit& edit) {
                   return edit.needs_keys() &&
                          (edit.scan.scan == scan || edit.earlier.scan == scan);
               });
    };
    std::uint64_t first = std::numeric_limits<std::uint64_t>::max();
    const auto note = [&](std::span<const GraphEdit> edits, std::span<const GraphEdit> others) {
        for (const GraphEdit& edit : edits) {
            if (has_change(others, edit)) continue;
            first = std::min(first, edit.scan.scan);
            if (edit.kind == GraphEdit::Kind::close && !is_key(edit.earlier.scan))
                first = std::min(first, edit.earlier.scan);
        }
    };
    note(before, after);
    note(after, before);
    return first;
}

}  // namespace hitos
