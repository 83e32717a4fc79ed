#include "hitos/simulation/fuente_simulada.hpp"

#include <utility>

#include "hitos/capture/normalized_text.hpp"

namespace hitos {

FuenteSimulada::FuenteSimulada(std::shared_ptr<const SimulatedTour> tour)
    : tour_(std::move(tour)),
      noise_(tour_->world().odometry.noise, tour_->world().odometry.noise_kind,
             tour_->world().seed) {}

std::optional<RawLine> FuenteSimulada::read_scan_line() {
    if (scan_ >= tour_->scans()) return std::nullopt;
    const double time_s = tour_->scan_time(scan_);
    while (readings_before_ < tour_->readings() && tour_->reading_time(readings_before_) <= time_s)
        ++readings_before_;
    scan_text_.clear();
    append_normalized(scan_text_, tour_->scan(scan_));
    ++scan_;
    return RawLine{scan_text_, scan_ + readings_before_, false};
}

std::optional<RawLine> FuenteSimulada::read_odometry_line() {
    if (reading_ >= tour_->readings()) return std::nullopt;
    const double time_s = tour_->reading_time(reading_);
    while (scans_before_ < tour_->scans() && tour_->scan_time(scans_before_) < time_s)
        ++scans_before_;
    reading_text_.clear();
    append_normalized(reading_text_, noise_(tour_->true_reading(reading_)));
    ++reading_;
    return RawLine{reading_text_, reading_ + scans_before_, false};
}

std::optional<double> FuenteSimulada::progress() const {
    return static_cast<double>(scan_) / static_cast<double>(tour_->scans());
}

std::unique_ptr<Fuente> FuenteSimulada::reopen() const {
    return std::make_unique<FuenteSimulada>(tour_);
}

}  // namespace hitos
