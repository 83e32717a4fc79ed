// SPDX-License-Identifier: GPL-3.0-or-later
// What holds messages: bags, MCAP, SQLite files and folders.
#include "recordings/recording.hpp"

#include <gmock/gmock.h>
#include <zlib.h>

#include "hitos/base/error.hpp"
#include "support.hpp"
#include "unit/capture/recorded_messages.hpp"
#include "unit/capture/ros_packings.hpp"

namespace hitos {
namespace {

using test::expect_first;
using test::messages;
using test::Open;
using test::Read;
using test::read;
using test::Said;
using test::TempFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct ContainerKind {
    const char* name;
    Open* open;
    std::string (*write)();
};

template <std::string (*Pack)(const std::string&)>
std::string bag_packed() {
    const bool bz2 = Pack == test::packed_bz2;
    return test::bag_of(messages(), {bz2                        ? "bz2"
                                     : Pack == test::packed_lz4 ? "lz4"
                                                                : "none",
                                     Pack});
}

template <std::string (*Pack)(const std::string&)>
std::string mcap_packed() {
    test::McapLayout layout;
    layout.packing = {Pack == test::packed_zstd  ? "zstd"
                      : Pack == test::packed_lz4 ? "lz4"
                                                 : "",
                      Pack};
    return test::mcap_of(messages(), layout);
}

std::string mcap_plain() {
    return test::mcap_of(messages());
}

class EveryContainer : public ::testing::TestWithParam<ContainerKind> {
  protected:
    TempFolder folder_;
};

TEST_P(EveryContainer, GivesAllMessages) {
    const auto path = folder_.put("a", GetParam().write());
    const Read all = read(GetParam().open, path);
    expect_first(all.all, messages().size());
    EXPECT_THAT(all.problems, IsEmpty());
    EXPECT_EQ(all.numbers.back(), 10U);
    // What is not wanted is counted.
    const Read some = read(GetParam().open, path, "/b");
    EXPECT_THAT(some.numbers, ElementsAre(1, 4, 7, 10));
}

// The good part and one problem, wherever it ends.
TEST_P(EveryContainer, GivesWhatIsThereWhereItIsCutOff) {
    const std::string whole = GetParam().write();
    const std::size_t step = std::max<std::size_t>(1, whole.size() / 400);
    std::size_t most = 0;
    for (std::size_t size = 13; size < whole.size(); size += step) {
        const Read part = read(GetParam().open, folder_.put("a", whole.substr(0, size)));
        EXPECT_GE(part.all.size(), most) << size;
        most = part.all.size();
        expect_first(part.all, most);
        // Between two records of a bag's index nothing is missed.
        if (most == messages().size() && part.problems.empty()) continue;
        ASSERT_EQ(part.problems.size(), 1U) << size;
        EXPECT_THAT(part.problems.front(), HasSubstr("byte")) << size;
    }
    EXPECT_EQ(most, messages().size());
}

TEST_P(EveryContainer, EndsWhateverIsChanged) {
    const std::string whole = GetParam().write();
    for (std::size_t place = 13; place < whole.size(); place += 1 + whole.size() / 300) {
        for (const char byte : {'\0', '\x7f', '\xff'}) {
            std::string bad = whole;
            bad[place] = byte;
            EXPECT_LE(read(GetParam().open, folder_.put("a", bad)).all.size(), 40U);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Containers, EveryContainer,
    testing::Values(ContainerKind{"bag", open_bag, bag_packed<test::unpacked>},
                    ContainerKind{"bag_bz2", open_bag, bag_packed<test::packed_bz2>},
                    ContainerKind{"bag_lz4", open_bag, bag_packed<test::packed_lz4>},
                    ContainerKind{"mcap", open_mcap, mcap_plain},
                    ContainerKind{"mcap_chunks", open_mcap, mcap_packed<test::unpacked>},
                    ContainerKind{"mcap_zstd", open_mcap, mcap_packed<test::packed_zstd>},
                    ContainerKind{"mcap_lz4", open_mcap, mcap_packed<test::packed_lz4>}),
    [](const auto& value) { return value.param.name; });

TEST(Recordings, AreKnownByTheirFirstBytes) {
    EXPECT_TRUE(begins_bag("#ROSBAG V2.0\n"));
    EXPECT_TRUE(begins_bag("#ROSBAG V1.2\n"));
    EXPECT_TRUE(begins_mcap(std::string(test::kMcapMagic) + "..."));
    EXPECT_FALSE(begins_mcap("\x89PNG\r\n\x1a\n"));
    EXPECT_TRUE(begins_db3({"SQLite format 3\0", 16}));
    EXPECT_FALSE(begins_db3("SQLite format 3"));
}

TEST(Recordings, AnOlderBagIsRefusedWithWhatToDo) {
    const TempFolder folder;
    EXPECT_THAT(test::message_of<FormatError>(
                    [&] { read(open_bag, folder.put("a", "#ROSBAG V1.2\nxyz")); }),
                AllOf(HasSubstr("#ROSBAG V1.2"), HasSubstr("rosbag fix")));
}

// Lengths that no file has ask for no memory.
TEST(Recordings, HoldLengthsAgainstWhatIsLeft) {
    const TempFolder folder;
    const std::string magic(test::kMcapMagic);
    const auto problem_of = [&](const std::string& bytes, Open* open) {
        const Read found = read(open, folder.put("a", bytes));
        EXPECT_THAT(found.all, IsEmpty());
        return found.problems.empty() ? "" : found.problems.front();
    };
    using test::Bytes;
    EXPECT_THAT(problem_of(magic + Bytes().u8(5).u64(~0ULL).text(), open_mcap),
                AllOf(HasSubstr("at byte 8"), HasSubstr("found a length of 18446744073709551615")));
    EXPECT_THAT(problem_of(magic + test::mcap_record(3, Bytes().u16(1).u32(~0U).text()), open_mcap),
                HasSubstr("found a length of 4294967295 bytes, expected at most 0"));
    const std::string chunk =
        Bytes().u64(0).u64(0).u64(1ULL << 40).u32(0).word("zstd").u64(0).text();
    EXPECT_THAT(problem_of(magic + test::mcap_record(6, chunk) + magic, open_mcap),
                HasSubstr("found a chunk of 1099511627776 bytes once unpacked"));
    const std::string unknown = Bytes().u64(0).u64(0).u64(10).u32(0).word("xz").u64(0).text();
    EXPECT_THAT(problem_of(magic + test::mcap_record(6, unknown) + magic, open_mcap),
                HasSubstr("compression \"xz\", expected none, bz2, lz4 or zstd"));
    EXPECT_THAT(problem_of("#ROSBAG V2.0\n" + Bytes().u32(~0U).text(), open_bag),
                AllOf(HasSubstr("at byte 13"), HasSubstr("4294967295")));
    EXPECT_THAT(problem_of("#ROSBAG V2.0\n" + test::bag_record({{"op", "\x02"}}, ""), open_bag),
                HasSubstr("without the field \"conn\""));
}

TEST(Mcap, ChannelZeroAndMessagesOfNoSchemaAreReadAndUnknownOnesTold) {
    const TempFolder folder;
    std::vector<Said> all = messages();
    all.push_back({"/events", "", "{}", 1});
    const Read found = read(open_mcap, folder.put("a", test::mcap_of(all)));
    EXPECT_EQ(found.all.size(), all.size());
    EXPECT_EQ(found.all.back().type, "");

    std::string stranger(test::kMcapMagic);
    stranger += test::mcap_record(5, test::Bytes().u16(9).u32(0).u64(0).u64(0).text());
    const Read none = read(open_mcap, folder.put("b", stranger.append(test::kMcapMagic)));
    EXPECT_THAT(none.problems, ElementsAre(HasSubstr("the channel 9, which nothing describes")));
}

// What is wrong with a record outside of chunks costs that record.
TEST(Mcap, GoesOnBehindADamagedRecord) {
    const TempFolder folder;
    const std::string whole = test::mcap_of(messages());
    const std::string bad = test::mcap_record(5, "short") +            // a message without a head
                            test::mcap_record(4, std::string(9, 'x'))  // a channel
                            + test::mcap_record(6, std::string(30, '\xff'));  // a chunk
    const std::size_t behind_header = whole.find('\x03', test::kMcapMagic.size() + 9);
    std::string file = whole;
    file.insert(behind_header, bad);
    const Read found = read(open_mcap, folder.put("a", file));
    expect_first(found.all, messages().size());
    EXPECT_EQ(found.problems.size(), 3U);
    for (const std::string& problem : found.problems) {
        EXPECT_THAT(problem, HasSubstr("at byte"));
    }
    // Of zeros nobody knows where they end.
    file = whole;
    file.insert(behind_header, std::string(9000, '\0'));
    EXPECT_THAT(read(open_mcap, folder.put("a", file)).problems,
                ElementsAre(HasSubstr("the unknown kind 0")));
}

// Reports are held for people: what goes beyond them is counted all the same.
TEST(Mcap, CountsEveryProblem) {
    const TempFolder folder;
    std::string file(test::kMcapMagic);
    for (int i = 0; i < 1000; ++i) file += test::mcap_record(5, "short");
    file += test::kMcapMagic;
    EXPECT_EQ(read(open_mcap, folder.put("a", file)).problems.size(), 1000U);
}

TEST(Mcap, AChunkThatHasLessThanItSaysIsTold) {
    const TempFolder folder;
    for (const bool packed : {true, false}) {
        std::string file =
            packed ? mcap_packed<test::packed_zstd>() : mcap_packed<test::unpacked>();
        // Its size stands behind the record's head and two times.
        const std::size_t chunk = file.find('\x06', test::kMcapMagic.size() + 9 + 17);
        file[chunk + 9 + 16] = static_cast<char>(file[chunk + 9 + 16] + 1);
        const Read found = read(open_mcap, folder.put("a", file));
        expect_first(found.all, messages().size());
        EXPECT_THAT(found.problems, ElementsAre(HasSubstr("the data end early")));
    }
}

TEST(Mcap, AnotherVersionIsToldAsSuch) {
    const TempFolder folder;
    const auto file = folder.put("a", "\x89MCAP1\r\n and more");
    EXPECT_TRUE(begins_mcap("\x89MCAP1\r\n"));
    EXPECT_THAT(test::message_of<FormatError>([&] { read(open_mcap, file); }),
                HasSubstr("is MCAP of the version \"1\", expected version 0"));
}

TEST(Mcap, ChecksumsAreCompared) {
    const TempFolder folder;
    test::McapLayout layout;
    layout.packing = {"zstd", test::packed_zstd};
    layout.in_chunk = 100;
    layout.checksum = 1;
    const Read wrong = read(open_mcap, folder.put("a", test::mcap_of(messages(), layout)));
    EXPECT_EQ(wrong.all.size(), 10U);
    EXPECT_THAT(wrong.problems, ElementsAre(HasSubstr("checksum")));
    static uLong sum = 0;
    layout.packing.pack = [](const std::string& content) {
        sum = ::crc32_z(0, reinterpret_cast<const Bytef*>(content.data()), content.size());
        return test::packed_zstd(content);
    };
    test::mcap_of(messages(), layout);
    layout.checksum = static_cast<std::uint32_t>(sum);
    EXPECT_THAT(read(open_mcap, folder.put("a", test::mcap_of(messages(), layout))).problems,
                IsEmpty());
}

template <std::string (*Pack)(const std::string&)>
std::string packed_in_two_frames(const std::string& content) {
    const std::size_t half = content.size() / 2;
    return Pack(content.substr(0, half)) + Pack(content.substr(half));
}

// Compressors that take their data in portions write a frame for each.
TEST(Mcap, AChunkMayBeOfSeveralFrames) {
    const TempFolder folder;
    test::McapLayout layout;
    layout.in_chunk = 100;
    for (const bool zstd : {false, true}) {
        layout.packing.name = zstd ? "zstd" : "lz4";
        layout.packing.pack = zstd ? &packed_in_two_frames<test::packed_zstd>
                                   : &packed_in_two_frames<test::packed_lz4>;
        const Read found = read(open_mcap, folder.put("a", test::mcap_of(messages(), layout)));
        EXPECT_EQ(found.all.size(), messages().size()) << zstd;
        EXPECT_THAT(found.problems, IsEmpty()) << zstd;
    }
}

// One damaged chunk costs its own messages.
TEST(Mcap, GoesOnBehindADamagedChunk) {
    const TempFolder folder;
    std::string file = mcap_packed<test::packed_zstd>();
    // The chunks follow each other; the second begins behind the first one's zstd magic.
    const std::string magic = "\x28\xb5\x2f\xfd";
    const std::size_t second = file.find(magic, file.find(magic) + 1);
    file.replace(second, 8, "xxxxxxxx");
    const Read found = read(open_mcap, folder.put("a", file));
    EXPECT_THAT(found.numbers, ElementsAre(1, 2, 3, 4, 6, 7));  // 5 is the damage
    EXPECT_EQ(found.all.back().bytes, messages().back().bytes);
    EXPECT_THAT(found.problems, ElementsAre(HasSubstr("the compressed data are damaged")));
}

}  // namespace
}  // namespace hitos
