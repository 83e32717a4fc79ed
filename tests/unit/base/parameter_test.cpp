// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/base/parameter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hitos/base/error.hpp"
#include "support.hpp"

namespace hitos {
namespace {

using namespace declare;
using test::message_of;
using ::testing::ElementsAre;

enum class Shape { round, square };

struct Wheel {
    double radius_m = 0.1;
    int spokes = 8;
    Shape shape = Shape::round;
    std::string tyre = "rubber";
    double pressure_bar = 2.0;
};

struct Cart {
    std::string name = "cart";
    Wheel left;
    Wheel right;
};

const Registry<RegistryEntry>& tyres() {
    static const Registry<RegistryEntry> registry(
        "tyre", "wheel.tyre",
        {{"rubber", "Rubber", "soft", {"wheel.pressure"}}, {"iron", "Iron", "hard"}});
    return registry;
}

std::vector<Parameter<Wheel>> make_wheel() {
    const auto shape =
        choice<&Wheel::shape>({.key = "wheel.shape"}, {{"round", "Round"}, {"square", "Square"}});
    std::vector<Parameter<Wheel>> table = together<Wheel>({
        {real<&Wheel::radius_m>({.key = "wheel.radius", .unit = "m", .maximum = 2.0}),
         integer<&Wheel::spokes>({.key = "wheel.spokes", .minimum = 3, .maximum = 40}), shape},
        {choice<&Wheel::tyre>({.key = "wheel.tyre"}, choices_of(tyres())),
         real<&Wheel::pressure_bar>({.key = "wheel.pressure", .maximum = 9.0},
                                    {where(shape, {"round"})})},
    });
    heed_readers(table, "wheel.tyre", tyres());
    return table;
}

const std::vector<Parameter<Wheel>> kWheel = make_wheel();

const Parameter<Wheel>& of_wheel(std::string_view key) {
    return find_parameter(std::span<const Parameter<Wheel>>(kWheel), key,
                          verbatim("see the manual"));
}

TEST(Parameter, ReadsAndSetsWhereItsMembersPoint) {
    Wheel w;
    of_wheel("wheel.radius").set(w, " 0.25 ");
    of_wheel("wheel.spokes").set(w, "12");
    of_wheel("wheel.shape").set(w, "square");
    of_wheel("wheel.tyre").set(w, "iron");
    EXPECT_EQ(w.radius_m, 0.25);
    EXPECT_EQ(w.spokes, 12);
    EXPECT_EQ(w.shape, Shape::square);
    EXPECT_EQ(w.tyre, "iron");
    EXPECT_EQ(of_wheel("wheel.radius").text(w), "0.25");
    EXPECT_EQ(of_wheel("wheel.shape").text(w), "square");
    EXPECT_EQ(of_wheel("wheel.tyre").text(w), "iron");
    EXPECT_EQ(of_wheel("wheel.tyre").place_of("iron"), 1U);
    EXPECT_EQ(of_wheel("wheel.tyre").choices[1].label, "Iron");
}

TEST(Parameter, NamesKeyFoundAndAllowed) {
    Wheel w;
    const auto refusal = [&](const char* key, const char* value) {
        return message_of<ConfigError>([&] { of_wheel(key).set(w, value); });
    };
    EXPECT_EQ(refusal("wheel.radius", "3"), "wheel.radius: 3 is out of range; allowed: 0 to 2 m");
    EXPECT_EQ(refusal("wheel.spokes", "2"),
              "wheel.spokes: 2 is out of range; allowed: integers from 3 to 40");
    EXPECT_EQ(refusal("wheel.tyre", "wood"),
              "wheel.tyre: \"wood\" is none of the choices; allowed: one of rubber, iron");
    EXPECT_EQ(w.radius_m, 0.1);
    EXPECT_EQ(w.tyre, "rubber");
}

TEST(Parameter, ChecksWhatCodeHasSet) {
    const std::span<const Parameter<Wheel>> table(kWheel);
    Wheel w;
    EXPECT_NO_THROW(check_all(table, w));
    w.tyre = "wood";
    EXPECT_EQ(message_of<ConfigError>([&] { check_all(table, w); }),
              "wheel.tyre: \"wood\" is none of the choices; allowed: one of rubber, iron");
    w = {};
    w.shape = static_cast<Shape>(7);
    EXPECT_EQ(message_of<ConfigError>([&] { check_all(table, w); }),
              "wheel.shape: \"7\" is none of the choices; allowed: one of round, square");
}

TEST(Parameter, IsUsedWhereAllConditionsHold) {
    const Parameter<Wheel>& pressure = of_wheel("wheel.pressure");
    Wheel w;
    EXPECT_TRUE(pressure.used_by(w));
    EXPECT_EQ(pressure.unmet(w), nullptr);
    w.shape = Shape::square;
    ASSERT_NE(pressure.unmet(w), nullptr);
    EXPECT_EQ(pressure.unmet(w)->key, "wheel.shape");
    EXPECT_EQ(pressure.unmet(w)->needed, "round");
    w.tyre = "iron";  // what the registry says stands before other conditions
    EXPECT_EQ(pressure.unmet(w)->key, "wheel.tyre");
    EXPECT_EQ(pressure.unmet(w)->needed, "rubber");
    EXPECT_FALSE(pressure.used_by(w));
    EXPECT_TRUE(of_wheel("wheel.radius").used_by(w));
}

TEST(Parameter, OfAPartServesTheWhole) {
    const Parameter<Cart> left = lifted(of_wheel("wheel.pressure"), &Cart::left);
    const Parameter<Cart> right = lifted(of_wheel("wheel.pressure"), &Cart::right);
    Cart cart;
    left.set(cart, "3.5");
    EXPECT_EQ(cart.left.pressure_bar, 3.5);
    EXPECT_EQ(right.text(cart), "2");
    cart.right.tyre = "iron";
    EXPECT_TRUE(left.used_by(cart));
    EXPECT_FALSE(right.used_by(cart));
    EXPECT_EQ(right.unmet(cart)->needed, "rubber");
}

TEST(Parameter, UnknownKeysAreToldWithNearOnes) {
    const auto refusal = [](std::string_view key) {
        return message_of<ConfigError>([&] { of_wheel(key); });
    };
    EXPECT_EQ(refusal("wheel.spoke"), "wheel.spoke: no such parameter; did you mean wheel.spokes?");
    EXPECT_EQ(refusal("cart.tyre"), "cart.tyre: no such parameter; did you mean wheel.tyre?");
    EXPECT_EQ(refusal("weather"), "weather: no such parameter; see the manual");
    EXPECT_EQ(look_up(std::span<const Parameter<Wheel>>(kWheel), "wheel.spoke"), nullptr);
}

TEST(Parameter, ChoicesOfARegistryKeepItsOrder) {
    std::vector<std::string> words;
    for (const ParameterChoice& choice : choices_of(tyres())) words.push_back(choice.word);
    EXPECT_THAT(words, ElementsAre("rubber", "iron"));
}

}  // namespace
}  // namespace hitos
