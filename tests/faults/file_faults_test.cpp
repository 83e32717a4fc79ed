// SPDX-License-Identifier: GPL-3.0-or-later
// Every file operation of a command fails in turn, as files do: no space, no more quota, an error
// of the disk, no permission, half a write. Of these a part, spread evenly;
// HITOS_REPEAT=1000 does all of them.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <iostream>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "commands.hpp"

namespace hitos::test {
namespace {

namespace fs = std::filesystem;

/// One operation, as the library of faults reports it.
struct Operation {
    std::string word;  ///< "space", "other", "hit"
    long number = 0;
    std::string what;
    std::string path;

    bool needs_space() const { return word == "space"; }
    /// Whether it is part of removing something: that then stays.
    bool removes() const {
        const bool looks = what == "openat" || what == "fdopendir" || what == "readdir" ||
                           what == "opendir" || what == "lstat" || what == "fstat";
        // A name alone is within a folder that is being removed.
        const bool hidden = path.find(".hitos-") != std::string::npos || !path.starts_with('/');
        return what == "unlink" || what == "unlinkat" || what == "remove" || what == "rmdir" ||
               (looks && hidden);
    }
};

std::optional<Operation> operation_in(const std::string& line) {
    std::istringstream text(line);
    Operation operation;
    if (!(text >> operation.word >> operation.number >> operation.what)) return std::nullopt;
    std::getline(text >> std::ws, operation.path);
    if (operation.path.ends_with(' ')) operation.path.pop_back();
    return operation;
}

/// What the errors of a disk are, for an operation that needs space and for any other.
constexpr std::array kNoSpace{ENOSPC, EDQUOT, EIO};
constexpr std::array kNoLook{EIO, EACCES};
constexpr std::array kNoLock{EIO, ENOLCK};  // EACCES says that another process has the lock

struct Fault {
    Operation operation;
    int error = 0;
    std::string word;  ///< "lasting", "cut" or empty

    std::string order() const {
        return fmt::format("HITOS_FAULT_FILE={}:{}{}{}", operation.number, error,
                           word.empty() ? "" : ":", word);
    }
};

std::vector<Fault> faults_of(const std::vector<Operation>& operations) {
    std::vector<Fault> faults;
    for (std::size_t i = 0; i < operations.size(); ++i) {
        const Operation& operation = operations[i];
        if (!operation.needs_space()) {
            const auto& errors = operation.what == "fcntl" ? kNoLock : kNoLook;
            faults.push_back({operation, errors[i % errors.size()], ""});
            continue;
        }
        faults.push_back({operation, kNoSpace[i % kNoSpace.size()], ""});
        faults.push_back({operation, ENOSPC, "lasting"});
        if (operation.what == "write") faults.push_back({operation, ENOSPC, "cut"});
    }
    const auto few_enough = static_cast<std::size_t>(repeated(24));
    const std::size_t every = std::max<std::size_t>(faults.size() / few_enough, 1);
    std::vector<Fault> some;
    for (std::size_t i = 0; i < faults.size(); i += every) some.push_back(faults[i]);
    return some;
}

/// The name by which a person knows the file: not that of the hidden ones.
std::string shown(const std::string& path) {
    fs::path known;
    for (const fs::path& part : fs::path(path)) {
        const std::string name = part.string();
        if (name.starts_with(".study.json.hitos-")) continue;  // in the study's own folder
        if (name == "former") break;                           // files that made way
        const std::size_t hidden = name.find(".hitos-");
        if (hidden == 0 || name.starts_with('#')) break;  // "#123 (deleted)": without a name
        known /= hidden == std::string::npos ? name : name.substr(1, hidden - 1);
    }
    return known.string();
}

class FileFaults : public ::testing::TestWithParam<std::string> {
  protected:
    Words watching(const std::string& order) const {
        return {"LD_PRELOAD=" HITOS_FAULTS_LIBRARY, order,
                "HITOS_FAULT_BELOW=" + place_.work().string(),
                "HITOS_FAULT_REPORT=" + place_.report_file()};
    }
    /// The operations of the last command, as the library of faults has reported them.
    std::vector<Operation> reported() const {
        std::vector<Operation> operations;
        for (const std::string& line : place_.take_report()) {
            if (std::optional<Operation> operation = operation_in(line)) {
                operations.push_back(*std::move(operation));
            }
        }
        return operations;
    }
    void expect_each_fault_harmless(const Command& command, const std::string& start);
    void expect_harmless(const Command& command, const Fault& fault);
    void expect_of_one_time(const Content& found, const Outcome& outcome, const Command& command);

