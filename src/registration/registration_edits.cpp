// SPDX-License-Identifier: GPL-3.0-or-later
// What somebody changes by hand in a registration.
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/registration/pose_graph_solver.hpp"
#include "registration_impl.hpp"

namespace hitos {

/// What somebody says of the newest key. `before` takes the keys as they were where it moves them.
void Registration::Impl::edit_graph(std::vector<KeyPose>& before) {
    const std::vector<GraphEdit> edits = editor_.of_newest(graph_);
    if (edits.empty()) return;
    before = graph_.poses;
    const std::size_t first_edge = graph_.edges.size();
    const std::size_t first_loop = loops_.size();
    for (const GraphEdit& edit : edits) {
        PoseEdge edge = edge_by_hand(edit);
        lay_where_said(compose(graph_.poses[edge.from].pose, edge.z), edge.from);
        graph_.edges.push_back(edge);
        if (edit.kind == GraphEdit::Kind::fix) continue;
        loops_.push_back(loop_by_hand(edit, edge));
        graph_.join(edge.from, edge.to);
        believe(edge.from);
    }
    PoseGraphSolver solver(graph_.size(), graph_.edges);
    solver.solve(graph_.poses, solution(6, false), first_edge);
    const double tension_before = tension(std::span(graph_.edges).first(first_edge));
    solver.solve(graph_.poses, solution(6, false));
    const double bent = tension(graph_.edges) - tension_before;
    solver.solve(graph_.poses, solution(6, true));
    const double move_m = greatest_move(before, graph_.poses);
    for (LoopRecord& loop : std::span(loops_).subspan(first_loop)) {
        loop.chi_square = bent;
        loop.move_m = move_m;
    }
    figures_.largest_correction_m = std::max(figures_.largest_correction_m, move_m);
    closer_.forget();
}

/// That two keys lie as somebody says; those of a place that is known from the first one. A scan
/// that is no key hangs on one.
PoseEdge Registration::Impl::edge_by_hand(const GraphEdit& edit) const {
    const bool fix = edit.kind == GraphEdit::Kind::fix;
    const std::uint32_t to = placed_[edit.scan.scan].key;
    const std::uint32_t from = fix ? 0 : placed_[edit.earlier.scan].key;
    Pose z = fix ? between(graph_.poses.front().pose, edit.pose) : edit.pose;
    if (graph_.poses[to].scan != edit.scan.scan) {
        z = compose(z, inverse(placed_[edit.scan.scan].pose_key_scan));
    }
    if (!fix && graph_.poses[from].scan != edit.earlier.scan) {
        z = compose(placed_[edit.earlier.scan].pose_key_scan, z);
    }
    const Eigen::Vector3d information = sigmas_by_hand(edit.kind).cwiseAbs2().cwiseInverse();
    return {from, to, z, information.asDiagonal().toDenseMatrix(), EdgeKind::by_hand};
}

LoopRecord Registration::Impl::loop_by_hand(const GraphEdit& edit, const PoseEdge& edge) {
    LoopRecord record;
    record.scan = edit.scan.scan;
    record.earlier = edit.earlier.scan;
    record.pose_earlier_scan = edit.pose;
    record.way_m = graph_.scans[edge.to].travelled_m - graph_.scans[edge.from].travelled_m;
    record.by_hand = true;
    closer_.measure(graph_, edge.to, edge.from, record);
    return record;
}

/// Somebody says where the newest key is, from a key on: a tour that nobody has found begins there.
void Registration::Impl::lay_where_said(const Pose& pose, std::size_t from) {
    const auto tour = tour_not_found(from);
    if (tour == carried_.end()) return;
    lay_piece(pose);
    note_found(*tour, graph_.poses.back().scan);
    believe(from);
}

LoopRecord Registration::Impl::fitted_loop(std::uint64_t scan, std::uint64_t earlier,
                                           const Pose& start) const {
    const auto key_of = [&](std::uint64_t number) {
        const auto key = std::ranges::find(graph_.poses, number, &KeyPose::scan);
        if (key == graph_.poses.end()) {
            throw Error(message(HITOS_TEXT("Errors", "scan %1 is no key scan"), number + 1));
        }
        return static_cast<std::uint32_t>(key - graph_.poses.begin());
    };
    LoopRecord record;
    record.scan = scan;
    record.earlier = earlier;
    record.pose_earlier_scan = start;
    LoopCloser closer = closer_;
    const std::uint32_t later_key = key_of(scan);
    const std::uint32_t earlier_key = key_of(earlier);
    record.way_m = graph_.scans[later_key].travelled_m - graph_.scans[earlier_key].travelled_m;
    closer.fit(graph_, later_key, earlier_key, record);
    return record;
}

}  // namespace hitos
