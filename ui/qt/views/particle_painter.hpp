// SPDX-License-Identifier: GPL-3.0-or-later
// Particles as marks on the plane: what one of them believes, and where all of them come from.
#pragma once

#include <vector>

#include "canvas_paint.hpp"
#include "hitos/services/run/run_worker.hpp"

namespace hitos::window {

/// Map, path and pose of one hypothesis, which are in the world's frame.
void draw_particle(QPainter& painter, const Scene& scene, const ParticleDetails& particle,
                   const Pose& pose_view_world);
/// The histories of all particles as the tree that they are: the more particles have a branch
/// behind them, the stronger it is. `begins`: scans at which another tour does.
void draw_ancestry(QPainter& painter, const Scene& scene,
                   const std::vector<HistoryBranch>& branches,
                   const std::vector<std::size_t>& begins, const Pose& pose_view_world);

/// The cloud: places with headings, in the view's frame, and how heavy each is beside the heaviest.
struct ParticleCloud {
    std::vector<QLineF> particles;
    std::vector<double> weights;  ///< 0 … 1
};
void draw_cloud(QPainter& painter, const Scene& scene, const ParticleCloud& cloud);

}  // namespace hitos::window
