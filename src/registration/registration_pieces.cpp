// A robot that was carried, found again where it has been before.
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "registration_impl.hpp"

namespace hitos {

/// From this scan on the robot may be anywhere. Breaks that follow on each other are one: of scans
/// that fit nothing there are several until the local map is of the new place.
void Registration::Impl::doubt(std::uint64_t scan) {
    constexpr double kOne = 5.0;  // [m] of way
    figures_.breaks.push_back(scan);
    const std::size_t next = graph_.size();  // key
    if (carried_.empty() || travelled_m_ - carried_.back().broken_m >= kOne) {
        carried_.push_back({next, next, scan, 0.0});
    }
    carried_.back().query = next;
    carried_.back().broken_m = travelled_m_;
}

/// The newest key, matched with what was there before the break: where most of it lies there, the
/// robot was not carried.
void Registration::Impl::believe_where_it_fits(std::span<const Linearization> by_source) {
    constexpr double kMost = 0.6;  // of its points
    if (carried_.empty()) return;
    const std::size_t first = carried_.back().first;
    int matches = 0;
    for (std::size_t i = 0; i < by_source.size(); ++i) {
        if (map_keys_[i] < first) matches += by_source[i].matches;
    }
    if (matches > kMost * static_cast<double>(points_.size())) believe(first - 1);
}

/// The newest key lies where the graph has it about an earlier one: since then nobody carried it.
void Registration::Impl::believe(std::size_t earlier_key) {
    if (carried_.empty()) return;
    std::erase_if(carried_, [&](const CarriedPiece& piece) { return earlier_key < piece.first; });
    if (carried_.empty()) closer_.rest();
}

/// `before` takes the keys as they were where it moves the graph and nothing has before.
void Registration::Impl::find_piece(std::vector<KeyPose>& before) {
    const std::size_t newest = graph_.size() - 1;
    if (newest < carried_.back().query) return;
    const auto found = closer_.search_piece(graph_, carried_.back(), refused_);
    if (!found) return;
    LoopRecord record = found->record;
    record.refused_from = editor_.refuses(graph_, *found);
    if (record.refused_from) {
        record.verdict = LoopVerdict::by_hand;
        refused_.push_back(record);
        return;
    }
    const KeyGraph graph = graph_;
    const std::vector<Placed> placed = placed_;
    // Outdoors much is bent between breaks where nobody carried the robot: what the graph explains
    // is a loop like any other.
    const bool explained = (record.verdict = close(*found, record)) == LoopVerdict::closed;
    if (record.verdict == LoopVerdict::strained) {
        graph_ = graph;
        lay_piece(found->pose);
        record.verdict = close(*found, record);
    }
    if (record.verdict != LoopVerdict::closed) {
        graph_ = graph;
        placed_ = placed;
        refused_.push_back(record);
        return;
    }
    closer_.forget();
    if (explained) {
        believe(found->key);
    } else {
        carried_.pop_back();
    }
    note_closed(record, graph.poses, before);
}

/// Cuts the tour where the robot was carried and lays the newest key at a pose, with all keys since
/// as they lie about it.
void Registration::Impl::lay_piece(const Pose& pose) {
    const std::size_t first = carried_.back().first;
    graph_.cut(first);
    // Scans of the new place that hang on the last key of the old one.
    for (std::size_t scan = carried_.back().scan; scan < placed_.size(); ++scan) {
        Placed& placed = placed_[scan];
        if (placed.key >= first) continue;
        const Pose at = compose(graph_.poses[placed.key].pose, placed.pose_key_scan);
        placed = {static_cast<std::uint32_t>(first), between(graph_.poses[first].pose, at)};
    }
    const Pose move = compose(pose, inverse(graph_.poses.back().pose));
    for (std::size_t k = first; k < graph_.size(); ++k) {
        graph_.poses[k].pose = compose(move, graph_.poses[k].pose);
    }
}

}  // namespace hitos
