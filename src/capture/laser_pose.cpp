#include "laser_pose.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/archivo.hpp"

namespace hitos {

std::optional<LaserPose> laser_pose_of(std::string_view text) {
    constexpr std::size_t kNumbers = 3;
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
    const std::vector<std::string_view> words = input::listed(text);
    LaserPose found;
    found.upside_down = words.size() == kNumbers + 1 && words.back() == "upside-down";
    if (words.size() != kNumbers + (found.upside_down ? 1 : 0)) throw refuse();
    std::array<double, kNumbers> numbers{};
    for (std::size_t i = 0; i < kNumbers; ++i) {
        const std::optional<double> number = input::parse_number(words[i]);
        if (!number || !std::isfinite(*number)) throw refuse();
        numbers.at(i) = *number;
    }
    const auto [x, y, degrees] = numbers;
    if (std::hypot(x, y) > kFarthest) throw refuse();
    found.pose_robot_laser = {x, y, wrap_angle(degrees * kRadiansPerDegree)};
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
