// SPDX-License-Identifier: GPL-3.0-or-later
// A run's state after a scan, and the few of them that a run keeps to go back to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "hitos/services/run/algoritmo.hpp"

namespace hitos {

/// A part of a run's state: its name, and the digest of its numbers.
struct StatePart {
    std::string name;
    std::string digest;
};

/// All that a run is after a scan, to come back to.
struct RunCheckpoint {
    RememberedTour::Place place;
    RunState state;
    Grid step_grid;  ///< empty with registration: of the key scans
    /// As they were when it was written; of builds that check (hitos/base/validate.hpp).
    std::vector<StatePart> parts = {};

    /// Scans taken.
    std::uint64_t steps() const { return state.odometry.trajectory().size(); }
    /// Memory that it takes, about.
    std::size_t bytes() const { return state.bytes() + step_grid.bytes(); }
};

/// What can be seen of the state.
std::vector<StatePart> parts_of(const RunState& state, const Grid& step_grid);

/// Throws std::logic_error of the first part that differs, `what` says of what.
void check_same(const std::vector<StatePart>& expected, const std::vector<StatePart>& found,
                const std::string& what);

/// The checkpoints of a run: every so many scans one, further and further apart so that all
/// together stay within a limit of memory and of number.
class RunCheckpoints {
  public:
    static constexpr std::size_t kMostBytes = std::size_t{184} << 20;
    static constexpr std::size_t kMost = 56;

    explicit RunCheckpoints(std::size_t most_bytes = kMostBytes) : most_bytes_(most_bytes) {}

    /// Keeps the run's state where one is due; to be called after every step.
    void note(const Algoritmo& run);
    /// The last one at or before so many scans; null where there is none.
    std::shared_ptr<const RunCheckpoint> before(std::uint64_t steps) const;
    /// By scans taken.
    std::vector<std::shared_ptr<const RunCheckpoint>> all() const;
    /// Those after more scans.
    void forget_after(std::uint64_t steps);
    void clear();

    /// Scans from the newest to the next.
    std::uint64_t spacing() const { return spacing_; }
    std::size_t count() const { return kept_.size(); }
    std::size_t bytes() const { return bytes_; }

  private:
    struct Kept {
        std::shared_ptr<const RunCheckpoint> checkpoint;
        std::size_t bytes;
    };
    using ByScan = std::map<std::uint64_t, Kept>;      // by scans taken
    static constexpr std::uint64_t kFirstSpacing = 8;  // where plots measure maps too

    std::size_t most_bytes_;
    std::uint64_t spacing_ = kFirstSpacing;
    std::size_t bytes_ = 0;
    ByScan kept_;
};

}  // namespace hitos
