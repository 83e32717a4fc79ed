// SPDX-License-Identifier: GPL-3.0-or-later
#include "configuration/parameter_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

using Type = ConfigParameter::Type;

/// Values away from the defaults, each parameter another one.
void change(const ConfigParameter& parameter, Configuracion& configuration, int salt) {
    switch (parameter.type) {
        case Type::real: {
            const double part = 0.25 + 0.001 * salt;
            parameter.put(configuration,
                          parameter.minimum + part * (parameter.maximum - parameter.minimum));
            break;
        }
        case Type::integer:
            parameter.put(configuration, static_cast<std::int64_t>(parameter.minimum) + 7 + salt);
            break;
        case Type::choice: {
            const std::size_t place = parameter.place_of(parameter.text(configuration)).value();
            parameter.put(configuration,
                          parameter.choices[(place + 1) % parameter.choices.size()].word);
            break;
        }
        case Type::text:
            parameter.put(configuration, std::string("changed"));
            break;
    }
}

TEST(ParameterTable, KeysAreUniqueAndHaveOneDot) {
    std::set<std::string_view> keys;
    for (const ConfigParameter& parameter : make_parameter_table()) {
        EXPECT_TRUE(keys.insert(parameter.key).second) << parameter.key;
        EXPECT_EQ(std::ranges::count(parameter.key, '.'), 1) << parameter.key;
    }
    EXPECT_EQ(keys.size(), 116U);
}

TEST(ParameterTable, GroupsAndTablesStandTogether) {
    std::vector<ParameterGroup> groups;
    std::vector<std::string_view> tables;
    for (const ConfigParameter& parameter : make_parameter_table()) {
        const std::string_view table = parameter.table();
        const ParameterGroup group = group_of(table).group;
        if (groups.empty() || groups.back() != group) groups.push_back(group);
        if (tables.empty() || tables.back() != table) tables.push_back(table);
    }
    EXPECT_EQ(std::set(groups.begin(), groups.end()).size(), groups.size());
    EXPECT_EQ(groups.size(), 9U);
    EXPECT_EQ(std::set(tables.begin(), tables.end()).size(), tables.size());
}

TEST(ParameterTable, ChoicesHaveLabelsAndOthersHaveNone) {
    for (const ConfigParameter& p : make_parameter_table()) {
        EXPECT_EQ(!p.choices.empty(), p.type == Type::choice) << p.key;
        EXPECT_FALSE(p.label.empty()) << p.key;
        for (const ParameterChoice& choice : p.choices) {
            EXPECT_FALSE(choice.label.empty()) << p.key << " " << choice.word;
        }
    }
}

TEST(ParameterTable, CardsAreThoseOfGroups) {
    for (const ConfigParameter& p : make_parameter_table()) {
        if (!p.card.empty()) {
            EXPECT_NO_THROW(group_of(p.card)) << p.key;
        }
    }
    EXPECT_THROW(group_of("weather"), ConfigError);
}

/// The keys that have no effect once these assignments are made.
std::set<std::string_view> idle_with(const std::vector<std::string>& assignments) {
    Configuracion configuration;
    for (const std::string& assignment : assignments) set_parameter(configuration, assignment);
    std::set<std::string_view> idle;
    for (const ConfigParameter& p : parameters()) {
        if (!p.used_by(configuration)) idle.insert(p.key);
    }
    return idle;
}

using Keys = std::set<std::string_view>;

Keys with(Keys keys, const Keys& more, const Keys& less) {
    keys.insert(more.begin(), more.end());
    for (const std::string_view key : less) keys.erase(key);
    return keys;
}

