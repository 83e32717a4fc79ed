// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/remembered_tour.hpp"

#include <utility>

namespace hitos {

std::optional<Scan> RememberedTour::next_scan() {
    auto& scans = tour_->scans.items;
    if (whole_ && at_.scans < scans.size()) return scans[at_.scans++];
    if (scans_end_) return std::nullopt;
    std::optional<Scan> scan = reader_->next_scan();
    if (!scan) {
        scans_end_ = true;
        note_end();
        return scan;
    }
    ++at_.scans;
    if (whole_) {
        scans.push_back(*scan);
        progress_.push_back(reader_->progress());
        note_bytes(sizeof(Scan) + scan->points.size() * sizeof(Point2) +
                   scan->landmarks.size() * sizeof(LandmarkSighting) +
                   (scan->rays.size() + scan->run_starts.size()) * sizeof(std::uint32_t));
    }
    return scan;
}

std::optional<Odometria> RememberedTour::next_odometry() {
    auto& odometry = tour_->odometry.items;
    if (whole_ && at_.odometry < odometry.size()) return odometry[at_.odometry++];
    if (odometry_end_) return std::nullopt;
    const std::optional<Odometria> reading = reader_->next_odometry();
    if (!reading) {
        odometry_end_ = scans_end_;  // else of a tour that is being driven more may come
        note_end();
        return reading;
    }
    ++at_.odometry;
    if (whole_) {
        odometry.push_back(*reading);
        note_bytes(sizeof(Odometria));
    }
    return reading;
}

/// The newest reading is at hand still: the reader goes on behind it.
void RememberedTour::note_bytes(std::size_t bytes) {
    bytes_ += bytes;
    if (bytes_ <= most_bytes_) return;
    // Only where both sequences are at their ends may they be left: else what was read ahead of
    // one of them would be lost.
    if (at_.scans < tour_->scans.items.size() || at_.odometry < tour_->odometry.items.size())
        return;
    whole_ = false;
    tour_ = std::make_shared<RecordedTour>();
    progress_ = {};
}

/// From here on the tour does not change: it may be read by others at the same time.
void RememberedTour::note_end() {
    if (!at_end()) return;
    tour_->name = reader_->name();
    tour_->format = reader_->format();
    tour_->options = reader_->options();
    tour_->findings = reader_->findings();
    tour_->truth = reader_->truth();
    tour_->of_recording = reader_->report().of_recording;
    // When what was left out lay between the scans is not known any more.
    tour_->scans.notes.push_back({tour_->scans.items.size() + 1, reader_->report()});
}

std::unique_ptr<TourReader> RememberedTour::reopen() const {
    if (!at_end()) return reader_->reopen();
    return std::make_unique<RecordedReader>(tour_);
}

std::vector<TourFinding> RememberedTour::findings() const {
    return at_end() ? tour_->findings : reader_->findings();
}

std::optional<double> RememberedTour::progress() const {
    if (!whole_ || at_.scans == 0 || at_.scans >= progress_.size()) return reader_->progress();
    return progress_[at_.scans - 1];
}

void RememberedTour::restart() {
    reader_->restart();
    *this = RememberedTour(std::move(reader_), most_bytes_);
}

}  // namespace hitos
