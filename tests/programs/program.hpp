// SPDX-License-Identifier: GPL-3.0-or-later
// Starts the programs as a user does and looks at what they leave.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "support.hpp"

namespace hitos::test {

namespace fs = std::filesystem;

inline const std::string kSource = HITOS_SOURCE_DIR;
inline const std::string kBin = HITOS_BIN_DIR;

/// Runs a line of shell. A program that is asked to stop has the time that a loaded machine takes.
inline Outcome shell(const std::string& line) {
    return run_command(": ${HITOS_STOP_SECONDS:=60}; export HITOS_STOP_SECONDS; { " + line + "\n}");
}

/// A new empty folder for each test.
class ProgramTest : public ::testing::Test {
  protected:
    std::string path(std::string_view name) const { return (folder_ / name).string(); }
    std::string file(std::string_view name, std::string_view text) const {
        return folder_.put(name, text).string();
    }

    /// Every file's content but for the times, by its name in the folder.
    std::map<std::string, std::string> files(std::string_view name) const {
        std::map<std::string, std::string> files;
        for (const auto& entry : fs::recursive_directory_iterator(folder_ / name)) {
            const std::string file = fs::relative(entry.path(), folder_ / name).string();
            const bool times = file.find("timing.csv") != std::string::npos ||
                               file.find("runs/") != std::string::npos;
            if (entry.is_regular_file() && !times) files[file] = content(entry.path());
        }
        return files;
    }

    TempFolder folder_;
    const std::string cli_ = kBin + "/hitos-cli";
    const std::string batch_ = kBin + "/BatchSLAM";
    const std::string log_ = kSource + "/data/bigloop.log.gz";
    const std::string map_ = kSource + "/data/maps/bigloop.map";
    const std::string config_ = kSource + "/config/thesis.cfg";
};

}  // namespace hitos::test