TEST(ParameterTable, WhatTheChoicesDoNotReadHasNoEffect) {
    const Keys sigmas = {"motion.unit", "motion.sigma_x", "motion.sigma_y", "motion.sigma_theta"};
    const Keys rates = {"motion.var_along", "motion.var_across", "motion.var_theta_per_rad",
                        "motion.var_theta_per_m"};
    const Keys ratios = {"motion.ratio_x", "motion.ratio_y", "motion.ratio_theta"};
    const Keys registered = {"motion.registered_memory", "motion.registered_share",
                             "motion.registered_sigma", "motion.registered_heading"};
    const Keys registration = {
        "registration.range",        "registration.key_scans",   "registration.key_distance",
        "registration.key_angle",    "registration.point_sigma", "registration.odometry_scale",
        "registration.robust_prior", "registration.search",      "registration.calibrate",
        "registration.loops",        "registration.loop_score",  "registration.loops_agree",
        "registration.final_passes", "registration.edits"};
    const Keys fixed = {"observation.var_rho", "observation.var_theta"};
    const Keys points = {"observation.point_sigma", "observation.common_sigma"};
    const Keys circles = {"features.circle_radius", "features.circle_gap",
                          "features.circle_points"};
    const Keys split = {"split_merge.dmax", "split_merge.fit", "split_merge.gap",
                        "split_merge.gap_per_range"};
    const Keys ransac = {"ransac.edge", "ransac.edge_per_range", "ransac.threshold",
                         "ransac.iterations", "ransac.order"};
    Keys idle = {"association.new_probability",
                 "association.gate_probability",
                 "association.joint_probability",
                 "association.segment_margin",
                 "landmarks.hit",
                 "landmarks.miss",
                 "landmarks.limit",
                 "landmarks.probation_scans",
                 "resampling.neff_threshold",
                 "source.hold",
                 "source.start",
                 "source.tour_seed",
                 "source.world_set"};
    for (const Keys& keys : {rates, ratios, registered, registration, points, circles, ransac})
        idle.insert(keys.begin(), keys.end());
    EXPECT_EQ(idle_with({}), idle);
    EXPECT_EQ(idle_with({"motion.model=no-odometry"}), idle);
    EXPECT_EQ(idle_with({"motion.model=proportional"}), with(idle, sigmas, rates));
    EXPECT_EQ(idle_with({"motion.model=increments"}), with(idle, sigmas, ratios));
    EXPECT_EQ(idle_with({"motion.model=registered"}),
              with(with(idle, sigmas, registered), {}, registration));
    EXPECT_EQ(idle_with({"source.map=a run"}), with(idle, {}, {"source.hold", "source.start"}));
    EXPECT_EQ(
        idle_with({"motion.model=registered", "registration.loops=off"}),
        with(with(idle, sigmas, registered), {},
             with(registration, {}, {"registration.loop_score", "registration.loops_agree"})));
    EXPECT_EQ(idle_with({"observation.covariance=points"}), with(idle, fixed, points));
    EXPECT_EQ(idle_with({"features.circles=on"}), with(with(idle, {}, points), {}, circles));
    EXPECT_EQ(idle_with({"features.method=ransac"}),
              with(with(idle, split, ransac), {"features.corner_lines"}, {}));
    EXPECT_EQ(idle_with({"split_merge.fit=least-squares"}),
              with(idle, {"features.corner_lines"}, {}));
    EXPECT_EQ(
        idle_with({"features.detect=lines"}),
        with(idle, {"features.corner_distance", "features.corner_angle", "features.corner_lines"},
             {}));
    EXPECT_EQ(
        idle_with({"source.file=a.toml"}),
        with(idle,
             {"source.scan_topic", "source.odom_topic", "source.laser_pose", "source.same_frames",
              "source.ray_time", "source.range_scale", "source.range_offset", "source.fan_scale",
              "source.odometry_axes", "source.scan_clock", "source.opening"},
             {"source.tour_seed", "source.world_set"}));
    EXPECT_EQ(idle_with({"features.detect=corners"}), idle);
    EXPECT_EQ(idle_with({"association.method=gnn"}),
              with(idle, {}, {"association.gate_probability"}));
    EXPECT_EQ(idle_with({"association.method=jcbb"}),
              with(idle, {}, {"association.gate_probability", "association.joint_probability"}));
    EXPECT_EQ(idle_with({"association.ambiguity=off"}), idle);
    EXPECT_EQ(idle_with({"association.segments=on"}),
              with(idle, {}, {"association.segment_margin"}));
    EXPECT_EQ(idle_with({"landmarks.vanish=on"}),
              with(idle, {}, {"landmarks.hit", "landmarks.miss", "landmarks.limit"}));
    EXPECT_EQ(idle_with({"landmarks.probation=1"}), idle);
    EXPECT_EQ(idle_with({"landmarks.probation=2"}), with(idle, {}, {"landmarks.probation_scans"}));
    EXPECT_EQ(idle_with({"resampling.rule=neff"}), with(idle, {}, {"resampling.neff_threshold"}));
    EXPECT_EQ(idle_with({"filter.algorithm=ekf-slam", "resampling.rule=neff"}),
              with(idle,
                   {"filter.particles", "filter.proposal", "association.p0", "resampling.rule",
                    "resampling.method", "association.segments", "association.exclusive",
                    "association.hypotheses", "landmarks.vanish", "landmarks.probation"},
                   {"association.new_probability", "association.gate_probability"}));
    EXPECT_EQ(idle_with({"filter.algorithm=graph-slam"}),
              with(with(idle, sigmas, registration),
                   {"filter.particles", "filter.proposal", "association.method", "association.p0",
                    "association.segments", "association.exclusive", "association.hypotheses",
                    "landmarks.vanish", "landmarks.probation", "motion.model", "resampling.rule",
                    "resampling.method"},
                   {"association.new_probability", "association.gate_probability"}));
}

