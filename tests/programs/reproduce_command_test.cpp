// SPDX-License-Identifier: GPL-3.0-or-later
// hitos-cli reproduce as a user calls it.
#include <algorithm>
#include <fstream>

#include "program.hpp"

namespace hitos::test {
namespace {

class ReproduceCommand : public ProgramTest {
  protected:
    Outcome reproduce(const std::string& arguments) const {
        return shell(cli_ + " reproduce " + arguments);
    }
};

TEST_F(ReproduceCommand, WritesTableDocumentAndPlotsOfOneFigureAndGoesOn) {
    const std::string arguments =
        "--only 10.28 --runs 1 --world tour.laps=1 --threads 2 --out " + path("two");
    const Outcome first = reproduce(arguments + " --report " + path("report.md"));
    ASSERT_EQ(first.status, 0) << first.output;
    EXPECT_NE(first.output.find("10 runs done, 0 found done, 0 failed"), std::string::npos)
        << first.output;
    const std::string csv = content(path("two/reproduction.csv"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 11);
    EXPECT_NE(csv.find("10.27/10.28,recinto,mlon,0.5,0.17,0.0045,8,"), std::string::npos) << csv;
    const std::string document = content(path("report.md"));
    EXPECT_NE(document.find("](report/10.27-recinto-mlon.png)"), std::string::npos);
    EXPECT_NE(document.find("## Summary"), std::string::npos);
    EXPECT_TRUE(fs::exists(path("two/reproduction.md")));
    for (const char* extension : {".dat", ".gp"})
        EXPECT_TRUE(fs::exists(path("two/plots/10.27-recinto-mlon") + extension)) << extension;
    const bool drawn = shell("command -v gnuplot").status == 0;
    EXPECT_EQ(fs::exists(path("two/plots/10.27-recinto-mlon.png")), drawn);
    EXPECT_EQ(fs::exists(path("report/10.27-recinto-mlon.png")), drawn);

    ASSERT_EQ(
        reproduce("--only 10.28 --runs 1 --world tour.laps=1 --threads 1 --out " + path("one"))
            .status,
        0);
    EXPECT_EQ(files("one"), files("two"));

    // What one that was killed left goes.
    const fs::path left = path("two/runs/10.27-recinto-mlon/s1-runs/.hitos-1-0.tmp");
    std::ofstream(left) << "half";
    ASSERT_TRUE(fs::exists(left));
    const Outcome again = reproduce(arguments);
    ASSERT_EQ(again.status, 0) << again.output;
    EXPECT_NE(again.output.find("0 runs done, 10 found done"), std::string::npos) << again.output;
    EXPECT_EQ(content(path("two/reproduction.csv")), csv);
    EXPECT_FALSE(fs::exists(left));
}

TEST_F(ReproduceCommand, TriesEveryReadingAndSetsThemSideBySide) {
    // One lap keeps it short; no reading is told from another by that.
    const Outcome outcome =
        reproduce("--only 10.28 --runs 1 --world tour.laps=1 --hypotheses --out " + path("all") +
                  " --report " + path("report.md"));
    ASSERT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("reading variances"), std::string::npos) << outcome.output;
    const std::string document = content(path("report.md"));
    EXPECT_NE(document.find("## Readings that were tried"), std::string::npos);
    EXPECT_NE(document.find("### As published"), std::string::npos);
    EXPECT_NE(document.find("tour.laps=1"), std::string::npos) << "what the call changed is told";
    const std::string thick = content(path("all/readings/thick-walls/reproduction.csv"));
    EXPECT_EQ(std::count(thick.begin(), thick.end(), '\n'), 11);
    EXPECT_NE(thick, content(path("all/reproduction.csv")));

    const Outcome one = reproduce(
        "--only 10.28 --runs 1 --world tour.laps=1 --reading thick-walls "
        "--out " +
        path("one"));
    ASSERT_EQ(one.status, 0) << one.output;
    EXPECT_EQ(content(path("one/reproduction.csv")), thick);
    EXPECT_NE(content(path("one/reproduction.md")).find("**This is the reading `thick-walls`**"),
              std::string::npos);
}

TEST_F(ReproduceCommand, ShowsExperimentsByMapsTheSameForAnyThreads) {
    const Outcome first = reproduce("--only 10.78 --only 10.58 --threads 2 --out " + path("two") +
                                    " --report " + path("report.md"));
    ASSERT_EQ(first.status, 0) << first.output;
    EXPECT_NE(first.output.find("4 runs shown by maps and counts done, 0 found done, 0 failed"),
              std::string::npos)
        << first.output;
    EXPECT_NE(first.output.find("experiments on recorded tours left out"), std::string::npos);
    EXPECT_FALSE(fs::exists(path("two/reproduction.csv"))) << "no figure with errors was named";
    const std::string document = content(path("report-maps.md"));
    EXPECT_NE(document.find("| [10.78](report-maps/10.78-iusiani-sensor_theta.png) | iusiani |"),
              std::string::npos);
    EXPECT_NE(document.find("| 17 | the lines are those of the place | "), std::string::npos);
    EXPECT_NE(document.find("| odometry alone |"), std::string::npos);
    EXPECT_NE(document.find("## Left out"), std::string::npos);
    EXPECT_TRUE(fs::exists(path("report-maps/10.58-iusiani-mpuntos.png")));
    const std::string csv = content(path("two/reproduction-maps.csv"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);

    ASSERT_EQ(reproduce("--only 10.78 --only 10.58 --threads 1 --out " + path("one")).status, 0);
    EXPECT_EQ(files("one"), files("two"));
    const Outcome again = reproduce("--only 10.78 --out " + path("one"));
    EXPECT_NE(again.output.find("0 runs shown by maps and counts done, 1 found done"),
              std::string::npos)
        << again.output;
}

TEST_F(ReproduceCommand, DoesWithoutGnuplot) {
    const Outcome outcome =
        shell("PATH=/nowhere " + cli_ + " reproduce --only 10.87 --runs 1 --out " + path("out"));
    ASSERT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("no plots: gnuplot is not installed"), std::string::npos)
        << outcome.output;
    EXPECT_NE(content(path("out/reproduction.md")).find("There are no plots"), std::string::npos);
    EXPECT_FALSE(fs::exists(path("out/plots/10.87-lineamedia-p.png")));
}

TEST_F(ReproduceCommand, RefusesWhatItCannotDo) {
    const auto refused = [&](const std::string& arguments, const std::string& words) {
        const Outcome outcome = reproduce(arguments + " --out " + path("out"));
        EXPECT_NE(outcome.status, 0) << arguments;
        EXPECT_NE(outcome.output.find(words), std::string::npos) << outcome.output;
        EXPECT_FALSE(fs::exists(path("out"))) << "something was written";
    };
    refused("--only 10.99", "10.99");
    refused("--runs 0", "expected 1 to");
    refused("--runs many", "many");
    refused("--threads -1", "--threads");
    refused("--reading no", "expected one of plain, ");
    refused("--reading stage --as-published", "excludes");
    refused("--world laser.rays=0", "laser.rays");
    refused("--set no.key=1", "no.key");
    refused("surplus", "surplus");
}

}  // namespace
}  // namespace hitos::test
