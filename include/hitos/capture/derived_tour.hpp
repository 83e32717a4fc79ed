// SPDX-License-Identifier: GPL-3.0-or-later
// A tour that is made of another one.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hitos/capture/tour_reader.hpp"

namespace hitos {

/// Is the other tour in whatever is not overridden.
class DerivedTour : public TourReader {
  public:
    explicit DerivedTour(std::unique_ptr<TourReader> tour) : tour_(std::move(tour)) {}

    std::optional<Scan> next_scan() override { return tour_->next_scan(); }
    std::optional<Odometria> next_odometry() override { return tour_->next_odometry(); }
    void restart() override { tour_->restart(); }
    const ReadReport& report() const override { return tour_->report(); }
    std::optional<double> progress() const override { return tour_->progress(); }
    std::string name() const override { return tour_->name(); }
    std::string format() const override { return tour_->format(); }
    ReadOptions options() const override { return tour_->options(); }
    std::vector<TourFinding> findings() const override { return tour_->findings(); }
    std::optional<Truth> truth() const override { return tour_->truth(); }

  protected:
    TourReader& tour() const { return *tour_; }

  private:
    std::unique_ptr<TourReader> tour_;
};

}  // namespace hitos
