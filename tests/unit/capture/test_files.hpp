// Files for tests: a folder that goes away by itself, plain and gzip writers, whole-log readers.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hitos/capture/archivo.hpp"
#include "hitos/capture/error.hpp"
#include "hitos/capture/procesador.hpp"

namespace hitos::test {

class TempDir {
  public:
    TempDir() {
        std::string pattern = (std::filesystem::temp_directory_path() / "hitos-XXXXXX").string();
        if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
        path_ = pattern;
    }
    ~TempDir() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TempDir(const TempDir&) = delete;
    TempDir& operator=(const TempDir&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }
    std::size_t files() const {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_),
                                                      std::filesystem::directory_iterator{}));
    }
    /// Writes the text and returns its path.
    std::filesystem::path put(const std::string& name, std::string_view text) const {
        std::ofstream(path_ / name, std::ios::binary)
            .write(text.data(), static_cast<std::streamsize>(text.size()));
        return path_ / name;
    }
    std::filesystem::path put_gz(const std::string& name, std::string_view text) const {
        const gzFile file = ::gzopen((path_ / name).c_str(), "wb");
        ::gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
        ::gzclose(file);
        return path_ / name;
    }

  private:
    std::filesystem::path path_;
};

inline std::string content_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Everything that a log gives.
struct Log {
    std::vector<Scan> scans;
    std::vector<Odometria> odometry;
    ReadReport report;
};

inline Log read_all(Procesador& procesador) {
    Log log;
    while (std::optional<Scan> scan = procesador.next_scan()) log.scans.push_back(std::move(*scan));
    while (const std::optional<Odometria> reading = procesador.next_odometry()) {
        log.odometry.push_back(*reading);
    }
    log.report = procesador.report();
    return log;
}

inline Log read_log(const std::filesystem::path& path, LogFormat format = LogFormat::automatic,
                    ReadOptions options = {}) {
    Procesador procesador(open_log(path, format), options);
    return read_all(procesador);
}

inline Log read_text(LogFormat format, std::string_view text, ReadOptions options = {}) {
    const TempDir folder;
    return read_log(folder.put("some.log", text), format, options);
}

/// The pose after each reading, from (0, 0, 0) on.
inline std::vector<Pose> summed(const std::vector<Odometria>& odometry, Pose pose = {}) {
    std::vector<Pose> poses;
    double clock_s = odometry.empty() ? 0.0 : odometry.front().time_s;
    for (const Odometria& reading : odometry) {
        pose = compose(pose, displacement(reading.twist, reading.time_s - clock_s));
        clock_s = reading.time_s;
        poses.push_back(pose);
    }
    return poses;
}

inline void expect_near(const Pose& a, const Pose& b, double tolerance,
                        const std::string& where = "") {
    EXPECT_NEAR(a.x, b.x, tolerance) << where;
    EXPECT_NEAR(a.y, b.y, tolerance) << where;
    EXPECT_NEAR(wrap_angle(a.theta - b.theta), 0.0, tolerance) << where;
}

inline void expect_near(const Point2& a, const Point2& b, double tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
}

/// The message of the error that the call throws; empty where it throws none of that type.
template <typename ErrorType, typename Call>
std::string message_of(Call&& call) {
    try {
        std::forward<Call>(call)();
    } catch (const ErrorType& error) {
        return error.what();
    }
    return {};
}

/// A log of the shared folder.
inline std::filesystem::path shared_log(const std::string& name) {
    return std::filesystem::path(HITOS_SHARED_DIR) / "data" / name;
}

}  // namespace hitos::test

#define HITOS_SKIP_WITHOUT(path)                                                         \
    if (!std::filesystem::exists(path)) {                                                \
        GTEST_SKIP() << (path) << " is absent: a recorded log that is no part of Hitos"; \
    }
