// SPDX-License-Identifier: GPL-3.0-or-later
// Tours that are read while they come in.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <thread>

#include "hitos/capture/file_growth.hpp"
#include "hitos/capture/live_source.hpp"
#include "live/received_file.hpp"
#include "live/received_mcap.hpp"
#include "regular_file.hpp"
#include "unit/capture/recorded_messages.hpp"
#include "unit/capture/ros_packings.hpp"
#include "unit/capture/ros_tours.hpp"
#include "unit/capture/test_files.hpp"

namespace hitos {
namespace {

using test::Bytes;
using test::Log;
using test::TempDir;

/// Appends pieces of random sizes as long as there is something.
void write_in_pieces(const std::filesystem::path& path, std::string_view content, std::size_t most,
                     unsigned seed) {
    std::mt19937 random(seed);
    while (!content.empty()) {
        const std::size_t count = std::min<std::size_t>(content.size(), 1 + random() % most);
        std::ofstream(path, std::ios::binary | std::ios::app) << content.substr(0, count);
        content.remove_prefix(count);
    }
}

/// Grows to its end while it is read.
Log read_growing(const TempDir& folder, std::string_view content, std::uint64_t opening,
                 std::size_t most, unsigned seed) {
    const std::filesystem::path path = folder.put("growing", content.substr(0, opening));
    ReadOptions options;
    options.opening_bytes = opening;
    options.growth = std::make_shared<FileGrowth>(path);
    std::jthread writer([&] {
        write_in_pieces(path, content.substr(opening), most, seed);
        options.growth->end();
    });
    return test::read_log(path, kAutoFormat, options);
}

Log read_whole(const TempDir& folder, std::string_view content, std::uint64_t opening) {
    ReadOptions options;
    options.opening_bytes = opening;
    return test::read_log(folder.put("whole", content), kAutoFormat, options);
}

void expect_same(const Log& a, const Log& b, const std::string& where) {
    EXPECT_EQ(a.scans, b.scans) << where;
    EXPECT_EQ(a.odometry, b.odometry) << where;
    EXPECT_EQ(a.report.skipped, b.report.skipped) << where;
    EXPECT_EQ(a.report.early_scans, b.report.early_scans) << where;
    EXPECT_EQ(a.report.duplicate_scans, b.report.duplicate_scans) << where;
    EXPECT_EQ(a.report.stamps_backwards, b.report.stamps_backwards) << where;
}

TEST(FileGrowth, WaitsForMoreAndEndsWhereItIsEnded) {
    const TempDir folder;
    const auto path = folder.put("a", "12345");
    FileGrowth growth(path);
    EXPECT_EQ(growth.size(), 5U);
    EXPECT_TRUE(growth.wait_beyond(4));
    std::jthread writer([&] { std::ofstream(path, std::ios::app) << "678"; });
    EXPECT_TRUE(growth.wait_beyond(5));
    writer.join();
    EXPECT_TRUE(growth.wait_beyond(7));
    std::jthread ender([&] { growth.end(); });
    EXPECT_FALSE(growth.wait_beyond(8));
    std::ofstream(path, std::ios::app) << "9";
    EXPECT_EQ(growth.size(), 8U);
    EXPECT_FALSE(growth.problem());
}

TEST(FileGrowth, KnowsWhenCameWhatWasTaken) {
    const TempDir folder;
    const auto path = folder.put("a", "12345");
    FileGrowth growth(path);
    growth.note_taken(5);
    EXPECT_FALSE(growth.taken_came());  // it was there before
    const auto before = FileGrowth::Clock::now();
    std::ofstream(path, std::ios::app) << "678";
    ASSERT_TRUE(growth.wait_beyond(7));
    const auto after = FileGrowth::Clock::now();
    std::ofstream(path, std::ios::app) << "9";
    ASSERT_TRUE(growth.wait_beyond(8));
    EXPECT_EQ(growth.waiting(), 4U);
    growth.note_taken(7);
    ASSERT_TRUE(growth.taken_came());
    EXPECT_GE(*growth.taken_came(), before);
    EXPECT_LE(*growth.taken_came(), after);
    growth.note_taken(9);
    EXPECT_GE(*growth.taken_came(), after);
    EXPECT_EQ(growth.waiting(), 0U);
}

TEST(FileGrowth, ThatBecomesShorterIsOverAndSaysSo) {
    const TempDir folder;
    const auto path = folder.put("a", "12345");
    FileGrowth growth(path);
    std::filesystem::resize_file(path, 2);
    EXPECT_FALSE(growth.wait_beyond(5));
    ASSERT_TRUE(growth.problem());
    EXPECT_NE(std::string(growth.problem()->what()).find("shorter"), std::string::npos);
    EXPECT_EQ(growth.size(), 2U);
    EXPECT_THROW(FileGrowth(folder.path() / "missing"), FileError);
    EXPECT_THROW(FileGrowth(folder.path()), FileError);
}

TEST(LiveTour, OfTextIsThatOfTheWholeFile) {
    const TempDir folder;
    for (const char* name :
         {"carmen-flaser.log.gz", "normalized.log.gz", "player-laser.log.gz", "radish.log.gz"}) {
        const std::string content = test::shipped_log(name);
        const std::uint64_t opening = content.find('\n', content.size() / 3) + 1;
        for (const std::size_t most : {1000U, 100'000U}) {
            const Log live = read_growing(folder, content, opening, most, 7);
            EXPECT_FALSE(live.scans.empty());
            expect_same(live, read_whole(folder, content, opening), name);
            std::filesystem::remove(folder / "growing");
        }
    }
}

/// Whatever is damaged, and however much had come when that showed.
TEST(LiveTour, OfADamagedMcapIsThatOfTheWholeFile) {
    const TempDir folder;
    const auto tour = test::small_tour(Bytes::cdr(), 60);
    std::mt19937 random(11);
    for (int i = 0; i < test::repeated(60); ++i) {
        const bool chunks = i % 3 == 0;
        std::string content = test::mcap_of(
            tour, {.packing = chunks ? test::Packing{"zstd", test::packed_zstd} : test::Packing{}});
        const std::size_t opening = content.size() / 4;
        // Records begin where nobody knows: lengths are hit among other bytes.
        for (int k = 0; k < 4; ++k) {
            const std::size_t at = opening + random() % (content.size() - opening);
            content[at] = static_cast<char>(content[at] + 1 + static_cast<int>(random() % 255));
        }
        Log live =
            read_growing(folder, content, opening, 300, static_cast<std::uint32_t>(random()));
        Log whole = read_whole(folder, content, opening);
        // Whether what is damaged is a message too, and counted, shows sooner or later.
        for (Log* log : {&live, &whole}) {
            for (Scan& scan : log->scans) scan.line = 0;
            for (Odometria& reading : log->odometry) reading.line = 0;
        }
        EXPECT_TRUE(live.scans == whole.scans && live.odometry == whole.odometry)
            << i << ": " << live.scans.size() << " scans and " << live.odometry.size()
            << " readings live, " << whole.scans.size() << " and " << whole.odometry.size();
        std::filesystem::remove(folder / "growing");
    }
}

TEST(LiveTour, OfMcapIsThatOfTheWholeFile) {
    const TempDir folder;
    const auto tour = test::small_tour(Bytes::cdr(), 60);
    for (const test::Packing& packing :
         {test::Packing{}, test::Packing{"", test::unpacked},
          test::Packing{"zstd", test::packed_zstd}, test::Packing{"lz4", test::packed_lz4}}) {
        const std::string content = test::mcap_of(tour, {.packing = packing});
        const Log live = read_growing(folder, content, content.size() / 2, 300, 3);
        EXPECT_EQ(live.scans.size(), 60U) << packing.name;
        expect_same(live, read_whole(folder, content, content.size() / 2), packing.name);
        EXPECT_EQ(live.scans, test::read_log(folder / "whole").scans) << packing.name;
        std::filesystem::remove(folder / "growing");
    }
}

/// A writer may be broken off anywhere; what is read along is what is then in the file.
TEST(LiveTour, BrokenOffAnywhereIsThatOfTheFileAsItIs) {
    const TempDir folder;
    const auto tour = test::small_tour(Bytes::cdr(), 8);
    for (const test::Packing& packing : {test::Packing{}, test::Packing{"", test::unpacked},
                                         test::Packing{"zstd", test::packed_zstd}}) {
        const std::string content = test::mcap_of(tour, {.packing = packing});
        for (std::size_t cut = content.size() / 2; cut < content.size(); cut += 31) {
            const std::string_view part = std::string_view(content).substr(0, cut);
            const Log live = read_growing(folder, part, content.size() / 2, 100, 5);
            expect_same(live, read_whole(folder, part, content.size() / 2),
                        packing.name + " cut at " + std::to_string(cut));
            std::filesystem::remove(folder / "growing");
        }
    }
}

/// A robot waits for its pose: no message is held back for others that may come late.
TEST(LiveTour, HandsOutAScanAsSoonAsItIsThere) {
    const TempDir folder;
    const auto tour = test::small_tour(Bytes::cdr(), 10);
    std::string content;
    ReceivedMcap mcap;
    ReceivedMcap::begin(content);
    const auto put = [&](const test::Said& said) {
        std::string type = said.type;
        type.insert(type.find('/'), "/msg");
        const std::uint16_t topic =
            mcap.add(content, {said.topic, "cdr", type, "ros2msg", "# text"});
        mcap.put_message(content, topic, said.log_time_ns, said.bytes);
    };
    for (const test::Said& said : tour) put(said);
    const auto path = folder.put("a.mcap", content);
    ReadOptions options;
    options.opening_bytes = content.size();
    options.growth = std::make_shared<FileGrowth>(path);
    Procesador reader(open_log(path, kAutoFormat, options), options);
    for (int i = 0; i < 10; ++i) ASSERT_TRUE(reader.next_scan()) << i;
    for (int i = 0; i < 10; ++i) ASSERT_TRUE(reader.next_odometry()) << i;
    EXPECT_EQ(options.growth->waiting(), 0U);
    options.growth->end();
    EXPECT_FALSE(reader.next_scan());
}

TEST(LiveTour, OfWhatCannotGrowIsRefused) {
    const TempDir folder;
    const auto tour = test::small_tour(Bytes::ros1(), 5);
    for (const auto& path :
         {folder.put("a.bag", test::bag_of(tour)),
          folder.put_gz("a.log.gz", test::shipped_log("normalized.log.gz")),
          folder.put("a.mcap.zstd",
                     test::packed_zstd(test::mcap_of(test::small_tour(Bytes::cdr(), 5), {})))}) {
        ReadOptions options;
        options.growth = std::make_shared<FileGrowth>(path);
        options.opening_bytes = options.growth->size();
        EXPECT_THROW(open_log(path, kAutoFormat, options), FileError) << path;
    }
}

TEST(ReceivedMcap, IsReadAsWhatWasPut) {
    const TempDir folder;
    const std::vector<test::Said> messages = test::messages();
    std::string content;
    ReceivedMcap mcap;
    ReceivedMcap::begin(content);
    for (const test::Said& said : messages) {
        const std::uint16_t topic =
            mcap.add(content, {said.topic, "cdr", said.type, "ros2msg", "# text"});
        mcap.put_message(content, topic, said.log_time_ns, said.bytes);
    }
    ReceivedMcap::finish(content);
    const test::Read read = test::read(open_mcap, folder.put("a.mcap", content));
    EXPECT_TRUE(read.problems.empty());
    test::expect_first(read.all, messages.size());
}

/// The two ends of a pipe.
struct Pipe {
    Pipe() { EXPECT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0); }
    ~Pipe() {
        ::close(ends[0]);
        close_writer();
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void write(std::string_view text) const {
        while (!text.empty()) {
            const ssize_t put = ::write(ends[1], text.data(), text.size());
            ASSERT_GT(put, 0);
            text.remove_prefix(static_cast<std::size_t>(put));
        }
    }
    void close_writer() {
        if (ends[1] >= 0) ::close(ends[1]);
        ends[1] = -1;
    }
    std::array<int, 2> ends{-1, -1};
};

TEST(LiveSource, KeepsAllThatComesThroughAPipe) {
    const TempDir folder;
    const std::string text = test::shipped_log("normalized.log.gz");
    const std::string mcap = test::mcap_of(test::small_tour(Bytes::cdr(), 30), {});
    for (const auto& [content, ending] :
         {std::pair(text, ".log"), std::pair(mcap, ".mcap"), std::pair(std::string("x"), ".log")}) {
        Pipe pipe;
        std::jthread writer([&pipe, &content = content] {
            pipe.write(content);
            pipe.close_writer();
        });
        const auto source =
            LiveSource::of_pipe(pipe.ends[0], folder / "kept", false, [] { return true; });
        ASSERT_TRUE(source);
        EXPECT_EQ(source->file(), folder / (std::string("kept") + ending));
        while (source->growth()->wait_beyond(source->growth()->size())) {
        }
        EXPECT_EQ(test::content(source->file()), content);
        EXPECT_FALSE(source->problem());
        std::filesystem::remove(source->file());
    }
}

TEST(LiveSource, TakesNoFileThatIsThereAndWaitsForNothingWhenAskedNotTo) {
    const TempDir folder;
    folder.put("kept.log", "mine");
    Pipe pipe;
    pipe.write("ODOM 1 2 3 4 5 6\n");
    EXPECT_THROW(LiveSource::of_pipe(pipe.ends[0], folder / "kept", false, [] { return true; }),
                 FileError);
    EXPECT_EQ(test::content(folder / "kept.log"), "mine");
    const Pipe silent;
    EXPECT_EQ(LiveSource::of_pipe(silent.ends[0], folder / "b", false, [] { return false; }),
              nullptr);
}

/// What an earlier run received is gone only when somebody has more of what came in its place.
TEST(LiveSource, KeepsWhatItIsToReplaceUntilItIsTold) {
    const TempDir folder;
    const auto kept = folder.put("kept.log", "old");
    const auto before = folder / "kept.log.before";
    const auto came = [&](std::string_view content) {
        Pipe pipe;
        const std::jthread writer([&pipe, content] {
            pipe.write(content);
            pipe.close_writer();
        });
        auto source = LiveSource::of_pipe(pipe.ends[0], folder / "kept", true, [] { return true; });
        while (source->growth()->wait_beyond(source->growth()->size())) {
        }
        return source;
    };
    {
        const auto source = came("usage: driver [-h]\n");
        EXPECT_THROW(source->wait_for_opening(kAutoFormat, {}, 1, [](const auto&) { return true; }),
                     FormatError);
        EXPECT_FALSE(source->give_back());
    }
    EXPECT_EQ(test::content(before), "old");
    EXPECT_THAT(test::content(kept), testing::HasSubstr("usage"));
    // Which the next one says.
    Pipe pipe;
    pipe.write("ODOM 0 0 0\n");
    try {
        LiveSource::of_pipe(pipe.ends[0], folder / "kept", false, [] { return true; });
        ADD_FAILURE();
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("kept.log.before"));
    }
    std::filesystem::rename(before, kept);
    {
        const auto source = came(test::shipped_log("normalized.log.gz"));
        EXPECT_EQ(test::content(before), "old");
        // Nor does another run take its place meanwhile.
        pipe.write("ODOM 0 0 0\n");
        EXPECT_THROW(LiveSource::of_pipe(pipe.ends[0], folder / "kept", true, [] { return true; }),
                     FileError);
        source->wait_for_opening(kAutoFormat, {}, 5, [](const auto&) { return true; });
        EXPECT_EQ(source->former(), before);
        source->replace_former();
        EXPECT_FALSE(std::filesystem::exists(before));
        EXPECT_EQ(source->former(), "");
    }
    EXPECT_THAT(test::content(kept), testing::HasSubstr("LASER"));
    // What is no file stays what it is.
    std::filesystem::create_symlink(kept, folder / "link.log");
    std::filesystem::create_directory(folder / "folder.log");
    ASSERT_EQ(::mkfifo((folder / "fifo.log").c_str(), S_IRUSR | S_IWUSR), 0);
    for (const char* name : {"link", "folder", "fifo"}) {
        const auto status = std::filesystem::symlink_status(folder / (name + std::string(".log")));
        pipe.write("ODOM 0 0 0\n");
        EXPECT_THROW(LiveSource::of_pipe(pipe.ends[0], folder / name, true, [] { return true; }),
                     FileError)
            << name;
        EXPECT_EQ(std::filesystem::symlink_status(folder / (name + std::string(".log"))).type(),
                  status.type());
    }
}

TEST(ReceivedFile, GivesBackWhatWasThereWhereNothingCame) {
    const TempDir folder;
    const auto kept = folder.put("kept.mcap", "old");
    {
        ReceivedFile file(kept, true);
        file.append(std::string("what describes it"), false);
        EXPECT_EQ(test::content(folder / "kept.mcap.before"), "old");
    }
    EXPECT_EQ(test::content(kept), "old");
    EXPECT_FALSE(std::filesystem::exists(folder / "kept.mcap.before"));
    {
        ReceivedFile file(kept, true);
        EXPECT_TRUE(file.give_back());
        EXPECT_FALSE(file.give_back());
        // What somebody else has put there meanwhile is theirs.
    }
    EXPECT_EQ(test::content(kept), "old");
    {
        const ReceivedFile file(folder / "other.mcap", false);
        std::filesystem::remove(folder / "other.mcap");
        folder.put("other.mcap", "theirs");
    }
    EXPECT_EQ(test::content(folder / "other.mcap"), "theirs");
    const ReceivedFile fresh(folder / "fresh.mcap", false);
    EXPECT_TRUE(std::filesystem::exists(folder / "fresh.mcap"));
}

TEST(LiveSource, OpensWhenSoManyScansHaveCome) {
    const TempDir folder;
    const std::string text = test::shipped_log("normalized.log.gz");
    const auto path = folder.put("a.log", "");
    LiveSource source(path);
    std::jthread writer([&](const std::stop_token& stop) {
        std::string_view rest = text;
        while (!rest.empty() && !stop.stop_requested()) {
            std::ofstream(path, std::ios::app) << rest.substr(0, 500);
            rest.remove_prefix(std::min<std::size_t>(500, rest.size()));
        }
    });
    const auto opening =
        source.wait_for_opening(kAutoFormat, {}, 5, [](const auto&) { return true; });
    ASSERT_TRUE(opening);
    EXPECT_EQ(opening->scans, 5U);
    EXPECT_EQ(text[opening->bytes - 1], '\n');
    EXPECT_FALSE(
        LiveSource(folder.put("b.log", "")).wait_for_opening(kAutoFormat, {}, 5, [](const auto&) {
            return false;
        }));
    // What will never be a tour is refused when it is over.
    LiveSource other(folder.put("c.log", "no log at all\n"));
    other.end();
    EXPECT_THROW(other.wait_for_opening(kAutoFormat, {}, 5, [](const auto&) { return true; }),
                 FormatError);
}

}  // namespace
}  // namespace hitos
