#include "reference_meter.hpp"

#include <QTimer>
#include <utility>

#include "background.hpp"

namespace hitos::window {
namespace {

constexpr int kLeastMs = 330;

Measured measure(const Snapshot& snapshot, const References& references) {
    Measured out;
    if (!snapshot.best_trajectory.empty()) {
        out.time_s =
            snapshot.best_trajectory.back().time_s - snapshot.best_trajectory.front().time_s;
    }
    if (references.map) out.map = map_error(snapshot.best_map, *references.map);
    if (references.trajectory) {
        out.trajectory = trajectory_error(snapshot.best_trajectory, *references.trajectory);
        out.odometry = trajectory_error(snapshot.odometry_trajectory, *references.trajectory);
        const Pose pose_world_reference =
            out.trajectory ? inverse(out.trajectory->pose_reference_estimate) : Pose{};
        for (const StampedPose& stamped : *references.trajectory) {
            out.reference_world.push_back(
                {stamped.time_s, compose(pose_world_reference, stamped.pose)});
        }
    }
    return out;
}

}  // namespace

ReferenceMeter::ReferenceMeter(Session& session, QObject* parent)
    : QObject(parent), session_(session) {
    pool_.setMaxThreadCount(1);
    clock_.start();
    connect(&session, &Session::snapshot_changed, this, &ReferenceMeter::consider);
    connect(&session, &Session::references_changed, this, [this] {
        last_revision_ = 0;
        ++generation_;
        consider();
    });
    connect(&session, &Session::restarted, this, [this] {
        last_revision_ = 0;
        ++generation_;
    });
}

ReferenceMeter::~ReferenceMeter() {
    pool_.waitForDone();
}

void ReferenceMeter::consider() {
    const auto snapshot = session_.snapshot();
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
    pool_.start([this, snapshot, references, generation = generation_] {
        begin_background_work();
        auto figures = std::make_shared<const Measured>(measure(*snapshot, references));
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
