#include "model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <sstream>
#include <utility>

#include "power_loss.hpp"

namespace hitos::test {

namespace fs = std::filesystem;

namespace {

const std::vector<std::string> kResults{"first", "second"};
const std::vector<std::string> kInputs{"tour.log", "truth.tum", "room.toml"};

void operator+=(Words& words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
}

Words path_of_programs(const Workplace& place) {
    return {"PATH=" + place.programs() + ":/usr/bin:/bin"};
}

std::string key_of(const Content& content) {
    std::string key;
    for (const auto& [name, bytes] : content) {
        key += fmt::format("{}:{:x};", name, std::hash<std::string>()(bytes));
    }
    return key;
}

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

/// What is put into the folder `root`: files by their paths.
void put(const fs::path& root, const Content& files) {
    for (const auto& [name, bytes] : files) {
        if (name.ends_with('/')) {
            fs::create_directories(root / name);
            continue;
        }
        fs::create_directories((root / name).parent_path());
        std::ofstream(root / name, std::ios::binary) << bytes;
    }
}

}  // namespace

UseModel::UseModel(const Workplace& place, unsigned seed)
    : random_(seed),
      place_(place),
      one_(HITOS_BIN_DIR "/hitos-cli", place_.work(), place_.work()),
      other_(HITOS_BIN_DIR "/hitos-cli", place_.work(), place_.work()) {
    for (const std::string& name : kResults) parts_[name];
    parts_["study"];
    for (const char* const name : {"made", "tour.txt", "room2.toml"}) parts_[name].folder = false;
}

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

void UseModel::take_over(const std::string& name) {
    Part& part = parts_[name];
    part.raw = raw_of(name);
    part.shown = shown_of(part.raw);
}

Step UseModel::some_step() {
    const std::string seed = std::to_string(1 + any(3));
    const Words small{"--set", "filter.particles=2", "--set", "grid.resolution=0.5"};
    Step step;
    switch (any(10)) {
        case 0:
        case 1:
        case 2: {
            const std::string out = one_of(kResults);
            const std::string log = one_of({"tour.log", "tour.log", "made.log", "tour.txt"});
            step.words = {"run",   log, "--seed",    seed,
                          "--out", out, "--threads", one_of({"1", "1", "3"})};
            step.words += small;
            if (any(2) == 0) step.words += {"--reference-trajectory", "truth.tum"};
            if (any(3) == 0) step.words += {"--uncertainty"};
            step.writes = {out};
            if (log != "tour.log") step.reads = {log == "made.log" ? "made" : log};
            break;
        }
        case 3:
        case 4:
            step.words = {"study",     "tour.log", "--runs",
                          "1",         "--seed",   seed,
                          "--threads", "1",        "--out",
                          "study",     "--vary",   one_of({"dmax=0.03,0.02", "dmax=0.01,0.02"})};
            step.words += small;
            if (any(2) == 0) step.words += {"--pictures=all"};
            if (any(3) == 0) {
                step.words += {"--shard", one_of({"1/2", "2/2"})};
                step.part_of_one = true;
            }
            step.writes = {"study"};
            step.resumes = true;
            break;
        case 5:
            step.words = {"simulate", "room.toml", "--seed",   seed,          "--out",
                          "made.log", "--truth",   "made.tum", "--reference", "made.map"};
            step.writes = {"made"};
            break;
        case 6:
            step.words = {"convert", "tour.log", "--to", "normalized", "--odometry-noise",
                          "0.1",     "--seed",   seed,   "--out",      "tour.txt"};
            step.writes = {"tour.txt"};
            break;
        case 7:
            step.words = {"world", one_of({"first", "second", "room.toml"}), "--out", "room2.toml"};
            step.writes = {"room2.toml"};
            step.reads = kResults;
            break;
        case 8:
            step.words = any(2) == 0 ? Words{"recover", "study"} : Words{"study", "merge", "study"};
            step.ends_what_was_begun = true;
            step.writes = {"study"};
            step.resumes = true;
            break;
        default:
            step.words = {"evaluate", one_of(kResults)};
            step.reads = {"first", "second", "made", "tour.txt"};
    }
    return step;
}

/// The same step in a folder that holds nothing else, undisturbed.
const UseModel::Expected& UseModel::expected(const Step& step) {
    static std::map<std::string, Expected> known;
    // Results name their log with its folder.
    std::string key = fmt::format("{} {}", place_.work().string(), fmt::join(step.words, " "));
    std::set<std::string> needed(step.reads.begin(), step.reads.end());
    needed.insert(step.writes.begin(), step.writes.end());
    for (const std::string& part : needed) key += " " + key_of(parts_[part].shown);
    const auto [found, is_new] = known.try_emplace(key);
    if (!is_new) return found->second;

    const fs::path root = place_.work();
    const fs::path aside = root.string() + ".aside";
    fs::rename(root, aside);
    fs::create_directory(root);
    for (const std::string& input : kInputs) fs::copy(aside / input, root / input);
    for (const std::string& part : needed) put(root, parts_[part].raw);
    Words counting = path_of_programs(place_);
    counting.emplace_back("HITOS_FAULT_FILE=0:0");
    const Outcome outcome = one_.run(step.words, counting);
    Expected& after = found->second;
    after.status = outcome.status;
    after.said = outcome.output;
    for (const std::string& line : one_.report()) {
        after.operations += line.starts_with("space ") || line.starts_with("other ") ? 1 : 0;
    }
    for (const std::string& part : step.writes) after.shown[part] = shown_of(raw_of(part));
    fs::remove_all(root);
    fs::rename(aside, root);
    return after;
}

Harm UseModel::some_harm(const Step& step) {
    if (step.writes.empty()) return Harm::none;
    constexpr std::array kAll{Harm::none,  Harm::none,  Harm::none,  Harm::fault,
                              Harm::fault, Harm::full,  Harm::cut,   Harm::kill,
                              Harm::kill,  Harm::power, Harm::power, Harm::twice};
    return kAll.at(any(static_cast<unsigned>(kAll.size())));
}

std::string UseModel::go_on() {
    if (any(5) == 0) return other_hand();
    const Step step = some_step();
    return disturbed(step, some_harm(step));
}

std::string UseModel::disturbed(const Step& step, Harm harm) {
    constexpr std::array kNames{"", "fault", "full", "cut", "kill", "power", "twice"};
    const Expected& after = expected(step);
    const long number = 1 + any(static_cast<unsigned>(std::max(after.operations, 1L)));
    history_.push_back(fmt::format(
        "{}{}", fmt::join(step.words, " "),
        harm == Harm::none
            ? ""
            : fmt::format("   ({} at {} of {})", kNames.at(static_cast<std::size_t>(harm)), number,
                          after.operations)));
    if (harm == Harm::twice) return twice(step);
    Outcome outcome;
    if (harm == Harm::power) {
        const std::string wrong = power_lost(step, number, outcome);
        return wrong.empty() ? judged(step, harm, outcome) : wrong;
    }
    Words variables = path_of_programs(place_);
    constexpr std::array kErrors{ENOSPC, EDQUOT, EIO};
    if (harm == Harm::fault) {
        variables.push_back(fmt::format("HITOS_FAULT_FILE={}:{}", number, kErrors.at(any(3))));
    } else if (harm == Harm::full || harm == Harm::cut) {
        variables.push_back(fmt::format("HITOS_FAULT_FILE={}:{}:{}", number,
                                        static_cast<int>(ENOSPC),
                                        harm == Harm::full ? "lasting" : "cut"));
    } else if (harm == Harm::kill) {
        variables.push_back(fmt::format("HITOS_FAULT_FILE={}:0:kill", number));
    }
    outcome = one_.run(step.words, variables);
    return judged(step, harm, outcome);
}

std::string UseModel::power_lost(const Step& step, long number, Outcome& outcome) {
    const fs::path copy = place_.work().string() + ".before";
    const fs::path kept = place_.work().string() + ".kept";
    fs::remove_all(copy);
    fs::remove_all(kept);
    fs::create_directory(kept);
    fs::copy(place_.work(), copy, fs::copy_options::recursive | fs::copy_options::copy_symlinks);
    Disk disk(place_.work(), copy);
    Words variables = path_of_programs(place_);
    variables.push_back("HITOS_FAULT_JOURNAL=" + kept.string());
    // Sometimes the current fails a moment after the command has ended.
    if (any(4) != 0) variables.push_back(fmt::format("HITOS_FAULT_FILE={}:0:kill", number));
    outcome = one_.run(step.words, variables);
    disk.follow(one_.report());
    if (outcome.status != 137) outcome.status = 137;  // what it said is of no use any more
    disk.lose_power(kept, random_);
    return {};
}

std::string UseModel::twice(const Step& step) {
    Step second = step;
    for (std::string& word : second.words) {
        if (word == "1" || word == "2") word = "3";  // another seed
    }
    const std::array<Expected, 2> after{expected(step), expected(second)};
    const Words variables = path_of_programs(place_);
    one_.begin(step.words, variables);
    other_.begin(second.words, variables);
    const std::array<Outcome, 2> outcomes{one_.end(), other_.end()};
    for (const std::string& name : step.writes) {
        const Content now = shown_of(raw_of(name));
        bool known =
            now == parts_[name].shown && outcomes[0].status != 0 && outcomes[1].status != 0;
        for (std::size_t k = 0; k < outcomes.size(); ++k) {
            known = known || (outcomes.at(k).status == 0 && now == after.at(k).shown.at(name));
        }
        // What the first one made was before the second.
        if (!known && !step.resumes && after[0].status == 0) {
            return fmt::format("{} is of neither of two at once:\n{}said: {} {}", name,
                               apart(after[0].shown.at(name), now), outcomes[0].output,
                               outcomes[1].output);
        }
        parts_[name].begun = !known;
        if (known) {
            if (now != parts_[name].shown) parts_[name].changed = false;
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
    const bool told =
        outcome.status == 0 && (outcome.output.find("not written: ") != std::string::npos ||
                                outcome.output.find("not drawn: ") != std::string::npos ||
                                outcome.output.find("no plots: ") != std::string::npos ||
                                outcome.output.find("no contact sheet: ") != std::string::npos);
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
        part.begun = part.begun || !nothing_done || outcome.status == 0;
        return {};
    }
    if (from_parts) {
        const Outcome verdict = one_.run({"verify", name}, path_of_programs(place_));
        if (verdict.status != 0 || outcome.status != 0) return {};  // it may be none of all runs
        part.begun = part.changed = false;
        take_over(name);
        return {};
    }
    if (undisturbed && after.status == 0) part.begun = false;
    if (done || nothing_done || told || between) {
        if (outcome.status == 0) part.begun = false;
        if (!nothing_done) part.changed = false;
        if (!part.begun || done) take_over(name);
    } else {
        part.begun = true;
    }
    // One that was killed while its files changed places is told to be so until somebody goes on.
    return step.resumes && outcome.status == 137 ? std::string() : verified(name);
}

std::string UseModel::verified(const std::string& name) {
    const Part& part = parts_[name];
    if (!part.folder || part.begun || part.raw.empty() || any(2) == 0) return {};
    const bool run = part.raw.contains(name + "/summary.json");
    const bool study = part.raw.contains(name + "/study.json");
    if (!run && !study) return {};
    const Outcome verdict = one_.run({"verify", name}, path_of_programs(place_));
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

/// A user, or another program, does something to the files.
std::string UseModel::other_hand() {
    const std::string name = one_of(kResults);
    Part& part = parts_[name];
    std::vector<std::string> files;
    for (const auto& [file, bytes] : part.raw) {
        if (!file.ends_with('/') && !file.ends_with("/note.txt")) files.push_back(file);
    }
    if (files.empty() || part.begun) return {};
    const fs::path root = place_.work();
    const std::string file = one_of(files);
    switch (any(7)) {
        case 0:
            history_.push_back("a note is put into " + name);
            std::ofstream(root / name / "note.txt") << "mine, " << any(100);
            break;
        case 1:
            history_.push_back("changed by hand: " + file);
            std::ofstream(root / file, std::ios::app) << " ";
            part.changed = true;
            break;
        case 2:
            history_.push_back("removed by hand: " + file);
            fs::remove(root / file);
            part.changed = true;
            break;
        case 3: {
            history_.push_back("another clock: " + file);
            const auto by = std::chrono::hours(24 * 365) * (static_cast<int>(any(20)) - 10);
            fs::last_write_time(root / file, fs::last_write_time(root / file) + by);
            fs::last_write_time(root / "tour.log", fs::last_write_time(root / "tour.log") - by);
            break;
        }
        case 4: {
            const std::string second = fmt::format("kept-{}", kept_.size());
            history_.push_back("a second name for " + file + ": " + second);
            fs::create_hard_link(root / file, root / second);
            kept_[second] = content(root / file);
            break;
        }
        case 5:
            history_.push_back("nobody else may read " + file);
            fs::permissions(root / file, fs::perms::owner_read | fs::perms::owner_write);
            break;
        default:
            if (fs::is_symlink(root / name)) {
                history_.push_back(name + " comes back to its place");
                const fs::path real = fs::canonical(root / name);
                fs::remove(root / name);
                fs::rename(real, root / name);
            } else {
                history_.push_back(name + " becomes a link to a folder elsewhere");
                fs::create_directory(root / "elsewhere");
                fs::rename(root / name, root / "elsewhere" / name);
                fs::create_symlink(fs::path("elsewhere") / name, root / name);
            }
    }
    take_over(name);
    return verified(name);
}

}  // namespace hitos::test
