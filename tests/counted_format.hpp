// SPDX-License-Identifier: GPL-3.0-or-later
// A log format of the tests' own that counts how often a scan is made of a line.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include "hitos/base/error.hpp"
#include "hitos/capture/conversor.hpp"
#include "hitos/capture/log_format.hpp"

namespace hitos::test {

inline std::atomic<int> scans_made = 0;

/// `C time`: a scan of a corner of walls, and a reading of a robot that drives on by 5 cm.
class CountedConversor final : public Conversor {
  public:
    std::optional<Scan> scan(const RawLine& line) override {
        ++scans_made;
        constexpr std::uint32_t kRays = 91;
        constexpr double kAhead = 3.0;  // the walls, and to the left of it [m]
        Scan scan;
        scan.line = line.number;
        scan.time_s = time_of(line);
        scan.fan = {0.0, kPi / 2.0, kRays, 10.0, {}};
        scan.run_starts = {0};
        for (std::uint32_t ray = 0; ray < kRays; ++ray) {
            const double angle = scan.fan.angle_rad(ray);
            const double ahead_m = kAhead - kStep * scan.time_s;
            const double range = std::min(ahead_m / std::max(1e-9, std::cos(angle)),
                                          kAhead / std::sin(angle + 1e-9));
            scan.points.push_back({range * std::cos(angle), range * std::sin(angle)});
            scan.rays.push_back(ray);
        }
        return scan;
    }
    std::optional<OdometryRecord> odometry(const RawLine& line) override {
        OdometryRecord record;
        record.line = line.number;
        record.time_s = time_of(line);
        record.pose_odom_robot = Pose{kStep * record.time_s, 0.0, 0.0};
        return record;
    }

    static std::string log(int scans) {
        std::string text;
        for (int i = 0; i < scans; ++i) text += "C " + std::to_string(i) + '\n';
        return text;
    }

  private:
    static constexpr double kStep = 0.05;
    static double time_of(const RawLine& line) {
        std::istringstream in{std::string(line.text.substr(1))};
        double time_s = 0.0;
        if (!(in >> time_s)) throw FormatError("", line.number, verbatim("expected a time"));
        return time_s;
    }
};

/// Before anything is read.
inline bool add_counted_format() {
    LogFormat format{{"counted", "Counted", "of tests"}};
    format.claims = [](std::string_view line) { return line.starts_with("C "); };
    format.classify = [](std::string_view line) {
        return line.starts_with("C ") ? LineKind::both : LineKind::damaged;
    };
    format.make_conversor = [](const Fuente& /*fuente*/,
                               const ReadOptions& /*options*/) -> std::unique_ptr<Conversor> {
        return std::make_unique<CountedConversor>();
    };
    log_formats().add(format);
    return true;
}

}  // namespace hitos::test
