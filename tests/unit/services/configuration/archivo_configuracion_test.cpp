// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/configuration/archivo_configuracion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "hitos/base/error.hpp"
#include "hitos/registration/graph_edit.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::message_of;
using test::TempFolder;
using ::testing::HasSubstr;
using Type = ConfigParameter::Type;

void expect_equal(const Configuracion& a, const Configuracion& b) {
    for (const ConfigParameter& p : parameters()) {
        if (p.type == Type::real) {
            EXPECT_EQ(std::bit_cast<std::uint64_t>(std::get<double>(p.get(a))),
                      std::bit_cast<std::uint64_t>(std::get<double>(p.get(b))))
                << p.key;
        } else {
            EXPECT_EQ(p.text(a), p.text(b)) << p.key;
        }
    }
}

Configuracion random_configuration(std::mt19937_64& random) {
    Configuracion c;
    for (const ConfigParameter& p : parameters()) {
        switch (p.type) {
            case Type::real:
                p.put(c, std::uniform_real_distribution(p.minimum, p.maximum)(random));
                break;
            case Type::integer:
                p.put(c, std::uniform_int_distribution<std::int64_t>(
                             static_cast<std::int64_t>(p.minimum),
                             p.maximum > 1e18 ? INT64_MAX
                                              : static_cast<std::int64_t>(p.maximum))(random));
                break;
            case Type::choice:
                p.put(c, p.choices[random() % p.choices.size()].word);
                break;
            case Type::text: {
                std::string text;
                for (int i = 0; i < 30; ++i) text += static_cast<char>(random() % 0x80);
                p.put(c, text + "ñ→𝄞");
                break;
            }
        }
    }
    return c;
}

FormatError error_of(const std::string& text) {
    try {
        ArchivoConfiguracion::parse(text, "x.cfg");
    } catch (const FormatError& error) {
        return error;
    }
    ADD_FAILURE() << "nothing was thrown";
    return {"", 0, {}};
}

TEST(ArchivoConfiguracion, AnEmptyFileGivesTheDefaults) {
    expect_equal(ArchivoConfiguracion::parse("", "x"), Configuracion{});
    expect_equal(ArchivoConfiguracion::parse("# nothing\n\n[grid]\n", "x"), Configuracion{});
}

TEST(ArchivoConfiguracion, ReadsEveryTypeOverTheDefaults) {
    const Configuracion c = ArchivoConfiguracion::parse(
        "run.threads = 2\n"
        "[grid]\nresolution = 1\nmiss = -2.5e-1\n"
        "[source]\nfile = 'C:\\a'\nformat = \"radish\"\r\n",
        "x");
    Configuracion expected;
    expected.run.threads = 2;
    expected.grid.resolution_m = 1.0;
    expected.grid.log_odds_miss = -0.25;
    expected.source.file = "C:\\a";
    expected.source.format = "radish";
    expect_equal(c, expected);
}

TEST(ArchivoConfiguracion, TextReadsBackToTheLastBit) {
    std::mt19937_64 random(11);
    for (int i = 0; i < 200; ++i) {
        Configuracion c = random_configuration(random);
        // What check() refuses together is met with probability 0, but for these.
        c.grid.max_range_m = 100.0;
        c.filter.association.new_probability = 0.9999995;
        c.registration.edits = "slip 7\n# a comment\nrefuse 9@1.5 3";
        c.source.start = "1, -2.5,90";
        c.source.map.clear();
        const std::string text = ArchivoConfiguracion::to_text(c);
        const Configuracion back = ArchivoConfiguracion::parse(text, "x");
        expect_equal(back, c);
        EXPECT_EQ(ArchivoConfiguracion::to_text(back), text);
    }
}

