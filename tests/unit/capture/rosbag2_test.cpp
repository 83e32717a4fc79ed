// SPDX-License-Identifier: GPL-3.0-or-later
// rosbag2's folders, and files in zstd.
#include <gmock/gmock.h>

#include <cstdlib>
#include <random>

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
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Rosbag2 : public ::testing::Test {
  protected:
    void put_mcap(const std::string& name, std::size_t begin, std::size_t end) const {
        std::vector<Said> all = messages();
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(end), all.end());
        all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(begin));
        static_cast<void>(folder_.put(name, test::mcap_of(all)));
    }
    std::string refusal() const {
        return test::message_of<Error>([&] { read(open_rosbag2_folder, folder_.path()); });
    }
    TempFolder folder_;
};

TEST_F(Rosbag2, ReadsItsFilesInTheOrderThatItSays) {
    put_mcap("z_0.mcap", 0, 3);
    put_mcap("a_1.mcap", 3, 10);
    static_cast<void>(folder_.put("metadata.yaml",
                                  "rosbag2_bagfile_information:\n  version: 5\n"
                                  "  compression_mode: \"\"\n  relative_file_paths:\n"
                                  "    - z_0.mcap\n    - 'old_name/a_1.mcap'\n  files: []\n"));
    const Read found = read(open_rosbag2_folder, folder_.path());
    expect_first(found.all, 10);
    EXPECT_EQ(found.numbers.back(), 10U);
    EXPECT_THAT(found.problems, IsEmpty());
}

TEST_F(Rosbag2, ReadsListsAsPeopleWriteThem) {
    put_mcap("z_0.mcap", 0, 3);
    put_mcap("a_1.mcap", 3, 10);
    for (const char* list :
         {"relative_file_paths:  # two\r\n\r\n  # the first\r\n    - \"z_0.mcap\"\r\n"
          "\r\n    - a_1.mcap   # the second\r\n  files: []\r\n",
          "  relative_file_paths: [z_0.mcap, 'a_1.mcap']\n  version: 5\n"}) {
        static_cast<void>(folder_.put("metadata.yaml", list));
        expect_first(read(open_rosbag2_folder, folder_.path()).all, 10);
    }
}

TEST_F(Rosbag2, ReadsAFileOnceAndGoesWithoutAMetadataFileThatSaysNothing) {
    put_mcap("r_0.mcap", 0, 3);
    put_mcap("r_1.mcap", 3, 10);
    for (const char* list :
         {"  relative_file_paths: [r_0.mcap, r_1.mcap, r_0.mcap]\n", "", "rosbag2_bagfile_inf"}) {
        static_cast<void>(folder_.put("metadata.yaml", list));
        expect_first(read(open_rosbag2_folder, folder_.path()).all, 10);
    }
}

TEST_F(Rosbag2, IsReadWithoutMetadataByTheNumbersOfItsFiles) {
    put_mcap("r_10.mcap", 6, 10);
    put_mcap("r_9.mcap", 3, 6);
    put_mcap("r_0.mcap", 0, 3);
    expect_first(read(open_rosbag2_folder, folder_.path()).all, 10);
}

TEST_F(Rosbag2, PassesOverALaterFileThatIsNone) {
    put_mcap("r_0.mcap", 0, 3);
    static_cast<void>(folder_.put("r_1.mcap", "nothing"));
    put_mcap("r_2.mcap", 3, 10);
    const Read found = read(open_rosbag2_folder, folder_.path());
    expect_first(found.all, 10);
    EXPECT_THAT(found.problems, ElementsAre("r_1.mcap: does not begin as MCAP does"));
}

// As compression mode FILE leaves them.
TEST_F(Rosbag2, FilesAreUnpacked) {
    put_mcap("r_0.mcap", 0, 3);
    const std::string first = test::content(folder_ / "r_0.mcap");
    std::filesystem::remove(folder_ / "r_0.mcap");
    static_cast<void>(folder_.put("r_0.mcap.zstd", test::packed_zstd(first)));
    put_mcap("r_1.mcap", 3, 10);  // the recorder was killed before it compressed this one
    static_cast<void>(folder_.put("r_1.mcap.zstd", "half"));
    expect_first(read(open_rosbag2_folder, folder_.path()).all, 10);
    for (const char* list : {"r_0.mcap.zstd, r_1.mcap", "tour/r_0.mcap, r_1.mcap.zst"}) {
        static_cast<void>(folder_.put("metadata.yaml",
                                      "  compression_format: zstd\n  compression_mode: FILE\n"
                                      "  relative_file_paths: [" +
                                          std::string(list) + "]\n"));
        const Read found = read(open_rosbag2_folder, folder_.path());
        expect_first(found.all, 10);
        EXPECT_THAT(found.problems, IsEmpty());
    }
    write_db3(folder_ / "a.db3", messages());
    const std::string packed = test::packed_zstd(test::content(folder_ / "a.db3"));
    expect_first(read(open_db3, folder_.put("a.db3.zstd", packed)).all, 10);
}

