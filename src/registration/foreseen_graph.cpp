// SPDX-License-Identifier: GPL-3.0-or-later
// What other changes by hand make of the graph at once, before the tour is taken with them.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <span>
#include <string>
#include <vector>

#include "hitos/registration/odometry_step.hpp"
#include "hitos/registration/pose_graph_solver.hpp"
#include "registration_impl.hpp"

namespace hitos {
namespace {

/// The edges of loops that hang together with one place where two passages were joined.
class Stretch {
  public:
    Stretch(const KeyGraph& graph, const GraphEdit& edit)
        : graph_(graph), of_it_(graph.edges.size()) {
        const Joint seed = graph.joint_at(edit.scan.scan, edit.earlier.scan);
        joints_.push_back(seed);
        // A scan is matched with older ones of its own passage as well.
        const bool short_way = seed.later_m - seed.earlier_m <= Joint::kAlong;
        std::vector<std::size_t> loops;
        for (std::size_t i = 0; i < graph.edges.size(); ++i) {
            const PoseEdge& edge = graph.edges[i];
            const Joint joint = joint_of(edge.to, edge.from);
            const bool own = !short_way && joint.later_m - joint.earlier_m <= Joint::kAlong;
            if (edge.kind == EdgeKind::loop && !own) loops.push_back(i);
        }
        std::ranges::stable_sort(loops, {}, [&](std::size_t i) { return graph.edges[i].to; });
        const auto middle = std::ranges::partition_point(loops, [&](std::size_t i) {
            return way_m(graph.edges[i].to) < seed.later_m - Joint::kBeside;
        });
        follow(seed, std::span(middle, loops.end()));
        std::reverse(loops.begin(), middle);
        follow(seed, std::span(loops.begin(), middle));
    }

    bool has_edge(std::size_t edge) const { return of_it_[edge]; }
    bool has(const LoopRecord& loop) const {
        return near(joints_, graph_.joint_at(loop.scan, loop.earlier));
    }

  private:
    double way_m(std::size_t key) const { return graph_.scans[key].travelled_m; }
    Joint joint_of(std::size_t later, std::size_t earlier) const {
        return {way_m(later), way_m(earlier)};
    }

    template <class Joints>
    static bool near(const Joints& joints, const Joint& joint) {
        return std::ranges::any_of(joints, [&](const Joint& one) { return one.is_near(joint); });
    }

    void follow(const Joint& seed, std::span<const std::size_t> loops) {
        std::deque<Joint> recent{seed};
        for (const std::size_t i : loops) {
            const PoseEdge& edge = graph_.edges[i];
            const Joint joint = joint_of(edge.to, edge.from);
            while (!recent.empty() &&
                   std::abs(recent.front().later_m - joint.later_m) > Joint::kAlong) {
                recent.pop_front();
            }
            if (recent.empty()) return;
            if (!near(recent, joint)) continue;
            of_it_[i] = true;
            recent.push_back(joint);
            joints_.push_back(joint);
        }
    }

