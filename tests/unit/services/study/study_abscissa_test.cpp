// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/study/study_abscissa.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hitos {
namespace {

using ::testing::ElementsAre;

StudyPlan::Axis axis_of(const std::vector<std::string>& words) {
    StudyPlan::Axis axis{"dmax", {"split_merge.dmax"}, {"m"}, {}};
    for (const std::string& word : words) axis.values.push_back({word});
    return axis;
}

TEST(StudyAbscissa, NumbersStandWhereTheyAre) {
    const StudyAbscissa x = study_abscissa(axis_of({"0.02", "0.01", "0.05"}));
    EXPECT_TRUE(x.numbers);
    EXPECT_FALSE(x.logarithmic);
    EXPECT_THAT(x.positions, ElementsAre(0.02, 0.01, 0.05));
    EXPECT_THAT(x.words, ElementsAre("0.02", "0.01", "0.05"));
}

TEST(StudyAbscissa, NumbersFarApartStandByTheirRatios) {
    EXPECT_TRUE(study_abscissa(axis_of({"100", "5", "20"})).logarithmic);
    EXPECT_FALSE(study_abscissa(axis_of({"99", "5", "20"})).logarithmic);
    EXPECT_FALSE(study_abscissa(axis_of({"0", "5", "500"})).logarithmic);
    EXPECT_FALSE(study_abscissa(axis_of({"-1", "5", "500"})).logarithmic);
}

TEST(StudyAbscissa, WordsStandSideBySide) {
    for (const char* odd : {"neff", "inf", "nan"}) {
        const StudyAbscissa x = study_abscissa(axis_of({"100", odd, "5"}));
        EXPECT_FALSE(x.numbers) << odd;
        EXPECT_FALSE(x.logarithmic) << odd;
        EXPECT_THAT(x.positions, ElementsAre(1.0, 2.0, 3.0)) << odd;
    }
}

TEST(StudyAbscissa, ValuesOfSeveralKeysAreWords) {
    StudyPlan::Axis axis{"sigma", {"a", "b"}, {"m", "rad"}, {{"1", "2"}, {"3", "4"}}};
    const StudyAbscissa x = study_abscissa(axis);
    EXPECT_FALSE(x.numbers);
    EXPECT_THAT(x.words, ElementsAre("1/2", "3/4"));
    EXPECT_THAT(x.positions, ElementsAre(1.0, 2.0));
    EXPECT_EQ(study_axis_label(axis), "sigma [m, rad]");
}

TEST(StudyAbscissa, LabelsNameTheUnitsThereAre) {
    EXPECT_EQ(study_axis_label(axis_of({"1"})), "dmax [m]");
    StudyPlan::Axis axis{"p", {"filter.particles", "x"}, {"", "m"}, {}};
    EXPECT_EQ(study_axis_label(axis), "p [m]");
    axis.units = {"", ""};
    EXPECT_EQ(study_axis_label(axis), "p");
}

}  // namespace
}  // namespace hitos
