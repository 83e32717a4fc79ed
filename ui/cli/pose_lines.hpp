// SPDX-License-Identifier: GPL-3.0-or-later
// Lines for whoever reads along: a file, or a pipe whose reader may be late, slow or gone.
#pragma once

#include <filesystem>
#include <string>

namespace hitos::cli {

/// Never waits for a reader: what a pipe does not take yet is kept, up to a limit.
class PoseLines {
  public:
    /// Throws FileError where it cannot be opened.
    explicit PoseLines(std::filesystem::path path);
    ~PoseLines();
    PoseLines(const PoseLines&) = delete;
    PoseLines& operator=(const PoseLines&) = delete;

    void put(const std::string& line);
    /// Why not all of it was written; empty where it was.
    const std::string& problem() const { return problem_; }
    const std::filesystem::path& path() const { return path_; }

  private:
    bool open();

    std::filesystem::path path_;
    int descriptor_ = -1;
    std::string held_;
    std::string problem_;
};

}  // namespace hitos::cli
