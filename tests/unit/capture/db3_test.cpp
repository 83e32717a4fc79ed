// SPDX-License-Identifier: GPL-3.0-or-later
// rosbag2's SQLite files.
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <tuple>

#include "hitos/base/error.hpp"
#include "support.hpp"
#include "unit/capture/recorded_messages.hpp"
#include "unit/capture/ros_packings.hpp"

namespace hitos {
namespace {

using test::are_first;
using test::expect_first;
using test::many_messages;
using test::messages;
using test::Read;
using test::read;
using test::Said;
using test::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Db3, GivesAllMessagesOrSaysWhatIsMissing) {
    const TempFolder folder;
    write_db3(folder / "a.db3", messages());
    const Read found = read(open_db3, folder / "a.db3");
    expect_first(found.all, messages().size());
    EXPECT_THAT(read(open_db3, folder / "a.db3", "/b").numbers, ElementsAre(1, 4, 7, 10));

    sqlite3* database = nullptr;
    sqlite3_open((folder / "b.db3").c_str(), &database);
    sqlite3_exec(database, "CREATE TABLE topics(id INTEGER PRIMARY KEY)", nullptr, nullptr,
                 nullptr);
    sqlite3_close(database);
    EXPECT_THAT(test::message_of<FormatError>([&] { read(open_db3, folder / "b.db3"); }),
                HasSubstr("without the table \"messages\""));
    EXPECT_THAT(test::message_of<FormatError>([&] {
                    read(open_db3, folder.put("c.db3", "SQLite format 3" + std::string(900, '\0')));
                }),
                HasSubstr("cannot be read as a recording"));
}

TEST(Db3, PassesOverWhatIsTooLargeAndWhatNobodyWants) {
    const TempFolder folder;
    std::vector<Said> all = messages();
    const std::string large(static_cast<std::size_t>(kLargestMessage) + 1, 'x');
    all[1].bytes = all[2].bytes = large;  // of "/b"
    write_db3(folder / "a.db3", all);
    const Read found = read(open_db3, folder / "a.db3", "/b");
    EXPECT_THAT(found.numbers, ElementsAre(1, 4, 7, 10));
    EXPECT_TRUE(found.problems.empty());
    const Read both = read(open_db3, folder / "a.db3");
    EXPECT_EQ(both.all.size(), messages().size() - 2);
    ASSERT_EQ(both.problems.size(), 2U);
    EXPECT_THAT(both.problems.front(), HasSubstr("expected at most 16777216"));
}

// At every depth of the tree: pages of 512 bytes have four levels of 3,000 messages.
TEST(Db3, GivesWhatIsThereWhereItIsCutOff) {
    const TempFolder folder;
    for (const std::size_t count : {10U, 300U, 3000U}) {
        const std::vector<Said> all = many_messages(count);
        for (const char* pragmas : {"", "PRAGMA page_size=512"}) {
            const auto path = folder / (std::to_string(count) + pragmas);
            write_db3(path, all, {.pragmas = pragmas});
            const std::string whole = test::content(path);
            const std::size_t page = *pragmas == '\0' ? 4096 : 512;
            std::size_t most = 0;
            for (std::size_t size = page + 1; size < whole.size(); size += 1 + whole.size() / 60) {
                Read part;
                try {
                    part = read(open_db3, folder.put("cut.db3", whole.substr(0, size)));
                } catch (const FormatError& error) {  // of the tables themselves
                    EXPECT_LE(size, 4 * page);
                    EXPECT_THAT(error.what(), HasSubstr("is cut off at byte"));
                    continue;
                }
                ASSERT_TRUE(are_first(part.all, all)) << size;
                EXPECT_GE(part.all.size(), most) << size;
                most = part.all.size();
                EXPECT_THAT(part.problems, ElementsAre(HasSubstr("is cut off at byte"))) << size;
                // But for the row that is cut and the pages' own use.
                EXPECT_GE(static_cast<double>(most + 30) / static_cast<double>(count),
                          0.9 * static_cast<double>(size) / static_cast<double>(whole.size()));
            }
            EXPECT_TRUE(most > 0U || count == 10U);  // which stand in one page
        }
    }
}

// A page of the tree that is damaged costs no leaf that is sound.
TEST(Db3, GoesOnBehindADamagedPage) {
    const TempFolder folder;
    const std::vector<Said> all = many_messages(3000);
    write_db3(folder / "a.db3", all, {.pragmas = "PRAGMA page_size=512"});
    std::string bad = test::content(folder / "a.db3");
    const std::size_t page = bad.size() / 2 / 512 * 512;
    bad.replace(page, 2048, std::string(2048, '\xff'));
    const Read found = read(open_db3, folder.put("b.db3", bad));
    EXPECT_GT(found.all.size(), 2900U);
    EXPECT_LT(found.all.size(), 3000U);
    EXPECT_EQ(found.all.back().log_time_ns, 2999U);
    EXPECT_THAT(found.problems, ElementsAre(HasSubstr("behind the row")));
}

/// A recording whose recorder was killed: all but the table of topics may be in the log beside it.
class Db3Changes : public ::testing::Test {
  protected:
    Db3Changes() {
        write_db3(folder_ / "r.db3", all_,
                  {.pragmas = "PRAGMA journal_mode=WAL", .in_transaction = 20, .before_close = [&] {
                       for (const char* ending : {"", "-wal"}) {
                           const std::string from = (folder_ / "r.db3").string() + ending;
                           kept_.push_back(test::content(from));
                       }
                   }});
        std::filesystem::create_directory(tour_);
        put("r.db3", kept_[0]);
        put("r.db3-wal", kept_[1]);
    }
    void put(const std::string& name, const std::string& bytes) const {
        std::ofstream(tour_ / name, std::ios::binary) << bytes;
    }
    /// Names, sizes, owners and times of all in the recording's folder and of itself.
    std::vector<std::string> state() const {
        std::vector<std::string> all;
        const auto add = [&](const std::filesystem::path& path) {
            struct stat is {};
            ::stat(path.c_str(), &is);
            all.push_back(path.string() + ' ' + std::to_string(is.st_size) + ' ' +
                          std::to_string(is.st_uid) + ' ' + std::to_string(is.st_ctim.tv_sec) +
                          '.' + std::to_string(is.st_ctim.tv_nsec));
        };
        add(tour_);
        for (const auto& entry : std::filesystem::directory_iterator(tour_)) add(entry.path());
        return all;
    }

