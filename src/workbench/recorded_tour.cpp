#include "hitos/workbench/recorded_tour.hpp"

namespace hitos {

RecordedTour::RecordedTour(TourReader& reader) {
    while (std::optional<Scan> scan = reader.next_scan()) scans.push_back(*std::move(scan));
    while (const std::optional<Odometria> reading = reader.next_odometry()) {
        odometry.push_back(*reading);
    }
    report = reader.report();
    truth = reader.truth();
}

const RecordedTour& RecordedReader::tour() {
    if (!tour_) {
        tour_ = open_();
        report_ = tour_->report;  // what was left out
        report_.scans = report_.odometry = 0;
    }
    return *tour_;
}

std::optional<Scan> RecordedReader::next_scan() {
    if (report_.scans == tour().scans.size()) return std::nullopt;
    return tour_->scans[report_.scans++];
}

std::optional<Odometria> RecordedReader::next_odometry() {
    if (report_.odometry == tour().odometry.size()) return std::nullopt;
    return tour_->odometry[report_.odometry++];
}

void RecordedReader::restart() {
    report_.scans = report_.odometry = 0;
}

std::unique_ptr<TourReader> RecordedReader::reopen() const {
    return std::make_unique<RecordedReader>(name_, format_, open_);
}

std::optional<double> RecordedReader::progress() const {
    if (!tour_ || tour_->scans.empty()) return 0.0;
    return static_cast<double>(report_.scans) / static_cast<double>(tour_->scans.size());
}

}  // namespace hitos