TEST(ArchivoConfiguracion, ChangesByHandAreReadFromPlainLinesToo) {
    const TempFolder folder;
    const std::string lines = "# of a friend\nslip 55  # wet [floor]\nrefuse 60 3\n";
    const auto file = folder.put("edits.txt", lines);
    EXPECT_EQ(text_of(parse_graph_edits(ArchivoConfiguracion::read_edits(file))),
              text_of(parse_graph_edits(lines)));
    const auto wrong = folder.put("wrong.txt", "slip 55\nopen 3\n");
    EXPECT_THAT(message_of<FormatError>([&] { ArchivoConfiguracion::read_edits(wrong); }),
                testing::AllOf(HasSubstr("wrong.txt: change 2"), HasSubstr("open")));
}

TEST(ArchivoConfiguracion, ChangesByHandReadBackWhateverTheirCommentsHold) {
    const TempFolder folder;
    for (const char* comment : {"plain", R"(a """ b)", R"(C:\temp\new)", R"(ends \)", "tab\there",
                                "# and ; more", "ñ→𝄞", "'''"}) {
        const std::string edits = std::string("slip 55 # ") + comment + "\nslip 60\n";
        const auto file = folder.put("edits.toml", ArchivoConfiguracion::edits_text("Why", edits));
        EXPECT_EQ(text_of(parse_graph_edits(ArchivoConfiguracion::read_edits(file))),
                  text_of(parse_graph_edits(edits)))
            << comment;
        Configuracion c;
        c.registration.edits = edits;
        const std::string text = ArchivoConfiguracion::to_text(c);
        EXPECT_EQ(ArchivoConfiguracion::parse(text, "x").registration.edits, edits);
    }
}

TEST(ArchivoConfiguracion, TextKeepsTheSignOfZero) {
    Configuracion c;
    c.grid.log_odds_miss = -0.0;
    expect_equal(ArchivoConfiguracion::parse(ArchivoConfiguracion::to_text(c), "x"), c);
}

TEST(ArchivoConfiguracion, TextExplainsEveryParameter) {
    Configuracion c;
    c.extraction.split_merge.dmax_m = 0.03;
    const std::string text = ArchivoConfiguracion::to_text(c);
    EXPECT_THAT(text, HasSubstr("\n[split_merge]\n\n"
                                "# Greatest distance Dmax of a point from its line; a higher value "
                                "makes fewer and rougher lines.\n"
                                "# Allowed: 1e-06 to 10 m. Default: 0.02.\n"
                                "dmax = 0.03\n"));
    EXPECT_THAT(text,
                HasSubstr("# Allowed: one of ml, gnn, jcbb. Default: \"ml\".\nmethod = \"ml\"\n"));
    EXPECT_THAT(text, HasSubstr("# Allowed: integers from 1 to 1000000. Default: 100.\n"
                                "particles = 100\n"));
    std::size_t lines = 0;
    for (std::string_view rest = text; !rest.empty(); ++lines) {
        const std::size_t end = rest.find('\n');
        EXPECT_LE(end, 100U) << rest.substr(0, end);
        rest.remove_prefix(end + 1);
    }
    EXPECT_GT(lines, 4 * parameters().size());
}

TEST(ArchivoConfiguracion, RefusesToWriteWhatTomlCannotHold) {
    for (const char* path : {"caf\xe9", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe2\x82",
                             "\x80", "\xe0\x80\x80", "\xf0\x80\x80\x80"}) {
        Configuracion c;
        c.source.file = path;
        EXPECT_THAT(message_of<ConfigError>([&] { ArchivoConfiguracion::to_text(c); }),
                    HasSubstr("is not UTF-8 and cannot stand in a configuration file"));
    }
}

TEST(ArchivoConfiguracion, NamesUnknownKeysAndNearOnesWithTheLine) {
    const FormatError error = error_of("[split_merge]\ndmax = 0.1\nmin_point = 3\n");
    EXPECT_EQ(error.line(), 3U);
    EXPECT_STREQ(error.what(),
                 "x.cfg:3: split_merge.min_point: no such parameter; did you mean "
                 "split_merge.min_points?");
}

