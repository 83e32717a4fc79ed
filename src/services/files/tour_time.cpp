// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/files/tour_time.hpp"

#include <cstddef>

namespace hitos {

namespace {

template <class Take>
void go_through(std::span<const StampedPose> path, Take take) {
    double begin = path.empty() ? 0.0 : path.front().time_s;  // had there been no pause
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (i > 0 && path[i].begins) begin += path[i].time_s - path[i - 1].time_s;
        take(path[i].time_s - begin);
    }
}

}  // namespace

std::vector<double> tour_seconds(std::span<const StampedPose> path) {
    std::vector<double> seconds;
    seconds.reserve(path.size());
    go_through(path, [&](double time_s) { seconds.push_back(time_s); });
    return seconds;
}

double tour_duration_s(std::span<const StampedPose> path) {
    double last = 0.0;
    go_through(path, [&](double time_s) { last = time_s; });
    return last;
}

}  // namespace hitos
