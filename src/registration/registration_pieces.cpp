// SPDX-License-Identifier: GPL-3.0-or-later
// A robot that was carried, found again where it has been before.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "registration_impl.hpp"

namespace hitos {
namespace {

constexpr double kApart = 100.0;  // [m], of a second tour from the first

}  // namespace

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
    clock_.ends(RegistrationStage::search);
    if (!found) return;
    LoopRecord record = found->record;
    record.refused_by = editor_.refuses(graph_, *found);
    if (record.refused_by) {
        record.verdict = LoopVerdict::by_hand;
        refused_.push_back(record);
        return;
    }
    const KeyGraph graph = graph_;
    const std::vector<Placed> placed = placed_;
    const auto tour = tour_not_found(found->key);
    const bool other_tour = tour != carried_.end();
    const std::size_t corrected = other_tour ? tour->first : graph_.size();
    // Outdoors much is bent between breaks where nobody carried the robot: what the graph explains
    // is a loop like any other.
    const bool explained =
        !other_tour && (record.verdict = close(*found, record)) == LoopVerdict::closed;
    if (other_tour || record.verdict == LoopVerdict::strained) {
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
    if (other_tour) note_found(*tour, record.scan, record.earlier);
    if (explained || other_tour) {
        believe(found->key);
    } else {
        carried_.pop_back();
    }
    note_closed(record, graph.poses, before, corrected);
}

/// A second tour begins anywhere in the world: beside all that the first one has seen, until it is
/// found.
void Registration::Impl::leave_first_tour() {
    Pose beside;
    for (const KeyPose& key : graph_.poses) {
        beside.x = std::max(beside.x, key.pose.x);
        beside.y = std::max(beside.y, key.pose.y);
    }
    now_ = {beside.x + kApart, beside.y + kApart, 0.0};
}

/// The newest key is its first.
void Registration::Impl::begin_second_tour(std::uint64_t scan, const TourBegin& begin) {
    const std::size_t first = graph_.size() - 1;
    graph_.cut(first);
    carried_.push_back({first, first, scan, travelled_m_, true, begin.start});
    figures_.later_tours.push_back(
        {.begin = scan, .found = std::nullopt, .laid_from = scan, .said = begin.start.has_value()});
    if (begin.hold) {
        editor_.check_held(graph_, scan, forced_keys_);
        held_ = first;
    }
    // It holds the tour where it lies, for whoever solves the graph, and goes when it is found.
    const auto from = static_cast<std::uint32_t>(first - 1);
    graph_.edges.push_back({from, from + 1,
                            between(graph_.poses[from].pose, graph_.poses[first].pose),
                            Eigen::Matrix3d::Identity(), EdgeKind::odometry});
}

/// The tour of a piece, of which a later scan was found beside an earlier one.
void Registration::Impl::note_found(const CarriedPiece& piece, std::uint64_t scan,
                                    std::uint64_t beside) {
    for (SecondTour& tour : figures_.later_tours) {
        if (tour.begin != piece.scan || tour.found) continue;
        tour.found = scan;
        tour.beside = beside;
        tour.laid_from = carried_.back().scan;
        tour.way_m = travelled_m_ - graph_.scans[piece.first].travelled_m;
    }
}

/// The tour that nobody has found yet and that began after a key; null where there is none. Behind
/// a break in it there are newer pieces.
std::vector<CarriedPiece>::iterator Registration::Impl::tour_not_found(std::size_t earlier_key) {
    return std::ranges::find_if(carried_, [earlier_key](const CarriedPiece& piece) {
        return piece.other_tour && earlier_key < piece.first;
    });
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
