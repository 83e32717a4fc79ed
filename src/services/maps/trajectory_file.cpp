#include "hitos/services/maps/trajectory_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "text_output.hpp"

namespace hitos {
namespace {

constexpr std::array<std::string_view, 8> kTrajectoryFields = {"t",  "x",  "y",  "z",
                                                               "qx", "qy", "qz", "qw"};

StampedPose pose_from(std::string_view line, const std::string& name, std::uint64_t number) {
    const std::array values = input::finite_numbers(line, kTrajectoryFields, {name, number});
    const auto [t, x, y, z, qx, qy, qz, qw] = values;
    // Rounding to two decimals moves the length by less than this.
    constexpr double kTolerance = 0.05;
    const double length = std::hypot(std::hypot(qx, qy), std::hypot(qz, qw));
    if (!(std::abs(length - 1.0) <= kTolerance)) {
        throw FormatError(name, number,
                          message(HITOS_TEXT("Errors", "the quaternion's length is %1; expected 1"),
                                  fmt::format("{:.6g}", length)));
    }
    // This form of the yaw holds for a quaternion of any length.
    const double yaw = std::atan2(2.0 * (qw * qz + qx * qy), qw * qw + qx * qx - qy * qy - qz * qz);
    return {t, {x, y, wrap_angle(yaw)}};
}

/// Nine decimals; what rounds to zero has no sign.
std::string nine_decimals(double value) {
    std::string text = fmt::format("{:.9f}", value);
    return text == "-0.000000000" ? text.substr(1) : text;
}

}  // namespace

Trajectory read_trajectory(const std::filesystem::path& path) {
    return parse_trajectory(input::read_text(path), path.string());
}

Trajectory parse_trajectory(std::string_view text, const std::string& name) {
    Trajectory trajectory;
    std::uint64_t number = 0;
    while (const auto line = input::next_line(text)) {
        ++number;
        const std::string_view content = input::trimmed(*line);
        if (content.empty() || content.starts_with('#')) continue;
        trajectory.push_back(pose_from(content, name, number));
    }
    if (trajectory.empty()) {
        throw FormatError(
            name, 0,
            message(HITOS_TEXT(
                "Errors",
                "no pose in the file; expected 8 numbers, t x y z qx qy qz qw on each line")));
    }
    return trajectory;
}

std::string trajectory_to_text(const Trajectory& trajectory) {
    std::string text;
    for (std::size_t i = 0; i < trajectory.size(); ++i) {
        const auto& [t, pose] = trajectory[i];
        if (!std::isfinite(t) || !std::isfinite(pose.x) || !std::isfinite(pose.y) ||
            !std::isfinite(pose.theta)) {
            throw Error(message(HITOS_TEXT("Errors",
                                           "pose %1 of the trajectory (t %2, x %3, y %4, theta %5) "
                                           "is not finite and cannot be written"),
                                i, t, pose.x, pose.y, pose.theta));
        }
        const double half = wrap_angle(pose.theta) / 2.0;
        text += fmt::format("{} {} {} 0 0 0 {} {}\n", without_sign_of_zero(t),
                            nine_decimals(pose.x), nine_decimals(pose.y),
                            nine_decimals(std::sin(half)), nine_decimals(std::cos(half)));
    }
    return text;
}

void write_trajectory(const Trajectory& trajectory, const std::filesystem::path& path) {
    write_file(path, trajectory_to_text(trajectory));
}

}  // namespace hitos
