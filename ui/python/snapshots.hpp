// SPDX-License-Identifier: GPL-3.0-or-later
// What a run is after a scan, as arrays.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "arrays.hpp"
#include "bindings.hpp"
#include "grids.hpp"
#include "hitos/services/run/run_worker.hpp"

namespace hitos::python {

/// Python's objects for a JSON text.
py::object parsed(const std::string& json);

/// A word of at most 7 letters, as numpy's "U7" holds it.
using Word = std::array<char32_t, 7>;
Word word_of(std::string_view text);

struct LandmarkRow {
    Word kind;
    double rho;
    double theta;
    double x;
    double y;
    std::int32_t observations;
    std::uint32_t first_seen;
    std::uint32_t last_seen;
    std::int32_t identity;
};

struct AssociationRow {
    Word kind;
    std::uint32_t observed;
    Word outcome;
    std::int32_t landmark;
};

struct FiguresRow {
    double time, x, y, theta, neff, best_log_weight, step_seconds, unseen;
    std::int32_t lines, corners, seen_lines, seen_corners, matched, created, ignored;
    std::uint64_t skipped;
    bool resampled, best_changed, loop_closed;
};

/// One state of a run; immutable but for what is made when it is first asked for, with the
/// interpreter's lock held.
class State {
  public:
    State(std::shared_ptr<const Snapshot> shown, bool finished);

    const std::shared_ptr<const Snapshot>& shown() const { return shown_; }
    bool finished() const { return finished_; }
    const std::shared_ptr<const std::vector<LandmarkRow>>& landmarks() const { return landmarks_; }
    /// Four numbers a landmark.
    const std::shared_ptr<const std::vector<double>>& covariances() const { return covariances_; }
    std::shared_ptr<const GridArray> grid() const;
    std::shared_ptr<const std::vector<AssociationRow>> associations() const;

  protected:
    void set_grid(std::shared_ptr<const GridArray> grid) { grid_ = std::move(grid); }

  private:
    std::shared_ptr<const Snapshot> shown_;
    bool finished_;
    std::shared_ptr<const std::vector<LandmarkRow>> landmarks_;
    std::shared_ptr<const std::vector<double>> covariances_;
    mutable std::shared_ptr<const GridArray> grid_;
    mutable std::shared_ptr<const std::vector<AssociationRow>> associations_;
};

std::shared_ptr<const std::vector<FiguresRow>> rows_of(const std::vector<StepFigures>& figures);
/// As a structured array.
py::array view_of(const std::shared_ptr<const std::vector<FiguresRow>>& figures);

}  // namespace hitos::python
