// SPDX-License-Identifier: GPL-3.0-or-later
// A simulated tour as a reader: no file, no text in between.
#pragma once

#include <memory>
#include <string>

#include "hitos/capture/odometry_track.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "hitos/simulation/drive/simulated_tour.hpp"
#include "hitos/simulation/worlds/odometry_noise.hpp"

namespace hitos {

/// Makes scans and odometry, noise and all, as they are asked for; the numbers of their lines are
/// those that a log of the tour would have. Reopened readers share the driven tour. Scans of a
/// laser that sweeps are unwarped by this odometry, as Procesador does.
class SimulatedTourReader final : public TourReader {
  public:
    /// Throws ConfigError where the options say where the laser sits: the world does.
    explicit SimulatedTourReader(std::shared_ptr<const SimulatedTour> tour,
                                 ReadOptions options = {});

    std::optional<Scan> next_scan() override;
    std::optional<Odometria> next_odometry() override;
    void restart() override;
    std::unique_ptr<TourReader> reopen() const override;
    const ReadReport& report() const override { return report_; }
    std::optional<double> progress() const override;
    std::string name() const override { return tour_->world().file; }
    std::string format() const override { return kWorldFormat; }
    ReadOptions options() const override { return options_; }
    std::vector<TourFinding> findings() const override;  ///< about the walls of its drawing
    std::optional<Truth> truth() const override;
    const std::shared_ptr<const SimulatedTour>& tour() const { return tour_; }

  private:
    std::shared_ptr<const SimulatedTour> tour_;
    ReadOptions options_;
    OdometryNoise noise_;
    ReadReport report_;
    std::uint64_t taken_ = 0;               // scans, handed out or left out
    std::unique_ptr<OdometryTrack> track_;  // where scans are unwarped
    std::uint64_t readings_before_ = 0;     // readings that stand before the next scan's line
    std::uint64_t scans_before_ = 0;        // scans that stand before the next reading's line
};

}  // namespace hitos
