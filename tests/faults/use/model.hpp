// SPDX-License-Identifier: GPL-3.0-or-later
// Use of hitos-cli as it goes on for a year: commands in any order, disturbed in any way, against a
// model of what must be there afterwards. What a command gives is what it gives undisturbed in a
// folder of its own; a disturbed one leaves what was there before, or that.
#pragma once

#include <deque>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "server.hpp"

namespace hitos::test {

/// A command, with the parts of the workplace that it reads and writes.
struct Step {
    Words words;
    std::vector<std::string> writes;
    std::vector<std::string> reads;
    bool by_window = false;  ///< not by hitos-cli
    bool resumes = false;  ///< what it has done when it is stopped stays, for the same one to go on
    bool part_of_one = false;          ///< a shard
    bool ends_what_was_begun = false;  ///< of the parts that are there
};

enum class Harm { none, fault, full, cut, kill, power, twice };

/// A part as a user finds it: a folder, or files of one beginning, that are written together.
struct Part {
    bool folder = true;
    Content raw;           ///< when it was last whole; what commands are given
    Content shown;         ///< without what differs from time to time
    bool changed = false;  ///< by another hand: verify says so
    bool begun = false;    ///< parts of a study are there, in its place or hidden
};

/// Two of each program, for two at once. Without a window hitos-cli alone.
struct Programs {
    explicit Programs(const Workplace& place);
    std::deque<Server> command_lines;
    std::deque<Server> windows;
};

class UseModel {
  public:
    /// `place` is as Workplace makes it, and the programs work in it.
    UseModel(const Workplace& place, Programs& programs, unsigned seed);

    /// One step; an empty text, or what is not as it must be.
    std::string go_on();
    /// What has been done, a line each.
    const std::vector<std::string>& history() const { return history_; }

  private:
    struct Expected {
        int status = 0;
        std::string said;
        long operations = 0;
        std::map<std::string, Content> shown;  ///< of each part it writes
    };

    unsigned any(unsigned below) { return static_cast<unsigned>(random_()) % below; }
    const std::string& one_of(const std::vector<std::string>& all) {
        return all[any(static_cast<unsigned>(all.size()))];
    }
    // What is done (model.cpp).
    Step some_step();
    Harm some_harm(const Step& step);
    std::filesystem::path scratch() const { return place_.work().string() + ".tmp"; }
    Words environment() const;
    Server& server(const Step& step, std::size_t number = 0);
    const Expected& expected(const Step& step);
    std::string other_hand();
    std::string disturbed(const Step& step, Harm harm);
    std::string power_lost(const Step& step, long number, Outcome& outcome);
    void take_over(const std::string& name);
    // What is judged (judgement.cpp).
    Content raw_of(const std::string& part) const;
    Content shown_of(const Content& raw) const;
    std::string twice(const Step& step);
    std::string judged(const Step& step, Harm harm, const Outcome& outcome);
    std::string judged_part(const std::string& name, const Step& step, const Expected& after,
                            bool undisturbed, const Outcome& outcome);
    bool waits(const std::string& name) const;
    bool has_strangers(const std::string& name) const;
    Outcome verdict_of(const std::string& name);
    std::string verified(const std::string& name);
    std::string leftovers(const Step& step) const;

    std::mt19937 random_;
    const Workplace& place_;
    Programs& programs_;
    std::map<std::string, Part> parts_;
    std::map<std::string, std::string> kept_;  ///< second names that files got, and their bytes
    std::vector<std::string> history_;
};

}  // namespace hitos::test
