// SPDX-License-Identifier: GPL-3.0-or-later
// What the status bar says of the run.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "hitos/capture/tour_finding.hpp"
#include "session/session.hpp"

class QLabel;
class QStatusBar;

namespace hitos::window {

class StatusLine final : public QObject {
    Q_OBJECT

  public:
    StatusLine(QStatusBar* bar, Session& session);

    /// The number of scans of the whole log, where it is known.
    void set_total(std::optional<quint64> scans);

    /// What there is to doubt about the log.
    void show_doubts(const std::vector<TourFinding>& findings);

    /// And about the references.
    void show_reference_doubts(const std::vector<Advice>& doubts);

    void show_place(QPointF world_m);
    void clear_place();
    /// A short message that goes away.
    void notice(const QString& text);
    /// Until the next notice; empty: nothing any more.
    void lasting(const QString& text);
    void refresh();

  signals:
    /// The user wants to see the damaged lines.
    void skipped_wanted();

  private:
    QString running_words(const Progress& progress) const;
    void show_advice();
    void show_find();
    void show_tool_tip();
    QLabel* add(const char* name, const QString& longest);

    Session& session_;
    QStatusBar* bar_;
    std::optional<quint64> total_;
    std::optional<std::uint64_t> found_;  ///< where in the map of the tour before
    QString advice_;                      ///< shown with the state; empty: none
    QString doubts_;                      ///< likewise
    QString of_references_;               ///< likewise
    QString warnings_;                    ///< all three
    QStringList said_;                    ///< the last notices, the newest first
    StopReason stopped_by_ = StopReason::none;
    QLabel* state_;
    QLabel* scan_;
    QLabel* time_;
    QLabel* speed_;
    QLabel* neff_;
    QLabel* landmarks_;
    QLabel* skipped_;
    QLabel* place_;
};

}  // namespace hitos::window