    TempFolder folder_;
    std::filesystem::path tour_ = folder_ / "tour";
    std::vector<Said> all_ = many_messages(200);
    std::vector<std::string> kept_;
};

TEST_F(Db3Changes, AreReadAndTheFolderIsLeftAsItIs) {
    ASSERT_GT(kept_[1].size(), 10'000U);
    // As root it is another one's.
    if (::geteuid() == 0) std::ignore = ::chown((tour_ / "r.db3").c_str(), 12345, 12345);
    const std::vector<std::string> before = state();
    for (const auto& path : {tour_, tour_ / "r.db3"}) {
        // Two at a time, as a tour is read.
        const Read again = read(path == tour_ ? open_rosbag2_folder : open_db3, path);
        EXPECT_EQ(again.all.size(), all_.size());
        EXPECT_TRUE(are_first(again.all, all_));
        EXPECT_THAT(again.problems, IsEmpty());
    }
    EXPECT_EQ(state(), before);
    std::filesystem::permissions(
        tour_, std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    EXPECT_EQ(read(open_rosbag2_folder, tour_).all.size(), all_.size());
    std::filesystem::permissions(tour_, std::filesystem::perms::owner_all);
}

TEST_F(Db3Changes, AreReadUpToTheLastOneThatIsWhole) {
    std::size_t most = 0;
    for (std::size_t size = 1; size < kept_[1].size(); size += 1 + kept_[1].size() / 50) {
        put("r.db3-wal", kept_[1].substr(0, size));
        Read part;
        try {
            part = read(open_db3, tour_ / "r.db3");
        } catch (const FormatError&) {  // the tables are not there yet
            EXPECT_EQ(most, 0U);
            continue;
        }
        ASSERT_TRUE(are_first(part.all, all_));
        EXPECT_EQ(part.all.size() % 20, 0U);
        EXPECT_GE(part.all.size(), most);
        most = part.all.size();
        // Behind the last byte of a change nothing tells that there was another one.
        if (part.problems.empty() && (size - 32) % (4096 + 24) == 0) continue;
        EXPECT_THAT(part.problems, ElementsAre(HasSubstr("r.db3-wal holds changes"))) << size;
    }
    EXPECT_GE(most, 160U);
}

TEST_F(Db3Changes, OfEarlierTimesAndOfOtherFilesAreLeftOut) {
    std::string changes = kept_[1];
    // Another salt is another recording's.
    changes[16] = static_cast<char>(changes[16] + 1);
    put("r.db3-wal", changes);
    EXPECT_THAT(test::message_of<FormatError>([&] { read(open_db3, tour_ / "r.db3"); }),
                HasSubstr("\"topics\""));
    // What a restart of the log has left behind it is no damage.
    const TempFolder other;
    write_db3(other / "r.db3", many_messages(3000),
              {.pragmas = "PRAGMA journal_mode=WAL", .in_transaction = 70, .before_close = [&] {
                   put("r.db3", test::content(other / "r.db3"));
                   put("r.db3-wal", test::content(other / "r.db3-wal"));
               }});
    const Read found = read(open_db3, tour_ / "r.db3");
    EXPECT_EQ(found.all.size(), 3000U);
    EXPECT_THAT(found.problems, IsEmpty());
}

TEST(Db3, TellsOfATransactionThatWasBrokenOff) {
    const TempFolder folder;
    write_db3(folder / "a.db3", messages());
    static_cast<void>(folder.put("a.db3-journal", "something"));
    const Read found = read(open_db3, folder / "a.db3");
    expect_first(found.all, messages().size());
    EXPECT_THAT(found.problems, ElementsAre(HasSubstr("as a.db3-journal tells")));
}

TEST(Db3, EndsWhateverIsChanged) {
    const TempFolder folder;
    write_db3(folder / "a.db3", messages());
    const std::string whole = test::content(folder / "a.db3");
    int refused = 0;
    int told = 0;
    for (std::size_t place = 16; place < whole.size(); place += 11) {
        std::string bad = whole;
        bad[place] = static_cast<char>(bad[place] + 77);
        if (place % 7 == 0) bad.resize(place);
        try {
            const Read found = read(open_db3, folder.put("b.db3", bad));
            EXPECT_LE(found.all.size(), 100U);
            if (!found.problems.empty()) ++told;
        } catch (const Error&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 0);
    EXPECT_GT(told, 0);
}

}  // namespace
}  // namespace hitos
