// SPDX-License-Identifier: GPL-3.0-or-later
#include "corrected_tour.hpp"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/capture/corrected_log.hpp"
#include "hitos/capture/derived_tour.hpp"

namespace hitos {
namespace {

/// A tour as far as a run that was stopped has taken it.
class TourSoFar final : public DerivedTour {
  public:
    /// `whole`: the run has come to the end; what odometry follows on the last scan is part of it.
    TourSoFar(std::unique_ptr<TourReader> tour, std::size_t scans, bool whole)
        : DerivedTour(std::move(tour)), scans_(scans), whole_(whole), left_(scans) {}

    std::optional<Scan> next_scan() override {
        if (left_ == 0) return std::nullopt;
        --left_;
        return tour().next_scan();
    }
    std::optional<Odometria> next_odometry() override {
        if (left_ == 0 && !whole_) return std::nullopt;
        return tour().next_odometry();
    }
    void restart() override {
        tour().restart();
        left_ = scans_;
    }
    std::unique_ptr<TourReader> reopen() const override {
        return std::make_unique<TourSoFar>(tour().reopen(), scans_, whole_);
    }

  private:
    std::size_t scans_;
    bool whole_;
    std::size_t left_;
};

}  // namespace

void write_corrected_tour(const Algoritmo& run, const Trajectory& path,
                          const std::filesystem::path& file) {
    const std::optional<Scan> first = run.reader().reopen()->next_scan();
    if (!first) throw Error(message(HITOS_TEXT("Errors", "the tour has no scan to write")));
    std::vector<Pose> poses;
    for (const StampedPose& stamped : path) poses.push_back(stamped.pose);
    TourSoFar tour(run.reader().reopen(), poses.size(), run.finished());
    const auto writer = make_corrected_log_writer(file, std::move(poses), *first);
    write_tour(tour, *writer);
    writer->finish();
}

}  // namespace hitos
