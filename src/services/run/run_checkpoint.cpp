// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/run/run_checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "hitos/base/digest.hpp"
#include "hitos/base/validate.hpp"
#include "hitos/slam/association_record.hpp"
#include "state_bytes.hpp"

namespace hitos {

Trajectory RunState::stamped(const std::vector<Pose>& poses) const {
    Trajectory stamped = odometry.trajectory();
    for (std::size_t i = 0; i < stamped.size(); ++i) stamped[i].pose = poses[i];
    return stamped;
}

Trajectory RunState::best_trajectory() const {
    return stamped(filter->best_history());
}

std::vector<SecondTour> RunState::later_tours() const {
    return registration ? registration->later_tours() : std::vector<SecondTour>();
}

std::size_t RunState::bytes() const {
    return filter->bytes() + (registration ? registration->bytes() : 0) + line_extents.bytes() +
           online.size() * 2 * sizeof(StampedPose) +
           key_scans.size() * (sizeof(Pose) + sizeof(key_scans[0])) + uncertainty.bytes();
}

std::vector<StatePart> parts_of(const RunState& state, const Grid& step_grid) {
    const LandmarkMap map = state.filter->best_map();
    const Trajectory path = state.best_trajectory();
    std::vector<StatePart> parts;
    std::string bytes;
    const auto end = [&](const char* name) {
        parts.push_back({name, Digest().add(std::exchange(bytes, {})).text()});
    };
    const auto note = [&](const char* name, const auto& row) {
        put_all(bytes, row);
        end(name);
    };
    put_hypotheses(bytes, *state.filter);
    end("hypotheses");
    put_landmarks(bytes, map);
    end("landmarks");
    const auto note_path = [&](const char* name, const Trajectory& row) {
        put_path(bytes, row);
        end(name);
    };
    note_path("path", path);
    note_path("path as it was driven", state.online);
    note_path("odometry", state.odometry.trajectory());
    note("scan", state.scan.points);
    put_told(bytes, state.scan);
    end("landmarks told");
    put_observation(bytes, state.observation);
    end("features seen");
    for (const LineExtent& one : state.line_extents.of(map, path)) put(bytes, one.a, one.b);
    end("extents of lines");
    if (state.registration) {  // its grid is drawn when it is asked for
        note("registration", state.registration->keys());
        return parts;
    }
    for (int row = 0; row < step_grid.rows(); ++row) {
        for (int column = 0; column < step_grid.columns(); ++column) {
            put(bytes, step_grid.log_odds(column, row));
        }
    }
    end("grid");
    return parts;
}

void check_same(const std::vector<StatePart>& expected, const std::vector<StatePart>& found,
                const std::string& what) {
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (i < found.size() && found[i].name == expected[i].name &&
            found[i].digest == expected[i].digest) {
            continue;
        }
        throw std::logic_error(
            fmt::format("{}: the {} is not what it was", what, expected[i].name));
    }
}

std::shared_ptr<const RunCheckpoint> Algoritmo::checkpoint(bool over_too) const {
    if (!options_.go_back || !remembered_->whole() || (finished() && !over_too)) return nullptr;
    std::optional<RunCheckpoint> now = copy();
    return now ? std::make_shared<const RunCheckpoint>(*std::move(now)) : nullptr;
}

std::optional<RunCheckpoint> Algoritmo::copy() const {
    // With registration the grid can be drawn of the key scans, which takes far less memory.
    RunCheckpoint now{remembered_->place(), state_,
                      state_.registration ? Grid(configuration_.grid) : step_grid_};
    if (!now.state.filter) return std::nullopt;
    if constexpr (kValidates) {
        now.parts = parts_of(state_, step_grid_);
        check_same(now.parts, parts_of(now.state, now.step_grid),
                   fmt::format("copy of the state after {} scans", steps()));
    }
    return now;
}

void Algoritmo::go_to(const RunCheckpoint& checkpoint) {
    remembered_->go_to(checkpoint.place);
    doubts_ = {};
    state_ = checkpoint.state;
    // Of those of before, which are all that touch it.
    if (state_.registration) state_.registration->set_edits(configuration_.registration.edits);
    step_grid_ = checkpoint.step_grid;
    step_grid_stale_ = registration() != nullptr;
    step_grid_change_ = {};
    ++step_grid_redrawn_;  // whoever followed its changes has to begin anew
    if constexpr (kValidates) {
        check_same(checkpoint.parts, parts_of(state_, step_grid_),
                   fmt::format("return to the state after {} scans", steps()));
    }
}

std::unique_ptr<const AssociationRecord> Algoritmo::weighed(const RunCheckpoint* before) {
    const std::uint64_t last = steps();
    if (remembered_ == nullptr || !remembered_->whole() || last == 0) return nullptr;
    const std::optional<RunCheckpoint> now = copy();
    if (!now) return nullptr;
    const bool drawn = std::exchange(options_.step_grid, false);
    const std::uint64_t redrawn = step_grid_redrawn_;
    const bool stale = step_grid_stale_;
    Grid grid = std::move(step_grid_);
    const auto come_back = [&] {
        options_.step_grid = drawn;
        go_to(*now);
        step_grid_ = std::move(grid);
        step_grid_stale_ = stale;
        step_grid_redrawn_ = redrawn;
    };
    auto record = std::make_unique<AssociationRecord>();
    try {
        if (before != nullptr) {
            go_to(*before);
        } else {
            rewind();
        }
        while (steps() + 1 < last) step();
        step(record.get());
    } catch (...) {
        come_back();
        throw;
    }
    come_back();
    return record;
}

bool Algoritmo::rewind() {
    if (remembered_ == nullptr || !remembered_->whole()) {
        restart();
        return false;
    }
    remembered_->go_to({});
    begin();
    return true;
}

void RunCheckpoints::note(const Algoritmo& run) {
    const std::uint64_t steps = run.steps();
    if (steps % spacing_ != 0 || kept_.contains(steps)) return;
    std::shared_ptr<const RunCheckpoint> checkpoint = run.checkpoint();
    if (!checkpoint) return;
    const std::size_t bytes = checkpoint->bytes();
    kept_.emplace(steps, Kept{std::move(checkpoint), bytes});
    bytes_ += bytes;
    while (kept_.size() > 2 && (kept_.size() > kMost || bytes_ > most_bytes_)) {
        // Every other one goes, one at a time, so that most of the memory is in use.
        const auto gone = std::ranges::find_if(
            kept_, [this](const auto& kept) { return kept.first % spacing_ != 0; });
        if (gone == kept_.end()) {
            spacing_ *= 2;
            continue;
        }
        bytes_ -= gone->second.bytes;
        kept_.erase(gone);
    }
}

std::shared_ptr<const RunCheckpoint> RunCheckpoints::before(std::uint64_t steps) const {
    const auto behind = kept_.upper_bound(steps);
    return behind == kept_.begin() ? nullptr : std::prev(behind)->second.checkpoint;
}

std::vector<std::shared_ptr<const RunCheckpoint>> RunCheckpoints::all() const {
    std::vector<std::shared_ptr<const RunCheckpoint>> all;
    all.reserve(kept_.size());
    for (const auto& [steps, kept] : kept_) all.push_back(kept.checkpoint);
    return all;
}

void RunCheckpoints::forget_after(std::uint64_t steps) {
    for (auto kept = kept_.upper_bound(steps); kept != kept_.end(); kept = kept_.erase(kept))
        bytes_ -= kept->second.bytes;
}

void RunCheckpoints::clear() {
    kept_.clear();
    bytes_ = 0;
    spacing_ = kFirstSpacing;
}

}  // namespace hitos
