// SPDX-License-Identifier: GPL-3.0-or-later
// Trees and posts: round things that stand alone.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "hitos/features/extractor.hpp"

namespace hitos {

/// A ray that met something, as its laser saw it.
struct SeenPoint {
    double bearing_rad = 0.0;  ///< in the robot's axes
    double range_m = 0.0;
    std::uint32_t point = 0;  ///< its index in the scan
};

/// A circle as the laser sees it, and how sure that is.
struct FittedCircle {
    double range_m = 0.0;  ///< of its centre, from the laser
    double bearing_rad = 0.0;
    double radius_m = 0.0;
    Eigen::Matrix2d covariance;  ///< of (range [m], bearing [rad]) of the centre
};

/// How ranges and rays lie.
struct CircleErrors {
    double range_sigma_m = 0.01;
    double step_rad = 0.0;  ///< from one ray to the next
};

/// The circle whose edges lie between the outermost of these rays, which follow each other
/// counter-clockwise, and the free ones beside them, and which passes through their points. Begun
/// by the angle that it covers, as Guivant, Masson and Nebot do (Simultaneous localization and map
/// building using natural features and absolute information, Robotics and Autonomous Systems 40,
/// 2002): radius = range times half that angle. Then Gauss-Newton over the distances of the points
/// from the circle [Gander, Golub, Strebel, Least-squares fitting of circles and ellipses, BIT 34,
/// 1994] and over both edges, each of which lies anywhere between two rays. Many points say what
/// the circle is by themselves; of one or two the edges say it. The covariance is that of the last
/// step. Nothing where the points are not on it, to within four sigma of their chi square.
std::optional<FittedCircle> fit_circle(std::span<const SeenPoint> seen, const CircleErrors& errors);

/// Finds circles and hands what is left of the scan to another extractor. Circles are the first of
/// the corners.
class CircleExtractor final : public Extractor {
  public:
    CircleExtractor(const ExtractionParams& params, std::unique_ptr<Extractor> rest)
        : params_(params.circles),
          sigma_m_(params.point_sigma_m),
          common_sigma_m_(params.common_sigma_m),
          rest_(std::move(rest)) {}
    void go_to(std::uint64_t scan) override { rest_->go_to(scan); }
    void extract(const Scan& scan, Observation& out) override;

  private:
    void look(const Scan& scan);
    void find(const Scan& scan);
    double turn_to_next(std::size_t i) const;
    bool joins_next(std::size_t i) const;
    bool stands_alone(std::size_t first, std::size_t count, const Scan& scan) const;
    bool clear_beside(const SeenPoint& end, std::size_t from, bool left, const Scan& scan) const;
    const Scan& without_circles(const Scan& scan);

    CircleParams params_;
    double sigma_m_;
    double common_sigma_m_;
    std::unique_ptr<Extractor> rest_;
    // Working memory: the scan counter-clockwise.
    std::vector<SeenPoint> ring_;
    bool closed_ = false;
    double step_rad_ = 0.0;
    std::vector<FittedCircle> circles_;
    std::vector<SeenPoint> cluster_;
    std::vector<bool> taken_;  // points of circles
    Scan left_;
};

}  // namespace hitos
