// SPDX-License-Identifier: GPL-3.0-or-later
#include "tour_laws.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "hitos/capture/archivo.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/capture/log_writer.hpp"
#include "hitos/capture/procesador.hpp"
#include "laws.hpp"

namespace hitos::fuzz {
namespace {

bool is_finite_twist(const Twist& twist) {
    return std::isfinite(twist.v) && std::isfinite(twist.v_lateral) && std::isfinite(twist.w);
}

void require_sound(const Scan& scan) {
    require(std::isfinite(scan.time_s), "a scan's stamp is finite");
    require(std::ranges::all_of(scan.points,
                                [](const Point2& point) {
                                    return std::isfinite(point.x) && std::isfinite(point.y);
                                }),
            "a scan's points are finite");
    require(std::ranges::all_of(scan.landmarks,
                                [](const LandmarkSighting& seen) {
                                    return std::isfinite(seen.bearing_rad) &&
                                           std::isfinite(seen.range_m) && seen.range_m >= 0.0 &&
                                           seen.identity >= LandmarkSighting::kNameless;
                                }),
            "a scan's landmarks are somewhere");
    require(scan.rays.empty() || scan.rays.size() == scan.points.size(), "every point has its ray");
    require(scan.points.empty() == scan.run_starts.empty(), "points belong to runs");
    if (scan.run_starts.empty()) return;
    require(scan.run_starts.front() == 0, "the first run begins with the first point");
    require(
        std::ranges::adjacent_find(scan.run_starts, std::greater_equal{}) == scan.run_starts.end(),
        "runs come one after the other");
    require(scan.run_starts.back() < scan.points.size(), "every run has a point");
}

/// Neither empty nor beyond where any tour goes; what decimals of the formats hold is not asked of
/// greater values.
bool is_of_this_world(const Tour& tour) {
    constexpr double kLastStamp = 1e9;  // s
    constexpr double kFarthest = 1e4;   // m
    constexpr double kFastest = 1e4;    // m/s, rad/s
    constexpr double kWidest = 100.0;   // rad
    if (tour.scans.empty() && tour.odometry.empty()) return false;
    const auto within = [](double value, double greatest) { return std::abs(value) <= greatest; };
    return std::ranges::all_of(tour.scans,
                               [&](const Scan& scan) {
                                   return within(scan.time_s, kLastStamp) &&
                                          within(scan.fan.min_angle_rad, kWidest) &&
                                          within(scan.fan.max_angle_rad, kWidest) &&
                                          std::ranges::all_of(scan.points, [&](const Point2& p) {
                                              return within(p.x, kFarthest) &&
                                                     within(p.y, kFarthest);
                                          });
                               }) &&
           std::ranges::all_of(tour.odometry, [&](const Odometria& reading) {
               return within(reading.time_s, kLastStamp) && within(reading.twist.v, kFastest) &&
                      within(reading.twist.v_lateral, kFastest) &&
                      within(reading.twist.w, kFastest);
           });
}

Tour read_file(const std::filesystem::path& file, std::string_view format,
               Order order = Order::scans_first) {
    Procesador reader(open_log(file, format));
    return read_tour(reader, order);
}

bool same_readings(const Tour& a, const Tour& b) {
    return a.scans == b.scans && a.odometry == b.odometry;
}

/// Whether the format could say the tour, and its file then.
std::optional<std::filesystem::path> written(const std::filesystem::path& file,
                                             std::string_view source_format,
                                             const std::string& target_format) {
    static const ScratchFolder scratch;
    return unless_refused([&] {
        std::filesystem::path target = scratch.path() / (target_format + ".log");
        Procesador reader(open_log(file, source_format));
        const auto writer = make_log_writer(target_format, target);
        write_tour(reader, *writer);
        writer->finish();
        return target;
    });
}

/// The normalised format keeps every bit of a tour whose stamps advance.
void check_normalized_copy(const std::filesystem::path& file, std::string_view format,
                           const Tour& tour) {
    const auto copy = written(file, format, "normalized");
    require(copy.has_value(), "every tour can be written in the normalised format");
    const Tour again = read_file(*copy, "normalized");
    require(again.report.skipped == 0, "a normalised copy is without damage");
    require(again.odometry.size() == tour.odometry.size(), "a normalised copy has all odometry");
    require(std::ranges::equal(tour.odometry, again.odometry,
                               [](const Odometria& a, const Odometria& b) {
                                   return a.time_s == b.time_s && a.twist == b.twist;
                               }),
            "a normalised copy has the odometry to the last bit");
    require(again.scans.size() + again.report.duplicate_scans == tour.scans.size(),
            "a normalised copy has all scans");
    const bool in_order = tour.report.stamps_backwards == 0 && again.report.duplicate_scans == 0 &&
                          std::ranges::is_sorted(tour.scans, {}, &Scan::time_s) &&
                          std::ranges::none_of(tour.scans, &Scan::carries_odometry);
    if (!in_order) return;
    require(std::ranges::equal(tour.scans, again.scans,
                               [](const Scan& a, const Scan& b) {
                                   return a.time_s == b.time_s && a.run_starts == b.run_starts &&
                                          a.points.size() == b.points.size();
                               }),
            "a normalised copy has the same scans");
}

/// In the other formats nothing is damaged, and no reading is lost.
void check_copy(const std::filesystem::path& file, std::string_view format, const Tour& tour) {
    const auto copy = written(file, format, std::string(format));
    if (!copy) return;
    const Tour again = read_file(*copy, format);
    require(again.report.skipped == 0, "a copy in the same format is without damage");
    require(again.scans.size() + again.report.duplicate_scans == tour.scans.size(),
            "a copy in the same format has all scans");
}

}  // namespace

Tour read_tour(TourReader& reader, Order order) {
    Tour tour;
    bool more_scans = order != Order::odometry_first;
    bool more_odometry = true;
    const auto take_scan = [&] {
        std::optional<Scan> scan = reader.next_scan();
        more_scans = scan.has_value();
        if (scan) tour.scans.push_back(*std::move(scan));
    };
    const auto take_reading = [&] {
        const std::optional<Odometria> reading = reader.next_odometry();
        more_odometry = reading.has_value();
        if (reading) tour.odometry.push_back(*reading);
    };
    while (more_scans) {
        take_scan();
        if (order == Order::in_turns && more_odometry) take_reading();
    }
    while (more_odometry) take_reading();
    if (order == Order::odometry_first) {
        do take_scan();
        while (more_scans);
    }
    tour.report = reader.report();
    return tour;
}

void require_sound(const Tour& tour, DamageIs damage) {
    for (const Scan& scan : tour.scans) require_sound(scan);
    require(std::ranges::all_of(tour.odometry,
                                [](const Odometria& reading) {
                                    return std::isfinite(reading.time_s) &&
                                           is_finite_twist(reading.twist);
                                }),
            "odometry is finite");
    require(std::ranges::adjacent_find(tour.odometry, std::greater_equal{}, &Odometria::time_s) ==
                tour.odometry.end(),
            "odometry's stamps advance");
    require(tour.report.scans == tour.scans.size(), "scans are counted");
    require(tour.report.odometry == tour.odometry.size(), "odometry is counted");
    // A line is damage, or a scan, or odometry, or both of these; of a message a part is damage. A
    // stamp that is out of line among those of scans may be in line among those of odometry.
    std::set<std::uint64_t> useful;
    for (const Scan& scan : tour.scans) useful.insert(scan.line);
    for (const Odometria& reading : tour.odometry) useful.insert(reading.line);
    require(damage == DamageIs::part ||
                std::ranges::none_of(tour.report.examples,
                                     [&](const auto& skip) {
                                         return useful.contains(skip.line) &&
                                                !skip.reason.english().starts_with("its time, ");
                                     }),
            "no line is damage and used");
    require(tour.report.examples.size() ==
                std::min<std::uint64_t>(tour.report.skipped, ReadReport::kExamples),
            "damage is told by examples");
}

bool check_log(std::string_view input, std::string_view format) {
    const std::filesystem::path& file = file_of(input);
    const auto reader =
        unless_refused([&] { return std::make_unique<Procesador>(open_log(file, format)); });
    if (!reader) return false;
    const Tour tour = read_tour(**reader);
    const bool recording = log_formats().find(format).open != nullptr;
    require_sound(tour, recording ? DamageIs::part : DamageIs::whole);
    constexpr std::uint32_t kLaws = 4;
    switch (turn_of(input, kLaws)) {
        case 0:
            (*reader)->restart();
            require(same_readings(tour, read_tour(**reader)), "a log reads twice alike");
            break;
        case 1:
            for (const Order order : {Order::odometry_first, Order::in_turns}) {
                const Tour other = read_file(file, format, order);
                require(same_readings(tour, other) && tour.report.skipped == other.report.skipped,
                        "scans and odometry do not depend on the order in which they are read");
            }
            break;
        case 2:
            if (is_of_this_world(tour)) check_normalized_copy(file, format, tour);
            break;
        default:
            // A recording without a scan is none of a laser.
            if (format != "normalized" && is_of_this_world(tour) &&
                !(recording && tour.scans.empty())) {
                check_copy(file, format, tour);
            }
    }
    return true;
}

}  // namespace hitos::fuzz
