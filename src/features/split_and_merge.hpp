// SPDX-License-Identifier: GPL-3.0-or-later
// Split & Merge as the thesis implements it [T 4.4].
#pragma once

#include <vector>

#include "collinear_merge.hpp"
#include "hitos/features/line_methods.hpp"

namespace hitos {

/// Recursive splitting at the farthest point [T table 4.3] in every run of neighbours, then the
/// merge of collinear pieces [T table 4.4], first piece first. What is shorter than a line may be
/// is dropped before it is split, as in the thesis, whose laser sees half a turn; where one sees
/// further round, once it is found to be straight.
class SplitAndMerge final : public MetodoExtraccionRectas {
  public:
    SplitAndMerge(const LineParams& lines, const SplitMergeParams& params)
        : lines_(lines), params_(params) {}
    void extract_lines(const Scan& scan, Observation& out) override;
    bool fits_end_points() const override { return params_.fit == LineFit::endpoints; }

  private:
    /// Whether neighbours are further apart than their range from the laser allows.
    bool gap_between(const Point2& a, const Point2& b, const Point2& laser) const;
    /// Divides what comes back to where it began at the point that is farthest from there; false
    /// where it does not.
    bool split_at_far_side(const Scan& scan, std::uint32_t begin, std::uint32_t end);
    /// Of a piece, the most points in a row that are no further apart than the shortest line is
    /// long: a wall that is seen along itself would else take a point of what lies behind its end.
    std::span<const Point2> without_strangers(std::span<const Point2> points) const;
    void split(const Scan& scan, std::uint32_t first, std::uint32_t last);

    LineParams lines_;
    SplitMergeParams params_;
    bool beyond_half_a_turn_ = false;  // the scan at hand
    // Working memory, kept between scans.
    std::vector<LinePiece> pieces_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pending_;
};

/// "split-merge".
LineMethodEntry split_and_merge_method();

}  // namespace hitos
