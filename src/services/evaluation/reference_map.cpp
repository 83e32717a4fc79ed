// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a reference map is one of the place, as it stands or read otherwise.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <variant>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/base/translatable.hpp"
#include "hitos/services/evaluation/reference_fit.hpp"
#include "reference_units.hpp"

namespace hitos {
namespace {

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
        if (error->mean_m <= kSameLandmark) ++found.near;
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
    double per_metre = 1.0;  ///< before that
};

Recta line_as_it_is(const Recta& line) {
    return line;
}
Esquina as_it_is(const Esquina& corner) {
    return corner;
}

constexpr std::array kOtherReadings{
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

std::vector<Reading> readings() {
    std::vector<Reading> all;
    all.reserve(kReferenceUnits.size() + kOtherReadings.size());
    for (const ReferenceUnit& unit : kReferenceUnits)
        all.push_back({unit.of_map, &line_as_it_is, &as_it_is, unit.per_metre});
    all.insert(all.end(), kOtherReadings.begin(), kOtherReadings.end());
    return all;
}

LandmarkMap read_as(const LandmarkMap& map, const Reading& reading) {
    LandmarkMap out = map;
    for (ICaracteristica& landmark : out) {
        if (const auto* line = std::get_if<Recta>(&landmark.value)) {
            landmark.value = reading.line({line->rho / reading.per_metre, line->theta});
        } else {
            const auto& corner = std::get<Esquina>(landmark.value);
            landmark.value =
                reading.corner({corner.x / reading.per_metre, corner.y / reading.per_metre});
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
    for (const Reading& reading : readings()) {
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
