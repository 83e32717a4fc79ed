// How fast the run goes: a list of paces, and a button for as fast as possible.
#pragma once

#include <QWidget>

#include "session/session.hpp"

class QAction;
class QComboBox;
class QSettings;

namespace hitos::window {

/// Sets the session's pace and remembers it. At a first start it is one at which one sees what
/// happens: ten times as fast as recorded.
class PaceControl final : public QWidget {
    Q_OBJECT

  public:
    /// `full_speed`: the checkable action of as fast as possible.
    PaceControl(Session& session, QSettings& settings, QAction* full_speed,
                QWidget* parent = nullptr);

    /// As if the user had chosen it the last time.
    static void set_full_speed(QSettings& settings);

  private:
    void apply();

    Session& session_;
    QSettings& settings_;
    QComboBox* paces_ = nullptr;
    QAction* full_;
};

}  // namespace hitos::window