TEST(ArchivoConfiguracion, NamesUnknownGroups) {
    EXPECT_STREQ(error_of("\n[splitmerge]\ndmax = 0.1\n").what(),
                 "x.cfg:3: splitmerge.dmax: no such parameter; did you mean split_merge.dmax?");
    EXPECT_STREQ(error_of("\n[splitmerge]\n").what(), "x.cfg:2: [splitmerge]: no such group");
    EXPECT_STREQ(error_of("dmax = 1.0").what(),
                 "x.cfg:1: dmax: no such parameter; did you mean split_merge.dmax?");
    EXPECT_STREQ(error_of("grid = 3").what(),
                 "x.cfg:1: grid: found an integer; expected a table [grid]");
}

TEST(ArchivoConfiguracion, NamesWrongTypes) {
    EXPECT_STREQ(error_of("[filter]\nparticles = 10.0").what(),
                 "x.cfg:2: filter.particles: found a real number; expected an integer, integers "
                 "from 1 to 1000000");
    EXPECT_STREQ(error_of("grid.limit = \"5\"").what(),
                 "x.cfg:1: grid.limit: found a string; expected a number, 0.1 to 100 log-odds");
    EXPECT_STREQ(error_of("source.file = true").what(),
                 "x.cfg:1: source.file: found a boolean; expected a string in quotes, any text");
    EXPECT_THAT(error_of("grid.limit = [5]").what(), HasSubstr("found an array"));
    EXPECT_THAT(error_of("[grid.limit]").what(), HasSubstr("found a table"));
    EXPECT_THAT(error_of("features.detect = 1979-05-27").what(),
                HasSubstr("found a date or time; expected a string in quotes, one of lines"));
}

TEST(ArchivoConfiguracion, NamesValuesThatAreNotAllowed) {
    EXPECT_STREQ(error_of("[grid]\n\nlimit = 0").what(),
                 "x.cfg:3: grid.limit: 0 is out of range; allowed: 0.1 to 100 log-odds");
    EXPECT_THAT(error_of("grid.limit = nan").what(), HasSubstr("nan is out of range"));
    EXPECT_THAT(error_of("grid.limit = inf").what(), HasSubstr("inf is out of range"));
    EXPECT_THAT(error_of("motion.model = 'fast'").what(),
                HasSubstr("\"fast\" is none of the choices; allowed: one of odometry"));
}

TEST(ArchivoConfiguracion, TellsAllMistakesAtOnceByLine) {
    const FormatError error =
        error_of("[split_merge]\nmin_points = 1\n[grid]\nlimit = 'x'\n[filter]\npartcles = 3\n");
    EXPECT_EQ(error.line(), 2U);
    EXPECT_STREQ(error.what(),
                 "x.cfg:2: 3 mistakes:\n"
                 "  line 2: split_merge.min_points: 1 is out of range; allowed: integers from 2 to "
                 "10000\n"
                 "  line 4: grid.limit: found a string; expected a number, 0.1 to 100 log-odds\n"
                 "  line 6: filter.partcles: no such parameter; did you mean filter.particles?");
}

TEST(ArchivoConfiguracion, TellsImpossibleCombinationsWithTheLineOfTheirKey) {
    const FormatError error = error_of("[grid]\nhit = 0\nmiss = 0\nmax_range = 9\n");
    EXPECT_EQ(error.line(), 2U);
    EXPECT_THAT(error.what(), HasSubstr("x.cfg:2: grid.hit: grid.hit and grid.miss both 0"));
    EXPECT_EQ(error_of("motion.model = 'no-odometry'\nmotion.sigma_x = 0\nmotion.sigma_y = 0.0\n"
                       "motion.sigma_theta = 0")
                  .line(),
              1U);
}

