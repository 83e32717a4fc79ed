// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/grid/odometry_grid.hpp"

#include <exception>

namespace hitos {

OdometryGridAhead::OdometryGridAhead(const GridParams& params) : grid_(params) {
    try {
        thread_ = std::jthread([this](const std::stop_token& stop) { build(stop); });
    } catch (const std::exception&) {  // not ahead then
        given_up_ = true;
    }
}

void OdometryGridAhead::add(const Scan& scan, const Pose& pose) {
    constexpr std::size_t kMostWaiting = 64;
    std::unique_lock lock(mutex_);
    ++added_;
    changed_.wait(lock, [&] { return given_up_ || waiting_.size() < kMostWaiting; });
    if (given_up_) return;
    waiting_.emplace_back(scan, pose);
    changed_.notify_all();
}

void OdometryGridAhead::build(const std::stop_token& stop) {
    try {
        while (grid_.bytes() <= kMostBytes) {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, stop, [&] { return !waiting_.empty(); })) return;
            const auto next = std::move(waiting_.front());
            waiting_.pop_front();
            changed_.notify_all();
            lock.unlock();
            grid_.add(next.first, next.second);
        }
    } catch (const std::exception&) {  // of memory
    }
    const std::scoped_lock lock(mutex_);
    given_up_ = true;
    waiting_.clear();
    changed_.notify_all();
}

std::optional<Grid> OdometryGridAhead::take(std::uint64_t scans) {
    {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return given_up_ || waiting_.empty(); });
    }
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
    if (std::exchange(given_up_, true) || added_ != scans) return std::nullopt;
    return std::exchange(grid_, Grid());
}

}  // namespace hitos
