// SPDX-License-Identifier: GPL-3.0-or-later
// A tour that comes in while the window maps it.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "hitos/capture/live_source.hpp"
#include "hitos/services/configuration/configuracion.hpp"

namespace hitos {
class TourReader;
}

namespace hitos::window {

/// Counts the scans that are there, with their odometry, so that a run is never sent to one that is
/// still to come: it would wait for it, and could be stopped by nobody. A thread of its own reads
/// the tour for that.
class IncomingTour {
  public:
    /// Called by that thread for every scan, and at the end.
    using Arrived = std::function<void()>;

    IncomingTour(std::shared_ptr<LiveSource> source, Arrived arrived)
        : source_(std::move(source)), arrived_(std::move(arrived)) {}
    /// The tour is what has come by now, and nobody is called any more.
    ~IncomingTour();
    IncomingTour(const IncomingTour&) = delete;
    IncomingTour& operator=(const IncomingTour&) = delete;

    LiveSource& source() const { return *source_; }
    /// Whether that configuration's source is what comes in, from the same beginning.
    bool is_of(const Configuracion& configuration) const;

    /// From now on scans are those that come by this configuration's source; those that were there
    /// already came when they did.
    void count(const Configuracion& configuration);
    /// To be read by a run, to the scans that are there; reopened it is the file as it is then.
    /// Throws what open_tour() throws.
    std::unique_ptr<TourReader> open(const Configuracion& configuration) const;
    std::uint64_t scans() const;
    /// Whether more may come.
    bool is_live() const;
    /// How long the first scan behind so many waits already; nothing where all are taken.
    std::optional<double> waiting_s(std::uint64_t steps) const;
    /// Since the last scan came.
    double silent_s() const;

  private:
    using Clock = std::chrono::steady_clock;
    Configuracion followed(Configuracion configuration) const;
    void read(const Configuracion& configuration, std::uint64_t count);

    std::shared_ptr<LiveSource> source_;
    Arrived arrived_;
    mutable std::mutex mutex_;
    std::uint64_t count_ = 0;  ///< number of the newest count()
    bool over_ = false;
    Clock::time_point begin_ = Clock::now();
    std::vector<float> came_s_;     ///< of each scan, since then
    std::vector<float> counted_s_;  ///< of those that were counted before
    std::vector<std::jthread> readers_;
};

}  // namespace hitos::window
