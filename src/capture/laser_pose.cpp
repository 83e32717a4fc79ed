// SPDX-License-Identifier: GPL-3.0-or-later
#include "laser_pose.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/archivo.hpp"

namespace hitos {

std::optional<PoseWords> pose_words(std::span<const std::string_view> words) {
    std::array<double, 3> numbers{};
    if (words.size() != numbers.size()) return std::nullopt;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::optional<double> number = input::parse_number(words[i]);
        if (!number || !std::isfinite(*number)) return std::nullopt;
        numbers.at(i) = *number;
    }
    return PoseWords{numbers[0], numbers[1], numbers[2]};
}

std::optional<LaserPose> laser_pose_of(std::string_view text) {
    constexpr double kFarthest = 100.0;  // no robot is larger
    if (input::trimmed(text).empty()) return std::nullopt;
    const auto refuse = [&] {
        return ConfigError(kLaserPoseKey,
                           HITOS_TEXT("Errors",
                                      "found \"%1\", expected where the laser sits on the robot as "
                                      "\"x,y,degrees\" (metres ahead, metres to the left, turn to "
                                      "the left) or \"x,y,degrees,upside-down\""),
                           text);
    };
    std::vector<std::string_view> words = input::listed(text);
    LaserPose found;
    found.upside_down = words.size() == 4 && words.back() == "upside-down";
    if (found.upside_down) words.pop_back();
    const std::optional<PoseWords> said = pose_words(words);
    if (!said || std::hypot(said->x, said->y) > kFarthest) throw refuse();
    found.pose_robot_laser = said->pose();
    return found;
}

std::string text_of(const LaserPose& pose) {
    const auto whole_cm = [](double metres) { return std::round(metres * 100.0) / 100.0 + 0.0; };
    const Pose& place = pose.pose_robot_laser;
    return fmt::format("{:g},{:g},{:.3g}{}", whole_cm(place.x), whole_cm(place.y),
                       wrap_angle(place.theta) * kDegreesPerRadian,
                       pose.upside_down ? ",upside-down" : "");
}

}  // namespace hitos
