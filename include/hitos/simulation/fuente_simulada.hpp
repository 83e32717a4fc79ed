// A simulated tour as a source of log lines, without a file.
#pragma once

#include <memory>
#include <string>

#include "hitos/capture/fuente.hpp"
#include "hitos/simulation/simulated_tour.hpp"

namespace hitos {

/// Makes the lines of the normalised log of the tour as they are asked for, number and text equal
/// to those that write_tour() puts into a file. Copies and reopened sources share the driven tour.
class FuenteSimulada final : public Fuente {
  public:
    explicit FuenteSimulada(std::shared_ptr<const SimulatedTour> tour);

    LogFormat format() const override { return LogFormat::normalized; }
    std::optional<RawLine> read_scan_line() override;
    std::optional<RawLine> read_odometry_line() override;
    std::optional<double> progress() const override;
    std::string name() const override { return tour_->world().file; }
    std::optional<std::pair<std::uint64_t, std::string>> take_damage() override { return {}; }
    std::unique_ptr<Fuente> reopen() const override;

    const SimulatedTour& tour() const { return *tour_; }

  private:
    std::shared_ptr<const SimulatedTour> tour_;
    OdometryNoise noise_;
    std::uint64_t scan_ = 0;             // the next one
    std::uint64_t reading_ = 0;          // the next one
    std::uint64_t readings_before_ = 0;  // readings that stand before the next scan's line
    std::uint64_t scans_before_ = 0;     // scans that stand before the next reading's line
    std::string scan_text_;
    std::string reading_text_;
};

}  // namespace hitos
