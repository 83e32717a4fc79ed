// The extractors of [T fig 9.7].
#pragma once

#include <memory>
#include <vector>

#include "hitos/features/extractor.hpp"

namespace hitos {

/// Appends the corners of the detected lines: the intersections of two lines that lie within
/// `corner_distance_m` of a supporting point of both [T table 4.2].
void find_corners(const Observation& lines, double corner_distance_m, std::vector<Esquina>& out);

/// Lines only.
class ExRectas final : public Extractor {
  public:
    explicit ExRectas(std::unique_ptr<MetodoExtraccionRectas> method)
        : method_(std::move(method)) {}
    void extract(const Scan& scan, Observation& out) override;

  private:
    std::unique_ptr<MetodoExtraccionRectas> method_;
};

/// Corners, and the lines that make them where `keep_lines` is set.
class ExPuntos final : public Extractor {
  public:
    ExPuntos(std::unique_ptr<MetodoExtraccionRectas> method, double corner_distance_m,
             bool keep_lines)
        : method_(std::move(method)),
          corner_distance_m_(corner_distance_m),
          keep_lines_(keep_lines) {}
    void extract(const Scan& scan, Observation& out) override;

  private:
    std::unique_ptr<MetodoExtraccionRectas> method_;
    double corner_distance_m_;
    bool keep_lines_;
};

}  // namespace hitos
