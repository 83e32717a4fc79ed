#include "hitos/capture/remembered_tour.hpp"

#include <utility>

namespace hitos {

std::optional<Scan> RememberedTour::next_scan() {
    if (whole_ && at_.scans < scans_.size()) return scans_[at_.scans++];
    std::optional<Scan> scan = reader_->next_scan();
    if (!scan) return scan;
    ++at_.scans;
    if (whole_) {
        scans_.push_back(*scan);
        progress_.push_back(reader_->progress());
        note_bytes(sizeof(Scan) + scan->points.size() * sizeof(Point2) +
                   (scan->rays.size() + scan->run_starts.size()) * sizeof(std::uint32_t));
    }
    return scan;
}

std::optional<Odometria> RememberedTour::next_odometry() {
    if (whole_ && at_.odometry < odometry_.size()) return odometry_[at_.odometry++];
    const std::optional<Odometria> reading = reader_->next_odometry();
    if (!reading) return reading;
    ++at_.odometry;
    if (whole_) {
        odometry_.push_back(*reading);
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
    if (at_.scans < scans_.size() || at_.odometry < odometry_.size()) return;
    whole_ = false;
    scans_ = {};
    progress_ = {};
    odometry_ = {};
}

std::optional<double> RememberedTour::progress() const {
    if (!whole_ || at_.scans == 0 || at_.scans >= progress_.size()) return reader_->progress();
    return progress_[at_.scans - 1];
}

void RememberedTour::restart() {
    reader_->restart();
    whole_ = true;
    bytes_ = 0;
    at_ = {};
    scans_.clear();
    progress_.clear();
    odometry_.clear();
}

}  // namespace hitos