    const KeyGraph& graph_;
    std::vector<bool> of_it_;  // by edge
    std::vector<Joint> joints_;
};

}  // namespace

bool Registration::Impl::foresee(const std::string& text) {
    const std::vector<GraphEdit> before = editor_.edits();
    const std::vector<GraphEdit> after = parse_graph_edits(text);
    corrections_.clear();
    if (graph_.size() < 2) return false;
    // Of scans that have come.
    const auto of_one = [&](const std::vector<GraphEdit>& edits,
                            const std::vector<GraphEdit>& other) {
        std::vector<GraphEdit> found;
        for (const GraphEdit& edit : edits) {
            if (edit.scan.scan < placed_.size() && !has_change(other, edit)) found.push_back(edit);
        }
        return found;
    };
    const std::vector<GraphEdit> gone = of_one(before, after);
    const std::vector<GraphEdit> made = of_one(after, before);
    const auto far = [this](const GraphEdit& edit) { return reaches_far(edit); };
    if (gone.empty() && made.empty()) return false;
    if (std::ranges::any_of(gone, far) || std::ranges::any_of(made, far)) return false;
    const std::vector<KeyPose> keys = graph_.poses;
    for (const GraphEdit& edit : gone) unbend(edit);
    for (const GraphEdit& edit : made) bend(edit);
    for (const std::vector<GraphEdit>& changed : {gone, made}) {
        for (const GraphEdit& edit : changed) {
            if (edit.kind == GraphEdit::Kind::slip) say_of_step(edit.scan.scan, after);
        }
    }
    // What changes came last, as who reads them expects it.
    for (std::vector<LoopRecord>* loops : {&loops_, &refused_})
        std::ranges::stable_sort(*loops, {}, &LoopRecord::scan);
    PoseGraphSolver solver(graph_.size(), graph_.edges);
    // Robust weights would hold what was there against what is new and large.
    solver.solve(graph_.poses, solution(1, false));
    solver.solve(graph_.poses, solution(1, true));
    if (std::ranges::any_of(loops_,
                            [](const LoopRecord& loop) { return loop.weight.has_value(); })) {
        weigh_loops();
    }
    correct(keys);
    tell_edges(true);
    return true;
}

/// Whether more depends on it than the graph tells: what is held stays as it is, and where a tour
/// lies that began anywhere.
bool Registration::Impl::reaches_far(const GraphEdit& edit) const {
    if (placed_[edit.scan.scan].key < held_) return true;
    if (edit.kind == GraphEdit::Kind::slip) return false;
    const std::uint64_t earlier = edit.of_two() ? edit.earlier.scan : 0;
    return std::ranges::any_of(figures_.later_tours, [&](const SecondTour& tour) {
        return earlier < tour.begin && tour.begin <= edit.scan.scan;
    });
}

void Registration::Impl::bend(const GraphEdit& edit) {
    switch (edit.kind) {
        case GraphEdit::Kind::refuse:
            part(edit);
            break;
        case GraphEdit::Kind::slip:
            break;
        case GraphEdit::Kind::close: {
            const PoseEdge edge = edge_by_hand(edit);
            graph_.edges.push_back(edge);
            loops_.push_back(loop_by_hand(edit, edge));
            break;
        }
        case GraphEdit::Kind::fix:
            graph_.edges.push_back(edge_by_hand(edit));
            break;
        case GraphEdit::Kind::wall:
        case GraphEdit::Kind::point:
            graph_.edges.push_back(anchor(edit));
            expect_like_the_others(edit);
            anchors_.push_back({edit, 0.0, explained_chi_square(1)});
            break;
    }
}

void Registration::Impl::unbend(const GraphEdit& edit) {
    if (edit.anchors()) {
        const PoseEdge made = anchor(edit);
        std::erase_if(graph_.edges, [&](const PoseEdge& edge) {
            return edge.kind == EdgeKind::anchor && edge.to == made.to && edge.z == made.z &&
                   edge.at == made.at;
        });
    }
    for (std::vector<NotedChange>* noted : {&anchors_, &fixes_})
        std::erase_if(*noted, [&](const NotedChange& one) { return same_change(one.edit, edit); });
    if (edit.has_pose()) {
        const PoseEdge made = edge_by_hand(edit);
        std::erase_if(graph_.edges, [&](const PoseEdge& edge) {
            return edge.kind == made.kind && edge.from == made.from && edge.to == made.to &&
                   edge.z == made.z;
        });
    }
    if (edit.kind == GraphEdit::Kind::close) part(edit);
    if (edit.kind != GraphEdit::Kind::refuse) return;
    const NamedLoop refusal{edit.scan.scan, edit.earlier.scan};
    // What it has kept out.
    for (LoopRecord& loop : refused_) {
        if (loop.refused_by != refusal) continue;
        const GraphEdit found{
            GraphEdit::Kind::close, {loop.scan}, {loop.earlier}, loop.pose_earlier_scan};
        graph_.edges.push_back(edge_by_hand(found));
        loop.verdict = LoopVerdict::closed;
        loop.refused_by.reset();
        loops_.push_back(loop);
    }
    std::erase_if(refused_,
                  [](const LoopRecord& loop) { return loop.verdict == LoopVerdict::closed; });
}

/// Takes apart what two passages were joined by, but what is by hand and stays.
void Registration::Impl::part(const GraphEdit& edit) {
    const Stretch stretch(graph_, edit);
    std::erase_if(loops_, [&](const LoopRecord& loop) {
        const bool named = loop.scan == edit.scan.scan && loop.earlier == edit.earlier.scan;
        if (loop.by_hand ? !named : !stretch.has(loop)) return false;
        if (edit.kind == GraphEdit::Kind::refuse) {
            refused_.push_back(loop);
            refused_.back().verdict = LoopVerdict::by_hand;
            refused_.back().refused_by = NamedLoop{edit.scan.scan, edit.earlier.scan};
        }
        return true;
    });
    std::size_t i = 0;
    std::erase_if(graph_.edges, [&](const PoseEdge&) { return stretch.has_edge(i++); });
}

/// What the odometry says of the way to the key at or behind a scan, with the slips on it.
void Registration::Impl::say_of_step(std::uint64_t scan, std::span<const GraphEdit> edits) {
    const auto key = static_cast<std::size_t>(
        std::ranges::lower_bound(graph_.poses, scan, {}, &KeyPose::scan) - graph_.poses.begin());
    if (key == graph_.size() || graph_.part_begin(key) == key) return;
    const auto slips = std::ranges::count_if(edits, [&](const GraphEdit& edit) {
        return edit.kind == GraphEdit::Kind::slip && edit.scan.scan <= graph_.poses[key].scan &&
               edit.scan.scan > graph_.poses[key - 1].scan;
    });
    for (PoseEdge& edge : graph_.edges) {
        if (edge.kind != EdgeKind::odometry || edge.to != key) continue;
        const Eigen::Vector3d variances = odometry_variances(edge.z, params_.odometry_scale) +
                                          static_cast<double>(slips) * slip_variances();
        edge.information = step_information(variances, 0.5 * edge.z.theta);
    }
}

}  // namespace hitos
