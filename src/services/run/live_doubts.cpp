// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/run/live_doubts.hpp"

#include <algorithm>
#include <chrono>

namespace hitos {

std::vector<TourFinding> LiveDoubts::look(RunWorker& run) {
    using namespace std::chrono_literals;
    if (looking_.valid() && looking_.wait_for(0s) == std::future_status::ready) {
        weighing_ = std::async(std::launch::async, [evidence = looking_.get()] {
            const auto& [examination, findings] = evidence;
            return examination ? examination->findings(findings) : std::vector<TourFinding>();
        });
    }
    std::vector<TourFinding> fresh;
    if (weighing_.valid() && weighing_.wait_for(0s) == std::future_status::ready) {
        for (const TourFinding& finding : weighing_.get()) {
            if (std::ranges::count(told_, finding.kind) > 0) continue;
            told_.push_back(finding.kind);
            fresh.push_back(finding);
        }
    }
    if (!awaits() && is_due(run.progress())) {
        looked_at_ = run.progress().steps;
        // It is answered between two scans, for which nobody waits here.
        looking_ = run.with_run([](const Algoritmo& now) -> Evidence {
            if (now.examination() == nullptr) return {};
            return {*now.examination(), now.reader().findings()};
        });
    }
    return fresh;
}

bool LiveDoubts::is_due(const Progress& progress) const {
    constexpr std::uint64_t kFirst = 100;
    if (progress.steps < kFirst) return false;
    if (progress.steps >= 2 * looked_at_) return true;
    // Nobody knows whether more comes.
    return progress.state != Progress::State::running && 4 * progress.steps >= 5 * looked_at_;
}

}  // namespace hitos
