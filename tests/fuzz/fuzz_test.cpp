// Thousands of damaged logs with a fixed seed: the reader never fails, and every line is accounted
// for.
#include <gtest/gtest.h>

#include <array>
#include <ostream>
#include <set>

#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

using test::Log;
using test::TempDir;

struct Sample {
    std::string_view format;
    std::vector<std::string> lines;
};

std::ostream& operator<<(std::ostream& out, const Sample& sample) {
    return out << sample.format;
}

std::vector<Sample> samples() {
    return {
        {"player",
         {"0.1 16777343 6665 laser 00 004 001 +0.1 +0.0 0.0 0.1 0.1",
          "0.1 16777343 6665 position2d 00 001 001 +00.000 +00.000 +0.000 +00.1 +00.0 +00.0 0",
          "0.2 16777343 6665 laser 00 001 001 0000 -1.5708 +1.5708 +0.01 +8.0 0002 1.0  1 2.0  1",
          "0.3 16777343 6665 position2d 00 001 001 +00.100 +00.000 +0.010 +00.1 +00.0 +00.0 0",
          "0.4 16777343 6665 laser 00 001 003 0000 +8.0 0003 1.0 -0.5  1 8.0 0.0  0 2.0 0.5  1",
          "0.4 16777343 6665 sonar 00 001 001 4 4 4", "## comment",
          "0.5 16777343 6665 ranger 00 001 001 0003 1.0 2.0 3.0"}},
        {"radish",
         {"position 0 1.0 0.0 0.0 0.0 0.1 0.0 0.0", "laser 0 1.1 1.0 -0.5 0 2.0 0.0 0 81.91 0.5 0",
          "position 0 1.2 0.1 0.0 0.0 0.1 0.0 0.0", "laser 0 1.3 1.5 -0.5 0 2.0 0.1 0 3.0 0.5 0"}},
        {"normalized",
         {"ODOM 1.0 0.5 0.1", "LASER 1.0 3 1 2 0 0 3 4", "ODOM 1.1 0.5 0.1 0.01",
          "LASER 1.1 2 1.5 2.5 nan 4"}},
        {"carmen",
         {"PARAM robot_front_laser_max 20.0 h 0", "ODOM 0 0 0 0 0 0 1.0 h 1.0",
          "FLASER 3 1.0 81.9 2.0 0 0 0 0.1 0 0 1.1 h 1.1",
          "ROBOTLASER1 0 -1.5 3.0 1.5 20.0 0.01 0 3 1 2 3 1 7 0.2 0 0 0.2 0 0 0 0 0 0 0 1.3 h 1.3",
          "RAWLASER1 0 -1.5 3.0 1.5 20.0 0.01 0 3 1 2 3 0 1.3 h 1.3",
          "ODOM 0.2 0 0 0 0 0 1.4 h 1.4"}}};
}

class Mutator {
  public:
    std::string mutate(std::string line) {
        const int times = 1 + below(3);
        for (int i = 0; i < times && !line.empty(); ++i) once(line);
        for (char& c : line) {
            if (c == '\n') c = ' ';
        }
        return line;
    }
    int below(int limit) { return static_cast<int>(engine_() % static_cast<unsigned>(limit)); }

  private:
    void once(std::string& line) {
        static constexpr std::array kWords = {
            "-1",   "0",   "nan",    "-inf",       "1e308", "99999999999999999999", "+-1",
            "x",    "0x7", "1e-320", "4294967296", "-0",    "2147483647",           "#",
            "ODOM", ".",   "1.",     "\r",         "\t"};
        const auto at = static_cast<std::size_t>(below(static_cast<int>(line.size())));
        switch (below(7)) {
            case 0:
                line[at] = static_cast<char>(below(256));
                break;
            case 1:
                line.erase(at, 1);
                break;
            case 2:
                line.insert(at, 1, static_cast<char>(below(256)));
                break;
            case 3:
                line.resize(at);
                break;
            case 4:
                line += line.substr(at);
                break;
            case 5:
                replace_word(
                    line, at,
                    kWords.at(static_cast<std::size_t>(below(static_cast<int>(kWords.size())))));
                break;
            default:
                replace_word(line, at, "");
                break;
        }
    }
    static void replace_word(std::string& line, std::size_t at, const std::string& word) {
        std::size_t begin = line.rfind(' ', at);
        begin = begin == std::string::npos ? 0 : begin + 1;
        std::size_t end = line.find(' ', begin);
        if (end == std::string::npos) end = line.size();
        line.replace(begin, end - begin, word);
    }

    std::mt19937 engine_{20240607};
};

