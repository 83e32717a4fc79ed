// SPDX-License-Identifier: GPL-3.0-or-later
#include "landmark_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "hitos/base/error.hpp"
#include "hitos/base/rounding.hpp"
#include "map_shapes.hpp"

namespace hitos {
namespace {

/// Empty where the end is not known.
std::string end_text(double end_m) {
    return std::isfinite(end_m) ? fmt::format("{}", without_sign_of_zero(end_m)) : std::string();
}

void put_covariance(std::string& out, const Eigen::Matrix2d& covariance) {
    if (!is_known(covariance)) {
        out += ",,,";
        return;
    }
    fmt::format_to(std::back_inserter(out), ",{},{},{}", without_sign_of_zero(covariance(0, 0)),
                   without_sign_of_zero(covariance(0, 1)), without_sign_of_zero(covariance(1, 1)));
}

}  // namespace

std::string landmark_table(const LandmarkMap& map) {
    // Of few tours only: sensors that tell landmarks apart are rare.
    const bool identities = std::ranges::any_of(
        map, [](const ICaracteristica& landmark) { return landmark.identity >= 0; });
    std::string out =
        "map_line,kind,landmark,rho_m,theta_rad,x_m,y_m,"
        "cov_rho_rho_m2,cov_rho_theta_m_rad,cov_theta_theta_rad2,"
        "cov_x_x_m2,cov_x_y_m2,cov_y_y_m2,"
        "from_m,to_m,observations,first_scan,last_scan";
    out += identities ? ",identity\n" : "\n";
    int row = 0;
    for (const FeatureKind kind : {FeatureKind::line, FeatureKind::corner}) {
        int number = 0;
        for (const ICaracteristica& landmark : map) {
            if (landmark.kind() != kind) continue;
            const Point2 point = landmark.point();
            if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
                throw Error(message(
                    HITOS_TEXT("Errors",
                               "landmark %1 of the map is not finite and cannot be written"),
                    row + 1));
            }
            fmt::format_to(std::back_inserter(out), "{},{},{}", ++row, to_string(kind), ++number);
            if (const auto* line = std::get_if<Recta>(&landmark.value)) {
                fmt::format_to(std::back_inserter(out), ",{},{},,", without_sign_of_zero(line->rho),
                               without_sign_of_zero(line->theta));
                put_covariance(out, landmark.covariance);
                out += ",,,";
                fmt::format_to(std::back_inserter(out), ",{},{}", end_text(landmark.from_m),
                               end_text(landmark.to_m));
            } else {
                fmt::format_to(std::back_inserter(out), ",,,{},{},,,",
                               without_sign_of_zero(point.x), without_sign_of_zero(point.y));
                put_covariance(out, landmark.covariance);
                out += ",,";
            }
            fmt::format_to(std::back_inserter(out), ",{},{},{}", landmark.observations,
                           landmark.first_seen + 1, landmark.last_seen + 1);
            if (identities) out += ',';
            if (landmark.identity >= 0) out += std::to_string(landmark.identity);
            out += '\n';
        }
    }
    return out;
}

}  // namespace hitos