TEST(ArchivoConfiguracion, TellsBadTomlWithTheLine) {
    EXPECT_EQ(error_of("[grid]\nlimit = \n").line(), 2U);
    EXPECT_EQ(error_of("[grid]\nlimit = 1.0\nlimit = 2.0\n").line(), 3U);
    EXPECT_STREQ(error_of("[grid]\n\n# caf\xe9\n").what(),
                 "x.cfg:3: found the byte 0xe9; expected UTF-8 text");
    EXPECT_THAT(error_of("[grid\n").what(), HasSubstr("x.cfg:1: "));
}

TEST(ArchivoConfiguracion, WritesAndReadsFiles) {
    const TempFolder folder;
    Configuracion c;
    c.grid.resolution_m = 0.1 + 0.2;
    const auto path = folder / "a.cfg";
    ArchivoConfiguracion::write(c, path);
    EXPECT_EQ(test::content(path), ArchivoConfiguracion::to_text(c));
    expect_equal(ArchivoConfiguracion::read(path), c);
    EXPECT_EQ(folder.files(), 1U);
}

TEST(ArchivoConfiguracion, LooksForTheLogBesideTheFile) {
    const TempFolder folder;
    const auto file = folder.put("a.cfg", "[source]\nfile = \"tour-of-this-test.log\"\n");
    EXPECT_EQ(ArchivoConfiguracion::read(file).source.file, "tour-of-this-test.log");  // nowhere
    const auto log = folder.put("tour-of-this-test.log", "ODOM 0 0 0\n");
    EXPECT_EQ(ArchivoConfiguracion::read(file).source.file, log.string());
    const auto absolute = folder.put("b.cfg", "[source]\nfile = \"/none/tour.log\"\n");
    folder.put("tour.log", "");
    EXPECT_EQ(ArchivoConfiguracion::read(absolute).source.file, "/none/tour.log");
    const auto without = folder.put("c.cfg", "[filter]\nparticles = 7\n");
    EXPECT_EQ(ArchivoConfiguracion::read(without).source.file, "");
    EXPECT_EQ(ArchivoConfiguracion::read(without).filter.particles, 7);
}

TEST(ArchivoConfiguracion, NamesTheLogSoThatItIsFoundFromEverywhere) {
    const TempFolder folder;
    const auto named = [&](const std::filesystem::path& log) {
        Configuracion c;
        c.source.file = log.string();
        ArchivoConfiguracion::write(c, folder / "a.cfg");
        return ArchivoConfiguracion::parse(test::content(folder / "a.cfg"), "a.cfg").source.file;
    };
    EXPECT_EQ(named(folder / "tour.log"), "tour.log");
    EXPECT_EQ(named(folder / "logs/../logs/tour.log"), "logs/tour.log");
    EXPECT_EQ(named("/none/tour.log"), "/none/tour.log");
    EXPECT_EQ(named("data/tour.log"), std::filesystem::current_path() / "data/tour.log");
    EXPECT_EQ(named(""), "");
}

TEST(ArchivoConfiguracion, MessagesNameTheFileThatWasRead) {
    const TempFolder folder;
    const auto path = folder.put("bad.cfg", "\nx = 1\n");
    EXPECT_THAT(message_of<FormatError>([&] { ArchivoConfiguracion::read(path); }),
                HasSubstr(path.string() + ":2: x: no such parameter"));
    const auto missing = folder / "none.cfg";
    EXPECT_EQ(message_of<FileError>([&] { ArchivoConfiguracion::read(missing); }),
              missing.string() + ": no such file");
    EXPECT_THAT(message_of<FileError>([&] { ArchivoConfiguracion::read(folder.path()); }),
                HasSubstr("is a directory"));
}

TEST(ArchivoConfiguracion, AFailedWriteLeavesTheFileThatWasThere) {
    const TempFolder folder;
    const auto file = folder.put("file", "precious");
    const auto below = file / "a.cfg";
    EXPECT_THAT(message_of<FileError>([&] { ArchivoConfiguracion::write({}, below); }),
                HasSubstr(below.string()));
    Configuracion bad;
    bad.source.file = "\xff";
    EXPECT_THROW(ArchivoConfiguracion::write(bad, file), ConfigError);
    EXPECT_EQ(test::content(file), "precious");
    EXPECT_EQ(folder.files(), 1U);
}