TEST(ParameterTable, DescriptionsAreSentencesOfPlainText) {
    for (const ConfigParameter& parameter : make_parameter_table()) {
        EXPECT_GT(parameter.description.size(), 30U) << parameter.key;
        EXPECT_TRUE(parameter.description.ends_with('.')) << parameter.key;
        for (const char c : parameter.description) {
            EXPECT_TRUE(c >= 0x20 && c < 0x7f) << parameter.key << ": " << parameter.description;
        }
    }
}

TEST(ParameterTable, TheThesisSymbolsAreNamed) {
    const std::map<std::string_view, std::string_view> symbols = {
        {"split_merge.dmax", "Dmax"},       {"split_merge.min_length", "Lmin"},
        {"split_merge.min_points", "Pmin"}, {"association.p0", "P0"},
        {"filter.particles", "M"},          {"resampling.neff_threshold", "Neff"},
        {"features.corner_distance", "Es"}};
    for (const auto& [key, symbol] : symbols) {
        const ConfigParameter& parameter = find_parameter(key);
        EXPECT_EQ(parameter.symbol, symbol);
        EXPECT_NE(parameter.description.find(symbol), std::string_view::npos) << key;
    }
    EXPECT_EQ(find_parameter("observation.var_rho").symbol, "σ²ρ");
}

TEST(ParameterTable, DefaultsAreAllowed) {
    const Configuracion defaults;
    for (const ConfigParameter& parameter : make_parameter_table()) {
        EXPECT_NO_THROW(parameter.check(defaults)) << parameter.key;
    }
}

TEST(ParameterTable, EachParameterReachesAPlaceOfItsOwn) {
    const std::vector<ConfigParameter> table = make_parameter_table();
    const Configuracion defaults;
    for (std::size_t i = 0; i < table.size(); ++i) {
        Configuracion changed;
        if (table[i].choices.size() == 1) continue;  // it has one value only
        change(table[i], changed, static_cast<int>(i));
        for (std::size_t j = 0; j < table.size(); ++j) {
            EXPECT_EQ(table[j].text(changed) == table[j].text(defaults), i != j)
                << table[i].key << " changes " << table[j].key;
        }
    }
}

