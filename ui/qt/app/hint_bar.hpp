// SPDX-License-Identifier: GPL-3.0-or-later
// What speaks against the log or the configuration in use, with the one button that mends it.
#pragma once

#include <QFrame>
#include <QString>
#include <vector>

#include "hitos/capture/tour_finding.hpp"
#include "session/session.hpp"

class QLabel;
class QPushButton;

namespace hitos::window {

/// Hidden where there is nothing to say. A log that is wrong, or does not suit the configuration,
/// is told as soon as it is opened, what only a run shows at its end; what is wrong comes first.
class HintBar final : public QFrame {
    Q_OBJECT

  public:
    explicit HintBar(QWidget* parent = nullptr);
    void set_session(Session& session);
    void show_doubts(const std::vector<TourFinding>& findings);

  signals:
    /// The user wants the configuration that the hint names.
    void preset_wanted(std::string preset);

  private:
    void look(const Session& session);
    void show_advice(const std::vector<Advice>& advice);
    void refresh();

    QLabel* text_;
    QPushButton* use_;
    std::string preset_;
    QString advice_;  ///< what `preset_` mends
    QString doubt_;
    // What the user has read.
    QString closed_advice_;
    QString closed_doubt_;
};

}  // namespace hitos::window
