// The grid along the odometry, built beside a run.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <thread>

#include "hitos/services/run/grid_builder.hpp"

namespace hitos {

/// Builds the grid along the odometry on a thread of its own, while the run that reads the same
/// tour goes on: it needs nothing of the run.
class OdometryGridAhead {
  public:
    /// Of the tour of `reader`, which it reads anew. Where it cannot, take() has nothing.
    OdometryGridAhead(const GridParams& params, const TourReader& reader);

    /// Waits until it is built, and gives it away; nothing where it is not that of exactly so many
    /// scans (the run was stopped), or could not be built: who needs it builds it then, and hears
    /// why that fails.
    std::optional<Grid> take(std::uint64_t scans);

  private:
    void build(const std::stop_token& stop);

    std::unique_ptr<GridBuilder> builder_;  // of the thread alone while it works
    std::uint64_t scans_ = 0;
    bool whole_ = false;
    std::jthread thread_;  // last: it uses everything above
};

}  // namespace hitos
