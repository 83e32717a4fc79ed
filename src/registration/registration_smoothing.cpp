// SPDX-License-Identifier: GPL-3.0-or-later
// The end of a tour: the whole graph once more, against all scans.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "hitos/base/thread_crew.hpp"
#include "hitos/registration/pose_graph_solver.hpp"
#include "registration_impl.hpp"

namespace hitos {

void Registration::Impl::finish(bool another_follows) {
    clock_.begin();
    corrections_.clear();
    if (!another_follows) editor_.check_end(placed_.size());
    if (graph_.size() < 2) return;
    const std::vector<KeyPose> before = graph_.poses;
    graph_.thin_resting();
    solve(graph_.poses, graph_.edges, solution(10, true));
    std::vector<std::vector<std::uint32_t>> older;  // of each key, by the first pass
    for (int pass = 0; pass < params_.final_passes; ++pass) register_anew(older);
    weigh_loops();
    correct(before);
    tell_edges(true);
    closer_.forget();
    clock_.ends(RegistrationStage::smoothing);
}

/// Every key's scan against its neighbours as they lie now. The first pass finds out which are near
/// along the graph, and some more than a map has: the next ones move keys by centimetres.
void Registration::Impl::register_anew(std::vector<std::vector<std::uint32_t>>& older) {
    const bool first_pass = older.empty();
    older.resize(graph_.size());
    constexpr MatchStage kWide{0.4, 0.1, true};
    std::erase_if(graph_.edges, [&](const PoseEdge& edge) {
        return (edge.kind == EdgeKind::scan || edge.kind == EdgeKind::loop) && edge.to >= held_;
    });
    constexpr std::size_t kTogether = 64;  // keys
    const std::size_t begin = std::max<std::size_t>(held_, 1);
    const std::size_t count = graph_.size() > begin ? graph_.size() - begin : 0;
    std::vector<std::vector<PoseEdge>> found((count + kTogether - 1) / kTogether);
    ThreadCrew crew(threads_);
    crew(found.size(), [&](std::size_t piece) {
        GraphWays ways;
        std::vector<std::uint32_t> keys;
        std::vector<Linearization> by_source;
        PointMap map;
        const std::size_t first = begin + piece * kTogether;
        for (std::size_t k = first; k < std::min(first + kTogether, graph_.size()); ++k) {
            const Pose& pose = graph_.poses[k].pose;
            const MapOfKeys about{k, pose, newest_in_map()};
            if (first_pass) {
                constexpr double kWay = 2.0 * kOldKeysWay;
                ways.begin(graph_, k, kWay);
                older[k] =
                    older_keys(graph_, about, ways.beside(kBesideKey, kWay), 2 * about.newest).keys;
            }
            select_keys(graph_, about, older[k], keys);
            build_map(graph_, keys, pose, kMapHalf, map);
            by_source.assign(keys.size(), {});
            const Linearization l =
                matcher_.linearize(graph_.scans[k].points(), map, pose,
                                   first_pass ? kWide : kFineStage, 1, &by_source);
            if (l.matches < kLeastMatches) continue;
            graph_.find_scan_edges(static_cast<std::uint32_t>(k), pose, keys, by_source,
                                   matcher_.information(), newest_in_map(), found[piece]);
        }
    });
    for (const std::vector<PoseEdge>& edges : found)
        graph_.edges.insert(graph_.edges.end(), edges.begin(), edges.end());
    graph_.thin_resting();
    solve(graph_.poses, graph_.edges, solution(3, true));
}

void Registration::Impl::weigh_loops() {
    struct Weights {
        double sum = 0.0;
        int edges = 0;
    };
    std::map<std::uint64_t, Weights> by_scan;
    for (const PoseEdge& edge : graph_.edges) {
        if (edge.kind != EdgeKind::loop && edge.kind != EdgeKind::by_hand) continue;
        Weights& weights = by_scan[graph_.poses[edge.to].scan];
        weights.sum += edge_weight(edge, squared_distance(edge, std::nullopt));
        ++weights.edges;
    }
    for (LoopRecord& loop : loops_) {
        const Weights& weights = by_scan[loop.scan];
        loop.weight = weights.sum / std::max(1, weights.edges);
    }
}

}  // namespace hitos
