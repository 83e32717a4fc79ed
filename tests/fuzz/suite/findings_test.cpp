// SPDX-License-Identifier: GPL-3.0-or-later
// What fuzzing has found, by what Hitos says now.
#include <gmock/gmock.h>

#include <string>

#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/log_writer.hpp"
#include "hitos/capture/procesador.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/configuration/configuracion.hpp"
#include "hitos/services/results/kept_run.hpp"
#include "hitos/services/results/results_check.hpp"
#include "hitos/services/study/study_check.hpp"
#include "hitos/simulation/worlds/world.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::message_of;
using test::TempFolder;
using ::testing::HasSubstr;
using ::testing::Not;

/// What reading a study says whose plan has these seeds and, of two parameters, so many values.
std::string refused_plan(const std::string& seeds, int values) {
    std::string list = R"(["0"])";
    for (int i = 1; i < values; ++i) list += ",[\"" + std::to_string(i) + "\"]";
    const std::string axis =
        R"({"name": "p", "keys": ["k"], "units": [""], "values": [)" + list + "]}";
    const TempFolder folder;
    folder.put("study.json",
               R"({"format": "hitos-study 3", "parameters": [)" + axis + "," + axis +
                   R"(], "first_seed": 1, "seeds": )" + seeds +
                   R"(, "source": "", "setting": "", "digest": "", "reference_lines": 0,)" +
                   R"("reference_corners": 0, "grid": false, "pictures": "none"})");
    return message_of<FormatError>([&] { check_study(study_in_folder(folder.path())); });
}

TEST(Findings, AStudyOfAbsurdSizeIsRefusedAtOnce) {
    for (const std::string seeds : {"2147483647", "1000001"}) {
        EXPECT_THAT(refused_plan(seeds, 1), HasSubstr("more than 1000000 runs"));
    }
    constexpr int kThousands = 3000;
    EXPECT_THAT(refused_plan("1", kThousands), HasSubstr("more than 1000000 runs"));
    constexpr std::size_t kDeep = 1000000;
    EXPECT_THAT(refused_plan(std::string(kDeep, '[') + std::string(kDeep, ']'), 1),
                HasSubstr("is nested deeper than 64 levels"));
    for (const std::string seeds : {"1e300", "-1", "4294967296"}) {
        EXPECT_THAT(refused_plan(seeds, 1),
                    HasSubstr("seeds is " + (seeds == "1e300" ? "1e+300" : seeds) +
                              "; expected a whole number"));
    }
    EXPECT_THAT(refused_plan("0", 1), HasSubstr("the plan is damaged"));
}

/// What reading a folder of results says whose summary counts so.
std::string refused_summary(const std::string& scans, const std::string& lines) {
    const TempFolder folder;
    folder.put("summary.json", R"({"run_seconds": 1, "scans": )" + scans +
                                   R"(, "landmarks": {"corners": 1, "lines": )" + lines + "}}");
    return message_of<FormatError>([&] { read_results(folder.path()); });
}

TEST(Findings, ASummaryCountsInWholeNumbers) {
    EXPECT_THAT(refused_summary("-1", "1"), HasSubstr("scans is -1; expected a whole number"));
    EXPECT_THAT(refused_summary("1", "1e300"), HasSubstr("lines is 1e+300; expected a whole"));
    EXPECT_THAT(refused_summary("1", "2147483648"), HasSubstr("from 0 to 2147483647"));
}

TEST(Findings, WhatCannotBeAFileIsNone) {
    constexpr std::size_t kTooLong = 300;
    const std::string name(kTooLong, 'x');
    EXPECT_THAT(message_of<FileError>([&] { check_results(name); }), HasSubstr("cannot be read"));
    EXPECT_THAT(message_of<FormatError>([&] {
                    parse_world("walls_dxf = \"" + name + "\"\n[tour]\nway_points = [[1, 1]]\n",
                                "some.toml");
                }),
                HasSubstr("no such file"));
}

TEST(Findings, MessagesShowControlCharacters) {
    Configuracion configuration;
    const std::string assignment("a\0b\x1b[2J=1", 9);
    EXPECT_THAT(message_of<ConfigError>([&] { set_parameter(configuration, assignment); }),
                HasSubstr("a\\x00b\\x1b[2J"));
}

TEST(Findings, AConfigurationOfMistakesAloneIsRefusedAtOnce) {
    std::string text;
    constexpr int kMistakes = 100000;
    for (int i = 0; i < kMistakes; ++i) text += "a" + std::to_string(i) + " = 1\n";
    EXPECT_THAT(message_of<FormatError>([&] { ArchivoConfiguracion::parse(text, "some.cfg"); }),
                HasSubstr("100 mistakes and perhaps more:"));
}

TEST(Findings, ALongLineIsCalledLong) {
    const TempFolder folder;
    const auto file = folder.put("x.log", std::string(3 * kLongestLine, 'x'));
    EXPECT_THAT(message_of<FormatError>([&] { open_log(file); }),
                testing::AllOf(HasSubstr("holds lines longer than 1 MiB"),
                               Not(HasSubstr("control characters"))));
}

/// The text of the log in CARMEN's format.
std::string as_carmen(const TempFolder& folder, std::string_view log) {
    Procesador reader(open_log(folder.put("in.log", log)));
    const auto target = folder / "out.log";
    const auto writer = make_log_writer("carmen", target);
    write_tour(reader, *writer);
    writer->finish();
    return test::content(target);
}

TEST(Findings, ALogWhoseFanChangesIsNotWrittenByHalves) {
    // A reader of CARMEN takes the scans of one message alone.
    constexpr std::string_view kHalfCircle = "FLASER 3 1 1 2 0 0 0 0.1 0 0 1.1 h 1.1\n";
    constexpr std::string_view kNarrow =
        "PARAM laser_front_laser_resolution 20 h 0\nFLASER 3 1 1 2 0 0 0 0.2 0 0 1.2 h 1.2\n";
    const TempFolder folder;
    EXPECT_THAT(message_of<FormatError>(
                    [&] { as_carmen(folder, std::string(kHalfCircle).append(kNarrow)); }),
                testing::AllOf(HasSubstr("the scan of line 3"), HasSubstr("FLASER")));
    EXPECT_FALSE(std::filesystem::exists(folder / "out.log"));

    constexpr std::string_view kWide =
        "PARAM laser_front_laser_resolution 90 h 0\nFLASER 3 1 1 2 0 0 0 0.3 0 0 1.3 h 1.3\n";
    EXPECT_THAT(as_carmen(folder, std::string(kNarrow).append(kWide)), Not(HasSubstr("\nFLASER")));
    Procesador again(open_log(folder / "out.log"));
    EXPECT_TRUE(again.next_scan());
    EXPECT_TRUE(again.next_scan());
}

}  // namespace
}  // namespace hitos
