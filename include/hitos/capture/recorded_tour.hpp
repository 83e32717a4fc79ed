// SPDX-License-Identifier: GPL-3.0-or-later
// A tour read once and handed to many runs.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hitos/capture/tour_reader.hpp"

namespace hitos {

/// Asked before something grows by so many bytes; where it says no, it is not made.
using MayGrow = std::function<bool(std::size_t bytes)>;

/// All that a reader has to give; immutable and so safe to share between threads.
struct RecordedTour {
    /// What the reader has counted of a sequence once it was asked for so many of its items; the
    /// numbers of scans and readings do not count.
    struct Note {
        std::uint64_t reads = 0;
        ReadReport report;
    };
    /// Scans or readings, and what was left out between them.
    template <class Item>
    struct Sequence {
        std::deque<Item> items;
        std::vector<Note> notes;
    };

    Sequence<Scan> scans;
    Sequence<Odometria> odometry;
    std::optional<Truth> truth;
    std::string name;
    std::string format;
    ReadOptions options;        ///< how it was read
    bool of_recording = false;  ///< ReadReport::of_recording
    std::vector<TourFinding> findings;
};

/// All of the tour that `reader` reads, which is left where it is; null where that may not grow so
/// large. Throws what reading throws.
std::shared_ptr<const RecordedTour> record_tour(const TourReader& reader, const MayGrow& may_grow);

/// Gives what the reader of the tour would, and reports what that would have at the same place;
/// progress goes by scans.
class RecordedReader final : public TourReader {
  public:
    explicit RecordedReader(std::shared_ptr<const RecordedTour> tour) : tour_(std::move(tour)) {
        report_.of_recording = tour_->of_recording;
    }

    std::optional<Scan> next_scan() override;
    std::optional<Odometria> next_odometry() override;
    void restart() override;
    std::unique_ptr<TourReader> reopen() const override;
    const ReadReport& report() const override { return report_; }
    std::optional<double> progress() const override;
    std::string name() const override { return tour_->name; }
    std::string format() const override { return tour_->format; }
    ReadOptions options() const override { return tour_->options; }
    std::vector<TourFinding> findings() const override { return tour_->findings; }
    std::optional<Truth> truth() const override { return tour_->truth; }

  private:
    /// How far a sequence is read.
    struct Place {
        std::size_t items = 0;
        std::size_t notes = 0;
    };
    template <class Item>
    std::optional<Item> next(const RecordedTour::Sequence<Item>& sequence, Place& place);
    void note_report();

    std::shared_ptr<const RecordedTour> tour_;
    Place scans_;
    Place odometry_;
    ReadReport report_;
};

}  // namespace hitos
