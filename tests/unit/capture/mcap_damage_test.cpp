// SPDX-License-Identifier: GPL-3.0-or-later
// A record of an MCAP whose length is damaged costs itself, and is told.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "hitos/capture/file_growth.hpp"
#include "unit/capture/recorded_messages.hpp"
#include "unit/capture/ros_packings.hpp"
#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

using test::many_messages;
using test::Read;
using test::Said;
using test::TempDir;
using testing::HasSubstr;

constexpr std::size_t kRecordHead = 9;
constexpr std::size_t kMessages = 40;

std::uint64_t length_at(const std::string& file, std::size_t record) {
    std::uint64_t length = 0;
    std::memcpy(&length, file.data() + record + 1, sizeof length);
    return length;
}

/// Where the records of the kind are, outside of chunks.
std::vector<std::size_t> records(const std::string& file, char kind) {
    std::vector<std::size_t> places;
    for (std::size_t at = test::kMcapMagic.size(); at + kRecordHead < file.size();
         at += kRecordHead + length_at(file, at)) {
        if (file[at] == kind) places.push_back(at);
    }
    return places;
}

std::string with_length(std::string file, std::size_t record, std::uint64_t length) {
    std::memcpy(file.data() + record + 1, &length, sizeof length);
    return file;
}

/// Lengths that no record has: short, long, to the end or beyond.
std::vector<std::uint64_t> wrong_lengths(const std::string& file, std::size_t record) {
    const std::uint64_t right = length_at(file, record);
    const std::uint64_t left = file.size() - record - kRecordHead;
    std::vector<std::uint64_t> lengths{0,          5,          right - 1, right + 1,   right + 503,
                                       left - 9,   left - 8,   left,      left + 1,    800'000'000,
                                       1ULL << 31, 1ULL << 40, ~0ULL,     ~0ULL - 5000};
    std::erase_if(lengths, [&](std::uint64_t length) { return length == right; });
    return lengths;
}

/// All but that one: what comes for it may be cut or too long.
void expect_the_others(const Read& found, std::size_t damaged, const std::string& where) {
    const std::vector<Said> all = many_messages(kMessages);
    EXPECT_FALSE(found.problems.empty()) << where;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i == damaged) continue;
        const auto same = [&](const Said& one) {
            return one.log_time_ns == all[i].log_time_ns && one.bytes == all[i].bytes;
        };
        EXPECT_EQ(std::ranges::count_if(found.all, same), 1) << where << ", message " << i;
    }
}

TEST(McapDamage, OfAMessagesLengthCostsThatMessage) {
    const TempDir folder;
    const std::string whole = test::mcap_of(many_messages(kMessages));
    const std::vector<std::size_t> messages = records(whole, 5);
    ASSERT_EQ(messages.size(), kMessages);
    for (const std::size_t damaged : {4U, 20U, 35U}) {
        for (const std::uint64_t length : wrong_lengths(whole, messages[damaged])) {
            const auto file = folder.put("a", with_length(whole, messages[damaged], length));
            expect_the_others(test::read(open_mcap, file), damaged, std::to_string(length));
        }
    }
}

TEST(McapDamage, OfAChunksLengthCostsThatChunk) {
    const TempDir folder;
    for (const test::Packing& packing :
         {test::Packing{"", test::unpacked}, test::Packing{"zstd", test::packed_zstd}}) {
        const std::string whole =
            test::mcap_of(many_messages(kMessages), {.packing = packing, .in_chunk = 2});
        const std::vector<std::size_t> chunks = records(whole, 6);
        ASSERT_EQ(chunks.size(), kMessages / 2);
        for (const std::uint64_t length : wrong_lengths(whole, chunks[7])) {
            const auto file = folder.put("a", with_length(whole, chunks[7], length));
            const Read found = test::read(open_mcap, file);
            EXPECT_FALSE(found.problems.empty()) << length;
            EXPECT_GE(found.all.size(), kMessages - 2) << packing.name << length;
            EXPECT_LE(found.all.size(), kMessages) << packing.name << length;
            EXPECT_EQ(found.all.back().log_time_ns, kMessages - 1) << length;
        }
    }
}

/// It is not waited for until the tour is over.
TEST(McapDamage, IsFoundInAFileThatGrows) {
    const TempDir folder;
    const std::string whole = test::mcap_of(many_messages(kMessages));
    const std::vector<std::size_t> messages = records(whole, 5);
    constexpr std::size_t kDamaged = 20;
    std::vector<std::uint64_t> lengths = wrong_lengths(whole, messages[kDamaged]);
    const std::uint64_t left = whole.size() - messages[kDamaged] - kRecordHead;
    // These end where the file does, and until then nobody can tell.
    std::erase_if(lengths, [&](auto one) { return one >= left - 9 && one <= left; });
    for (const std::uint64_t length : lengths) {
        const std::string where = std::to_string(length);
        const std::string file = with_length(whole, messages[kDamaged], length);
        // Nor does it come to its end while it is read.
        const std::string open = file.substr(0, messages.back());
        const auto path = folder.put("growing", open.substr(0, messages[10]));
        Topics topics([](const Topic&) { return true; });
        const auto growth = std::make_shared<FileGrowth>(path);
        const auto recording = open_mcap(path, {topics, true, {.growth = growth}});
        std::jthread writer([&] {
            for (std::size_t at = messages[10]; at < open.size(); at += 777)
                std::ofstream(path, std::ios::binary | std::ios::app) << open.substr(at, 777);
        });
        Read found;
        // The last one but two: a chain is seen to stand where three records do.
        while (found.all.empty() || found.all.back().log_time_ns < kMessages - 4) {
            const auto one = recording->next();
            ASSERT_TRUE(one) << where;
            found.all.push_back({one->topic->name, one->topic->type, std::string(one->bytes),
                                 static_cast<std::uint64_t>(one->log_time_ns)});
        }
        writer.join();
        growth->end();
        while (const auto one = recording->next()) {
            found.all.push_back({one->topic->name, one->topic->type, std::string(one->bytes),
                                 static_cast<std::uint64_t>(one->log_time_ns)});
        }
        while (const auto problem = recording->take_problem())
            found.problems.push_back(problem->reason.english());
        found.all.push_back(many_messages(kMessages).back());
        expect_the_others(found, kDamaged, where);
        EXPECT_THAT(found.problems, testing::Contains(HasSubstr("reading goes on at byte")))
            << where;
    }
}

}  // namespace
}  // namespace hitos
