// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/study/study_values.hpp"

#include <gmock/gmock.h>

#include "hitos/base/error.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/configuration/configuracion.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::message_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

StudyParameter with_values(std::string_view name, const std::vector<std::string>& words) {
    StudyParameter parameter = find_thesis_parameter(name);
    set_values(parameter, words);
    return parameter;
}

TEST(StudyValues, EveryThesisNameStandsForKeysThatExist) {
    std::vector<std::string_view> names;
    for (const ThesisParameter& thesis : thesis_parameters()) {
        names.push_back(thesis.name);
        for (const std::string_view key : thesis.keys) EXPECT_EQ(find_parameter(key).key, key);
        EXPECT_EQ(find_study_parameter(thesis.name).keys.size(), thesis.keys.size());
    }
    EXPECT_THAT(names,
                ElementsAre("p", "dmax", "mlon", "mpuntos", "sensor", "mov", "p0", "col", "es"));
}

TEST(StudyValues, SensorTakesPairsMovTriplesColPairsAndTheOthersOne) {
    EXPECT_THAT(with_values("p", {"5", "10"}).values,
                ElementsAre(StudyValue{"5"}, StudyValue{"10"}));
    EXPECT_THAT(with_values("sensor", {"1", "2", "3", "4"}).values,
                ElementsAre(StudyValue{"1", "2"}, StudyValue{"3", "4"}));
    EXPECT_THAT(with_values("mov", {"1", "2", "3", "4", "5", "6"}).values,
                ElementsAre(StudyValue{"1", "2", "3"}, StudyValue{"4", "5", "6"}));
    EXPECT_THAT(with_values("col", {"0.1", "0.07"}).values, ElementsAre(StudyValue{"0.1", "0.07"}));
}

TEST(StudyValues, AWrongCountNamesWhatIsExpected) {
    EXPECT_EQ(message_of<ConfigError>([] {
                  with_values("sensor", {"1", "2", "3"});
              }),
              "sensor: found 3 values; each run takes 2 (variance of rho in m^2, variance of theta "
              "in rad^2)");
    EXPECT_THAT(message_of<ConfigError>([] {
                    with_values("mov", {"1", "2"});
                }),
                HasSubstr("found 2 values; each run takes 3 (standard deviation of x in m, of y"));
    EXPECT_THAT(message_of<ConfigError>([] { with_values("col", {"1"}); }), HasSubstr("takes 2"));
    EXPECT_THAT(message_of<ConfigError>([] { with_values("p", {}); }), HasSubstr("found 0 values"));
}

TEST(StudyValues, AWrongNameListsTheNames) {
    EXPECT_EQ(message_of<ConfigError>([] { find_thesis_parameter("split_merge.dmax"); }),
              "split_merge.dmax: no such parameter; expected one of p, dmax, mlon, mpuntos, "
              "sensor, mov, p0, col, es");
    EXPECT_THAT(message_of<ConfigError>([] { find_study_parameter("split_merge.dmx"); }),
                HasSubstr("did you mean split_merge.dmax"));
    EXPECT_THAT(message_of<ConfigError>([] { find_study_parameter("split_merge.dmax+"); }),
                HasSubstr("no such parameter"));
    EXPECT_THAT(
        message_of<ConfigError>([] { find_study_parameter("split_merge.dmax+split_merge.dmax"); }),
        HasSubstr("names a key twice"));
}

