// SPDX-License-Identifier: GPL-3.0-or-later
// What somebody changes by hand in a registration.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/registration/laid_drawing.hpp"
#include "hitos/registration/pose_graph_solver.hpp"
#include "registration_impl.hpp"
#include "wall_finder.hpp"

namespace hitos {

/// What somebody says of the newest key. `before` takes the keys as they were where it moves them.
void Registration::Impl::edit_graph(std::vector<KeyPose>& before) {
    const bool placed = tour_not_found(0) == carried_.end();
    const std::vector<GraphEdit> edits = editor_.of_newest(graph_, placed);
    if (edits.empty()) return;
    if (graph_.size() > 1) before = graph_.poses;
    const std::size_t first_loop = loops_.size();
    for (const GraphEdit& edit : edits) {
        if (edit.anchors()) {
            graph_.edges.push_back(anchor(edit));
            expect_like_the_others(edit);
            continue;
        }
        const PoseEdge edge = edge_by_hand(edit);
        lay_where_said(compose(graph_.poses[edge.from].pose, edge.z), edge.from);
        graph_.edges.push_back(edge);
        if (edit.kind == GraphEdit::Kind::fix) continue;
        loops_.push_back(loop_by_hand(edit, edge));
        graph_.join(edge.from, edge.to);
        believe(edge.from);
    }
    if (graph_.size() < 2) {
        note_known_places(edits, std::vector<double>(edits.size(), 0.0), 0);
        return;
    }
    // A tour that is laid where it belongs has lost its step from the one before.
    const std::size_t edges = edits.size();
    const std::size_t first_edge = graph_.edges.size() - edges;
    PoseGraphSolver solver(graph_.size(), graph_.edges);
    solver.solve(graph_.poses, solution(6, false), first_edge);
    const double tension_before = tension(std::span(graph_.edges).first(first_edge));
    const std::vector<KeyPose> as_they_lay = graph_.poses;
    solver.solve(graph_.poses, solution(6, false));
    std::vector<double> bent(edges, tension(graph_.edges) - tension_before);
    if (edges > 1 && bent.front() > explained_chi_square(edges))
        blame_one(as_they_lay, tension_before, bent);
    solver.solve(graph_.poses, solution(6, true));
    const double move_m = greatest_move(before, graph_.poses);
    for (std::size_t i = 0, loop = first_loop; i < edges; ++i) {
        if (edits[i].kind != GraphEdit::Kind::close) continue;
        loops_[loop].chi_square = bent[i];
        loops_[loop++].move_m = move_m;
    }
    note_known_places(edits, bent, edges);
    figures_.largest_correction_m = std::max(figures_.largest_correction_m, move_m);
    closer_.forget();
}

/// Where one of the newest edges bends the graph by itself more than it explains, each one has what
/// it does so; else they contradict each other, and `bent` stays what all do together.
void Registration::Impl::blame_one(const std::vector<KeyPose>& poses, double tension_before,
                                   std::vector<double>& bent) {
    const std::vector<KeyPose> together = std::exchange(graph_.poses, poses);
    std::vector<PoseEdge> edges(graph_.edges.begin(),
                                graph_.edges.end() - static_cast<std::ptrdiff_t>(bent.size() - 1));
    std::vector<double> alone;
    for (const PoseEdge& edge : std::span(graph_.edges).last(bent.size())) {
        edges.back() = edge;
        graph_.poses = poses;
        solve(graph_.poses, edges, solution(6, false));
        alone.push_back(tension(edges) - tension_before);
    }
    graph_.poses = together;
    if (*std::ranges::max_element(alone) > explained_chi_square(1)) bent = alone;
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
    return {from, to, z, information.asDiagonal().toDenseMatrix(),
            fix ? EdgeKind::fix : EdgeKind::by_hand};
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
    note_found(*tour, graph_.poses.back().scan, graph_.poses[from].scan);
    believe(from);
}

/// That what a scan sees is in a drawing. Of a scan that is no key, which only what is foreseen
/// names, the key that it hangs on sees it.
PoseEdge Registration::Impl::anchor(const GraphEdit& edit) const {
    constexpr double kEndsAcross = 0.02;  // [m], standard deviation of where a wall's ends are seen
    const Placed& placed = placed_[edit.scan.scan];
    const bool key = graph_.poses[placed.key].scan == edit.scan.scan;
    const Pose pose_key_scan = key ? Pose{} : placed.pose_key_scan;
    const Eigen::Vector3d information = sigmas_by_hand(edit.kind).cwiseAbs2().cwiseInverse();
    PoseEdge edge;
    edge.kind = EdgeKind::anchor;
    edge.to = placed.key;
    if (edit.kind == GraphEdit::Kind::point) {
        edge.at = transform(pose_key_scan, edit.seen);
        edge.z = {edit.left.x, edit.left.y, 0.0};
        edge.information.diagonal().head<2>() = information.head<2>();
        return edge;
    }
    const auto wall = find_wall(graph_.scans[placed.key].points(), pose_key_scan, edit.bearing);
    if (!wall) {
        throw ConfigError(kGraphEditsKey,
                          HITOS_TEXT("Errors",
                                     "change %1: scan %2 sees no straight wall of half a metre in "
                                     "the direction of %3 rad (%4 degrees to the left of ahead)"),
                          number_of(edit), edit.scan.scan + 1, edit.bearing,
                          edit.bearing * 180.0 / kPi);
    }
    edge.at = wall->middle();
    const Point2 way{edit.right.x - edit.left.x, edit.right.y - edit.left.y};
    const double length_m = std::hypot(way.x, way.y);
    const double seen = std::atan2(wall->right.y - wall->left.y, wall->right.x - wall->left.x);
    edge.z = {0.5 * (edit.left.x + edit.right.x), 0.5 * (edit.left.y + edit.right.y),
              wrap_angle(std::atan2(way.y, way.x) - seen)};
    // Across the wall; along it the scan may slide.
    const Eigen::Vector2d across(-way.y / length_m, way.x / length_m);
    edge.information.topLeftCorner<2, 2>() = information(0) * across * across.transpose();
    // A short wall says less of its direction.
    const double turn = kEndsAcross / (0.5 * distance(wall->left, wall->right));
    edge.information(2, 2) = 1.0 / (1.0 / information(2) + turn * turn);
    return edge;
}

std::size_t Registration::Impl::number_of(const GraphEdit& edit) const {
    const auto found = std::ranges::find_if(
        editor_.edits(), [&](const GraphEdit& one) { return same_change(one, edit); });
    return static_cast<std::size_t>(found - editor_.edits().begin()) + 1;
}

/// Beyond half a right angle it is another wall, and the graph would not know which way to turn.
void Registration::Impl::expect_like_the_others(const GraphEdit& edit) const {
    constexpr double kMost = 0.25 * kPi;
    if (edit.kind != GraphEdit::Kind::wall) return;
    const std::span others = std::span(graph_.edges).first(graph_.edges.size() - 1);
    const bool told = std::ranges::any_of(others, [](const PoseEdge& edge) {
        return edge.kind == EdgeKind::anchor && edge.information(2, 2) > 0.0;
    });
    if (!told) return;
    const PoseEdge& edge = graph_.edges.back();
    const double turned =
        edge_error(edge, laid_drawing(graph_.poses, others)->pose, graph_.poses[edge.to].pose)
            .value(2);
    if (std::abs(turned) <= kMost) return;
    throw ConfigError(
        kGraphEditsKey,
        HITOS_TEXT("Errors",
                   "change %1: the wall that scan %2 sees is turned by %3 degrees against that of "
                   "the drawing, as the walls before it lay the drawing, and at most 45 are taken; "
                   "is it another wall, or are its ends the wrong way round? The first is the left "
                   "one, as the robot sees it"),
        number_of(edit), edit.scan.scan + 1, std::round(turned * 180.0 / kPi));
}

void Registration::Impl::note_known_places(std::span<const GraphEdit> edits,
                                           std::span<const double> bent, std::size_t edges) {
    for (std::size_t i = 0; i < edits.size(); ++i) {
        const NotedChange noted{edits[i], bent[i], explained_chi_square(edges)};
        if (edits[i].anchors()) anchors_.push_back(noted);
        if (edits[i].kind == GraphEdit::Kind::fix) fixes_.push_back(noted);
    }
}

std::vector<AnchorFigures> Registration::Impl::anchor_figures() const {
    std::vector<AnchorFigures> figures;
    const auto drawing = laid_drawing(graph_.poses, graph_.edges);
    for (const NotedChange& noted : anchors_) {
        const PoseEdge edge = anchor(noted.edit);
        const Eigen::Vector3d error =
            edge_error(edge, drawing->pose, graph_.poses[edge.to].pose).value;
        const Eigen::Matrix3d& known = edge.information;
        const double sigma_m = sigmas_by_hand(noted.edit.kind)(0);
        const double squared = error.head<2>().dot(known.topLeftCorner<2, 2>() * error.head<2>());
        const double off_m = sigma_m * std::sqrt(std::max(0.0, squared));
        figures.push_back({number_of(noted.edit) - 1, noted.edit.scan.scan, off_m,
                           known(2, 2) > 0.0 ? std::optional(error(2)) : std::nullopt, noted.bent,
                           noted.limit});
    }
    return figures;
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
