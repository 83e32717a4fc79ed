// The grid along the odometry, built beside a run.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <thread>

#include "hitos/services/grid/grid_builder.hpp"

namespace hitos {

/// Builds the grid along the odometry on a thread of its own, while the run that reads the same
/// tour goes on: it needs nothing of the run.
class OdometryGridAhead {
  public:
    /// A greater one is not built ahead: the run may need the memory.
    static constexpr std::size_t kMostBytes = std::size_t{64} << 20;

    /// Of the tour of `reader`, which it reads anew. Where it cannot, take() has nothing.
    OdometryGridAhead(const GridParams& params, const TourReader& reader);
    OdometryGridAhead(const OdometryGridAhead&) = delete;  // its thread knows where it is
    OdometryGridAhead& operator=(const OdometryGridAhead&) = delete;
    ~OdometryGridAhead() = default;

    /// Waits until it is built up to so many scans, and gives it away; nothing where it is already
    /// that of more (the run was stopped), or could not be built: who needs it builds it then, and
    /// hears why that fails.
    std::optional<Grid> take(std::uint64_t scans);

  private:
    void build(const std::stop_token& stop);

    std::unique_ptr<GridBuilder> builder_;  // of the thread alone while it works
    std::atomic<std::uint64_t> wanted_ = UINT64_MAX;
    std::uint64_t scans_ = 0;
    bool failed_ = false;
    std::jthread thread_;  // last: it uses everything above
};

}  // namespace hitos
