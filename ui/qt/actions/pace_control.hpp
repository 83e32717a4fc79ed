// SPDX-License-Identifier: GPL-3.0-or-later
// How fast the run goes: a list of paces, the last of which is as fast as possible.
#pragma once

#include <QWidget>

#include "session/session.hpp"

class QAction;
class QComboBox;
class QSettings;

namespace hitos::window {

/// Sets the session's pace and remembers it. Until the user has chosen one it is the slowest,
/// from the recorded one on, at which the whole tour takes no more than half a minute.
class PaceControl final : public QWidget {
    Q_OBJECT

  public:
    /// `full_speed`: the checkable action of as fast as possible.
    PaceControl(Session& session, QSettings& settings, QAction* full_speed,
                QWidget* parent = nullptr);

    /// The tour takes so long as it was recorded.
    void suit(double duration_s);
    /// As if the user had chosen it the last time.
    static void set_full_speed(QSettings& settings);

  private:
    void take_suited();
    void apply();

    Session& session_;
    QSettings& settings_;
    QComboBox* paces_ = nullptr;
    QAction* full_;
    int chosen_ = -1;  ///< by the user, one of the paces; -1: none yet
    int suited_ = -1;  ///< to the tour; -1: not known
    int pace_ = 0;     ///< where it is not as fast as possible
};

}  // namespace hitos::window
