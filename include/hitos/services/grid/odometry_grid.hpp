// SPDX-License-Identifier: GPL-3.0-or-later
// The grid along the odometry, built beside a run.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

#include "hitos/services/grid/grid.hpp"

namespace hitos {

/// Builds the grid along the odometry on a thread of its own, of the scans that a run takes: it
/// needs nothing else of it.
class OdometryGridAhead {
  public:
    /// A greater one is not built ahead: the run may need the memory.
    static constexpr std::size_t kMostBytes = std::size_t{64} << 20;

    explicit OdometryGridAhead(const GridParams& params);
    OdometryGridAhead(const OdometryGridAhead&) = delete;  // its thread knows where it is
    OdometryGridAhead& operator=(const OdometryGridAhead&) = delete;
    ~OdometryGridAhead() = default;

    /// The next scan, with its pose by odometry. Waits where too many have come already.
    void add(const Scan& scan, const Pose& pose);
    /// Waits until what was added is in it, and gives it away; nothing where that were other than
    /// so many scans, or it could not be built: who needs it builds it then, and hears why that
    /// fails.
    std::optional<Grid> take(std::uint64_t scans);

  private:
    void build(const std::stop_token& stop);

    Grid grid_;  // of the thread alone while it works
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<std::pair<Scan, Pose>> waiting_;
    std::uint64_t added_ = 0;
    bool given_up_ = false;
    std::jthread thread_;  // last: it uses everything above
};

}  // namespace hitos
