// SPDX-License-Identifier: GPL-3.0-or-later
#include "output_crew.hpp"

#include <algorithm>
#include <string>
#include <system_error>
#include <thread>

#include "hitos/base/error.hpp"
#include "hitos/base/thread_clock.hpp"

namespace hitos {
namespace {

/// Each may hold a grid with its picture.
constexpr int kMostWorkers = 3;
/// Of a grid; greater ones are held one at a time.
constexpr double kCellsAtOnce = 96.0 * 1024.0 * 1024.0;

/// About as many as the grid along a path has, where a laser sees 25 m.
double cells(const Trajectory& path, double resolution_m) {
    constexpr double kSeen = 25.0;
    const auto extent = [&path, resolution_m](double Pose::*axis) {
        const auto [least, greatest] = std::ranges::minmax_element(
            path, {}, [axis](const StampedPose& stamped) { return stamped.pose.*axis; });
        return ((*greatest).pose.*axis - (*least).pose.*axis + 2.0 * kSeen) / resolution_m;
    };
    return path.empty() ? 0.0 : extent(&Pose::x) * extent(&Pose::y);
}

}  // namespace

std::vector<Message> OutputCrew::write(std::span<const RunOutput* const> outputs, int threads) {
    reasons_.assign(outputs.size(), Message());
    failed_.assign(outputs.size(), 0);
    seconds_.assign(outputs.size(), 0.0);
    for (next_ = 0; next_ < outputs.size() && outputs[next_]->essential; ++next_) {
        tell(*outputs[next_]);
        write_timed(*outputs[next_], next_);
    }
    const int count = workers(threads);
    if (count == 1) {
        work(outputs, Attempt::last);
    } else {
        work_together(outputs, count);
    }
    if (broken_) std::rethrow_exception(broken_);
    for (std::size_t place = 0; count > 1 && place < outputs.size(); ++place) {
        if (failed_[place] != 0) write_one(*outputs[place], place, Attempt::last);
    }
    return std::move(reasons_);
}

int OutputCrew::workers(int threads) const {
    const double resolution_m = finished_.run.configuration().grid.resolution_m;
    for (const Trajectory* path : {&finished_.best, &finished_.run.odometry_trajectory()}) {
        if (!(cells(*path, resolution_m) < kCellsAtOnce)) return 1;  // not even a number
    }
    if (threads == 0) threads = static_cast<int>(std::thread::hardware_concurrency());
    return std::clamp(threads, 1, kMostWorkers);
}

void OutputCrew::work_together(std::span<const RunOutput* const> outputs, int workers) {
    std::vector<std::jthread> others;
    try {
        for (int i = 1; i < workers; ++i) {
            others.emplace_back([this, outputs] { work(outputs, Attempt::first); });
        }
    } catch (const std::exception&) {  // fewer, then
    }
    work(outputs, Attempt::first);
}

void OutputCrew::work(std::span<const RunOutput* const> outputs, Attempt attempt) {
    try {
        for (std::size_t place = next_++; place < outputs.size() && !stopped_; place = next_++) {
            tell(*outputs[place]);
            write_one(*outputs[place], place, attempt);
        }
    } catch (...) {  // of the observer, and what no message could be made of
        const std::scoped_lock lock(mutex_);
        if (!broken_) broken_ = std::current_exception();
        stopped_ = true;
    }
}

void OutputCrew::write_one(const RunOutput& output, std::size_t place, Attempt attempt) {
    try {
        failed_[place] = 0;
        if (output.rereads && finished_.stopped()) throw Error(left_out());
        write_timed(output, place);
    } catch (const std::exception& error) {  // of a library too
        if (output.essential) throw;
        failed_[place] = 1;
        if (attempt == Attempt::first) return;
        for (const std::string& file : output.files(finished_)) {
            std::error_code ignored;
            std::filesystem::remove(folder_ / file, ignored);
        }
        reasons_[place] = message_of(error);
    }
}

void OutputCrew::write_timed(const RunOutput& output, std::size_t place) {
    const double began = thread_seconds();
    reasons_[place] = output.write(finished_, folder_);
    seconds_[place] += thread_seconds() - began;
}

void OutputCrew::tell(const RunOutput& output) {
    if (!told_) return;
    const std::scoped_lock lock(mutex_);
    told_({output.files(finished_).front(), ++told_of_, count_});
}

}  // namespace hitos
