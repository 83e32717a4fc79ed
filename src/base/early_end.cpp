// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/early_end.hpp"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "hitos/base/atomic_file.hpp"

namespace hitos {
namespace {

struct Clearing {
    std::mutex mutex;  // held for ever by who ends the process
    std::list<std::function<void()>> functions;
    std::atomic<bool> ending = false;
};

// Never destroyed: threads may still be at work when the others are.
Clearing& clearing() {
    static auto* one = new Clearing;
    return *one;
}

}  // namespace

AtEarlyEnd::AtEarlyEnd(std::function<void()> clear) {
    Clearing& all = clearing();
    const std::scoped_lock lock(all.mutex);
    place_ = all.functions.insert(all.functions.begin(), std::move(clear));
}

AtEarlyEnd::~AtEarlyEnd() {
    forget();
}

void AtEarlyEnd::forget() {
    if (kept_) static_cast<void>(hold());
}

std::unique_lock<std::mutex> AtEarlyEnd::hold() {
    Clearing& all = clearing();
    std::unique_lock lock(all.mutex);
    if (kept_) all.functions.erase(place_);
    kept_ = false;
    return lock;
}

void remove_under_way(const std::filesystem::path& folder) {
    constexpr int kTries = 50;
    constexpr std::chrono::milliseconds kPause(2);
    std::error_code error;
    for (int i = 0; i < kTries; ++i) {
        std::filesystem::remove_all(folder, error);
        if (!error) return;
        std::this_thread::sleep_for(kPause);
    }
}

void end_early(int status) {
    Clearing& all = clearing();
    all.ending = true;
    all.mutex.lock();
    for (const std::function<void()>& clear : all.functions) {
        try {
            clear();
        } catch (const std::exception&) {
            continue;  // what stays is cleared by the next process
        }
    }
    remove_temporary_files();
    std::_Exit(status);
}

void wait_for_early_end() {
    Clearing& all = clearing();
    if (all.ending) const std::scoped_lock lock(all.mutex);
}

}  // namespace hitos
