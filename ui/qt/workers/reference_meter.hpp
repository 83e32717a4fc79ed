// Errors against a reference, measured beside the run.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QThreadPool>
#include <memory>
#include <optional>

#include "app/session.hpp"

namespace hitos::window {

struct Measured {
    double time_s = 0.0;  ///< since the first scan
    std::optional<MapError> map;
    std::optional<TrajectoryError> trajectory;
    std::optional<TrajectoryError> odometry;
    Trajectory reference_world;  ///< the reference trajectory moved to the run's frame
};

/// Measures every new snapshot, but one at a time and at most thrice a second.
class ReferenceMeter final : public QObject {
    Q_OBJECT

  public:
    ReferenceMeter(Session& session, QObject* parent);
    ~ReferenceMeter() override;

  signals:
    void measured(std::shared_ptr<const Measured> figures);

  private:
    void consider();
    void take(const std::shared_ptr<const Measured>& figures, quint64 revision, int generation);

    Session& session_;
    QThreadPool pool_;
    QElapsedTimer clock_;
    bool busy_ = false;
    quint64 last_revision_ = 0;
    int generation_ = 0;  ///< of run and references; what was measured of earlier ones is dropped
};

}  // namespace hitos::window
