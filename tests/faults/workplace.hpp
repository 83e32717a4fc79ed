// SPDX-License-Identifier: GPL-3.0-or-later
// A folder in which programs are started that fail or are killed, and what they leave there.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "support.hpp"

namespace hitos::test {

/// Every file's bytes by its path in the folder, without the figures of time; folders have a slash
/// at their end and no bytes.
using Content = std::map<std::string, std::string>;

using Words = std::vector<std::string>;

/// A program that has been started.
class Process {
  public:
    /// `words`: its path, then its arguments. What it says goes into a file.
    Process(const Words& words, const Words& environment, std::filesystem::path said);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    void kill() const;
    /// Waits for its end.
    Outcome ended();

  private:
    pid_t process_ = 0;
    std::filesystem::path said_;
};

/// `work()` holds what the programs read and write; what watches over them lies beside it. A
/// gnuplot that only says what it would draw stands before the real one, which takes too long.
class Workplace {
  public:
    Workplace();

    std::filesystem::path work() const { return folder_ / "work"; }
    std::string path(std::string_view name) const { return (work() / name).string(); }
    /// hitos-cli with these arguments, `environment` on top of this process's.
    Outcome run(const Words& arguments, const Words& environment = {}) const;
    /// The same, not waited for.
    std::unique_ptr<Process> start(const Words& arguments, const Words& environment = {}) const;

    Content content() const;
    /// Remembers what work() holds, under a name.
    void keep(const std::string& name) const;
    void restore(const std::string& name) const;

    /// What the library of faults reports, line by line; then it is forgotten.
    std::vector<std::string> take_report() const;
    std::string report_file() const { return (folder_ / "report").string(); }
    /// The folder with the gnuplot that stands before the real one.
    std::string programs() const { return (folder_ / "bin").string(); }

  private:
    TempFolder folder_;
};

/// Without what is left of the time that a run took.
std::string without_times(const std::filesystem::path& file, const std::string& text);

/// Whether a command that ended well said that pictures or plots are missing.
bool tells_of_missing(const std::string& output);

/// Whether the name is one of those that a program gives to what is not done yet.
bool is_temporary(const std::string& path);

/// Without temporary files.
Content finished_files(Content content);
/// Without the runs of a study that wait for its end, beside another one's results.
Content without_waiting(Content content);

/// The names whose bytes differ, for people.
std::string difference(const Content& a, const Content& b);

}  // namespace hitos::test
