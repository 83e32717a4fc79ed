// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/carmen_clocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "fields.hpp"
#include "hitos/base/median.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/base/translatable.hpp"
#include "remedies.hpp"

namespace hitos {
namespace {

constexpr std::size_t kScansAsked = 500;
constexpr std::size_t kReadingsAsked = 5000;
/// Fewer say nothing.
constexpr std::size_t kLeastLines = 10;

struct CarmenStamp {
    double stamp_s = 0.0;
    double logged_s = 0.0;
};

std::string_view take_last(std::string_view& text) {
    constexpr std::string_view kBlanks = " \t\r";
    const std::size_t last = text.find_last_not_of(kBlanks);
    text = text.substr(0, last == std::string_view::npos ? 0 : last + 1);
    const std::size_t blank = text.find_last_of(kBlanks);
    const std::string_view word = text.substr(blank == std::string_view::npos ? 0 : blank + 1);
    text.remove_suffix(word.size());
    return word;
}

std::optional<double> take_time(std::string_view& text) {
    const std::optional<double> time_s = parse_double(take_last(text));
    return time_s && std::abs(*time_s) < kGreatestValue ? time_s : std::nullopt;
}

/// From the end of a line, whose readings cost too much here; nothing where the logger's time is
/// left out.
std::optional<CarmenStamp> stamp_of(std::string_view text) {
    const std::optional<double> logged_s = take_time(text);
    const bool host = !parse_double(take_last(text));
    const std::optional<double> stamp_s = take_time(text);
    if (!logged_s || !host || !stamp_s) return {};
    return CarmenStamp{*stamp_s, *logged_s};
}

/// The lines of one message.
struct CarmenStamps {
    std::vector<CarmenStamp> all;

    void note(std::string_view text) {
        if (const std::optional<CarmenStamp> stamp = stamp_of(text)) all.push_back(*stamp);
    }
    std::vector<double> ahead() const {
        std::vector<double> ahead_s;
        for (const CarmenStamp& one : all) ahead_s.push_back(one.stamp_s - one.logged_s);
        return ahead_s;
    }
    std::uint64_t repeated(double CarmenStamp::*time) const {
        std::uint64_t count = 0;
        for (std::size_t i = 1; i < all.size(); ++i) count += all[i].*time == all[i - 1].*time;
        return count;
    }
    bool logged_in_order() const { return std::ranges::is_sorted(all, {}, &CarmenStamp::logged_s); }
    /// Whether many share a stamp that the logger tells apart.
    bool coarse() const {
        constexpr double kMostOfOneTime = 0.2;  // as TourExamination counts them
        const double most = kMostOfOneTime * static_cast<double>(all.size());
        return all.size() >= kLeastLines && logged_in_order() &&
               static_cast<double>(repeated(&CarmenStamp::stamp_s)) > most &&
               static_cast<double>(repeated(&CarmenStamp::logged_s)) < most;
    }
};

/// Counts where time goes back.
struct TimeOrder {
    std::optional<double> last_s;
    std::uint64_t back = 0;

    void note(double stamp_s) {
        if (last_s && stamp_s < *last_s) ++back;
        last_s = stamp_s;
    }
};

/// Of the poses in lines of ODOM and of scans, each for itself and in the log's order.
struct PoseOrder {
    TimeOrder readings;
    TimeOrder scans;
    TimeOrder all;
    std::uint64_t readings_asked = 0;
    std::uint64_t scans_asked = 0;