TEST_F(Rosbag2, OfAPackedFileThatIsCutOffThereIsWhatCanBeUnpacked) {
    std::vector<Said> all = many_messages(2000);
    std::minstd_rand random;  // which no compressor makes small
    for (Said& said : all) {
        for (char& c : said.bytes) c = static_cast<char>(random() >> 8U);
    }
    write_db3(folder_ / "a.db3", all);
    const std::string db3 = test::packed_zstd(test::content(folder_ / "a.db3"));
    const std::string mcap = test::packed_zstd(test::mcap_of(all));
    for (const double part : {0.3, 0.7, 0.95}) {
        const auto cut = [&](const std::string& whole) {
            return folder_.put(
                "cut", whole.substr(
                           0, static_cast<std::size_t>(part * static_cast<double>(whole.size()))));
        };
        for (const Read& found : {read(open_db3, cut(db3)), read(open_mcap, cut(mcap))}) {
            EXPECT_TRUE(are_first(found.all, all));
            EXPECT_GT(static_cast<double>(found.all.size()), (part - 0.15) * 2000.0);
            EXPECT_THAT(found.problems, ElementsAre(HasSubstr("byte")));
        }
    }
    for (const char* what : {"", "\xff and so on"}) {
        const auto bad = folder_.put("bad", "\x28\xb5\x2f\xfd" + std::string(what));
        EXPECT_THAT(test::message_of<FormatError>([&] { read(open_db3, bad); }),
                    HasSubstr("the compressed data"));
    }
}

TEST_F(Rosbag2, UnpacksIntoAFileWithoutANameWhereThereIsRoom) {
    const char* before = std::getenv("TMPDIR");
    const std::string kept = before == nullptr ? "" : before;
    const TempFolder room;
    put_mcap("r.mcap", 0, 3);
    const auto packed =
        folder_.put("r.mcap.zstd", test::packed_zstd(test::content(folder_ / "r.mcap")));
    ::setenv("TMPDIR", (folder_ / "none").c_str(), 1);
    EXPECT_THAT(test::message_of<FileError>([&] { read(open_mcap, packed); }),
                AllOf(HasSubstr("cannot be unpacked in"), HasSubstr("TMPDIR")));
    ::setenv("TMPDIR", room.path().c_str(), 1);
    Topics topics([](const Topic&) { return true; });
    const auto recording = open_mcap(packed, {topics, true});
    EXPECT_TRUE(recording->next());
    EXPECT_EQ(room.files(), 0U) << "no kill leaves anything";
    EXPECT_EQ(folder_.files(), 2U);
    before == nullptr ? ::unsetenv("TMPDIR") : ::setenv("TMPDIR", kept.c_str(), 1);
}

TEST_F(Rosbag2, SaysWhatItCannotRead) {
    EXPECT_THAT(refusal(), HasSubstr("is a folder without a recording"));
    const auto metadata = [&](const std::string& text) {
        static_cast<void>(folder_.put("metadata.yaml", text));
        return refusal();
    };
    EXPECT_THAT(metadata(""), HasSubstr("is a folder without a recording"));
    EXPECT_THAT(metadata("  relative_file_paths:\n  - a.mcap\n"),
                HasSubstr("names the file \"a.mcap\", which is not in its folder"));
    put_mcap("a.mcap", 0, 3);
    EXPECT_THAT(metadata("  relative_file_paths:\n  - ../" + folder_.path().filename().string() +
                         "/a.mcap\n"),
                HasSubstr("which is not in its folder"));
    EXPECT_THAT(metadata("  compression_mode: MESSAGE\n  relative_file_paths:\n  - a.mcap\n"),
                HasSubstr("compressed by MESSAGE"));
}

}  // namespace
}  // namespace hitos
