// SPDX-License-Identifier: GPL-3.0-or-later
// The extractors of [T fig 9.7].
#pragma once

#include <memory>

#include "hitos/features/extractor.hpp"
#include "hitos/features/line_fit.hpp"
#include "hitos/features/line_methods.hpp"

namespace hitos {

/// Appends the corners of the detected lines: the intersections of two lines that lie within
/// `corner_distance_m` of a supporting point of both [T table 4.2] and make at least the angle
/// `corner_angle_rad`, modulo pi; with their covariances where the lines have theirs.
void find_corners(Observation& seen, double corner_distance_m, double corner_angle_rad = 0.0);

/// Finds lines by the method that the parameters name and says, where they ask for it, how sure
/// each of them is.
class LineFinder {
  public:
    LineFinder(const ExtractionParams& params, std::uint64_t seed);
    void go_to(std::uint64_t scan) { method_->go_to(scan); }
    /// Replaces the content of `out`.
    void find(const Scan& scan, Observation& out);
    /// Whether fit_all() may change the lines that find() gives.
    bool may_fit() const { return method_->fits_end_points(); }
    /// Fits every line anew, to all its points by least squares, and says how sure it then is.
    void fit_all(const Scan& scan, Observation& out) const;

  private:
    PointErrors errors(const Scan& scan) const;

    std::unique_ptr<MetodoExtraccionRectas> method_;
    ObservationCovariance covariance_;
    double point_sigma_m_;
    double common_sigma_m_;
    Scan cut_open_;  ///< working memory
};

/// Lines only.
class ExRectas final : public Extractor {
  public:
    explicit ExRectas(LineFinder lines) : lines_(std::move(lines)) {}
    void go_to(std::uint64_t scan) override { lines_.go_to(scan); }
    void extract(const Scan& scan, Observation& out) override;

  private:
    LineFinder lines_;
};

/// Corners, and the lines that make them where `keep_lines` is set.
class ExPuntos final : public Extractor {
  public:
    ExPuntos(LineFinder lines, double corner_distance_m, double corner_angle_rad,
             CornerLines corner_lines, bool keep_lines)
        : lines_(std::move(lines)),
          corner_distance_m_(corner_distance_m),
          corner_angle_rad_(corner_angle_rad),
          fit_(corner_lines == CornerLines::fitted && lines_.may_fit()),
          keep_lines_(keep_lines) {}
    void go_to(std::uint64_t scan) override { lines_.go_to(scan); }
    void extract(const Scan& scan, Observation& out) override;

  private:
    LineFinder lines_;
    double corner_distance_m_;
    double corner_angle_rad_;
    bool fit_;  ///< the lines are fitted anew for the corners
    bool keep_lines_;
    // Working memory: the lines as they were detected.
    std::vector<DetectedLine> detected_;
    std::vector<Eigen::Matrix2d> detected_covariances_;
};

}  // namespace hitos
