// SPDX-License-Identifier: GPL-3.0-or-later
// Errors against a reference, measured beside the run.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QThreadPool>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "session/session.hpp"

namespace hitos::window {

/// Errors of the state at one scan.
struct ErrorPoint {
    double time_s = 0.0;                 ///< since the first scan
    std::optional<double> map_m;         ///< MapError::mean_m
    std::optional<double> trajectory_m;  ///< TrajectoryError::rmse_m
};

struct Measured {
    /// At the run's checkpoints, the same scans every time, and at the last one shown; by time.
    std::vector<ErrorPoint> course;
    std::optional<MapError> map;
    std::optional<TrajectoryError> trajectory;
    std::optional<TrajectoryError> odometry;
    std::vector<Advice> doubts;  ///< whether the references are of this place and tour
    Trajectory reference_world;  ///< the reference trajectory moved to the run's frame
};

/// Of checkpoints, by scans: measured once.
using KnownErrors = std::map<std::uint64_t, ErrorPoint>;

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
    void begin_anew();
    void take(const std::shared_ptr<const Measured>& figures, quint64 revision, int generation);

    Session& session_;
    QThreadPool pool_;
    QElapsedTimer clock_;
    bool busy_ = false;
    quint64 last_revision_ = 0;
    std::shared_ptr<KnownErrors> known_ = std::make_shared<KnownErrors>();  ///< of this generation
    int generation_ = 0;  ///< of run and references; what was measured of earlier ones is dropped
};

}  // namespace hitos::window