    void note(double stamp_s, bool of_scan) {
        (of_scan ? scans : readings).note(stamp_s);
        ++(of_scan ? scans_asked : readings_asked);
        all.note(stamp_s);
    }
    /// A few lines come out of order from any logger.
    bool to_and_fro() const {
        constexpr std::uint64_t kMany = 5;  // every fifth
        return std::min(readings_asked, scans_asked) >= kLeastLines &&
               kMany * all.back > scans_asked && kMany * readings.back < readings_asked &&
               kMany * scans.back < scans_asked;
    }
};

double typical_distance(std::vector<double> values, double from) {
    for (double& value : values) value = std::abs(value - from);
    return median(std::move(values));
}

std::optional<double> lateness(const CarmenStamps& scans, const CarmenStamps& odometry) {
    constexpr double kLeast = 1.0;  // a logger may hold lines up that long
    constexpr double kStable = 0.25;
    if (scans.all.size() < kLeastLines || odometry.all.size() < kLeastLines) return {};
    const double scans_s = median(scans.ahead());
    const double odometry_s = median(odometry.ahead());
    const double late_s = odometry_s - scans_s;
    const double spread_s = std::max(typical_distance(scans.ahead(), scans_s),
                                     typical_distance(odometry.ahead(), odometry_s));
    const bool differ = std::abs(late_s) >= kLeast && spread_s < kStable * std::abs(late_s);
    return differ ? std::optional(late_s) : std::nullopt;
}

}  // namespace

CarmenClocks carmen_clocks(const Fuente& fuente) {
    const std::unique_ptr<Fuente> ahead = fuente.opening();
    CarmenClocks clocks;
    CarmenStamps scans;
    std::uint64_t last_line = 0;
    while (scans.all.size() < kScansAsked) {
        const std::optional<RawLine> line = ahead->read_scan_line();
        if (!line) break;
        const std::string_view name = Fields(line->text).take();
        if (name == "PARAM") continue;
        if (clocks.scans.empty()) clocks.scans = name;
        if (name != clocks.scans) continue;
        scans.note(line->text);
        last_line = line->number;
    }
    CarmenStamps odometry;
    PoseOrder order;
    while (odometry.all.size() < kReadingsAsked) {
        const std::optional<RawLine> line = ahead->read_odometry_line();
        if (!line || line->number > last_line) break;
        const bool of_scan = !line->text.starts_with("ODOM");
        if (!of_scan) odometry.note(line->text);
        if (const auto stamp = stamp_of(line->text)) order.note(stamp->stamp_s, of_scan);
    }
    for (const CarmenStamps* coarse : {&scans, &odometry}) {
        if (!coarse->coarse() || !scans.logged_in_order() || !odometry.logged_in_order()) continue;
        clocks.asked = coarse->all.size();
        clocks.of_one_time = coarse->repeated(&CarmenStamp::stamp_s);
        clocks.from_logger_s = median(coarse->ahead());
        return clocks;
    }
    clocks.scans_late_s = lateness(scans, odometry);
    clocks.to_and_fro = order.to_and_fro();
    return clocks;
}

std::vector<TourFinding> carmen_doubts(const Fuente& fuente, const ReadOptions& options) {
    const CarmenClocks clocks = carmen_clocks(fuente);
    if (clocks.from_logger_s && options.mend == Mend::all) {
        return {{TourFinding::Kind::coarse_stamps,
                 static_cast<double>(clocks.of_one_time) / static_cast<double>(clocks.asked),
                 message(HITOS_TEXT("Errors",
                                    "%1 of the first %2 stamps are the same as the one before: "
                                    "they have too few digits; the logger's times, the last number "
                                    "of each line, are taken in their place"),
                         clocks.of_one_time, clocks.asked),
                 {{marked(HITOS_TEXT("Errors",
                                     "record times with milliseconds, as numbers of 64 bits"))}}}};
    }
    constexpr double kAlmostNone = 0.02;  // [s]
    if (!clocks.scans_late_s || !input::trimmed(options.scan_clock).empty()) return {};
    const double stamps_s = *clocks.scans_late_s;
    const double late_s = stamps_s - options.scan_delay_s;
    if (std::abs(late_s) < kAlmostNone) return {};
    return {
        {TourFinding::Kind::late_stamps,
         late_s,
         message(HITOS_TEXT("Errors",
                            "by the logger's times the stamps of %1 are %2 s behind those of %3: "
                            "the clocks of their computers differ"),
                 stamps_s < 0.0 ? "ODOM" : clocks.scans, fmt::format("{:.2f}", std::abs(stamps_s)),
                 stamps_s < 0.0 ? clocks.scans : "ODOM"),
         {added_difference(WholeValues(options).later_by(late_s))},
         late_s}};
}

}  // namespace hitos
