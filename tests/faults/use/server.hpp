// SPDX-License-Identifier: GPL-3.0-or-later
// A program that is loaded once and runs as often as it is asked, each time in a child of its own.
#pragma once

#include <sys/types.h>

#include <filesystem>

#include "../workplace.hpp"

namespace hitos::test {

class Server {
  public:
    /// `folder`: where it works, and whose operations the library of faults counts.
    Server(const std::filesystem::path& program, std::filesystem::path folder);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    /// Begins `arguments` in `folder`, with variables NAME=VALUE on top of this process's.
    void begin(const Words& arguments, const Words& variables = {});
    Outcome end();
    Outcome run(const Words& arguments, const Words& variables = {});

    /// What the library of faults has reported since the last begin().
    std::vector<std::string> report() const;

  private:
    std::filesystem::path folder_;
    TempFolder own_;
    int requests_ = -1;
    int replies_ = -1;
    pid_t process_ = 0;
};

}  // namespace hitos::test
