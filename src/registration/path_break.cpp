// SPDX-License-Identifier: GPL-3.0-or-later
#include "path_break.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "free_view.hpp"

namespace hitos {

bool breaks_path(std::span<const SurfacePoint> scan, const MatchedStep& matched,
                 const KeyGraph& graph) {
    // Of six recorded tours and five worlds the worst scan, with a score of 0.27, has 0.14 of
    // contradiction. Of 18 gaps that tests/bench/gaps makes in the tours 15 are told; places behind
    // the others look like those before, and one is 0.4 m wide.
    constexpr double kDoubtful = 0.4;
    constexpr double kMuch = 0.2;
    constexpr std::size_t kNewest = 3;  // keys
    if (!matched.matched) return true;
    if (matched.score > kDoubtful) return false;
    const std::array<FreeView, 1> now{FreeView(scan, matched.pose)};
    std::vector<FreeView> before;
    std::vector<Point2> seen_before;
    for (std::size_t n = 1; n <= std::min(kNewest, graph.size()); ++n) {
        const std::size_t k = graph.size() - n;
        before.emplace_back(graph.scans[k].points(), graph.poses[k].pose);
        place(graph.scans[k].points(), graph.poses[k].pose, seen_before);
    }
    std::vector<Point2> seen_now;
    place(scan, matched.pose, seen_now);
    return contradiction(seen_now, before) > kMuch || contradiction(seen_before, now) > kMuch;
}

}  // namespace hitos
