// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/run/live_doubts.hpp"

#include <algorithm>
#include <chrono>

namespace hitos {

std::vector<TourFinding> LiveDoubts::look(RunWorker& run) {
    constexpr std::uint64_t kFirst = 100;
    const std::uint64_t steps = run.progress().steps;
    if (!looking_.valid() && !weighing_.valid() && steps >= std::max(kFirst, 2 * looked_at_)) {
        looked_at_ = steps;
        // It is answered between two scans, for which nobody waits here.
        looking_ = run.with_run([](const Algoritmo& now) -> Evidence {
            if (now.examination() == nullptr) return {};
            return {*now.examination(), now.reader().findings()};
        });
    }
    using namespace std::chrono_literals;
    if (looking_.valid() && looking_.wait_for(0s) == std::future_status::ready) {
        weighing_ = std::async(std::launch::async, [evidence = looking_.get()] {
            const auto& [examination, findings] = evidence;
            return examination ? examination->findings(findings) : std::vector<TourFinding>();
        });
    }
    if (!weighing_.valid() || weighing_.wait_for(0s) != std::future_status::ready) return {};
    std::vector<TourFinding> fresh;
    for (const TourFinding& finding : weighing_.get()) {
        if (std::ranges::count(told_, finding.kind) > 0) continue;
        told_.push_back(finding.kind);
        fresh.push_back(finding);
    }
    return fresh;
}

}  // namespace hitos
