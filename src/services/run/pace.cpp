#include "hitos/services/run/pace.hpp"

namespace hitos {

Pacer::Clock::time_point Pacer::next(std::uint64_t steps, double duration_s,
                                     Clock::time_point now) {
    if (pace_.kind == Pace::Kind::full) return now;
    const double at = pace_.kind == Pace::Kind::recorded ? duration_s : static_cast<double>(steps);
    if (begun_) {
        const auto due = since_ + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>((at - from_) / pace_.rate));
        if (now <= due + kMostBehind) return due;
    }
    begun_ = true;
    since_ = now;
    from_ = at;
    return now;
}

}  // namespace hitos
