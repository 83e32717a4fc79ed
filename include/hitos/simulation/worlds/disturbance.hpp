// SPDX-License-Identifier: GPL-3.0-or-later
// What happens to a tour at a time, so that one can see what the filter makes of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "hitos/base/message.hpp"
#include "hitos/base/translatable.hpp"
#include "hitos/simulation/farthest.hpp"

namespace hitos {

struct World;

/// In the order of kDisturbances.
enum class DisturbanceKind : std::uint8_t {
    push,
    slip,
    blind,
    box,
    open,
    close,
    odometry_noise,
    laser_sigma
};

/// One of the numbers that say how strong or where; its unit is in the meaning.
struct DisturbanceValue {
    std::string_view name;  ///< translated in the context "Disturbance"
    double least = 0.0;
    double greatest = 0.0;
    double usual = 0.0;  ///< offered first where a user is asked
};

/// What is said of a kind.
struct DisturbanceFacts {
    std::string_view word;     ///< key in world files
    std::string_view label;    ///< translated in the context "Disturbance"
    std::string_view meaning;  ///< likewise
    std::array<DisturbanceValue, 3> values;
    std::size_t count = 0;  ///< of the values that it has
    std::span<const DisturbanceValue> used() const { return std::span(values).first(count); }
};

inline constexpr std::array kDisturbances = {
    DisturbanceFacts{"push",
                     HITOS_TEXT("Disturbance", "Push the robot"),
                     HITOS_TEXT("Disturbance",
                                "carries the robot ahead [m], to its left [m] and round to its "
                                "left [degrees]; its wheels do not notice"),
                     {{{HITOS_TEXT("Disturbance", "ahead"), -kFarthest, kFarthest, 1.0},
                       {HITOS_TEXT("Disturbance", "left"), -kFarthest, kFarthest, 0.0},
                       {HITOS_TEXT("Disturbance", "turn"), -360.0, 360.0, 20.0}}},
                     3},
    DisturbanceFacts{
        "slip",
        HITOS_TEXT("Disturbance", "Let a wheel slip"),
        HITOS_TEXT("Disturbance",
                   "for so long [s] these parts of the left and of the right wheel's way are lost"),
        {{{HITOS_TEXT("Disturbance", "seconds"), 0.0, 3600.0, 2.0},
          {HITOS_TEXT("Disturbance", "left"), 0.0, 1.0, 0.5},
          {HITOS_TEXT("Disturbance", "right"), 0.0, 1.0, 0.0}}},
        3},
    DisturbanceFacts{"blind",
                     HITOS_TEXT("Disturbance", "Blind the laser"),
                     HITOS_TEXT("Disturbance", "for so long [s] no ray gives a reading"),
                     {{{HITOS_TEXT("Disturbance", "seconds"), 0.0, 3600.0, 2.0}}},
                     1},
    DisturbanceFacts{
        "box",
        HITOS_TEXT("Disturbance", "Put a box in the way"),
        HITOS_TEXT("Disturbance", "a square box with its middle there [m] and sides so long [m]"),
        {{{HITOS_TEXT("Disturbance", "x"), -kFarthest, kFarthest, 0.0},
          {HITOS_TEXT("Disturbance", "y"), -kFarthest, kFarthest, 0.0},
          {HITOS_TEXT("Disturbance", "side"), 0.01, 100.0, 0.5}}},
        3},
    DisturbanceFacts{"open",
                     HITOS_TEXT("Disturbance", "Open a door"),
                     HITOS_TEXT("Disturbance", "the door of that number"),
                     {{{HITOS_TEXT("Disturbance", "door"), 1.0, 1e6, 1.0}}},
                     1},
    DisturbanceFacts{"close",
                     HITOS_TEXT("Disturbance", "Close a door"),
                     HITOS_TEXT("Disturbance", "the door of that number"),
                     {{{HITOS_TEXT("Disturbance", "door"), 1.0, 1e6, 1.0}}},
                     1},
    DisturbanceFacts{"odometry_noise",
                     HITOS_TEXT("Disturbance", "Change the odometry's noise"),
                     HITOS_TEXT("Disturbance", "the level of odometry.noise from there on"),
                     {{{HITOS_TEXT("Disturbance", "level"), 0.0, 10.0, 0.3}}},
                     1},
    DisturbanceFacts{
        "laser_sigma",
        HITOS_TEXT("Disturbance", "Change the laser's noise"),
        HITOS_TEXT("Disturbance", "the standard deviation of a range [m] from there on"),
        {{{HITOS_TEXT("Disturbance", "sigma"), 0.0, 1.0, 0.05}}},
        1},
};

/// Takes effect at the first control step that is not before its time.
struct Disturbance {
    DisturbanceKind kind = DisturbanceKind::push;
    double at_s = 0.0;               ///< since the tour began
    std::array<double, 3> values{};  ///< as its facts name them
    std::uint64_t line = 0;          ///< in the world file

    const DisturbanceFacts& facts() const { return kDisturbances[static_cast<std::size_t>(kind)]; }
};

/// What speaks against it in that world; empty where nothing does.
Message problem_of(const Disturbance& disturbance, const World& world);

}  // namespace hitos
