// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference_meter.hpp"

#include <QTimer>
#include <algorithm>
#include <iterator>
#include <utility>

#include "hitos/services/evaluation/reference_fit.hpp"
#include "hitos/services/evaluation/tour_frames.hpp"
#include "hitos/services/files/tour_time.hpp"
#include "session/background.hpp"

namespace hitos::window {
namespace {

constexpr int kLeastMs = 330;

ErrorPoint point(const Trajectory& path, const std::optional<MapError>& map,
                 const std::optional<TrajectoryError>& trajectory) {
    ErrorPoint point;
    point.time_s = tour_duration_s(path);
    if (map) point.map_m = map->mean_m;
    if (trajectory) point.trajectory_m = trajectory->rmse_m;
    return point;
}

ErrorPoint measure(const RunCheckpoint& checkpoint, const References& references) {
    const Trajectory path = checkpoint.state.best_trajectory();
    std::optional<MapError> map;
    // A copy of its own: a filter may keep its map once it was asked for, and the run goes back to
    // it.
    if (references.map)
        map = map_error(checkpoint.state.filter->clone()->best_map(), *references.map);
    std::optional<TrajectoryError> trajectory;
    if (references.trajectory) {
        trajectory = trajectory_error(in_one_frame(path, checkpoint.state.later_tours()),
                                      *references.trajectory);
    }
    return point(path, map, trajectory);
}

std::vector<ErrorPoint> course_of(const Snapshot& snapshot, const References& references,
                                  const ErrorPoint& now, KnownErrors& known) {
    std::vector<ErrorPoint> course;
    for (const auto& checkpoint : snapshot.checkpoints) {
        const std::uint64_t steps = checkpoint->steps();
        const auto found = known.find(steps);
        course.push_back(
            found != known.end()
                ? found->second
                : known.emplace(steps, measure(*checkpoint, references)).first->second);
    }
    const auto after = std::ranges::lower_bound(course, now.time_s, {}, &ErrorPoint::time_s);
    if (after == course.end() || after->time_s != now.time_s) course.insert(after, now);
    return course;
}

Measured measure(const Snapshot& snapshot, const References& references, KnownErrors& known) {
    Measured out;
    if (references.map) {
        out.map = map_error(snapshot.best_map, *references.map);
        if (const auto doubt = doubt_of_map(snapshot.best_map, *references.map))
            out.doubts.push_back(*doubt);
    }
    if (references.trajectory) {
        const Trajectory path = in_one_frame(snapshot.best_trajectory, snapshot.later_tours);
        out.trajectory = trajectory_error(path, *references.trajectory);
        out.odometry = tour_by_tour_error(snapshot.odometry_trajectory, snapshot.later_tours,
                                          *references.trajectory);
        ReferenceFit fit = fit_of_path(path, *references.trajectory, references.tolerance_s);
        if (!has_ended(snapshot)) fit.poses = 0;  // it may tell of what is still to come
        std::ranges::move(fit.doubts(), std::back_inserter(out.doubts));
        const Pose pose_world_reference =
            out.trajectory ? inverse(out.trajectory->pose_reference_estimate) : Pose{};
        for (const StampedPose& stamped : *references.trajectory) {
            out.reference_world.push_back(
                {stamped.time_s, compose(pose_world_reference, stamped.pose)});
        }
    }
    out.course = course_of(snapshot, references,
                           point(snapshot.best_trajectory, out.map, out.trajectory), known);
    return out;
}

}  // namespace

ReferenceMeter::ReferenceMeter(Session& session, QObject* parent)
    : QObject(parent), session_(session) {
    pool_.setMaxThreadCount(1);
    clock_.start();
    connect(&session, &Session::snapshot_changed, this, &ReferenceMeter::consider);
    connect(&session, &Session::references_changed, this, [this] {
        begin_anew();
        consider();
    });
    connect(&session, &Session::restarted, this, &ReferenceMeter::begin_anew);
}

void ReferenceMeter::begin_anew() {
    last_revision_ = 0;
    known_ = std::make_shared<KnownErrors>();
    ++generation_;
}

ReferenceMeter::~ReferenceMeter() {
    pool_.waitForDone();
}

void ReferenceMeter::consider() {
    const auto snapshot = session_.of_run();
    const References& references = session_.references();
    if (!snapshot || snapshot->revision == last_revision_ ||
        (!references.map && !references.trajectory)) {
        return;
    }
    if (busy_) return;  // take() looks again
    if (clock_.elapsed() < kLeastMs) {
        busy_ = true;
        QTimer::singleShot(kLeastMs, this, [this] {
            busy_ = false;
            consider();
        });
        return;
    }
    busy_ = true;
    clock_.restart();
    pool_.start([this, snapshot, references, known = known_, generation = generation_] {
        begin_background_work();
        auto figures = std::make_shared<const Measured>(measure(*snapshot, references, *known));
        QMetaObject::invokeMethod(
            this,
            [this, figures, revision = snapshot->revision, generation] {
                take(figures, revision, generation);
            },
            Qt::QueuedConnection);
    });
}

void ReferenceMeter::take(const std::shared_ptr<const Measured>& figures, quint64 revision,
                          int generation) {
    busy_ = false;
    if (generation == generation_) {
        last_revision_ = revision;
        emit measured(figures);
    }
    consider();
}

}  // namespace hitos::window
