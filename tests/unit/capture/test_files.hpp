// SPDX-License-Identifier: GPL-3.0-or-later
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

#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/procesador.hpp"
#include "support.hpp"

namespace hitos::test {

/// A folder that also takes compressed files.
class TempDir : public TempFolder {
  public:
    std::filesystem::path put_gz(const std::string& name, std::string_view text) const {
        gzFile file = ::gzopen((path() / name).c_str(), "wb");
        ::gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
        ::gzclose(file);
        return path() / name;
    }
};

/// What a compressed file unpacks to.
inline std::string unpacked_content(const std::filesystem::path& path) {
    std::string content;
    std::string block(1 << 16, '\0');
    gzFile file = ::gzopen(path.c_str(), "rb");
    for (int got = 1; got > 0;) {
        got = ::gzread(file, block.data(), static_cast<unsigned>(block.size()));
        if (got > 0) content.append(block, 0, static_cast<std::size_t>(got));
    }
    ::gzclose(file);
    return content;
}

/// A log that comes with Hitos.
inline std::string shipped_log(const std::string& name) {
    return unpacked_content(std::filesystem::path(HITOS_SOURCE_DIR) / "data/logs" / name);
}

/// Everything that a log gives.
struct Log {
    std::vector<Scan> scans;
    std::vector<Odometria> odometry;
    ReadReport report;
    std::vector<TourFinding> findings = {};
};

inline Log read_all(TourReader& reader) {
    Log log;
    while (std::optional<Scan> scan = reader.next_scan()) log.scans.push_back(std::move(*scan));
    while (const std::optional<Odometria> reading = reader.next_odometry()) {
        log.odometry.push_back(*reading);
    }
    log.report = reader.report();
    log.findings = reader.findings();
    return log;
}

inline Log read_log(const std::filesystem::path& path, std::string_view format = kAutoFormat,
                    const ReadOptions& options = {}) {
    Procesador procesador(open_log(path, format, options), options);
    return read_all(procesador);
}

inline Log read_text(std::string_view format, std::string_view text,
                     const ReadOptions& options = {}) {
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

/// A log of the shared folder.
inline std::filesystem::path shared_log(const std::string& name) {
    return std::filesystem::path(HITOS_SHARED_DIR) / "data" / name;
}

}  // namespace hitos::test

#define HITOS_SKIP_WITHOUT(path)                                                         \
    if (!std::filesystem::exists(path)) {                                                \
        GTEST_SKIP() << (path) << " is absent: a recorded log that is no part of Hitos"; \
    }
