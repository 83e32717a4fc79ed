// SPDX-License-Identifier: GPL-3.0-or-later
// Lines by successive edge following, RANSAC and total least squares [P 2].
#pragma once

#include <cstdint>
#include <vector>

#include "collinear_merge.hpp"
#include "hitos/base/random_stream.hpp"
#include "hitos/features/line_methods.hpp"

namespace hitos {

/// Successive edge following cuts the scan where the range jumps; in each run RANSAC (Fischler and
/// Bolles, 1981) finds the line with the largest consensus, takes its points away and goes on with
/// the rest; total least squares fits. Where lines meet, each point then goes to the nearest. In
/// the paper's own order RANSAC has the whole scan, and edges divide the points of each line.
class RansacLines final : public MetodoExtraccionRectas {
  public:
    RansacLines(const LineParams& lines, const RansacParams& ransac, std::uint64_t seed)
        : lines_params_(lines), params_(ransac), seed_(seed) {}
    void go_to(std::uint64_t scan) override { next_scan_ = scan; }
    void extract_lines(const Scan& scan, Observation& out) override;

  private:
    /// Points of a run that no line has taken yet.
    struct Candidates {
        std::vector<double> x;
        std::vector<double> y;
        std::size_t size() const { return x.size(); }
    };

    std::span<const Point2> in_order(const Scan& scan);
    void follow_edges(std::span<const Point2> points, std::size_t begin, std::size_t end,
                      RandomStream& random);
    bool parted(std::size_t last, std::size_t next) const;
    bool edge_between(double range_a, double range_b) const;
    void search(std::span<const Point2> run, RandomStream& random);
    /// The line through two points with the most points nearer than the threshold; false where
    /// no hypothesis reaches the fewest points of a line.
    bool hypothesize(RandomStream& random, Recta& best) const;
    /// Fits the points near the line anew until their number no longer changes.
    bool refine(Recta& line);
    void keep_pieces(std::span<const Point2> run);
    /// The point at which one line passes to the next belongs to both, as in Split & Merge.
    void share_corners(std::span<const Point2> run);
    /// points_ from `first` on, where they are enough for a line; else they are dropped.
    void keep_piece(std::size_t first);
    bool near(const PreparedRecta& line, const Point2& point) const;
    bool long_enough(std::span<const Point2> points, const Recta& line) const;

    LineParams lines_params_;
    RansacParams params_;
    std::uint64_t seed_;
    std::uint64_t next_scan_ = 0;
    // Working memory, kept between scans.
    std::vector<double> ranges_;  // of all points, from the laser
    std::vector<Point2> around_;  // those of a scan that goes all round, in the order used
    std::vector<std::uint32_t>
        run_of_;  // run of neighbours of each point, where RANSAC comes first
    std::span<const double> run_ranges_;  // of the run at hand
    Candidates candidates_;
    std::vector<Recta> found_;             // in the run at hand
    std::vector<PreparedRecta> prepared_;  // the same
    std::vector<Point2> consensus_;
    std::vector<std::size_t> nearest_;  // line of each point of the run
    std::vector<std::size_t> shared_;   // second line of each point at a corner
    std::vector<std::size_t> order_;
    std::vector<std::size_t> place_;  // of each point among those that may part a line's
    std::vector<Point2> fitted_;      // of the piece at hand, without shared ones
    std::vector<Point2> points_;      // of all pieces, piece by piece
    std::vector<LinePiece> pieces_;
};

/// "ransac".
LineMethodEntry ransac_method();

}  // namespace hitos
