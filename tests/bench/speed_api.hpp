// SPDX-License-Identifier: GPL-3.0-or-later
// What the bench of speed calls of Hitos, the same for this build and for the release that it is
// compared with, whose interface was another (HITOS_BASELINE; speed.cmake forwards moved headers).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/base/random_stream.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/procesador.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/drawing/picture_file.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/services/files/trajectory_file.hpp"
#include "hitos/services/grid/grid.hpp"
#include "hitos/simulation/drive/simulated_tour.hpp"
#include "hitos/simulation/worlds/odometry_noise.hpp"
#include "hitos/slam/filters.hpp"
#include "hitos/slam/resampler.hpp"

namespace speed {

inline void step(hitos::SlamFilter& filter, [[maybe_unused]] const hitos::Scan& scan,
                 std::span<const hitos::Control> controls, const hitos::Observation& seen) {
#ifdef HITOS_BASELINE
    filter.step(controls, seen);
#else
    filter.step({scan, controls, seen});
#endif
}

/// Of the best hypothesis.
inline int landmarks(const hitos::SlamFilter& filter) {
#ifdef HITOS_BASELINE
    return filter.best_lines() + filter.best_corners();
#else
    return filter.best_count(hitos::FeatureKind::line) +
           filter.best_count(hitos::FeatureKind::corner);
#endif
}

inline void take_ekf_slam(hitos::FilterParams& params) {
#ifdef HITOS_BASELINE
    params.algorithm = hitos::SlamAlgorithm::ekf_slam;
#else
    params.algorithm = "ekf-slam";
#endif
}

inline void take_proportional_motion(hitos::FilterParams& params) {
#ifdef HITOS_BASELINE
    params.motion.model = hitos::MotionModel::proportional;
#else
    params.motion.model = "proportional";
#endif
}

/// Which particles low-variance resampling copies.
class Selection {
  public:
    void select(std::span<const double> weights, std::uint64_t step) {
        hitos::RandomStream random(1, hitos::RandomPurpose::resampling, step, 0);
#ifdef HITOS_BASELINE
        hitos::low_variance_selection(weights, random.uniform(), selected_);
#else
        method_->select(weights, random, selected_);
#endif
    }
    const std::vector<std::uint32_t>& selected() const {
        return selected_;
    }

  private:
#ifndef HITOS_BASELINE
    std::unique_ptr<hitos::ResamplingMethod> method_ =
        hitos::resampling_methods().find("low-variance").make({});
#endif
    std::vector<std::uint32_t> selected_;
};

}  // namespace speed
