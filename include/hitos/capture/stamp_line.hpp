// SPDX-License-Identifier: GPL-3.0-or-later
// What one device sends is stamped in the order in which it comes; what is not, is found here.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <utility>

#include "hitos/base/message.hpp"

namespace hitos {

/// Where stamps go back to times that were, and stay there.
struct StampReturns {
    static constexpr double kOutOfOrder = 2.0;   ///< less is out of order only [s]
    static constexpr double kLongest = 86400.0;  ///< nobody drives on after more [s]

    void note(double time_s, std::uint64_t line);
    /// Stamps of two clocks in turn go to and fro.
    bool rare() const { return count > 0 && kOften * count < stamps; }

    static constexpr std::uint64_t kOften = 10;
    std::uint64_t stamps = 0;
    std::uint64_t count = 0;
    double before_s = 0.0;  ///< stamp before the last
    double last_s = 0.0;
    std::uint64_t last_line = 0;
    double most_s = 0.0;
    double at_s = 0.0;            ///< of that one, the last stamp before it,
    std::uint64_t line = 0;       ///< and the line behind it
    std::uint64_t backwards = 0;  ///< stamps that are before the last one
    double first_s = 0.0;
    std::uint64_t leaps = 0;          ///< steps ahead that no tour has
    double farthest_s = 0.0;          ///< the longest step ahead,
    double farthest_at_s = 0.0;       ///< from where,
    std::uint64_t farthest_line = 0;  ///< and the line behind it
};

/// How many of a sequence's stamps are out of line, and what they stamped left out.
struct BrokenStamps {
    std::uint64_t stamps = 0;
    std::uint64_t left_out = 0;
    friend BrokenStamps operator+(const BrokenStamps& a, const BrokenStamps& b) {
        return {a.stamps + b.stamps, a.left_out + b.left_out};
    }
};

/// Tells stamps that are broken from clocks that were set, by what comes behind them: a few that
/// leave the line of their neighbours, which then goes on, are broken; where the line goes on from
/// them, the clock was set or the tour played again.
class StampJudge {
  public:
    static constexpr double kShortPause = 10.0;  ///< what waits longer is asked more closely [s]
    static constexpr double kNoPause = 30.0 * 86400.0;  ///< no tour has one so long [s]
    static constexpr std::size_t kRun = 8;              ///< of so many in a row a line is made

    /// What is to be done with the first that wait.
    struct Verdict {
        std::size_t count = 0;  ///< 0: more has to be known
        bool broken = false;
    };
    /// `times_s` wait, in the order in which they came; `ended`: no more will. Of several that go
    /// on, one at a time.
    Verdict judge(const std::deque<double>& times_s, bool ended) const;
    /// The first of them went on.
    void went_on(double time_s);
    /// That one of them is left out, for the reader's report.
    Message problem(double time_s, std::optional<double> next_s) const;

    /// How often what went on has gone back to times that were.
    std::uint64_t returns() const { return returns_; }

  private:
    /// Less is out of order only, or the pace of what is slow [s].
    double slack_s() const;
    bool follows(double time_s, double next_s) const { return next_s >= time_s - slack_s(); }
    Verdict judge_first(const std::deque<double>& times_s, bool ended) const;
    Verdict judge_ahead(const std::deque<double>& times_s, bool ended) const;
    Verdict judge_back(const std::deque<double>& times_s, bool ended) const;

    std::optional<double> last_s_;
    std::array<double, 2> steps_s_{};  ///< the newest that went on
    std::uint64_t returns_ = 0;
};

/// Items of one device, of which those with a broken stamp are left out. An item waits for those
/// behind it only where its stamp leaves the line, and the first ones.
template <class Item>
class StampLine {
  public:
    void add(double time_s, std::uint64_t line, Item item) {
        times_s_.push_back(time_s);
        items_.emplace_back(line, std::move(item));
    }
    /// No more come.
    void end() { ended_ = true; }
    bool ended() const { return ended_; }

    /// The next that goes on. `left_out(line, reason)` is called for those that do not.
    template <class LeftOut>
    std::optional<Item> take(const LeftOut& left_out) {
        while (!times_s_.empty()) {
            const StampJudge::Verdict verdict = judge_.judge(times_s_, ended_);
            if (verdict.count == 0) return std::nullopt;
            if (!verdict.broken) {
                Item item = std::move(items_.front().second);
                judge_.went_on(times_s_.front());
                items_.pop_front();
                times_s_.pop_front();
                ++broken_.stamps;
                return std::optional<Item>(std::move(item));
            }
            std::optional<double> next_s;
            if (verdict.count < times_s_.size()) next_s = times_s_[verdict.count];
            for (std::size_t i = 0; i < verdict.count; ++i, ++broken_.stamps, ++broken_.left_out) {
                left_out(items_.front().first, judge_.problem(times_s_.front(), next_s));
                items_.pop_front();
                times_s_.pop_front();
            }
        }
        return std::nullopt;
    }
    std::uint64_t returns() const { return judge_.returns(); }
    BrokenStamps broken() const { return broken_; }

  private:
    StampJudge judge_;
    BrokenStamps broken_;
    std::deque<double> times_s_;
    std::deque<std::pair<std::uint64_t, Item>> items_;
    bool ended_ = false;
};

}  // namespace hitos