std::filesystem::path shipped(std::string_view name) {
    return std::filesystem::path(HITOS_SOURCE_DIR) / "config" / name;
}

TEST(ShippedConfigurations, InitIsTheTextOfTheDefaults) {
    EXPECT_EQ(test::content(shipped("init.cfg")), ArchivoConfiguracion::to_text({}));
}

TEST(ShippedConfigurations, ThesisIsTheTableOfTheThesis) {
    const Configuracion c = ArchivoConfiguracion::read(shipped("thesis.cfg"));
    Configuracion expected;  // [T table 10.17]
    expected.source.world_set = "laser.sigma=0.003";
    expected.source.read.odometry = OdometryFrom::velocities;  // [T 1.3, 9.2.2]
    expected.grid.path_marks = PathMarks::cross_and_ring;      // as its figures have them
    expected.filter.particles = 100;
    expected.filter.resampling.rule = ResamplingRule::always;
    expected.filter.association.p0 = 0.005;
    expected.extraction.lines.min_points = 9;
    expected.extraction.split_merge.dmax_m = 0.02;
    expected.extraction.lines.min_length_m = 0.4;
    expected.filter.motion.model = "odometry";
    expected.filter.motion.sigma_x_m = expected.filter.motion.sigma_y_m = 0.01;
    expected.filter.motion.sigma_theta_rad = 0.008;
    expected.filter.observation = {0.04, 0.00122};
    expect_equal(c, expected);
}

TEST(ShippedConfigurations, RecordedIsForRealRobots) {
    for (const auto& [name, model] : {std::pair{"recorded.cfg", "registered"},
                                      std::pair{"recorded-fastslam1.cfg", "proportional"}}) {
        const Configuracion c = ArchivoConfiguracion::read(shipped(name));
        EXPECT_EQ(c.filter.motion.model, model);
        EXPECT_EQ(c.extraction.split_merge.fit, LineFit::least_squares);
        EXPECT_GT(c.extraction.split_merge.gap_m, 0.0);
    }
}

TEST(ShippedConfigurations, PaperIsThePaper) {
    const Configuracion c = ArchivoConfiguracion::read(shipped("paper.cfg"));
    EXPECT_EQ(c.filter.algorithm, "ekf-slam");
    EXPECT_EQ(c.filter.motion.model, "increments");
    EXPECT_EQ(c.filter.association.method, AssociationMethod::gated_nearest);
    EXPECT_EQ(c.filter.association.gate_probability, c.filter.association.new_probability);
    EXPECT_EQ(c.filter.association.ambiguity, AmbiguityRule::off);
    EXPECT_EQ(c.extraction.method, "ransac");
    EXPECT_EQ(c.extraction.ransac.order, RansacOrder::ransac_first);
    EXPECT_EQ(c.extraction.detect, Detection::lines);
    EXPECT_EQ(c.extraction.lines.collinear.rho_m, 0.0);
}

/// The short files say only what differs from the defaults.
TEST(ShippedConfigurations, HoldNothingThatIsADefault) {
    for (const char* name : {"simulated.cfg", "thesis.cfg", "ekf.cfg", "paper.cfg", "recorded.cfg",
                             "recorded-fastslam1.cfg", "landmarks.cfg", "trees.cfg"}) {
        const Configuracion c = ArchivoConfiguracion::read(shipped(name));
        std::size_t differing = 0;
        for (const ConfigParameter& p : parameters())
            differing += p.text(c) != p.text({}) ? 1U : 0U;
        const std::string text = test::content(shipped(name));
        std::size_t set = 0;
        for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1) {
            const std::string line = text.substr(at, text.find('\n', at) - at);
            if (!line.starts_with('#') && line.find('=') != std::string::npos) ++set;
        }
        EXPECT_EQ(set, differing) << name;
    }
}

}  // namespace
}  // namespace hitos
