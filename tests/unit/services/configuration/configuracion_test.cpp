// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/configuration/configuracion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "hitos/base/error.hpp"
#include "hitos/base/parameter.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using test::message_of;
using ::testing::HasSubstr;
using Type = ConfigParameter::Type;

std::string refusal(std::string_view assignment) {
    Configuracion configuration;
    return message_of<ConfigError>([&] { set_parameter(configuration, assignment); });
}

std::string find_refusal(std::string_view key) {
    return message_of<ConfigError>([&] { find_parameter(key); });
}

TEST(SetParameter, SetsEveryType) {
    Configuracion c;
    set_parameter(c, "split_merge.dmax=0.03");
    set_parameter(c, " filter.particles = +500 ");
    set_parameter(c, "association.method = gnn");
    set_parameter(c, "source.file=a = b.log");
    set_parameter(c, "source.odometry=velocities");
    EXPECT_EQ(c.extraction.split_merge.dmax_m, 0.03);
    EXPECT_EQ(c.filter.particles, 500);
    EXPECT_EQ(c.filter.association.method, AssociationMethod::gated_nearest);
    EXPECT_EQ(c.source.file, "a = b.log");
    EXPECT_EQ(c.source.read.odometry, OdometryFrom::velocities);
}

TEST(SetParameter, TakesBothEndsOfEveryRangeAndRefusesWhatLiesBeyond) {
    for (const ConfigParameter& p : parameters()) {
        if (p.type != Type::real) continue;
        Configuracion c;
        for (const double bound : {p.minimum, p.maximum}) {
            p.put(c, bound);
            const std::string text = p.text(c);
            p.put(c, -77.0);
            EXPECT_NO_THROW(p.set(c, text)) << p.key;
            EXPECT_EQ(std::get<double>(p.get(c)), bound) << p.key;
        }
        const double infinity = std::numeric_limits<double>::infinity();
        for (const double beyond :
             {std::nextafter(p.minimum, -infinity), std::nextafter(p.maximum, infinity)}) {
            p.put(c, beyond);
            const std::string text = p.text(c);
            p.put(c, -77.0);
            EXPECT_THAT(message_of<ConfigError>([&] { p.set(c, text); }),
                        HasSubstr(" is out of range; allowed: " + p.allowed()))
                << p.key;
            EXPECT_EQ(std::get<double>(p.get(c)), -77.0) << p.key;
        }
    }
}

TEST(SetParameter, NamesKeyValueAndRange) {
    EXPECT_EQ(refusal("split_merge.dmax=20"),
              "split_merge.dmax: 20 is out of range; allowed: 1e-06 to 10 m");
    EXPECT_EQ(refusal("split_merge.dmax=wide"),
              "split_merge.dmax: \"wide\" is not a number; allowed: 1e-06 to 10 m");
    EXPECT_EQ(refusal("filter.particles=0"),
              "filter.particles: 0 is out of range; allowed: integers from 1 to 1000000");
    EXPECT_EQ(refusal("filter.particles=1.5"),
              "filter.particles: \"1.5\" is not an integer; allowed: integers from 1 to 1000000");
    EXPECT_EQ(refusal("association.p0=0"),
              "association.p0: 0 is out of range; allowed: 1e-30 to 1000");
    EXPECT_EQ(refusal("split_merge.fit=Endpoints"),
              "split_merge.fit: \"Endpoints\" is none of the choices; allowed: one of endpoints, "
              "least-squares");
    EXPECT_EQ(refusal("run.seed=-1"),
              "run.seed: -1 is out of range; allowed: integers from 0 to 9223372036854775807");
}

TEST(SetParameter, RefusesNumbersThatAreNone) {
    for (const char* value : {"nan", "inf", "-inf"}) {
        EXPECT_THAT(refusal(std::string("motion.sigma_x=") + value), HasSubstr("is out of range"));
    }
    for (const char* value : {"", "1e999", "0.1m", "0,1", "--1"}) {
        EXPECT_THAT(refusal(std::string("motion.sigma_x=") + value), HasSubstr("is not a number"));
    }
    for (const char* value : {"", "+", "+-1", "1e2", "inf", "5 6"}) {
        EXPECT_THAT(refusal(std::string("run.threads=") + value), HasSubstr("is not an integer"));
    }
}

TEST(SetParameter, SeedsReachTheGreatestInteger) {
    Configuracion c;
    set_parameter(c, "run.seed=9223372036854775807");
    EXPECT_EQ(c.run.seed, 9223372036854775807U);
    EXPECT_EQ(find_parameter("run.seed").text(c), "9223372036854775807");
    EXPECT_THAT(refusal("run.seed=9223372036854775808"), HasSubstr("is out of range"));
}

TEST(SetParameter, ExpectsAnEqualsSign) {
    EXPECT_EQ(refusal("split_merge.dmax"), "split_merge.dmax: expected key=value");
}

TEST(SetParameter, LeavesTheConfigurationAloneWhereItRefuses) {
    Configuracion c;
    c.filter.particles = 123;
    c.filter.association.method = AssociationMethod::gated_nearest;
    EXPECT_THROW(set_parameter(c, "filter.particles=1e3"), ConfigError);
    EXPECT_THROW(set_parameter(c, "association.method=best"), ConfigError);
    EXPECT_EQ(c.filter.particles, 123);
    EXPECT_EQ(c.filter.association.method, AssociationMethod::gated_nearest);
}

