#include "hitos/services/run/run_checkpoint.hpp"

#include <iterator>
#include <utility>

#include "hitos/slam/association_record.hpp"

namespace hitos {

std::size_t RunCheckpoint::bytes() const {
    return filter->bytes() + (registration ? registration->bytes() : 0) + step_grid.bytes() +
           line_extents.bytes() + online.size() * 2 * sizeof(StampedPose) +
           key_scans.size() * (sizeof(Pose) + sizeof(key_scans[0])) + uncertainty.bytes();
}

Trajectory RunCheckpoint::best_trajectory() const {
    Trajectory path = odometry.trajectory();
    const std::vector<Pose> poses = filter->best_history();
    for (std::size_t i = 0; i < path.size(); ++i) path[i].pose = poses[i];
    return path;
}

std::shared_ptr<const RunCheckpoint> Algoritmo::checkpoint() const {
    if (remembered_ == nullptr || !remembered_->whole() || finished_) return nullptr;
    std::optional<RunCheckpoint> now = state();
    return now ? std::make_shared<const RunCheckpoint>(*std::move(now)) : nullptr;
}

std::optional<RunCheckpoint> Algoritmo::state() const {
    std::unique_ptr<const SlamFilter> filter = filter_->clone();
    if (!filter) return std::nullopt;
    return RunCheckpoint{
        remembered_->place(), *controls_,
        registration_ ? std::make_unique<const Registration>(*registration_) : nullptr,
        std::move(filter),
        // With registration it can be drawn of the key scans, which takes far less memory.
        registration_ ? Grid(configuration_.grid) : step_grid_, key_scans_, key_poses_, online_,
        line_extents_, suitability_, uncertainty_, scan_, observation_, odometry_};
}

void Algoritmo::go_to(const RunCheckpoint& checkpoint) {
    remembered_->go_to(checkpoint.place);
    *controls_ = checkpoint.controls;
    registration_ = checkpoint.registration
                        ? std::make_unique<Registration>(*checkpoint.registration)
                        : nullptr;
    filter_ = checkpoint.filter->clone();
    step_grid_ = checkpoint.step_grid;
    step_grid_stale_ = registration_ != nullptr;
    step_grid_change_ = {};
    ++step_grid_redrawn_;  // whoever followed its changes has to begin anew
    key_scans_ = checkpoint.key_scans;
    key_poses_ = checkpoint.key_poses;
    online_ = checkpoint.online;
    line_extents_ = checkpoint.line_extents;
    suitability_ = checkpoint.suitability;
    uncertainty_ = checkpoint.uncertainty;
    scan_ = checkpoint.scan;
    observation_ = checkpoint.observation;
    odometry_ = checkpoint.odometry;
    finished_ = false;
}

std::unique_ptr<const AssociationRecord> Algoritmo::weighed(const RunCheckpoint* before) {
    const std::uint64_t last = steps();
    if (remembered_ == nullptr || !remembered_->whole() || last == 0) return nullptr;
    const std::optional<RunCheckpoint> now = state();
    if (!now) return nullptr;
    const bool finished = finished_;
    const bool drawn = std::exchange(options_.step_grid, false);
    const std::uint64_t redrawn = step_grid_redrawn_;
    const bool stale = step_grid_stale_;
    Grid grid = std::move(step_grid_);
    const auto come_back = [&] {
        options_.step_grid = drawn;
        go_to(*now);
        finished_ = finished;
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
        spacing_ *= 2;
        for (auto kept = kept_.begin(); kept != kept_.end();) {
            const bool stays = kept->first % spacing_ == 0;
            if (!stays) bytes_ -= kept->second.bytes;
            kept = stays ? std::next(kept) : kept_.erase(kept);
        }
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

void RunCheckpoints::clear() {
    kept_.clear();
    bytes_ = 0;
    spacing_ = kFirstSpacing;
}

}  // namespace hitos
