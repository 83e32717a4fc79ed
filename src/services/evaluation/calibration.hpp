// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the regions that a filter gives hold the truth as often as they say.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "hitos/services/evaluation/nees.hpp"
#include "hitos/services/files/line_extents.hpp"
#include "hitos/services/files/map_file.hpp"

namespace hitos {

class SlamFilter;

/// The probability that a chi-square variable with 1, 2 or 3 degrees of freedom is at most
/// x (Abramowitz and Stegun, Handbook of Mathematical Functions, 1964, 26.4.4 and 26.4.5).
double chi_square_probability(double x, int degrees);

/// How often the truth lay in regions of normal variables with 1, 2 or 3 values.
class Coverage {
  public:
    explicit Coverage(int degrees) : degrees_(degrees) {}

    /// e' P^-1 e, with e how far the truth is from the estimate and P the estimate's covariance.
    void add(double squared);
    int degrees() const { return degrees_; }
    int count() const { return count_; }
    /// The mean of what was added: `degrees` where the covariances tell the truth; 0 of nothing.
    double mean() const { return count_ == 0 ? 0.0 : sum_ / count_; }
    /// The share that lay in the region of kRegions; 0 of nothing.
    double inside(std::size_t region) const {
        return count_ == 0 ? 0.0 : static_cast<double>(inside_.at(region)) / count_;
    }

  private:
    int degrees_;
    int count_ = 0;
    double sum_ = 0.0;
    std::array<int, kRegions.size()> inside_{};
};

/// Of one run whose truth is known.
struct Calibration {
    Coverage pose{3};       ///< at every scan at which the mean pose has a covariance
    Coverage landmarks{2};  ///< at the end: of the map against the true one
    Coverage distances{1};  ///< likewise, between walls
};

/// What one of several hypotheses has of the best map.
struct HypothesisMap {
    double weight = 0.0;
    LandmarkMap map;
    /// Of every landmark of the best map the place in this one of what is nearest to it of its
    /// kind and has none nearer in the best map; nothing where there is none such.
    std::vector<std::optional<std::size_t>> places;
};
/// Each with weight in turn.
void for_each_hypothesis(const SlamFilter& filter, const LandmarkMap& best,
                         const std::function<void(const HypothesisMap&)>& visit);

/// The best map with the uncertainty of all hypotheses: each landmark's values and covariance are
/// those of the mixture, by weights, of what the hypotheses have of it. Of a filter with a single
/// hypothesis its map.
LandmarkMap mixed_map(const SlamFilter& filter);

/// Counts every landmark against the nearest of its kind in the reference, which is in the same
/// frame; a line by its rho and theta, a corner by its x and y. One without uncertainty is passed
/// over.
void count_landmarks(Coverage& coverage, const LandmarkMap& map, const LandmarkMap& reference);

/// Counts how far apart the best map has walls that in the reference, which is in the same frame,
/// are parallel with none between them: from line to line along the true normal, midway between
/// where both were seen (`extents`, of that map). The variance of a distance is that of
/// joint_covariance(), or of the mixture of what the hypotheses have of both lines, which are
/// independent in each. Nothing of a filter that has neither.
void count_distances(Coverage& coverage, const SlamFilter& filter,
                     std::span<const LineExtent> extents, const LandmarkMap& reference);

}  // namespace hitos
