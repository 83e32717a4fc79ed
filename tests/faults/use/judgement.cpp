// SPDX-License-Identifier: GPL-3.0-or-later
// What is judged of a workplace after each step: parts are as before or as undisturbed commands
// make them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "model.hpp"

namespace hitos::test {

namespace fs = std::filesystem;

namespace {

/// The names of what differs, with the first line that does.
std::string apart(const Content& wanted, const Content& found) {
    std::string text = difference(wanted, found);
    for (const auto& [name, bytes] : wanted) {
        const auto other = found.find(name);
        if (other == found.end() || other->second == bytes) continue;
        std::istringstream one(bytes);
        std::istringstream two(other->second);
        std::string a;
        std::string b;
        do {
            std::getline(one, a);
            std::getline(two, b);
        } while (one && two && a == b);
        text += fmt::format("{}: wanted {:.200}\n  found {:.200}\n", name, a, b);
    }
    return text;
}

}  // namespace

Content UseModel::raw_of(const std::string& part) const {
    Content found;
    const fs::path root = place_.work();
    if (!parts_.at(part).folder) {
        for (const auto& entry : fs::directory_iterator(root)) {
            const std::string name = entry.path().filename().string();
            if (name.starts_with(part)) found[name] = content(entry.path());
        }
        return found;
    }
    if (!fs::is_directory(root / part)) return found;
    found[part + "/"];
    const fs::path real = fs::canonical(root / part);
    for (const auto& entry : fs::recursive_directory_iterator(real)) {
        const std::string name = part + "/" + entry.path().lexically_relative(real).string();
        if (is_temporary(name)) continue;
        if (entry.is_directory()) {
            found[name + "/"];
        } else {
            found[name] = content(entry.path());
        }
    }
    return found;
}

Content UseModel::shown_of(const Content& raw) const {
    Content shown;
    for (const auto& [name, bytes] : raw) {
        // That a folder has been made is no result yet.
        if (!name.ends_with('/')) shown[name] = without_times(place_.work() / name, bytes);
    }
    return shown;
}

std::string UseModel::twice(const Step& step) {
    Step second = step;
    for (std::string& word : second.words) {
        if (word == "1" || word == "2") word = "3";  // another seed
    }
    const std::array<Expected, 2> after{expected(step), expected(second)};
    const Words variables = environment();
    Server& one = server(step);
    Server& other = server(second, 1);
    one.begin(step.words, variables);
    other.begin(second.words, variables);
    const std::array<Outcome, 2> outcomes{one.end(), other.end()};
    const bool both_failed = outcomes[0].status != 0 && outcomes[1].status != 0;
    for (const std::string& name : step.writes) {
        Part& part = parts_[name];
        const Content now = shown_of(raw_of(name));
        if (both_failed && now == part.shown && !waits(name)) {  // begun, or not, as it was
            if (!part.begun) take_over(name);
            continue;
        }
        if (step.part_of_one) {  // as in judged_part
            part.begun = true;
            continue;
        }
        bool known = false;
        for (std::size_t k = 0; k < outcomes.size(); ++k) {
            known = known || (outcomes.at(k).status == 0 && now == after.at(k).shown.at(name));
        }
        // What the first one made was before the second.
        if (!known && !step.resumes && after[0].status == 0) {
            return fmt::format("{} is of neither of two at once:\n{}said: {} {}", name,
                               apart(after[0].shown.at(name), now), outcomes[0].output,
                               outcomes[1].output);
        }
        part.begun = !known || (step.resumes && waits(name));
        if (known) {
            if (now != part.shown) part.changed = has_strangers(name);
            take_over(name);
        }
    }
    for (const Outcome& outcome : outcomes) {
        if (outcome.status > 2) return "one of two at once ended with " + outcome.output;
    }
    return {};
}

std::string UseModel::judged(const Step& step, Harm harm, const Outcome& outcome) {
    const Expected& after = expected(step);
    const bool undisturbed = harm == Harm::none;
    const bool killed = harm == Harm::kill || harm == Harm::power;
    const std::string said =
        fmt::format("status {}, said:\n{}", outcome.status, outcome.output.substr(0, 2000));
    const bool from_parts = step.resumes && parts_["study"].begun && step.ends_what_was_begun;
    if (undisturbed && outcome.status != after.status && !from_parts) {
        return fmt::format("status {} expected ({}), but {}", after.status, after.said, said);
    }
    if (!killed &&
        (outcome.status > 2 || outcome.output.find("terminate called") != std::string::npos)) {
        return "it has not ended by itself: " + said;
    }
    if (!killed && outcome.status != 0 && outcome.output.empty()) return "it ended without a word";
    for (auto& [name, part] : parts_) {
        if (std::ranges::find(step.writes, name) != step.writes.end()) {
            const std::string wrong = judged_part(name, step, after, undisturbed, outcome);
            if (!wrong.empty()) return fmt::format("{}\n{}", wrong, said);
        } else if (!part.begun && raw_of(name) != part.raw) {
            return fmt::format("{} has nothing to do with it, and has changed:\n{}{}", name,
                               difference(part.raw, raw_of(name)), said);
        }
    }
    for (const auto& [name, bytes] : kept_) {
        if (content(place_.work() / name) != bytes) return name + ", a second name, has changed";
    }
    return undisturbed && outcome.status == 0 ? leftovers(step) : std::string();
}

std::string UseModel::judged_part(const std::string& name, const Step& step, const Expected& after,
                                  bool undisturbed, const Outcome& outcome) {
    Part& part = parts_[name];
    const Content now = shown_of(raw_of(name));
    const Content& wanted = after.shown.at(name);
    const bool done = now == wanted;
    const bool nothing_done = now == part.shown;
    // A picture that could not be written is told, and the summary says so too.
    const bool told = outcome.status != 137 && tells_of_missing(outcome.output);
    // What comes of parts depends on which there are.
    const bool from_parts = part.begun && (step.ends_what_was_begun || step.part_of_one);
    if (outcome.status == 0 && !done && !told && !from_parts) {
        return fmt::format("{} is not what an undisturbed command makes:\n{}", name,
                           apart(wanted, now));
    }
    // Files of a simulated tour change places one by one, the log last: docs/reliability.md,
    // limits.
    const bool between = outcome.status == 137 && name == "made" && !now.contains("made.log");
    if (!done && !nothing_done && !told && !between && !step.resumes && !part.begun) {
        return fmt::format("{} is neither as before nor as after:\n{}\nto what was:\n{}", name,
                           apart(wanted, now), difference(part.shown, now));
    }
    if (step.part_of_one) {
        part.begun = part.begun || !nothing_done || outcome.status == 0 || waits(name);
        if (!part.begun) take_over(name);  // its folder may be there
        return {};
    }
    if (from_parts) {
        const Outcome verdict = verdict_of(name);
        if (verdict.status != 0 || outcome.status != 0) return {};  // it may be none of all runs
        part.begun = part.changed = false;                          // as verify says
        take_over(name);
        return {};
    }
    if (undisturbed && after.status == 0) part.begun = false;
    if (done || nothing_done || told || between) {
        if (outcome.status == 0) part.begun = false;
        if (!nothing_done) part.changed = has_strangers(name);
        if (!part.begun || done) take_over(name);
    } else {
        part.begun = true;
    }
    part.begun = part.begun || (step.resumes && waits(name));
    // One that was killed while its files changed places is told to be so until somebody goes on.
    return step.resumes && outcome.status == 137 ? std::string() : verified(name);
}

/// Whether a hidden study is there that whoever comes next may finish.
bool UseModel::waits(const std::string& name) const {
    const fs::path folder = place_.work() / name;
    return fs::exists(folder / ".study.json.hitos-new") ||
           fs::exists(folder / ".study.json.hitos-next");
}

/// Whose summary was taken away by hand is nobody's: the next run leaves it, and verify tells of
/// it.
bool UseModel::has_strangers(const std::string& name) const {
    const Content raw = raw_of(name);
    const auto summary = raw.find(name + "/summary.json");
    if (summary == raw.end()) return false;
    const std::string_view text = summary->second;
    const std::string_view files = text.substr(std::min(text.rfind("\"files\""), text.size()));
    return std::ranges::any_of(raw, [&](const auto& file) {
        const std::string word = fs::path(file.first).filename().string();
        const bool of_none = word.empty() || word == "summary.json" || word == "note.txt";
        return !of_none && files.find(fmt::format("\"{}\"", word)) == std::string_view::npos;
    });
}

Outcome UseModel::verdict_of(const std::string& name) {
    return programs_.command_lines.front().run({"verify", name}, environment());
}

std::string UseModel::verified(const std::string& name) {
    const Part& part = parts_[name];
    if (!part.folder || part.begun || part.raw.empty() || any(2) == 0) return {};
    const bool run = part.raw.contains(name + "/summary.json");
    const bool study = part.raw.contains(name + "/study.json");
    if (!run && !study) return {};
    const Outcome verdict = verdict_of(name);
    if ((verdict.status == 0) == !part.changed) return {};
    return fmt::format("verify says of {}, {}:\n{}", name, part.changed ? "changed" : "whole",
                       verdict.output);
}

/// What is hidden beside or in the parts that it has just written.
std::string UseModel::leftovers(const Step& step) const {
    for (const std::string& name : step.writes) {
        // Beside the folder itself: what lies beside a link to it was left before it was one.
        const fs::path real = fs::weakly_canonical(place_.work() / name);
        for (const fs::path& folder : {real.parent_path(), real}) {
            if (!fs::is_directory(folder)) continue;
            for (const auto& entry : fs::directory_iterator(folder)) {
                const std::string file = entry.path().filename().string();
                const bool hidden = file.find(".hitos-") != std::string::npos;
                const bool of_it = folder == real || file.starts_with("." + name + ".hitos-");
                // A study that was stopped waits there until somebody goes on with it or begins a
                // third.
                if (hidden && of_it && !file.ends_with("-next")) {
                    return "left behind: " + entry.path().string();
                }
            }
        }
    }
    return {};
}

}  // namespace hitos::test
