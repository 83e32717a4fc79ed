// SPDX-License-Identifier: GPL-3.0-or-later
// Tours that are made wrong on purpose, and what is told of them.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hitos/capture/tour_examination.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/shipped_data.hpp"

namespace hitos::test {

/// That a ray of the scan ends so far from the laser.
inline void add_reading(Scan& scan, std::uint32_t ray, double range_m) {
    const double angle = scan.fan.angle_rad(ray);
    scan.points.push_back(transform(scan.fan.pose_robot_laser,
                                    Point2{range_m * std::cos(angle), range_m * std::sin(angle)}));
    scan.rays.push_back(ray);
}

/// A tour wholly read, to be made wrong.
struct Readings {
    std::vector<Scan> scans;
    std::vector<Odometria> odometry;

    std::vector<TourFinding> findings() const {
        TourExamination examination{ReadOptions{}};
        auto reading = odometry.begin();
        for (const Scan& scan : scans) {
            for (; reading != odometry.end() && reading->line <= scan.line; ++reading)
                examination.note(*reading);
            examination.note(scan);
        }
        for (; reading != odometry.end(); ++reading) examination.note(*reading);
        return examination.findings();
    }
    std::optional<TourFinding> of_kind(TourFinding::Kind kind) const {
        for (const TourFinding& finding : findings()) {
            if (finding.kind == kind) return finding;
        }
        return std::nullopt;
    }
    /// What is said of it, for the message of a test that fails.
    std::string said() const {
        std::string words;
        for (const TourFinding& finding : findings()) words += finding.what.english() + '\n';
        return words;
    }
};

inline Readings read(const SourceParams& params) {
    const std::unique_ptr<TourReader> reader = open_tour(params);
    Readings readings;
    while (auto scan = reader->next_scan()) readings.scans.push_back(std::move(*scan));
    while (const auto reading = reader->next_odometry()) readings.odometry.push_back(*reading);
    return readings;
}

inline Readings read(const std::string& source) {
    SourceParams params;
    params.file = source;
    return read(params);
}

}  // namespace hitos::test