TEST(ParameterText, ReadsBackToTheSameBits) {
    std::mt19937_64 random(5);
    const ConfigParameter& parameter = find_parameter("grid.limit");
    for (int i = 0; i < 20000; ++i) {
        Configuracion c;
        c.grid.log_odds_limit = std::uniform_real_distribution(0.1, 100.0)(random);
        Configuracion back;
        parameter.set(back, parameter.text(c));
        ASSERT_EQ(std::bit_cast<std::uint64_t>(back.grid.log_odds_limit),
                  std::bit_cast<std::uint64_t>(c.grid.log_odds_limit));
    }
}

TEST(ParameterText, EveryChoiceReadsBack) {
    for (const ConfigParameter& parameter : parameters()) {
        for (const ParameterChoice& choice : parameter.choices) {
            Configuracion c;
            parameter.set(c, choice.word);
            EXPECT_EQ(parameter.text(c), choice.word) << parameter.key;
        }
    }
}

TEST(ParameterText, FormatsAreTheWordsOfTheCaptureLayer) {
    const ConfigParameter& format = find_parameter("source.format");
    ASSERT_EQ(format.choices.size(), log_formats().entries().size() + 1);
    for (std::size_t i = 1; i < format.choices.size(); ++i) {
        EXPECT_EQ(format.choices[i].word, log_formats().entries()[i - 1].word);
    }
    EXPECT_EQ(
        format.allowed(),
        "one of auto, player, radish, normalized, carmen, mrclam, rosbag, mcap, db3, rosbag2");
}

TEST(FindParameter, FindsEveryKey) {
    for (const ConfigParameter& parameter : parameters()) {
        EXPECT_EQ(&find_parameter(parameter.key), &parameter);
    }
}

TEST(FindParameter, ProposesNearKeys) {
    EXPECT_EQ(find_refusal("split_merge.dmx"),
              "split_merge.dmx: no such parameter; did you mean split_merge.dmax?");
    EXPECT_EQ(find_refusal("dmax"), "dmax: no such parameter; did you mean split_merge.dmax?");
    EXPECT_EQ(find_refusal("filter.dmax"),
              "filter.dmax: no such parameter; did you mean split_merge.dmax?");
    EXPECT_THAT(find_refusal("filter.partcles"), HasSubstr("did you mean filter.particles?"));
    // The nearest stands first.
    EXPECT_THAT(find_refusal("motion.sigma_z"),
                HasSubstr("did you mean motion.sigma_x or motion.sigma_y"));
    EXPECT_THAT(find_refusal("max_range"), HasSubstr("source.max_range or grid.max_range"));
}

TEST(FindParameter, ProposesNothingWhereNothingIsNear) {
    for (const std::string& key : {std::string("weather"), std::string(5000, 'x'), std::string()}) {
        EXPECT_EQ(find_refusal(key), key + ": no such parameter; init.cfg lists all of them");
    }
}

TEST(Check, TakesTheDefaults) {
    EXPECT_NO_THROW(check(Configuracion{}));
}

TEST(Check, RefusesValuesOutOfRangeThatCodeHasSet) {
    Configuracion c;
    c.filter.particles = 0;
    EXPECT_EQ(message_of<ConfigError>([&] { check(c); }),
              "filter.particles: 0 is out of range; allowed: integers from 1 to 1000000");
    c = {};
    c.filter.observation.var_rho_m2 = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(message_of<ConfigError>([&] { check(c); }),
              "observation.var_rho: nan is out of range; allowed: 1e-12 to 1000 m^2");
    c = {};
    c.run.seed = std::numeric_limits<std::uint64_t>::max();
    EXPECT_THAT(message_of<ConfigError>([&] { check(c); }), HasSubstr("run.seed: "));
    c = {};
    c.filter.motion.model = "fast";
    EXPECT_THAT(
        message_of<ConfigError>([&] { check(c); }),
        HasSubstr("motion.model: \"fast\" is none of the choices; allowed: one of odometry"));
}

TEST(Check, RefusesAParticleThatCanNeverMove) {
    Configuracion c;
    c.filter.motion = {"no-odometry", 0.0, 0.0, 0.0};
    EXPECT_THAT(message_of<ConfigError>([&] { check(c); }),
                HasSubstr("motion.model: no-odometry with motion.sigma_x, motion.sigma_y"));
    c.filter.motion.sigma_theta_rad = 0.1;
    EXPECT_NO_THROW(check(c));
    c.filter.motion = {"odometry", 0.0, 0.0, 0.0};
    EXPECT_NO_THROW(check(c));
}

TEST(Parameters, TheUnitOfConstantNoiseFollowsItsReading) {
    Configuracion c;
    const ConfigParameter& x = find_parameter("motion.sigma_x");
    const ConfigParameter& theta = find_parameter("motion.sigma_theta");
    EXPECT_EQ(x.unit_of(c), "m");
    EXPECT_EQ(theta.unit_of(c), "rad");
    find_parameter("motion.unit").set(c, "variance");
    EXPECT_EQ(x.unit_of(c), "m^2");
    EXPECT_EQ(theta.unit_of(c), "rad^2");
    EXPECT_EQ(find_parameter("split_merge.dmax").unit_of(c), "m");
}

TEST(Check, RefusesAGridThatDrawsNothing) {
    Configuracion c;
    c.grid.log_odds_hit = c.grid.log_odds_miss = 0.0;
    EXPECT_THAT(message_of<ConfigError>([&] { check(c); }), HasSubstr("grid.hit and grid.miss"));
    c.grid.log_odds_hit = 0.5;
    EXPECT_NO_THROW(check(c));
    c.grid.max_range_m = 0.04;
    EXPECT_EQ(message_of<ConfigError>([&] { check(c); }),
              "grid.max_range: 0.04 m is less than a cell (grid.resolution 0.05 m); 0 draws rays "
              "whole");
    c.grid.max_range_m = 0.05;
    EXPECT_NO_THROW(check(c));
}

}  // namespace
}  // namespace hitos