    Workplace place_;
    Content before_;
    Content after_;
};

/// The files that a command puts in place together: a folder of results, those of a simulated tour,
/// or each file for itself.
std::string together(const std::string& name) {
    if (name.starts_with("made.")) return "made.";  // of simulate
    return name.starts_with("out/") ? "out/" : name;
}

/// Everything is as before or as after, and what belongs together is of one time.
void FileFaults::expect_of_one_time(const Content& found, const Outcome& outcome,
                                    const Command& command) {
    std::map<std::string, std::array<bool, 2>> of;  // each as before, as after
    const auto same = [](const Content& a, const Content& b, const std::string& name) {
        const auto one = a.find(name);
        const auto other = b.find(name);
        if (one == a.end() || other == b.end()) return one == a.end() && other == b.end();
        return one->second == other->second;
    };
    for (const Content* content : std::array<const Content*, 3>{&before_, &after_, &found}) {
        for (const auto& [name, bytes] : *content) {
            if (is_temporary(name)) continue;
            auto& [old, fresh] =
                of.try_emplace(together(name), std::array{true, true}).first->second;
            // That a folder has been made is no result yet.
            if (name.ends_with('/') && found.contains(name)) continue;
            old = old && same(found, before_, name);
            fresh = fresh && same(found, after_, name);
        }
    }
    for (const auto& [name, times] : of) {
        if (times[0] || times[1]) continue;
        // A picture that could not be written is told, and the summary says so too.
        const bool told = command.name == "run" && tells_of_missing(outcome.output);
        EXPECT_TRUE(told) << name << " is neither as before nor as after\n"
                          << difference(after_, found);
        const Outcome verdict = place_.run({"verify", place_.path("out")});
        EXPECT_EQ(verdict.status, 0) << verdict.output;
    }
}

void FileFaults::expect_harmless(const Command& command, const Fault& fault) {
    const Outcome outcome = place_.run(command.words, watching(fault.order()));
    const std::vector<std::string> report = place_.take_report();
    const std::optional<Operation> hit =
        report.empty() ? std::nullopt : operation_in(report.front());
    if (!hit) return;  // the threads took another turn
    // They may have met a lock instead of what was meant, which by this error is another's.
    if (hit->what == "fcntl" && fault.error == EACCES) return;
    SCOPED_TRACE(fmt::format("{} ({} of {}), status {}, said:\n{}", fault.order(), hit->what,
                             hit->path, outcome.status, outcome.output));
    EXPECT_LT(outcome.status, 3) << "it has not ended by itself";
    EXPECT_EQ(outcome.output.find("terminate called"), std::string::npos);

    const Content left = outcome.status == 0 ? place_.content() : without_waiting(place_.content());
    const Content found = finished_files(left);
    if (!command.resumes) expect_of_one_time(found, outcome, command);
    if (outcome.status != 0) {
        // A full disk is told of the file that is essential, or of all; a list of files that is not
        // whole, of their folder.
        const fs::path file = fault.word.empty() ? shown(hit->path) : place_.work().string();
        const auto says = [&outcome](const std::string& words) {
            return outcome.output.find(words) != std::string::npos;
        };
        EXPECT_TRUE(says(file.string()) || says(file.parent_path().string() + ": "))
            << "the file is not named";
    } else if (!tells_of_missing(outcome.output)) {
        EXPECT_EQ(difference(after_, found), "") << "what is missing is not told";
    }
    if (!hit->removes() && left.size() != found.size()) {
        ADD_FAILURE() << "temporary files are left:\n" << difference(found, left);
    }
    if (left == before_ || left == after_) return;  // known to give what it should
    const Outcome again = place_.run(command.words);
    EXPECT_EQ(again.status, 0) << again.output;
    EXPECT_EQ(difference(after_, place_.content()), "") << "after the same command again";
}

void FileFaults::expect_each_fault_harmless(const Command& command, const std::string& start) {
    before_ = place_.content();
    const Outcome undisturbed = place_.run(command.words, watching("HITOS_FAULT_FILE=0:0"));
    ASSERT_EQ(undisturbed.status, 0) << undisturbed.output;
    ASSERT_FALSE(tells_of_missing(undisturbed.output)) << undisturbed.output;
    after_ = place_.content();
    std::vector<Operation> operations = reported();
    std::erase_if(operations, [](const Operation& operation) {
        return operation.word != "space" && operation.word != "other";
    });
    ASSERT_GT(operations.size(), 10U);
    ASSERT_EQ(place_.run(command.words).status, 0);
    ASSERT_EQ(difference(after_, place_.content()), "") << "it does not give the same twice";
    const std::vector<Fault> faults = faults_of(operations);
    for (const Fault& fault : faults) {
        place_.restore(start);
        expect_harmless(command, fault);
        if (HasFatalFailure()) return;
    }
    std::cout << fmt::format("{}: {} file operations, {} faults\n", command.name, operations.size(),
                             faults.size());
}

TEST_P(FileFaults, LeaveTheOldResultsOrTheNewOnes) {
    const Command command = command_named(GetParam(), place_);
    const Outcome first = place_.run(command.before);
    ASSERT_EQ(first.status, 0) << first.output;
    place_.keep("before");
    expect_each_fault_harmless(command, "before");
}

TEST_P(FileFaults, LeaveNothingOrAllWhereNothingWas) {
    place_.keep("empty");
    expect_each_fault_harmless(command_named(GetParam(), place_), "empty");
}

/// Where there is a folder of others among the results, the files change places one by one.
class FaultsOneByOne : public FileFaults {};

TEST_P(FaultsOneByOne, AreTakenBack) {
    const Command command = command_named(GetParam(), place_);
    ASSERT_EQ(place_.run(command.before).status, 0);
    fs::create_directory(place_.path("out/others"));
    place_.keep("before");
    expect_each_fault_harmless(command, "before");
}

/// That its summary cannot be looked at for once makes nobody else's of what a run has left.
TEST_P(FaultsOneByOne, OfTheFormerSummaryLeaveNoneOfItsFiles) {
    const Command command = command_named(GetParam(), place_);
    ASSERT_EQ(place_.run(command.before).status, 0);
    place_.keep("before");
    Words fewer = command.words;
    std::erase(fewer, "--uncertainty");
    ASSERT_EQ(place_.run(fewer, watching("HITOS_FAULT_FILE=0:0")).status, 0);
    ASSERT_FALSE(fs::exists(place_.path("out/uncertainty.csv")));
    int faults = 0;
    for (const Operation& operation : reported()) {
        if (operation.path != place_.path("out/summary.json")) continue;
        place_.restore("before");
        const Fault fault{operation, EIO, ""};
        const Outcome outcome = place_.run(fewer, watching(fault.order()));
        EXPECT_EQ(fs::exists(place_.path("out/uncertainty.csv")), outcome.status != 0)
            << fault.order() << ' ' << operation.what << ", said:\n"
            << outcome.output;
        ++faults;
    }
    EXPECT_GT(faults, 5);
}

/// That another run's results cannot be looked at for once lets nobody put others in their place.
TEST_P(FaultsOneByOne, OfAnotherRunsResultsDoNotLetThemGo) {
    const Command command = command_named(GetParam(), place_);
    ASSERT_EQ(place_.run(command.before).status, 0);
    place_.keep("before");
    before_ = place_.content();
    Words unasked = command.words;
    ASSERT_EQ(std::erase(unasked, "--replace"), 1U);
    const Outcome refused = place_.run(unasked, watching("HITOS_FAULT_FILE=0:0"));
    ASSERT_EQ(refused.status, 1) << refused.output;
    const std::vector<Operation> operations = reported();
    int faults = 0;
    for (const Operation& operation : operations) {
        if (operation.path.find("/out") == std::string::npos) continue;
        place_.restore("before");
        const Fault fault{operation, faults % 2 == 0 ? EIO : EACCES, ""};
        const Outcome outcome = place_.run(unasked, watching(fault.order()));
        EXPECT_NE(outcome.status, 0)
            << fault.order() << ' ' << operation.what << ' ' << operation.path << ", said:\n"
            << outcome.output;
        EXPECT_EQ(difference(before_, place_.content()), "") << fault.order();
        ++faults;
    }
    EXPECT_GT(faults, 2);
}

/// That the log cannot be looked at for once is told as such, with its name.
TEST_P(FaultsOneByOne, OfTheLogAreToldOfTheLog) {
    const Command command = command_named(GetParam(), place_);
    ASSERT_EQ(place_.run(command.before).status, 0);
    place_.keep("before");
    before_ = place_.content();
    ASSERT_EQ(place_.run(command.words, watching("HITOS_FAULT_FILE=0:0")).status, 0);
    after_ = place_.content();
    int faults = 0;
    for (const Operation& operation : reported()) {
        if (operation.what != "stat" || operation.path != place_.path("tour.log")) continue;
        place_.restore("before");
        expect_harmless(command, {operation, EACCES, ""});
        ++faults;
    }
    EXPECT_GT(faults, 5);
}

class FaultsOfRemoving : public FileFaults {};

/// Of a third study that waits nothing becomes a part of the next one, though it could not be
/// removed at once.
TEST_P(FaultsOfRemoving, LeaveNoneOfAThirdStudysRuns) {
    const Command command = command_named(GetParam(), place_);
    ASSERT_EQ(place_.run(command.before).status, 0);
    Words third = command.words;
    *std::ranges::find(third, "dmax=0.01,0.02") = "dmax=0.04,0.05";
    third.insert(third.end(), {"--shard", "1/2"});
    ASSERT_EQ(place_.run(third).status, 0);
    place_.keep("waiting");
    before_ = place_.content();
    ASSERT_EQ(place_.run(command.words, watching("HITOS_FAULT_FILE=0:0")).status, 0);
    after_ = place_.content();
    int faults = 0;
    for (const Operation& operation : reported()) {
        // What is removed by its name within a folder that goes.
        if (operation.path.find("dmax-0.04") == std::string::npos) continue;
        place_.restore("waiting");
        expect_harmless(command, {operation, EIO, ""});
        ++faults;
    }
    EXPECT_GE(faults, 4) << "record, map, grid and path of a run";
}

INSTANTIATE_TEST_SUITE_P(, FaultsOfRemoving, ::testing::Values("study"),
                         [](const auto& command) { return command.param; });

INSTANTIATE_TEST_SUITE_P(, FaultsOneByOne, ::testing::Values("run"),
                         [](const auto& command) { return command.param; });

INSTANTIATE_TEST_SUITE_P(, FileFaults, ::testing::Values("run", "convert", "simulate", "study"),
                         [](const auto& command) { return command.param; });

}  // namespace
}  // namespace hitos::test
