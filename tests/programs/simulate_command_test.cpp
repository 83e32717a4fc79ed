// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli simulate as a user calls it.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "hitos/capture/archivo.hpp"
#include "hitos/services/drawing/picture_file.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/services/files/trajectory_file.hpp"

namespace hitos {
namespace {

struct Result {
    int status = -1;
    std::string said;  ///< both streams
};

class Simulate : public ::testing::Test {
  protected:
    void SetUp() override {
        std::string pattern =
            (std::filesystem::temp_directory_path() / "hitos-simulate-XXXXXX").string();
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
    }
    void TearDown() override {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

    std::string in(const std::string& name) const { return (folder_ / name).string(); }
    std::size_t files() const {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_),
                                                      std::filesystem::directory_iterator()));
    }
    std::string content(const std::string& name) const {
        std::ifstream file(folder_ / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }

    static Result call(const std::string& arguments, const std::string& before = "") {
        return shell(before + std::string(HITOS_BIN_DIR) + "/hitos-cli " + arguments);
    }
    static Result shell(const std::string& line) {
        FILE* pipe = ::popen(("{ " + line + "\n} 2>&1").c_str(), "r");
        if (pipe == nullptr) return {};
        Result result;
        std::array<char, 4096> buffer{};
        while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), pipe))
            result.said.append(buffer.data(), got);
        const int status = ::pclose(pipe);
        result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        return result;
    }
    void expect_refusal(const std::string& arguments, const std::string& words) {
        const std::size_t before = files();
        const Result result = call(arguments);
        EXPECT_NE(result.status, 0) << arguments;
        EXPECT_NE(result.said.find(words), std::string::npos) << result.said;
        EXPECT_EQ(files(), before) << "something was half written";
    }

    std::filesystem::path folder_;
};

TEST_F(Simulate, WritesLogTruthReferenceAndPicture) {
    for (const std::string format : {"player", "radish", "normalized", "carmen"}) {
        const Result result =
            call("simulate recinto --laps 1 --format " + format + " --out " + in("tour." + format) +
                 " --truth " + in("truth.tum") + " --reference " + in("reference.map") +
                 " --picture " + in("tour.png"));
        ASSERT_EQ(result.status, 0) << result.said;
        EXPECT_EQ(open_log(in("tour." + format))->format().word, format);
    }
    EXPECT_EQ(read_map(in("reference.map")).size(), 8U);
    const Trajectory truth = read_trajectory(in("truth.tum"));
    EXPECT_EQ(truth.front(), (StampedPose{0.0, {}}));
    const Grid::Picture picture = read_mean_picture(in("tour.png")).grey;
    const auto grey = [&](int row, int column) {
        return picture.grey.at(static_cast<std::size_t>(row) *
                                   static_cast<std::size_t>(picture.width) +
                               static_cast<std::size_t>(column));
    };
    // Walls are drawn where they are: the room's lower left corner, 30 pixels from the border.
    EXPECT_EQ(grey(30 + 700, 30 + 3), 0);
    EXPECT_EQ(grey(30 + 690, 30 + 10), 255);
    EXPECT_EQ(call("simulate recinto --laps 1 --picture " + in("tour.jpg")).status, 0);
    EXPECT_EQ(read_mean_picture(in("tour.jpg")).grey.width, picture.width);
}

TEST_F(Simulate, OptionsReachTheTour) {
    const std::string base = "simulate lineamedia --laps 1 --out ";
    ASSERT_EQ(call(base + in("a.log")).status, 0);
    ASSERT_EQ(call(base + in("b.log") + " --seed 1 --laser-sigma 0.01 --odometry-noise 0.1").status,
              0);
    EXPECT_EQ(content("a.log"), content("b.log"));
    for (const std::string change :
         {"--seed 2", "--laser-sigma 0.003", "--odometry-noise 0.2", "--set tour.laps=2",
          "--odometry-noise-kind variance", "--set laser.rays=91", "--set tour.rest=1"}) {
        const bool laps = change.find("laps") != std::string::npos;
        const std::string all = "simulate lineamedia " + change + (laps ? "" : " --laps 1");
        ASSERT_EQ(call(all + " --out " + in("c.log")).status, 0);
        EXPECT_NE(content("a.log"), content("c.log")) << change;
    }
}

TEST_F(Simulate, RefusesClearlyAndLeavesNothing) {
    expect_refusal("simulate atlantis --out " + in("x.log"),
                   "no such world file; the worlds that come with Hitos are bigloop,");
    expect_refusal("simulate recinto", "found nothing to write");
    expect_refusal("simulate recinto --format auto --out " + in("x.log"), "expected player");
    expect_refusal("simulate recinto --out " + in("no/x.log"), "create the folder first");
    expect_refusal("simulate recinto --set laser.sigm=1 --out " + in("x.log"), "no such key");
    expect_refusal("simulate recinto --seed -1 --out " + in("x.log"), "seed: found -1");
    expect_refusal("simulate recinto --picture " + in("x.bmp") + " --out " + in("x.log"),
                   ".png, .jpg or .jpeg");
    expect_refusal("simulate recinto --truth " + in("no/x.tum") + " --out " + in("x.log"),
                   "create the folder first");
    std::ofstream(folder_ / "bad.toml") << "walls = [[[0, 0]]]\n";
    expect_refusal("simulate " + in("bad.toml") + " --out " + in("x.log"),
                   "bad.toml:1: wall 1: found one point");
    std::ofstream(folder_ / "tight.toml")
        << "walls = [[[1, -5], [1, 5]]]\n[tour]\nway_points = [[0.9, 0]]\n";
    expect_refusal("simulate " + in("tight.toml") + " --out " + in("x.log"),
                   "tight.toml:3: on the way to way point 1");
}

