// SPDX-License-Identifier: GPL-3.0-or-later
// A tour that can be read again from any place that it has been read to.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hitos/capture/recorded_tour.hpp"
#include "hitos/capture/tour_reader.hpp"

namespace hitos {

/// Keeps what another reader gives, up to a limit of memory. Scans and odometry are the same to the
/// last bit however often they are read, and once both are at their ends nobody who reads the tour
/// anew has to go back to where it comes from.
class RememberedTour final : public TourReader {
  public:
    static constexpr std::size_t kMostBytes = std::size_t{512} << 20;

    /// How much of both sequences has been read.
    struct Place {
        std::size_t scans = 0;
        std::size_t odometry = 0;
    };

    explicit RememberedTour(std::unique_ptr<TourReader> reader, std::size_t most_bytes = kMostBytes)
        : reader_(std::move(reader)), most_bytes_(most_bytes) {}

    std::optional<Scan> next_scan() override;
    std::optional<Odometria> next_odometry() override;
    void restart() override;
    std::unique_ptr<TourReader> reopen() const override;

    /// Of all that was read, up to the furthest place.
    const ReadReport& report() const override { return reader_->report(); }
    /// At the place where it is read now.
    std::optional<double> progress() const override;
    std::string name() const override { return reader_->name(); }
    std::string format() const override { return reader_->format(); }
    ReadOptions options() const override { return reader_->options(); }
    std::vector<TourFinding> findings() const override;
    std::optional<Truth> truth() const override { return reader_->truth(); }

    Place place() const { return at_; }
    /// Whether nothing had to be forgotten: go_to() is possible.
    bool whole() const { return whole_; }
    /// Goes on from a place that it has been at. Only where whole().
    void go_to(const Place& place) { at_ = place; }

  private:
    void note_bytes(std::size_t bytes);
    void note_end();
    bool at_end() const { return whole_ && scans_end_ && odometry_end_; }

    std::unique_ptr<TourReader> reader_;
    std::size_t most_bytes_;
    std::size_t bytes_ = 0;
    bool whole_ = true;
    Place at_;
    std::shared_ptr<RecordedTour> tour_ = std::make_shared<RecordedTour>();
    std::vector<std::optional<double>> progress_;  // after each scan
    bool scans_end_ = false;                       // is known
    bool odometry_end_ = false;
};

}  // namespace hitos
