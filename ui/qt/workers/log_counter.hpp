// SPDX-License-Identifier: GPL-3.0-or-later
// How many scans the log in use holds and what there is to doubt about it, found beside everything
// else.
#pragma once

#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <atomic>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "hitos/capture/tour_finding.hpp"
#include "hitos/capture/tour_summary.hpp"
#include "hitos/services/run/live_doubts.hpp"
#include "session/session.hpp"

namespace hitos::window {

class LogCounter final : public QObject {
    Q_OBJECT

  public:
    LogCounter(Session& session, QObject* parent);
    ~LogCounter() override;

    /// Somebody has looked at that source already, and found this: nobody looks again where it is
    /// the next one in use.
    void know(const SourceParams& source, const TourSummary& summary);
    /// What is told is not about the log in use yet.
    bool busy() const { return busy_; }

  signals:
    /// Nothing while the count is not known.
    void counted(std::optional<quint64> scans);
    /// From its first stamp to the last [s].
    void timed(double seconds);
    /// What would make its map wrong, gravest first; empty while that is not known.
    void doubted(const std::vector<TourFinding>& findings);

  private:
    void begin();
    /// Of a tour that comes in.
    void look();
    using Stop = std::shared_ptr<std::atomic<bool>>;
    void tell(TourSummary summary, const Stop& of);

    Session& session_;
    SourceParams source_;
    std::optional<std::pair<SourceParams, TourSummary>> known_;
    bool busy_ = false;
    std::optional<LiveDoubts> live_;  ///< while a tour comes in
    std::vector<TourFinding> told_;   ///< of it
    QTimer again_;
    Stop stop_;
    QThreadPool pool_;
};

}  // namespace hitos::window
