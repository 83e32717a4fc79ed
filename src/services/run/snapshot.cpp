// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>

#include "hitos/services/evaluation/quality.hpp"
#include "hitos/services/run/run_worker.hpp"

namespace hitos {

ParticleDetails details_of(const Algoritmo& run, std::size_t hypothesis) {
    ParticleDetails details{
        hypothesis, run.filter().map(hypothesis), {}, run.trajectory_of(hypothesis)};
    details.line_extents = run.line_extents().of(details.map, details.path);
    return details;
}

Snapshot snapshot_of(const Algoritmo& run, const SnapshotParts& parts) {
    Snapshot snapshot;
    snapshot.parts = parts;
    snapshot.source = run.reader().name();
    snapshot.steps = run.steps();
    snapshot.revision = run.revision();
    snapshot.scan = run.scan();
    snapshot.observation = run.observation();
    const auto associations = run.filter().associations();
    snapshot.associations.assign(associations.begin(), associations.end());
    snapshot.best_pose = run.filter().best_pose();
    snapshot.best_map = run.filter().best_map();
    snapshot.hypotheses = run.filter().hypotheses();
    snapshot.best_hypothesis = run.filter().best_hypothesis();
    snapshot.mean_pose = run.filter().mean_pose();
    snapshot.pose_covariance = run.filter().pose_covariance();
    if (parts.joint_covariance) snapshot.joint_covariance = run.filter().joint_covariance();
    if (parts.particle && *parts.particle < snapshot.hypotheses.size()) {
        snapshot.particle = details_of(run, *parts.particle);
    }
    if (parts.ancestry) snapshot.ancestry = run.filter().ancestry();
    snapshot.best_trajectory = run.best_trajectory();
    snapshot.online_trajectory = run.online_trajectory();
    snapshot.later_tours = run.later_tours();
    if (const Registration* registration = run.registration()) {
        const auto keys = registration->keys();
        snapshot.keys.assign(keys.begin(), keys.end());
        snapshot.loops = run_loops(registration->loops(), registration->refused_loops(),
                                   snapshot.best_trajectory);
        if (parts.key_scans) {
            snapshot.key_scans = run.key_scans();
            snapshot.chi_square = registration->chi_square();
            snapshot.drawing = registration->drawing();
        }
    }
    if (run.finished()) {
        snapshot.advice = warnings(run.evidence());
        std::ranges::move(run.advice(), std::back_inserter(snapshot.advice));
    }
    snapshot.line_extents = run.line_extents().of(snapshot.best_map, snapshot.best_trajectory);
    snapshot.odometry_trajectory = run.odometry_trajectory();
    return snapshot;
}

}  // namespace hitos
