// SPDX-License-Identifier: GPL-3.0-or-later
// What tests of recordings write and read.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "recordings/recording.hpp"
#include "unit/capture/ros_writers.hpp"

namespace hitos::test {

struct Read {
    std::vector<Said> all;
    std::vector<std::uint64_t> numbers;
    std::vector<std::string> problems;
};

using Open = std::unique_ptr<Recording>(const std::filesystem::path&, RecordingUse);

inline Read read(Open* open, const std::filesystem::path& path,
                 const std::string& unwanted = "none") {
    Read result;
    Topics topics([&](const Topic& topic) { return topic.name != unwanted; });
    const auto recording = open(path, {topics, true});
    while (const auto found = recording->next()) {
        result.all.push_back({found->topic->name, found->topic->type, std::string(found->bytes),
                              static_cast<std::uint64_t>(found->log_time_ns)});
        result.numbers.push_back(found->number);
        EXPECT_GE(recording->progress(), 0.0);
        EXPECT_LE(recording->progress(), 1.0);
    }
    while (const auto problem = recording->take_problem()) {
        result.problems.push_back(problem->reason.english());
    }
    return result;
}

/// Messages of every length, an empty one among them.
inline std::vector<Said> messages() {
    std::vector<Said> all;
    for (std::uint64_t i = 0; i < 10; ++i) {
        all.push_back({i % 3 == 0 ? "/a" : "/b", i % 3 == 0 ? "x_msgs/A" : "x_msgs/B",
                       std::string(i * 700, static_cast<char>('a' + i)), 5'000'000'000 + i});
    }
    return all;
}

inline void expect_first(const std::vector<Said>& found, std::size_t count) {
    const std::vector<Said> all = messages();
    ASSERT_EQ(found.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
        EXPECT_EQ(found[i].topic, all[i].topic);
        EXPECT_EQ(found[i].type, all[i].type);
        EXPECT_EQ(found[i].bytes, all[i].bytes);
        EXPECT_EQ(found[i].log_time_ns, all[i].log_time_ns);
    }
}

inline std::vector<Said> many_messages(std::size_t count) {
    std::vector<Said> all;
    for (std::size_t i = 0; i < count; ++i) {
        all.push_back({i % 3 == 0 ? "/a" : "/b", i % 3 == 0 ? "x_msgs/A" : "x_msgs/B",
                       std::string(i % 7 * 150, static_cast<char>('a' + i % 26)), i});
    }
    return all;
}

/// Whether these are the first of them, each whole.
inline bool are_first(const std::vector<Said>& found, const std::vector<Said>& all) {
    const auto same = [](const Said& a, const Said& b) {
        return a.topic == b.topic && a.bytes == b.bytes && a.log_time_ns == b.log_time_ns;
    };
    return found.size() <= all.size() && std::equal(found.begin(), found.end(), all.begin(), same);
}

}  // namespace hitos::test
