// SPDX-License-Identifier: GPL-3.0-or-later
#include "remedies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "hitos/base/text_input.hpp"
#include "hitos/capture/archivo.hpp"
#include "laser_units.hpp"

namespace hitos {
namespace {

using Settings = WholeValues::Settings;

/// No digits that nobody has measured.
std::string digits(double value) {
    return fmt::format("{:.4g}", value);
}

}  // namespace

std::string hundredths_of(double value) {
    constexpr double kNone = 0.005;  // else "-0.00"
    return fmt::format("{:.2f}", std::abs(value) < kNone ? 0.0 : value);
}

Settings set(std::string_view key, std::string value) {
    return {{std::string(key), std::move(value)}};
}

Settings laser_at(const LaserPose& pose) {
    return set(kLaserPoseKey, text_of(pose));
}

Settings operator+(Settings some, Settings more) {
    for (SourceSetting& one : more) some.push_back(std::move(one));
    return some;
}

Settings WholeValues::later_by(double seconds) const {
    if (!input::trimmed(read_->scan_clock).empty()) return clock(ScanClock::always(seconds));
    return set(kScanDelayKey, hundredths_of(read_->scan_delay_s + seconds));
}

Settings WholeValues::clock(const ScanClock& added) const {
    const ScanClock known = ScanClock(read_->scan_clock).plus(read_->scan_delay_s);
    Settings settings = set(kScanClockKey, known.plus(added).text());
    if (read_->scan_delay_s != 0.0) settings = settings + set(kScanDelayKey, "0");
    return settings;
}

Settings WholeValues::range_scale(double times) const {
    Settings settings = set("source.range_scale", digits(read_->range_scale * times));
    if (read_->range_offset_m != 0.0) {
        settings =
            settings + set("source.range_offset", hundredths_of(read_->range_offset_m * times));
    }
    return settings;
}

Settings WholeValues::range_offset(double metres) const {
    return set("source.range_offset", hundredths_of(read_->range_offset_m + metres));
}

Settings WholeValues::fan_scale(double times) const {
    return set("source.fan_scale", digits(read_->fan_scale * times));
}

Settings WholeValues::odometry_scale(double times) const {
    return set("source.odometry_scale", digits(read_->odometry_scale * times));
}

Settings WholeValues::odometry_turns(double times) const {
    return set("source.odometry_turns", digits(read_->odometry_turns * times));
}

Settings WholeValues::axes(const OdometryAxes& of_read) const {
    return set(kOdometryAxesKey, OdometryAxes(read_->odometry_axes).then(of_read).text());
}

Message say_so() {
    return marked(HITOS_TEXT("Errors", "say so"));
}

Message added_to_times() {
    return marked(HITOS_TEXT("Errors", "add that to their times, in all"));
}

Remedy added_difference(Settings delay) {
    return {marked(HITOS_TEXT("Errors", "add the difference to the scans' times")),
            std::move(delay)};
}

std::vector<Remedy> millimetres_or_centimetres(const ReadOptions& read) {
    std::vector<Remedy> remedies;
    for (const LengthUnit& unit : {kMillimetre, kCentimetre}) {
        remedies.push_back({message(HITOS_TEXT("Errors", "if they are %1"), marked(unit.name)),
                            WholeValues(read).range_scale(unit.metres)});
    }
    return remedies;
}

Remedy take_it_from_scans() {
    return {marked(HITOS_TEXT("Errors",
                              "take how it moved from the scans, where they show enough for that")),
            set("source.odometry", "scans")};
}

Remedy take_velocities() {
    return {marked(HITOS_TEXT("Errors", "take the velocities")),
            set("source.odometry", "velocities")};
}

Remedy take_poses() {
    return {marked(HITOS_TEXT("Errors", "take the poses")), set("source.odometry", "poses")};
}

Remedy map_with_registration() {
    return {marked(HITOS_TEXT(
                "Errors",
                "map it with registration, which finds what is left of it: --preset recorded")),
            {},
            true};
}

std::string options_of(const std::vector<SourceSetting>& settings) {
    std::string options;
    const bool of_clock = std::ranges::count(settings, kScanClockKey, &SourceSetting::key) > 0;
    for (const auto& [key, value] : settings) {
        if (key == kScanDelayKey && of_clock) continue;  // a table leaves no other delay
        if (!options.empty()) options += ' ';
        if (key == kScanDelayKey || key == kScanClockKey) {
            options += "--scan-delay " + value;
        } else if (key == kLaserPoseKey) {
            options += "--laser-pose " + value;
        } else {
            options += fmt::format("--set {}={}", key, value);
        }
    }
    return options;
}

Message advice_of(const TourFinding& finding) {
    Message all;
    for (const Remedy& remedy : finding.remedies) {
        const Message one = remedy.settings.empty()
                                ? remedy.words
                                : message("%1: %2", remedy.words, options_of(remedy.settings));
        all = all.empty() ? one : message("%1; %2", all, one);
    }
    return all;
}

Message sentence_of(const TourFinding& finding) {
    const Message advice = advice_of(finding);
    return advice.empty() ? finding.what : message("%1; %2", finding.what, advice);
}

}  // namespace hitos