void check_values(const Log& log) {
    for (const Scan& scan : log.scans) {
        ASSERT_TRUE(std::isfinite(scan.time_s));
        for (const Point2& point : scan.points) {
            ASSERT_TRUE(std::isfinite(point.x) && std::isfinite(point.y));
        }
        ASSERT_TRUE(scan.rays.empty() || scan.rays.size() == scan.points.size());
        ASSERT_EQ(scan.points.empty(), scan.run_starts.empty());
        if (!scan.run_starts.empty()) {
            ASSERT_EQ(scan.run_starts.front(), 0U);
        }
        for (std::size_t i = 1; i < scan.run_starts.size(); ++i) {
            ASSERT_LT(scan.run_starts[i - 1], scan.run_starts[i]);
            ASSERT_LT(scan.run_starts[i], scan.points.size());
        }
    }
    for (std::size_t i = 0; i < log.odometry.size(); ++i) {
        const Twist& twist = log.odometry[i].twist;
        ASSERT_TRUE(std::isfinite(twist.v) && std::isfinite(twist.v_lateral) &&
                    std::isfinite(twist.w));
        if (i > 0) {
            ASSERT_GT(log.odometry[i].time_s, log.odometry[i - 1].time_s);
        }
    }
}

class Fuzz : public ::testing::TestWithParam<Sample> {};

TEST_P(Fuzz, OneDamagedLineCostsThatLineAtMost) {
    const Sample& sample = GetParam();
    const TempDir folder;
    std::string good;
    for (const std::string& line : sample.lines) good += line + "\n";
    const Log whole = test::read_log(folder.put("good", good), sample.format);
    ASSERT_GE(whole.scans.size(), 1U);
    Mutator mutator;
    std::uint64_t skipped = 0;
    for (int round = 0; round < 3000; ++round) {
        const auto& lines = sample.lines;
        const std::string bad = mutator.mutate(
            lines[static_cast<std::size_t>(mutator.below(static_cast<int>(lines.size())))]);
        const Log log = test::read_log(folder.put("bad", good + bad + "\n"), sample.format);
        SCOPED_TRACE(bad);
        check_values(log);
        const ReadReport& a = whole.report;
        const ReadReport& b = log.report;
        ASSERT_EQ(b.scans, log.scans.size());
        ASSERT_EQ(b.odometry, log.odometry.size());
        const std::uint64_t more_skipped = b.skipped - a.skipped;
        const std::uint64_t more_scans = b.scans + b.duplicate_scans - a.scans - a.duplicate_scans;
        const std::uint64_t more_odometry = b.odometry - a.odometry;
        ASSERT_LE(more_skipped, 1U);
        ASSERT_LE(more_scans, 1U);
        ASSERT_LE(more_odometry, 1U);
        // Either it is damage, or it gives what it says.
        if (more_skipped == 1) {
            ASSERT_EQ(more_scans + more_odometry, 0U);
        }
        skipped += more_skipped;
    }
    EXPECT_GT(skipped, 500U);
    EXPECT_LT(skipped, 2900U);
}

TEST_P(Fuzz, LogsOfDamagedLinesAreReadToTheirEnd) {
    const Sample& sample = GetParam();
    const TempDir folder;
    Mutator mutator;
    for (int round = 0; round < 300; ++round) {
        std::string text;
        std::uint64_t lines = 0;
        for (int i = 0; i < 60; ++i, ++lines) {
            const std::string& line = sample.lines[static_cast<std::size_t>(
                mutator.below(static_cast<int>(sample.lines.size())))];
            text += (mutator.below(2) == 0 ? mutator.mutate(line) : line) + "\n";
        }
        try {
            const Log log = test::read_log(folder.put("bad", text), sample.format);
            check_values(log);
            // A line is damage, or a scan, or odometry, or both of these.
            std::set<std::uint64_t> useful;
            for (const Scan& scan : log.scans) useful.insert(scan.line);
            for (const Odometria& reading : log.odometry) useful.insert(reading.line);
            ASSERT_LE(useful.size() + log.report.skipped + log.report.duplicate_scans, lines);
            for (const ReadReport::Skip& skip : log.report.examples) {
                ASSERT_FALSE(useful.contains(skip.line))
                    << skip.line << " " << skip.reason.english();
            }
        } catch (const FormatError&) {
            // No line of the format was left.
        }
    }
}

TEST_P(Fuzz, DamagedGzipNeverFails) {
    const Sample& sample = GetParam();
    const TempDir folder;
    std::string text;
    for (int i = 0; i < 50; ++i) {
        for (const std::string& line : sample.lines) text += line + "\n";
    }
    const std::string packed = test::content(folder.put_gz("good", text));
    Mutator mutator;
    for (int round = 0; round < 300; ++round) {
        std::string bad = packed;
        const auto at =
            10 + static_cast<std::size_t>(mutator.below(static_cast<int>(bad.size()) - 10));
        if (round % 2 == 0) {
            bad.resize(at);
        } else {
            bad[at] = static_cast<char>(mutator.below(256));
        }
        try {
            check_values(test::read_log(folder.put("bad", bad), sample.format));
        } catch (const FormatError&) {
            // Nothing could be unpacked.
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, Fuzz, ::testing::ValuesIn(samples()),
                         [](const auto& value) { return std::string(value.param.format); });

}  // namespace
}  // namespace hitos