TEST(StudyValues, AssignmentsTakeListsRangesAndTuples) {
    const StudyParameter dmax = parse_study_parameter("split_merge.dmax = 0.01, 0.02");
    EXPECT_EQ(dmax.name, "split_merge.dmax");
    EXPECT_THAT(dmax.values, ElementsAre(StudyValue{"0.01"}, StudyValue{"0.02"}));
    EXPECT_THAT(parse_study_parameter("p=5,10:30:10").values,
                ElementsAre(StudyValue{"5"}, StudyValue{"10"}, StudyValue{"20"}, StudyValue{"30"}));
    EXPECT_THAT(parse_study_parameter("sensor=0.04/0.001,0.01/0.0005").values,
                ElementsAre(StudyValue{"0.04", "0.001"}, StudyValue{"0.01", "0.0005"}));
    const StudyParameter joined = parse_study_parameter("association.p0+split_merge.dmax=1/2");
    EXPECT_THAT(joined.keys, ElementsAre("association.p0", "split_merge.dmax"));
    EXPECT_THAT(joined.values, ElementsAre(StudyValue{"1", "2"}));
    // Neither a path nor a word with a colon is taken apart.
    EXPECT_THAT(parse_study_parameter("source.file=a/b.log,c:d:e").values,
                ElementsAre(StudyValue{"a/b.log"}, StudyValue{"c:d:e"}));
}

TEST(StudyValues, OfTextsThatMayBeLeftOutAreEmptyToo) {
    const StudyParameter edits = parse_study_parameter("registration.edits=,refuse 1128 1");
    ASSERT_EQ(edits.values.size(), 2U);
    EXPECT_THAT(edits.values[0], ElementsAre(""));
    EXPECT_THAT(edits.values[1], ElementsAre("refuse 1128 1"));
    EXPECT_THROW(parse_study_parameter("motion.model=,odometry"), ConfigError);
}

TEST(StudyValues, BadAssignmentsSayWhatIsWrong) {
    EXPECT_THAT(message_of<ConfigError>([] { parse_study_parameter("p"); }),
                HasSubstr("expected name=value,value"));
    EXPECT_THAT(message_of<ConfigError>([] { parse_study_parameter("p="); }),
                HasSubstr("empty value"));
    EXPECT_THAT(message_of<ConfigError>([] { parse_study_parameter("p=1,,2"); }),
                HasSubstr("empty value"));
    EXPECT_THAT(message_of<ConfigError>([] { parse_study_parameter("sensor=1/2,3"); }),
                HasSubstr("found \"3\" of 1 components; each run takes 2"));
}

TEST(StudyValues, RangesHoldBothEndsAndRoundDecimals) {
    EXPECT_THAT(expand_range("0.1:0.3:0.1"), ElementsAre("0.1", "0.2", "0.3"));
    EXPECT_THAT(expand_range("1:2:0.25"), ElementsAre("1.00", "1.25", "1.50", "1.75", "2.00"));
    EXPECT_THAT(expand_range("30:10:-10"), ElementsAre("30", "20", "10"));
    EXPECT_THAT(expand_range("5:5:1"), ElementsAre("5"));
    EXPECT_THAT(expand_range("0:10:4"), ElementsAre("0", "4", "8"));
    EXPECT_THAT(expand_range("1e-3:3e-3:1e-3"), ElementsAre("0.001", "0.002", "0.003"));
    EXPECT_THAT(expand_range("-1:1:1"), ElementsAre("-1", "0", "1"));
    EXPECT_EQ(expand_range("0.01:1:0.01").size(), 100U);
    EXPECT_EQ(expand_range("0.01:1:0.01").back(), "1.00");
}

TEST(StudyValues, RangesThatLeadNowhereAreRefused) {
    for (const char* bad : {"1:2", "1:2:3:4", "a:2:1", "1::1", "1:inf:1", "1:2:nan"}) {
        EXPECT_THAT(message_of<ConfigError>([&] { expand_range(bad); }), HasSubstr("from:to:step"))
            << bad;
    }
    for (const char* bad : {"1:2:0", "1:2:-1", "2:1:1"}) {
        EXPECT_THAT(message_of<ConfigError>([&] { expand_range(bad); }),
                    HasSubstr("does not lead from"))
            << bad;
    }
    EXPECT_THAT(message_of<ConfigError>([] { expand_range("0:1:1e-9"); }),
                HasSubstr("more than 100000 values"));
}

}  // namespace
}  // namespace hitos