TEST(ParameterTable, KeysReachTheFieldsThatTheirNamesSay) {
    Configuracion c;
    c.source.file = "a.log";
    c.source.format = "carmen";
    c.source.read.max_range_m = 12.5;
    c.source.read.odometry = OdometryFrom::velocities;
    c.source.read.scan_topic = "/front,/rear";
    c.source.read.odom_topic = "tf";
    c.source.read.leave_out_early_scans = true;
    c.source.read.scan_delay_s = -0.25;
    c.source.read.scan_clock = "0@0,-1@9";
    c.source.read.opening_bytes = 4711;
    c.source.read.laser_pose = "0.1,0.2,30";
    c.source.read.same_frames = "a=b";
    c.source.read.min_range_m = 0.27;
    c.source.read.ray_time_s = 0.28;
    c.source.read.range_scale = 0.0254;
    c.source.read.range_offset_m = -0.07;
    c.source.read.fan_scale = 0.97;
    c.source.read.odometry_scale = 1.29;
    c.source.read.odometry_turns = -1.5;
    c.source.read.odometry_axes = "y,x,theta";
    c.source.read.mend = Mend::rays;
    c.source.tour_seed = 43;
    c.source.world_set = "laser.sigma=0.003";
    c.source.map = "a run";
    c.source.hold = true;
    c.source.start = "1,2,30";
    c.run = {42, 3};
    c.filter.algorithm = "ekf-slam";
    c.filter.particles = 77;
    c.filter.motion = {"proportional",       0.11, 0.12, 0.13, 0.14, 0.15, 0.16, 0.17,
                       MotionUnit::variance, 0.18, 0.19, 0.2,  0.23, 0.24, 0.25, 0.26};
    c.filter.observation = {0.21, 0.22};
    c.filter.association = {AssociationMethod::gated_nearest,
                            0.31,
                            0.91,
                            0.92,
                            AmbiguityRule::new_landmark,
                            0.33,
                            0.93,
                            true,
                            0.34,
                            true,
                            false,
                            true};
    c.filter.landmarks = {true, 0.35, -0.36, 4.5, 37, 38};
    c.filter.resampling = {ResamplingRule::neff, 41.5, "residual"};
    c.extraction.detect = Detection::corners;
    c.extraction.lines = {0.52, 53, {0.54, 0.55, 0.56}};
    c.extraction.split_merge = {0.51, LineFit::least_squares, 0.57, 0.58};
    c.extraction.method = "ransac";
    c.extraction.ransac = {0.71, 0.72, 0.73, 74, RansacOrder::ransac_first};
    c.extraction.circles = {true, 0.77, 0.78, 79};
    c.extraction.covariance = ObservationCovariance::points;
    c.extraction.point_sigma_m = 0.75;
    c.extraction.common_sigma_m = 0.76;
    c.extraction.corner_distance_m = 0.59;
    c.extraction.corner_angle_rad = 0.5;
    c.extraction.corner_lines = CornerLines::fitted;
    c.registration = {1.81,  82,    0.83,  0.84, 0.85, 0.86, false,
                      false, false, false, 0.87, 8,    89,   "slip 5; refuse 9 2"};
    c.grid = {0.61, 0.62, -0.63, 6.4, 6.5, PathMarks::cross_and_ring};
    const std::map<std::string_view, std::string> expected = {
        {"source.file", "a.log"},
        {"source.format", "carmen"},
        {"source.max_range", "12.5"},
        {"source.odometry", "velocities"},
        {"source.scan_topic", "/front,/rear"},
        {"source.odom_topic", "tf"},
        {"source.early_scans", "leave_out"},
        {"source.scan_delay", "-0.25"},
        {"source.scan_clock", "0@0,-1@9"},
        {"source.opening", "4711"},
        {"source.laser_pose", "0.1,0.2,30"},
        {"source.same_frames", "a=b"},
        {"source.min_range", "0.27"},
        {"source.ray_time", "0.28"},
        {"source.range_scale", "0.0254"},
        {"source.range_offset", "-0.07"},
        {"source.fan_scale", "0.97"},
        {"source.odometry_scale", "1.29"},
        {"source.odometry_turns", "-1.5"},
        {"source.odometry_axes", "y,x,theta"},
        {"source.mend", "rays"},
        {"source.tour_seed", "43"},
        {"source.world_set", "laser.sigma=0.003"},
        {"source.map", "a run"},
        {"source.hold", "on"},
        {"source.start", "1,2,30"},
        {"run.seed", "42"},
        {"run.threads", "3"},
        {"filter.algorithm", "ekf-slam"},
        {"filter.particles", "77"},
        {"association.method", "gnn"},
        {"association.p0", "0.31"},
        {"association.gate_probability", "0.91"},
        {"association.new_probability", "0.92"},
        {"association.joint_probability", "0.93"},
        {"association.ambiguity", "new-landmark"},
        {"association.ambiguity_ratio", "0.33"},
        {"association.segments", "on"},
        {"association.segment_margin", "0.34"},
        {"association.exclusive", "on"},
        {"association.known", "off"},
        {"association.hypotheses", "on"},
        {"landmarks.vanish", "on"},
        {"landmarks.hit", "0.35"},
        {"landmarks.miss", "-0.36"},
        {"landmarks.limit", "4.5"},
        {"landmarks.probation", "37"},
        {"landmarks.probation_scans", "38"},
        {"registration.range", "1.81"},
        {"registration.key_scans", "82"},
        {"registration.key_distance", "0.83"},
        {"registration.key_angle", "0.84"},
        {"registration.point_sigma", "0.85"},
        {"registration.odometry_scale", "0.86"},
        {"registration.robust_prior", "off"},
        {"registration.search", "off"},
        {"registration.calibrate", "off"},
        {"registration.loops", "off"},
        {"registration.loop_score", "0.87"},
        {"registration.loops_agree", "8"},
        {"registration.final_passes", "89"},
        {"registration.edits", "slip 5; refuse 9 2"},
        {"motion.model", "proportional"},
        {"motion.unit", "variance"},
        {"motion.sigma_x", "0.11"},
        {"motion.sigma_y", "0.12"},
        {"motion.sigma_theta", "0.13"},
        {"motion.var_along", "0.14"},
        {"motion.var_across", "0.15"},
        {"motion.var_theta_per_rad", "0.16"},
        {"motion.var_theta_per_m", "0.17"},
        {"motion.ratio_x", "0.18"},
        {"motion.ratio_y", "0.19"},
        {"motion.ratio_theta", "0.2"},
        {"motion.registered_memory", "0.23"},
        {"motion.registered_share", "0.24"},
        {"motion.registered_sigma", "0.25"},
        {"motion.registered_heading", "0.26"},
        {"observation.var_rho", "0.21"},
        {"observation.var_theta", "0.22"},
        {"observation.covariance", "points"},
        {"observation.point_sigma", "0.75"},
        {"observation.common_sigma", "0.76"},
        {"features.method", "ransac"},
        {"features.detect", "corners"},
        {"features.corner_distance", "0.59"},
        {"features.corner_angle", "0.5"},
        {"features.corner_lines", "fitted"},
        {"features.circles", "on"},
        {"features.circle_radius", "0.77"},
        {"features.circle_gap", "0.78"},
        {"features.circle_points", "79"},
        {"split_merge.dmax", "0.51"},
        {"split_merge.min_length", "0.52"},
        {"split_merge.min_points", "53"},
        {"split_merge.fit", "least-squares"},
        {"split_merge.collinear_rho", "0.54"},
        {"split_merge.collinear_theta", "0.55"},
        {"split_merge.collinear_gap", "0.56"},
        {"split_merge.gap", "0.57"},
        {"split_merge.gap_per_range", "0.58"},
        {"ransac.edge", "0.71"},
        {"ransac.edge_per_range", "0.72"},
        {"ransac.threshold", "0.73"},
        {"ransac.iterations", "74"},
        {"ransac.order", "ransac-first"},
        {"resampling.rule", "neff"},
        {"resampling.neff_threshold", "41.5"},
        {"resampling.method", "residual"},
        {"filter.proposal", "motion"},
        {"grid.resolution", "0.61"},
        {"grid.hit", "0.62"},
        {"grid.miss", "-0.63"},
        {"grid.limit", "6.4"},
        {"grid.max_range", "6.5"},
        {"grid.path_marks", "x-and-o"}};
    for (const ConfigParameter& parameter : make_parameter_table()) {
        const auto entry = expected.find(parameter.key);
        ASSERT_NE(entry, expected.end()) << parameter.key;
        EXPECT_EQ(parameter.text(c), entry->second) << parameter.key;
    }
}

}  // namespace
}  // namespace hitos
