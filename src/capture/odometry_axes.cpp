// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/odometry_axes.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "hitos/capture/archivo.hpp"
#include "remedies.hpp"

namespace hitos {
namespace {

constexpr double kTurnDegrees = 360.0;

/// From a heading that was read as `last` to the next one. Quaternions hold what is left of degrees
/// by whole turns of radians: of what it may have been, up to half a turn, the nearest.
double step_in_degrees(double last, double heading) {
    constexpr double kOfRadians = kPi * (1.0 + 1e-6);
    constexpr int kMost = 28;  // turns of radians in half a turn of degrees
    double step = std::remainder(heading - last, kTurnDegrees);
    if (std::abs(heading) > kOfRadians) return step;
    for (int turns = -kMost; turns <= kMost; ++turns) {
        const double other = std::remainder(heading + turns * 2.0 * kPi - last, kTurnDegrees);
        if (std::abs(other) < std::abs(step)) step = other;
    }
    return step;
}

/// A step from one of these to the other is one of their sum's halves, across a turn's end too.
double middle_of(double from_rad, double to_rad) {
    return from_rad + wrap_angle(to_rad - from_rad) / 2.0;
}

/// To a quarter of a turn, which axes differ by, where it is about one.
double rounded(double sum_rad) {
    constexpr double kQuarter = kPi / 2.0;
    constexpr double kNear = 8.0 * kRadiansPerDegree;
    const double quarter = std::round(sum_rad / kQuarter) * kQuarter;
    return wrap_angle(std::abs(sum_rad - quarter) < kNear ? quarter : sum_rad);
}

}  // namespace

OdometryAxes::OdometryAxes(std::string_view text) {
    if (input::trimmed(text).empty()) return;
    const auto refuse = [&] {
        return ConfigError(
            kOdometryAxesKey,
            HITOS_TEXT("Errors",
                       "found \"%1\", expected what the log has in the place of x, y and heading: "
                       "\"x,y,theta\" with axes in another order or negative and theta, or degrees "
                       "where it is in degrees, as in \"y,x,theta\", \"x,y,90-theta\", "
                       "\"x,y,degrees\""),
            text);
    };
    const std::vector<std::string_view> words = input::listed(text);
    if (words.size() != 3) throw refuse();
    const auto axis_of = [&](std::string_view word) {
        Axis axis;
        if (word.starts_with('-')) {
            axis.sign = -1.0;
            word.remove_prefix(1);
        }
        axis.of_y = word == "y";
        if (word != "x" && word != "y") throw refuse();
        return axis;
    };
    x_ = axis_of(words[0]);
    y_ = axis_of(words[1]);
    if (x_.of_y == y_.of_y) throw refuse();
    // A heading with an angle before or behind it.
    std::string angle(words[2]);
    const bool radians = angle.find("theta") != std::string::npos;
    const std::string_view name = radians ? "theta" : "degrees";
    const std::size_t place = angle.find(name);
    if (place == std::string::npos) throw refuse();
    degrees_ = !radians;
    std::size_t begin = place;
    if (place > 0) {
        begin = place - 1;
        if (angle[begin] != '-' && angle[begin] != '+') throw refuse();
        if (angle[begin] == '-') sign_ = -1.0;
    }
    angle.erase(begin, place + name.size() - begin);
    if (angle.empty()) return;
    if (begin == 0 && angle.front() != '-' && angle.front() != '+') throw refuse();
    if (angle.front() == '+') angle.erase(0, 1);
    const std::optional<double> degrees = input::parse_number(angle);
    if (!degrees || !std::isfinite(*degrees)) throw refuse();
    offset_rad_ = std::remainder(*degrees, kTurnDegrees) * kRadiansPerDegree;
}

OdometryAxes OdometryAxes::then(const OdometryAxes& others) const {
    OdometryAxes both;
    const auto axis = [&](const Axis& other) {
        const Axis& mine = other.of_y ? y_ : x_;
        return Axis{mine.of_y, mine.sign * other.sign};
    };
    both.x_ = axis(others.x_);
    both.y_ = axis(others.y_);
    both.sign_ = sign_ * others.sign_;
    both.degrees_ = degrees_ || others.degrees_;
    const double unit = others.degrees_ ? kRadiansPerDegree : 1.0;  // in which mine is read
    both.offset_rad_ = wrap_angle(others.sign_ * unit * offset_rad_ + others.offset_rad_);
    return both;
}

OdometryAxes OdometryAxes::in_radians() const {
    OdometryAxes axes = *this;
    axes.degrees_ = false;
    return axes;
}

std::string OdometryAxes::text() const {
    const auto axis = [](const Axis& one) {
        return fmt::format("{}{}", one.sign < 0.0 ? "-" : "", one.of_y ? "y" : "x");
    };
    const std::string_view heading = degrees_ ? "degrees" : "theta";
    constexpr double kNone = 1e-6;
    const double offset = offset_rad_ * kDegreesPerRadian;
    const bool none = std::abs(offset) < kNone;
    std::string angle;
    if (sign_ > 0.0) {
        angle = none ? std::string(heading) : fmt::format("{}{:+.4g}", heading, offset);
    } else {
        angle = none ? fmt::format("-{}", heading) : fmt::format("{:.4g}-{}", offset, heading);
    }
    return fmt::format("{},{},{}", axis(x_), axis(y_), angle);
}

Pose OdometryAxes::taken(const Pose& logged) {
    const auto along = [&](const Axis& axis) {
        return axis.sign * (axis.of_y ? logged.y : logged.x);
    };
    double heading = logged.theta;
    if (degrees_) {
        sum_deg_ += begun_ ? step_in_degrees(sum_deg_, heading) : heading;
        begun_ = true;
        heading = sum_deg_ * kRadiansPerDegree;
    }
    return {along(x_), along(y_), sign_ * heading + offset_rad_};
}

void HeadingCheck::Reading::note(double direction, double heading, double weight) {
    doubled += std::polar(weight, 2.0 * (direction - middle_of(from_rad, heading)));
    from_rad = heading;
}

void HeadingCheck::note(const Pose& pose) {
    constexpr double kPiece = 0.05;  // [m]: of less, rounding may be the direction
    constexpr double kMost = 1.0;    // of leaps, and of units that are none
    const double degrees_rad = degrees_.taken(pose).theta;
    if (from_) {
        const double way = std::hypot(pose.x - from_->x, pose.y - from_->y);
        if (!(way >= kPiece)) return;
        const double weight = std::min(way, kMost);
        const double direction = std::atan2(pose.y - from_->y, pose.x - from_->x);
        const double sum = direction + middle_of(told_.from_rad, pose.theta);
        against_ahead_ += std::polar(weight, sum);
        told_.note(direction, pose.theta, weight);
        against_.note(direction, -pose.theta, weight);
        in_degrees_.note(direction, degrees_rad, weight);
        straight_.note(direction, 0.0, weight);
        way_ += weight;
    }
    from_ = pose;
    told_.from_rad = pose.theta;
    against_.from_rad = -pose.theta;
    in_degrees_.from_rad = degrees_rad;
}

std::optional<TourFinding> HeadingCheck::doubt(const ReadOptions& read) const {
    constexpr double kLeastWay = 3.0;
    constexpr double kAllAlong = 0.9;
    constexpr double kClear = 0.04;  // of a robot on wheels it is all but the whole way
    const auto share = [&](const Reading& reading) { return std::abs(reading.doubled) / way_; };
    if (!(way_ > kLeastWay)) return std::nullopt;
    const double told = share(told_);
    const double against_share = share(against_);
    const double of_degrees = share(in_degrees_);
    const double best = std::max(against_share, of_degrees);
    if (best < kAllAlong || best < std::max(told, share(straight_)) + kClear) return std::nullopt;
    const auto percents = [](double of) { return std::lround(100.0 * of); };
    if (of_degrees > against_share) {
        return TourFinding{
            TourFinding::Kind::odometry_units,
            kRadiansPerDegree,
            message(HITOS_TEXT("Errors",
                               "the odometry's headings are where its positions go if they are in "
                               "degrees (%1 % of the way, against %2 % as they are read)"),
                    percents(of_degrees), percents(told)),
            {headings_in_degrees(read)}};
    }
    // Ahead where the robot mostly drives so; else one of both.
    const double doubled = std::arg(against_.doubled) / 2.0;
    const double ahead = std::arg(against_ahead_);
    const double sum =
        rounded(std::cos(ahead - doubled) < 0.0 ? wrap_angle(doubled + kPi) : doubled);
    return TourFinding{
        TourFinding::Kind::sideways_odometry,
        sum,
        message(
            HITOS_TEXT("Errors",
                       "the odometry's headings turn the other way than its positions (they fit "
                       "each other on %1 % of the way so, on %2 % as they are told): headings "
                       "count to the right, or an axis of the positions is swapped or negative"),
            percents(against_share), percents(told)),
        {reversed_headings(sum, read), reversed_positions(sum, read)}};
}

Remedy headings_in_degrees(const ReadOptions& read) {
    return {say_so(), WholeValues(read).axes(OdometryAxes("x,y,degrees"))};
}

Remedy reversed_headings(double sum_rad, const ReadOptions& read) {
    const OdometryAxes axes(fmt::format("x,y,{}-theta", std::lround(sum_rad * kDegreesPerRadian)));
    return {marked(HITOS_TEXT("Errors", "where the headings are wrong, let them turn")),
            WholeValues(read).axes(axes)};
}

Remedy reversed_positions(double sum_rad, const ReadOptions& read) {
    static constexpr std::array<std::string_view, 4> kAxes{"x,-y", "y,x", "-x,y", "-y,-x"};
    constexpr double kQuarter = kPi / 2.0;
    const double quarters = std::round(sum_rad / kQuarter);
    const long off = std::lround((sum_rad - quarters * kQuarter) * kDegreesPerRadian);
    const OdometryAxes axes(fmt::format(
        "{},theta{:+}", kAxes.at((static_cast<std::size_t>(quarters + 4.0)) % kAxes.size()), -off));
    return {marked(HITOS_TEXT("Errors", "where the positions are wrong, put their axes right")),
            WholeValues(read).axes(axes)};
}

}  // namespace hitos
