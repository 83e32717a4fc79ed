// SPDX-License-Identifier: GPL-3.0-or-later
// The files that a run writes where it is asked to, read by other programs.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

#include "program.hpp"

namespace hitos {
namespace {

using test::content;
using test::Outcome;
using test::shell;
using ::testing::HasSubstr;

class WrittenFiles : public test::ProgramTest {
  protected:
    std::string run(const std::string& tour, const std::string& more, const char* out) const {
        std::string command = cli_;
        command.append(" run ").append(tour).append(" --config ").append(config_);
        command.append(" --set filter.particles=20 --strict ").append(more);
        return command.append(" --out ").append(path(out));
    }
    std::string written(const char* out, const char* name) const {
        return content(test::fs::path(path(out)) / name);
    }
};

TEST_F(WrittenFiles, OfALogAndOfAWorldAreWhatOtherProgramsTakeThemFor) {
    if (shell("python3 -c 'import xml'").status != 0) GTEST_SKIP() << "there is no python3";
    const std::string world = test::kSource + "/data/worlds/recinto.toml";
    for (const auto& [tour, out] : {std::pair(log_, "log"), std::pair(world, "world")}) {
        const Outcome outcome = shell(run(tour, "--write all", out));
        ASSERT_EQ(outcome.status, 0) << outcome.output;
        const Outcome found = shell(test::kSource + "/tests/programs/read_outputs.py " + path(out));
        EXPECT_EQ(found.status, 0) << found.output;
        for (const char* name : {"map.yaml: ", "map.xml: ", "landmarks.csv: ", "graph.g2o: ",
                                 "corrected.log: ", "map.svg: "}) {
            EXPECT_THAT(found.output, HasSubstr(name));
        }
        EXPECT_EQ(shell(cli_ + " verify " + path(out)).status, 0);
    }
}

TEST_F(WrittenFiles, AreTheSameWithAnyNumberOfThreads) {
    ASSERT_EQ(shell(run(log_, "--write all --threads 1", "1")).status, 0);
    ASSERT_EQ(shell(run(log_, "--write all --threads 3", "3")).status, 0);
    for (const char* name : {"map.svg", "map.pdf", "map.yaml", "map.pgm", "map.xml",
                             "landmarks.csv", "graph.g2o", "corrected.log"}) {
        EXPECT_FALSE(written("1", name).empty()) << name;
        EXPECT_EQ(written("1", name), written("3", name)) << name;
    }
}

TEST_F(WrittenFiles, AFigureIsOneToPoppler) {
    if (shell("pdfinfo -v").status == 127) GTEST_SKIP() << "poppler-utils is not installed";
    ASSERT_EQ(shell(run(log_, "--write map.pdf", "out")).status, 0);
    const Outcome facts = shell("pdfinfo " + path("out/map.pdf"));
    EXPECT_THAT(facts.output, HasSubstr("bigloop.log.gz"));
    EXPECT_THAT(facts.output, HasSubstr("Pages:           1\n"));
    EXPECT_THAT(facts.output, HasSubstr("Page size:       240.9"));  // 85 mm
    const Outcome words = shell("pdftotext -layout " + path("out/map.pdf") + " -");
    EXPECT_EQ(words.status, 0);
    for (const char* word : {"x [m]", "y [m]", "line landmarks", "uncertainty, 2 \xcf\x83"}) {
        EXPECT_THAT(words.output, HasSubstr(word));
    }
    EXPECT_THAT(facts.output + words.output, ::testing::Not(HasSubstr("Error")));
    const Outcome fonts = shell("pdffonts " + path("out/map.pdf"));
    EXPECT_THAT(fonts.output, HasSubstr("DejaVuSans")) << "the font of the packages";
    EXPECT_THAT(fonts.output, HasSubstr("yes yes yes")) << "embedded, in part, with its letters";
}

TEST_F(WrittenFiles, AreThoseThatWereAskedFor) {
    ASSERT_EQ(shell(run(log_, "--write svg,map.pgm", "out")).status, 0);
    const auto summary = nlohmann::json::parse(written("out", "summary.json"));
    std::set<std::string> named;
    for (const auto& file : summary["files"]) named.insert(file["name"]);
    for (const char* name : {"map.svg", "map.pgm", "map.yaml"}) EXPECT_TRUE(named.contains(name));
    EXPECT_FALSE(test::fs::exists(path("out/graph.g2o")));
    const Outcome help = shell(cli_ + " run --help");
    for (const char* word : {"map-server", "corrected.log", "IEEE 1873-2015"}) {
        EXPECT_THAT(help.output, HasSubstr(word));
    }
}

TEST_F(WrittenFiles, AnUnknownNameIsToldBeforeTheRun) {
    const Outcome outcome = shell(run(log_, "--write map.sgv", "out"));
    EXPECT_GT(outcome.status, 0);
    EXPECT_LT(outcome.status, 128);
    EXPECT_THAT(outcome.output, HasSubstr("found \"map.sgv\""));
    EXPECT_THAT(outcome.output, HasSubstr("did you mean map.svg"));
    EXPECT_FALSE(test::fs::exists(path("out")));
}

}  // namespace
}  // namespace hitos
