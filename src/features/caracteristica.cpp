// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/features/caracteristica.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace hitos {

std::string_view to_string(FeatureKind kind) {
    return kind == FeatureKind::line ? "line" : "corner";
}

Recta normalized(const Recta& recta) {
    if (recta.rho < 0.0) return {-recta.rho, wrap_angle(recta.theta + kPi)};
    return {recta.rho, wrap_angle(recta.theta)};
}

Recta line_through(const Point2& a, const Point2& b) {
    const double theta = std::atan2(a.x - b.x, b.y - a.y);
    // The middle of the two points cancels the error of theta to first order.
    const double rho = 0.5 * ((a.x + b.x) * std::cos(theta) + (a.y + b.y) * std::sin(theta));
    return normalized({rho, theta});
}

LineDifference difference(const Recta& a, const Recta& b) {
    const double turn = std::abs(wrap_angle(a.theta - b.theta));
    if (turn > kPi / 2.0) return {std::abs(a.rho + b.rho), kPi - turn};
    return {std::abs(a.rho - b.rho), turn};
}

Point2 foot(const Recta& recta) {
    return {recta.rho * std::cos(recta.theta), recta.rho * std::sin(recta.theta)};
}

double signed_distance(const Recta& recta, const Point2& point) {
    return PreparedRecta(recta).signed_distance(point);
}

Recta transform(const Pose& pose_a_b, const Recta& recta_b) {
    const double theta = recta_b.theta + pose_a_b.theta;
    const double rho = recta_b.rho + pose_a_b.x * std::cos(theta) + pose_a_b.y * std::sin(theta);
    return normalized({rho, theta});
}

Esquina transform(const Pose& pose_a_b, const Esquina& esquina_b) {
    const Point2 point = transform(pose_a_b, Point2{esquina_b.x, esquina_b.y});
    return {point.x, point.y};
}

Point2 ICaracteristica::point() const {
    if (const auto* recta = std::get_if<Recta>(&value)) return foot(*recta);
    const auto& esquina = std::get<Esquina>(value);
    return {esquina.x, esquina.y};
}

ICaracteristica transform(const Pose& pose_a_b, const ICaracteristica& landmark_b) {
    ICaracteristica landmark_a = landmark_b;
    Eigen::Matrix2d jacobian;
    if (const auto* recta = std::get_if<Recta>(&landmark_b.value)) {
        const double theta = recta->theta + pose_a_b.theta;
        const double rho = recta->rho + pose_a_b.x * std::cos(theta) + pose_a_b.y * std::sin(theta);
        const double side = rho < 0.0 ? -1.0 : 1.0;  // the flip to normal form turns rho's sign
        // How far the foot stays behind along the line.
        const double shift = pose_a_b.y * std::cos(theta) - pose_a_b.x * std::sin(theta);
        jacobian << side, side * shift,  //
            0.0, 1.0;
        std::tie(landmark_a.from_m, landmark_a.to_m) =
            std::minmax({side * (landmark_b.from_m + shift), side * (landmark_b.to_m + shift)});
        landmark_a.value = normalized({rho, theta});
    } else {
        jacobian << std::cos(pose_a_b.theta), -std::sin(pose_a_b.theta),  //
            std::sin(pose_a_b.theta), std::cos(pose_a_b.theta);
        landmark_a.value = transform(pose_a_b, std::get<Esquina>(landmark_b.value));
    }
    landmark_a.covariance = jacobian * landmark_b.covariance * jacobian.transpose();
    return landmark_a;
}

}  // namespace hitos