TEST_F(Simulate, FilesChangePlacesTogetherOrNotAtAll) {
    const std::string names = " --out " + in("tour.log") + " --truth " + in("truth.tum") +
                              " --reference " + in("reference.map") + " --picture " +
                              in("tour.png");
    ASSERT_EQ(call("simulate recinto --laps 1" + names).status, 0);
    const auto contents = [this] {
        return std::array{content("tour.log"), content("truth.tum"), content("reference.map"),
                          content("tour.png")};
    };
    const auto before = contents();
    std::filesystem::permissions(in("tour.log"), std::filesystem::perms::owner_all);
    const auto mode = std::filesystem::status(in("tour.log")).permissions();
    // There is room for all but the log.
    const Result full = call("simulate corridor" + names, "ulimit -f 500; ");
    EXPECT_EQ(full.status, 1);
    EXPECT_NE(full.said.find("hitos-cli: " + in("tour.log") + ": writing fails"), std::string::npos)
        << full.said;
    EXPECT_EQ(contents(), before);
    EXPECT_EQ(files(), 4U);
    // Links stay links, and a file's mode its mode.
    std::filesystem::create_symlink(in("tour.log"), in("link"));
    ASSERT_EQ(call("simulate corridor --truth " + in("truth.tum") + " --out " + in("link")).status,
              0);
    EXPECT_TRUE(std::filesystem::is_symlink(in("link")));
    EXPECT_NE(content("tour.log"), before[0]);
    EXPECT_NE(content("truth.tum"), before[1]);
    EXPECT_EQ(content("reference.map"), before[2]);
    EXPECT_EQ(std::filesystem::status(in("tour.log")).permissions(), mode);
    EXPECT_EQ(files(), 5U);
}

TEST_F(Simulate, OneAtATimeWritesTheSameFiles) {
    const std::string log = in("tour.log");
    ASSERT_EQ(call("simulate recinto --laps 1 --out " + log).status, 0);
    const std::string before = content("tour.log");
    // The first goes on for ever, the second comes while it does; then the first is asked to stop.
    const std::string cli = std::string(HITOS_BIN_DIR) + "/hitos-cli simulate recinto ";
    const Result both =
        shell(cli + "--laps 1000 --out " + log + " --truth " + in("a.tum") +
              " > /dev/null 2>&1 & first=$!; "
              "until [ -d " +
              in(".tour.log.hitos-new") + " ] || ! kill -0 $first; do sleep 0.05; done; " + cli +
              "--laps 1 --truth " + in("b.tum") + " --out " + log +
              "; echo second $?; kill -TERM $first; wait $first; echo first $?");
    EXPECT_NE(both.said.find("tour.log: is being written by process"), std::string::npos)
        << both.said;
    EXPECT_NE(both.said.find("second 1\nfirst 143\n"), std::string::npos) << both.said;
    EXPECT_EQ(content("tour.log"), before);
    EXPECT_EQ(files(), 1U);
}

TEST_F(Simulate, HelpListsEveryKeyAndWorld) {
    const Result result = call("simulate --help");
    EXPECT_EQ(result.status, 0);
    for (const char* word : {"--truth", "--reference", "laser.sigma = 0.01", "usc-sal",
                             "odometry.noise_kind = relative-sigma"}) {
        EXPECT_NE(result.said.find(word), std::string::npos) << word;
    }
}

TEST_F(Simulate, RunTakesAWorldFile) {
    const std::string world =
        (std::filesystem::path(HITOS_SOURCE_DIR) / "data/worlds/recinto.toml").string();
    const Result result = call("run " + world + " --set filter.particles=5 --out " + in("results"));
    EXPECT_EQ(result.status, 0) << result.said;
    EXPECT_TRUE(std::filesystem::exists(folder_ / "results/map.txt"));
}

/// Each of them stands among all walls; kept with all that came before they would take gigabytes.
TEST_F(Simulate, BoxesTakeTheMemoryOfBoxes) {
#ifdef HITOS_SANITIZED
    GTEST_SKIP() << "sanitizers need more address space than may be limited";
#endif
    std::ofstream world(folder_ / "boxes.toml");
    world << "walls = [[[-50, -50], [50, -50], [50, 50], [-50, 50], [-50, -50]]]\n"
             "[tour]\nstart = [0, 0, 0]\nrest = 0\ncommands = [[0.3, 0, 20]]\nevents = [\n";
    constexpr int kBoxes = 4000;
    constexpr int kRow = 60;
    for (int i = 0; i < kBoxes; ++i) {
        const int row = i / kRow;
        world << "{ at = " << 0.005 * i << ", box = [" << 20 + 0.4 * (i % kRow) << ", " << 0.4 * row
              << ", 0.3] },\n";
    }
    world << "]\n";
    world.close();
    const Result result =
        call("simulate " + in("boxes.toml") + " --out " + in("boxes.log"), "ulimit -v 1200000; ");
    EXPECT_EQ(result.status, 0) << result.said;
}

}  // namespace
}  // namespace hitos
