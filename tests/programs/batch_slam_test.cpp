// SPDX-License-Identifier: GPL-3.0-or-later
// BatchSLAM with the arguments of the thesis [T 9.2.7], and with all that can be wrong about them.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>

#include "program.hpp"

namespace hitos {
namespace {

using test::content;
using test::Outcome;
using test::shell;
using test::fs::exists;
using ::testing::HasSubstr;

class BatchSlam : public test::ProgramTest {
  protected:
    /// A configuration that names the log as it lies beside it.
    std::string config(const std::string& log = "tour.log.gz") const {
        test::fs::copy_file(log_, path("tour.log.gz"), test::fs::copy_options::overwrite_existing);
        return file("batch.cfg", "[source]\nfile = \"" + log +
                                     "\"\n[filter]\nparticles = 5\n[motion]\nsigma_x = 0.01\n"
                                     "sigma_y = 0.01\n[split_merge]\nmin_points = 9\n");
    }
    Outcome batch(const std::string& arguments) const { return shell(batch_ + " " + arguments); }
    static long lines(const std::string& text) {
        return std::count(text.begin(), text.end(), '\n');
    }
};

TEST_F(BatchSlam, TakesTheArgumentsOfTheThesis) {
    const Outcome result =
        batch(config() + " " + path("out/dmax.csv") + " " + map_ + " dmax 0.01 0.02");
    EXPECT_EQ(result.status, 0) << result.output;
    EXPECT_THAT(result.output, HasSubstr("10 runs to do"));
    EXPECT_THAT(result.output, HasSubstr("| 0.02 | 5 |"));
    const std::string quality = content(path("out/dmax.csv"));
    EXPECT_EQ(lines(quality), 11);
    EXPECT_THAT(quality, HasSubstr("\n0.02,5,ok,"));
    EXPECT_TRUE(exists(path("out/dmax-maps/dmax-0.01-s1.map")));
    EXPECT_TRUE(exists(path("out/dmax-maps/dmax-0.02-s5.map")));
    EXPECT_EQ(lines(content(path("out/dmax-summary.csv"))), 3);
    EXPECT_TRUE(exists(path("out/dmax-timing.csv")));
}

TEST_F(BatchSlam, EveryParameterCanBeVaried) {
    const std::string start = config() + " ";
    const auto one = [&](const std::string& name, const std::string& values) {
        const Outcome result = batch(start + path(name + ".csv") + " " + map_ + " " + name + " " +
                                     values + " --runs 1 --csv");
        EXPECT_EQ(result.status, 0) << result.output;
        EXPECT_EQ(lines(content(path(name + ".csv"))), 2) << name;
    };
    one("p", "3");
    one("dmax", "0.03");
    one("mlon", "0.6");
    one("mpuntos", "12");
    one("sensor", "0.01 0.0006");
    one("mov", "0.01 0.01 0.008");
    one("p0", "0.001");
    one("col", "0.2 0.1");
    one("es", "0.2");
}

TEST_F(BatchSlam, RunsASecondParameterAndOtherSeeds) {
    const Outcome result =
        batch(config() + " " + path("q.csv") + " " + map_ +
              " p 3 4 --second sensor 0.04 0.00122 0.01 0.0006 --seed 7 --runs 2 "
              "--threads 2 --csv");
    EXPECT_EQ(result.status, 0) << result.output;
    const std::string quality = content(path("q.csv"));
    EXPECT_EQ(lines(quality), 9);
    EXPECT_THAT(quality, HasSubstr("filter.particles,observation.var_rho,observation.var_theta,"));
    EXPECT_THAT(quality, HasSubstr("\n4,0.01,0.0006,8,ok,"));
    EXPECT_THAT(result.output, HasSubstr("\n4,0.01,0.0006,2,0,2,"));
}

TEST_F(BatchSlam, AWrongCountOfValuesNamesWhatIsExpected) {
    const auto said = [&](const std::string& what) {
        const Outcome result = batch(config() + " " + path("q.csv") + " " + map_ + " " + what);
        EXPECT_EQ(result.status, 1);
        return result.output;
    };
    EXPECT_EQ(said("sensor 0.04 0.001 0.01"),
              "BatchSLAM: sensor: found 3 values; each run takes 2 (variance of rho in m^2, "
              "variance of theta in rad^2)\n");
    EXPECT_THAT(said("mov 1 2 3 4"), HasSubstr("each run takes 3"));
    EXPECT_THAT(said("p 5 --second col 0.1"), HasSubstr("col: found 1 values; each run takes 2"));
    EXPECT_THAT(said("dmx 1"), HasSubstr("dmx: no such parameter; expected one of p, dmax, mlon"));
    EXPECT_FALSE(exists(path("q.csv")));
}

/// gnuplot runs what stands behind `<` or `|`, and lines of its script.
TEST_F(BatchSlam, NamesOfOutputsAreNoCommands) {
    const std::string start = config() + " ";
    int number = 0;
    for (const std::string name :
         {"< cd ..; touch HURT #", "|cd ..; touch HURT #", "a\nsystem(\"cd ..; touch HURT\")\n#",
          "`touch HURT`", "=1+1", "$(touch HURT)"}) {
        const std::string out = "out" + std::to_string(++number);
        test::fs::create_directory(path(out));
        const Outcome result = shell(fmt::format("cd '{}' && {} {}'{}.csv' - p 2 3 --runs 1",
                                                 path(out), batch_, start, name));
        EXPECT_EQ(result.status, 0) << result.output;
        EXPECT_TRUE(exists(path(out) + "/" + name + "-landmarks.gp")) << name;
    }
    for (const auto& entry : test::fs::recursive_directory_iterator(path("")))
        EXPECT_NE(entry.path().filename(), "HURT") << entry.path();
}

TEST_F(BatchSlam, AFailingRunIsReportedAndTheNextGoesOn) {
    const Outcome result =
        batch(config() + " " + path("q.csv") + " " + map_ + " dmax 0 0.02 --runs 1");
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.output,
                HasSubstr("run failed: dmax=0 seed 1: split_merge.dmax: 0 is out of"));
    EXPECT_THAT(content(path("q.csv")), HasSubstr("\n0.02,1,ok,"));
}

TEST_F(BatchSlam, HopelessThingsEndWithOneClearError) {
    const auto expect = [&](const std::string& arguments, const std::string& message) {
        const Outcome result = batch(arguments);
        EXPECT_EQ(result.status, 1) << arguments;
        EXPECT_THAT(result.output, HasSubstr("BatchSLAM: " + message)) << arguments;
        EXPECT_EQ(lines(result.output), 1) << result.output;
    };
    const std::string good = config();
    const std::string rest = " " + path("q.csv") + " " + map_ + " p 5";
    expect(path("none.cfg") + rest, path("none.cfg") + ": no such file");
    expect(file("bad.cfg", "[filter]\nparticle = 5\n") + rest, path("bad.cfg") + ":2: ");
    expect(file("empty.cfg", "") + rest, "source.file: found no file name in ");
    expect(config("gone.log") + rest, "gone.log: there is no such file");
    config();
    expect(good + " " + path("q.csv") + " " + path("none.map") + " p 5",
           path("none.map") + ": no such file");
    expect(
        good + " " + path("q.csv") + " " + file("bad.map", "rho: 1 theta: 2\nx: a y: 2\n") + " p 5",
        path("bad.map") + ":2: x is \"a\"; expected a finite number");
    expect(good + " " + folder_.path().string() + " " + map_ + " p 5",
           folder_.path().string() + ": is a folder; expected the path of the quality file");
    expect(good + " /proc/none/q.csv " + map_ + " p 5", "/proc/none: cannot make this output");
    EXPECT_NE(batch(good + " " + path("q.csv") + " " + map_ + " p").status, 0);
    EXPECT_NE(batch("").status, 0);
}

TEST_F(BatchSlam, HelpListsTheParameters) {
    for (const char* option : {"-h", "--help"}) {
        const Outcome help = batch(option);
        EXPECT_EQ(help.status, 0);
        for (const char* word : {"Config", "Salida", "Referencia", "Parametro", "Valores",
                                 "mpuntos  1:", "sensor   2:", "mov      3:", "--second"}) {
            EXPECT_THAT(help.output, HasSubstr(word));
        }
    }
}

}  // namespace
}  // namespace hitos
