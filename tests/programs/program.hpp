// Starts the programs as a user does and looks at what they leave.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <string_view>

namespace hitos::testing {

namespace fs = std::filesystem;

inline const std::string kSource = HITOS_SOURCE_DIR;
inline const std::string kBin = HITOS_BIN_DIR;

struct Result {
    int status = -1;
    std::string said;  ///< stdout and stderr
};

/// Runs a line of shell.
inline Result shell(const std::string& line) {
    Result result;
    FILE* pipe = ::popen(("{ " + line + "\n} 2>&1").c_str(), "r");
    if (pipe == nullptr) return result;
    std::array<char, 4096> buffer{};
    while (std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
        result.said.append(buffer.data(), n);
    const int status = ::pclose(pipe);
    result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return result;
}

inline std::string content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// A new empty folder for each test.
class ProgramTest : public ::testing::Test {
  protected:
    ProgramTest() {
        static std::atomic<int> count{0};
        folder_ = fs::temp_directory_path() /
                  ("hitos-programs-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
        fs::create_directories(folder_);
    }
    ~ProgramTest() override {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

    std::string path(std::string_view name) const { return (folder_ / name).string(); }
    std::string file(std::string_view name, std::string_view text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
        return path(name);
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

    fs::path folder_;
    const std::string cli_ = kBin + "/hitos-cli";
    const std::string batch_ = kBin + "/BatchSLAM";
    const std::string log_ = kSource + "/data/bigloop.log.gz";
    const std::string map_ = kSource + "/data/maps/bigloop.map";
    const std::string config_ = kSource + "/config/simulated.cfg";
};

}  // namespace hitos::testing
