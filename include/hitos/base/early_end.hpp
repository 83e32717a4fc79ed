// SPDX-License-Identifier: GPL-3.0-or-later
// What a process clears before it is ended from outside, with no time to end by itself.
#pragma once

#include <filesystem>
#include <functional>
#include <list>
#include <mutex>

namespace hitos {

/// Calls `clear` where the process is ended early while this lives. The function may meet other
/// threads at work, and must not wait for them.
class AtEarlyEnd {
  public:
    explicit AtEarlyEnd(std::function<void()> clear);
    ~AtEarlyEnd();
    AtEarlyEnd(const AtEarlyEnd&) = delete;
    AtEarlyEnd& operator=(const AtEarlyEnd&) = delete;

    /// From here on nothing is to be cleared. Does not return once the process is being ended.
    void forget();
    /// As forget(); until what is returned goes, the process is not ended early, and nobody may
    /// say what is to be cleared.
    [[nodiscard]] std::unique_lock<std::mutex> hold();

  private:
    std::list<std::function<void()>>::iterator place_;
    bool kept_ = true;
};

/// Removes a folder in which other threads may be writing, for a tenth of a second at the most.
void remove_under_way(const std::filesystem::path& folder);

/// Ends the process with that status: clears what is to be, the newest first, and the temporary
/// files. No other thread ends it with another status meanwhile, if it asks wait_for_early_end().
[[noreturn]] void end_early(int status);

/// Does not return where the process is being ended.
void wait_for_early_end();

}  // namespace hitos
