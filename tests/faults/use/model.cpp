// SPDX-License-Identifier: GPL-3.0-or-later
#include "model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cerrno>
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

std::string key_of(const Content& content) {
    std::string key;
    for (const auto& [name, bytes] : content) {
        key += fmt::format("{}:{:x};", name, std::hash<std::string>()(bytes));
    }
    return key;
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

Programs::Programs(const Workplace& place) {
    for (int number = 0; number < 2; ++number) {
        command_lines.emplace_back(HITOS_BIN_DIR "/hitos-cli", place.work());
#ifdef HITOS_WINDOW_SAVES
        windows.emplace_back(HITOS_WINDOW_SAVES, place.work());
#endif
    }
}

UseModel::UseModel(const Workplace& place, Programs& programs, unsigned seed)
    : random_(seed), place_(place), programs_(programs) {
    fs::remove_all(scratch());  // of the killed ones before
    fs::create_directory(scratch());
    for (const std::string& name : kResults) parts_[name];
    parts_["study"];
    for (const char* const name : {"made", "tour.txt", "room2.toml"}) parts_[name].folder = false;
}

Words UseModel::environment() const {
    return {"PATH=" + place_.programs() + ":/usr/bin:/bin", "TMPDIR=" + scratch().string()};
}

Server& UseModel::server(const Step& step, std::size_t number) {
    return (step.by_window ? programs_.windows : programs_.command_lines).at(number);
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
    // A window takes as long as ten commands.
    if (!programs_.windows.empty() && any(60) == 0) {
        step.by_window = true;
        switch (any(3)) {
            case 0:
                step.words = {"save", "world", "room.toml", seed, "room2.toml"};
                step.writes = {"room2.toml"};
                break;
            case 1:
                step.words = {"save", "log", "room.toml", seed, "made.log"};
                step.writes = {"made"};
                break;
            default:
                step.words = {"save", "results", "tour.log", seed, one_of(kResults)};
                step.writes = {step.words.back()};
        }
        return step;
    }
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
    constexpr std::size_t kMost = 2000;  // some hundred megabytes
    static std::map<std::string, Expected> known;
    // Results name their log with its folder.
    std::string key = fmt::format("{} {}", place_.work().string(), fmt::join(step.words, " "));
    std::set<std::string> needed(step.reads.begin(), step.reads.end());
    needed.insert(step.writes.begin(), step.writes.end());
    // What is shown of a part does not tell what somebody has changed in a file that tells times.
    for (const std::string& name : needed) {
        const Part& part = parts_[name];
        key += " " + key_of(part.changed ? part.raw : part.shown);
    }
    if (known.size() >= kMost && !known.contains(key)) known.clear();
    const auto [found, is_new] = known.try_emplace(key);
    if (!is_new) return found->second;

    const fs::path root = place_.work();
    const fs::path aside = root.string() + ".aside";
    fs::rename(root, aside);
    fs::create_directory(root);
    for (const std::string& input : kInputs) fs::copy(aside / input, root / input);
    for (const std::string& part : needed) put(root, parts_[part].raw);
    Words counting = environment();
    counting.emplace_back("HITOS_FAULT_FILE=0:0");
    const Outcome outcome = server(step).run(step.words, counting);
    Expected& after = found->second;
    after.status = outcome.status;
    after.said = outcome.output;
    for (const std::string& line : server(step).report()) {
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
    Words variables = environment();
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
    outcome = server(step).run(step.words, variables);
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
    Words variables = environment();
    variables.push_back("HITOS_FAULT_JOURNAL=" + kept.string());
    // Sometimes the current fails a moment after the command has ended.
    if (any(4) != 0) variables.push_back(fmt::format("HITOS_FAULT_FILE={}:0:kill", number));
    outcome = server(step).run(step.words, variables);
    disk.follow(server(step).report());
    if (outcome.status != 137) outcome.status = 137;  // what it said is of no use any more
    // Of its own, so that what comes after is the same however much there was to drop.
    std::mt19937 dropped(static_cast<unsigned>(random_()));
    disk.lose_power(kept, dropped);
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
            for (auto& [second, bytes] : kept_) {
                if (fs::equivalent(root / second, root / file)) bytes += " ";
            }
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
