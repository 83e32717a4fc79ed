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
    const auto newest = static_cast<std::uint32_t>(graph_.size() - 1);
    before = graph_.poses;
    const std::size_t first_edge = graph_.edges.size();
    const std::size_t first_loop = loops_.size();
    const auto hold = [&](std::uint32_t from, const Pose& z, GraphEdit::Kind kind) {
        const Eigen::Vector3d information = sigmas_by_hand(kind).cwiseAbs2().cwiseInverse();
        graph_.edges.push_back(
            {from, newest, z, information.asDiagonal().toDenseMatrix(), EdgeKind::by_hand});
    };
    for (const GraphEdit& edit : edits) {
        if (edit.kind == GraphEdit::Kind::fix) {
            lay_where_said(edit.pose, 0);
            hold(0, between(graph_.poses.front().pose, edit.pose), edit.kind);
            continue;
        }
        const auto earlier = static_cast<std::uint32_t>(
            std::ranges::lower_bound(graph_.poses, edit.earlier.scan, {}, &KeyPose::scan) -
            graph_.poses.begin());
        lay_where_said(compose(graph_.poses[earlier].pose, edit.pose), earlier);
        LoopRecord record;
        record.scan = edit.scan.scan;
        record.earlier = edit.earlier.scan;
        record.pose_earlier_scan = edit.pose;
        record.way_m = graph_.scans[newest].travelled_m - graph_.scans[earlier].travelled_m;
        record.by_hand = true;
        closer_.measure(graph_, newest, earlier, record);
        loops_.push_back(record);
        hold(earlier, edit.pose, edit.kind);
        graph_.join(earlier, newest);
        believe(earlier);
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
