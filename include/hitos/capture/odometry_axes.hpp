// SPDX-License-Identifier: GPL-3.0-or-later
// Which way the axes and the heading of logged poses point.
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <string_view>

#include "hitos/base/geometry.hpp"
#include "hitos/capture/tour_finding.hpp"

namespace hitos {

struct ReadOptions;

/// Takes poses of other axes to x, y to the left of it, and a heading in radians from x to y.
class OdometryAxes {
  public:
    /// What stands in the place of x, y and heading: "y,x,theta", "x,y,90-theta", "x,y,degrees".
    /// Empty: all as logged. Throws ConfigError, under the parameter's key, for another text.
    explicit OdometryAxes(std::string_view text = {});
    /// Asked for every pose, in order: headings in degrees may have been wrapped to a turn of
    /// radians.
    Pose taken(const Pose& logged);

    /// These axes, and then those of what they give.
    OdometryAxes then(const OdometryAxes& others) const;
    std::string text() const;
    /// The same with headings in radians.
    OdometryAxes in_radians() const;
    bool in_degrees() const { return degrees_; }

  private:
    struct Axis {
        bool of_y = false;
        double sign = 1.0;
    };
    Axis x_;
    Axis y_{.of_y = true};
    double sign_ = 1.0;
    double offset_rad_ = 0.0;
    bool degrees_ = false;
    bool begun_ = false;
    double sum_deg_ = 0.0;  ///< heading in degrees, without leaps of whole turns
};

/// Holds the headings of logged poses against the directions in which their positions move.
class HeadingCheck {
  public:
    void note(const Pose& pose);
    /// Headings that turn the other way than the positions do, or are in degrees.
    std::optional<TourFinding> doubt(const ReadOptions& read) const;

  private:
    /// How a reading of the headings fits: the directions of the way less it, doubled, so that
    /// ahead and back are one.
    struct Reading {
        double from_rad = 0.0;  ///< heading where the newest piece of way begins
        std::complex<double> doubled;
        void note(double direction, double heading, double weight);
    };
    Reading told_;
    Reading against_;
    Reading in_degrees_;
    Reading straight_;                    ///< no heading: by how much the way bends at all
    std::complex<double> against_ahead_;  ///< not doubled
    OdometryAxes degrees_{"x,y,degrees"};
    std::optional<Pose> from_;
    double way_ = 0.0;
};

Remedy headings_in_degrees(const ReadOptions& read);
/// What mends headings that turn the other way than the positions: `sum_rad` are direction and
/// heading together, the same all along. By the headings, or by the positions.
Remedy reversed_headings(double sum_rad, const ReadOptions& read);
Remedy reversed_positions(double sum_rad, const ReadOptions& read);

}  // namespace hitos
