// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a reference map is one of the place, as it stands or read otherwise.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <variant>

#include "hitos/base/geometry.hpp"
#include "hitos/base/translatable.hpp"
#include "hitos/services/evaluation/reference_fit.hpp"

namespace hitos {
namespace {

// [m] A landmark further away is none of the reference's; docs/evaluation.md has errors of maps.
constexpr double kReach = 1.0;
constexpr std::size_t kFewLandmarks = 10;  // of these a few may be new, or false

/// How many landmarks, of those of a kind that the reference has, lie near one of it.
struct Near {
    std::size_t near = 0;
    std::size_t all = 0;

    bool half() const { return all > 0 && 2 * near >= all; }
    bool most() const { return all > 0 && 5 * near >= 4 * all; }
};

Near near_of(const LandmarkMap& map, const LandmarkMap& reference) {
    Near found;
    // Maps whose landmarks have names need not have their frame in common.
    Pose pose;
    const bool identities = have_identities(map, reference);
    if (identities) {
        if (const auto aligned = aligned_map_error(map, reference))
            pose = aligned->pose_reference_map;
    }
    for (const ICaracteristica& landmark : map) {
        if (identities && landmark.identity < 0) continue;
        const auto error = map_error({transform(pose, landmark)}, reference);
        if (!error) continue;
        ++found.all;
        if (error->mean_m <= kReach) ++found.near;
    }
    return found;
}

Recta normal_form(double rho, double theta) {
    return {std::abs(rho), wrap_angle(rho < 0.0 ? theta + kPi : theta)};
}

/// What a file says otherwise than it is read, and how to read it.
struct Reading {
    std::string_view said;
    Recta (*line)(const Recta&);
    Esquina (*corner)(const Esquina&);
};

template <int milli>
constexpr Recta smaller(const Recta& line) {
    return {line.rho * milli / 1000.0, line.theta};
}
template <int milli>
constexpr Esquina smaller(const Esquina& corner) {
    return {corner.x * milli / 1000.0, corner.y * milli / 1000.0};
}
Esquina as_it_is(const Esquina& corner) {
    return corner;
}

constexpr std::array kReadings{
    Reading{HITOS_TEXT("Advice",
                       "The reference map has its angles in radians, where degrees are expected: "
                       "%1 of the landmarks lie within a metre of one of it as it is."),
            [](const Recta& line) { return normal_form(line.rho, line.theta * kDegreesPerRadian); },
            &as_it_is},
    Reading{HITOS_TEXT("Advice",
                       "The reference map has rho and theta of its lines in each other's place: "
                       "%1 of the landmarks lie within a metre of one of it as it is."),
            // A wall further than 90 m has lost its side.
            [](const Recta& line) {
                const double degrees = line.theta * kDegreesPerRadian;
                const double rho = std::remainder(degrees, 180.0);
                const bool turned = std::abs(degrees - rho) > 1.0;
                return normal_form(rho, (turned ? -line.rho : line.rho) / kDegreesPerRadian);
            },
            &as_it_is},
    Reading{HITOS_TEXT("Advice",
                       "The reference map is in millimetres, where metres are expected: %1 of the "
                       "landmarks lie within a metre of one of it as it is."),
            &smaller<1>, &smaller<1>},
    Reading{HITOS_TEXT("Advice",
                       "The reference map is in centimetres, where metres are expected: %1 of the "
                       "landmarks lie within a metre of one of it as it is."),
            &smaller<10>, &smaller<10>},
    Reading{HITOS_TEXT("Advice",
                       "The reference map is a mirror image, as where its y axis points the other "
                       "way: %1 of the landmarks lie within a metre of one of it as it is."),
            [](const Recta& line) { return normal_form(line.rho, -line.theta); },
            [](const Esquina& corner) {
                return Esquina{corner.x, -corner.y};
            }},
    Reading{HITOS_TEXT("Advice",
                       "The reference map is a mirror image, as where its x axis points the other "
                       "way: %1 of the landmarks lie within a metre of one of it as it is."),
            [](const Recta& line) { return normal_form(line.rho, kPi - line.theta); },
            [](const Esquina& corner) {
                return Esquina{-corner.x, corner.y};
            }},
    Reading{HITOS_TEXT("Advice",
                       "The reference map has x and y in each other's place: %1 of the landmarks "
                       "lie within a metre of one of it as it is."),
            [](const Recta& line) { return normal_form(line.rho, kPi / 2 - line.theta); },
            [](const Esquina& corner) {
                return Esquina{corner.y, corner.x};
            }}};

LandmarkMap read_as(const LandmarkMap& map, const Reading& reading) {
    LandmarkMap out = map;
    for (ICaracteristica& landmark : out) {
        if (const auto* line = std::get_if<Recta>(&landmark.value)) {
            landmark.value = reading.line(*line);
        } else {
            landmark.value = reading.corner(std::get<Esquina>(landmark.value));
        }
    }
    return out;
}

}  // namespace

std::optional<Advice> doubt_of_map(const LandmarkMap& map, const LandmarkMap& reference) {
    if (map.empty()) return std::nullopt;
    const Near found = near_of(map, reference);
    if (found.half() && (found.most() || found.all < kFewLandmarks)) return std::nullopt;
    const std::string figure =
        fmt::format("{}/{}", found.near, found.all > 0 ? found.all : map.size());
    for (const Reading& reading : kReadings) {
        const Near otherwise = near_of(map, read_as(reference, reading));
        if (otherwise.most() && otherwise.near > found.near)
            return Advice{reading.said, figure, {}};
    }
    if (!found.half()) {
        return Advice{HITOS_TEXT("Advice",
                                 "Less than half of the landmarks lie within a metre of one of the "
                                 "reference map (%1): is it of this place, and in the frame of the "
                                 "robot's start?"),
                      figure,
                      {}};
    }
    return Advice{HITOS_TEXT("Advice",
                             "Less than four fifths of the landmarks lie within a metre of one of "
                             "the reference map (%1), and the error is that of the others too: is "
                             "it of this place, and the whole of it?"),
                  figure,
                  {}};
}

}  // namespace hitos
