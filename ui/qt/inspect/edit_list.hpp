// What is changed by hand in the graph of the run, and the way to take it back.
#pragma once

#include <QWidget>
#include <vector>

#include "session/session.hpp"

class QListWidget;
class QPushButton;

namespace hitos::window {

/// In sight where there is something to take back. A step that slipped is said here too.
class EditList final : public QWidget {
    Q_OBJECT

  public:
    EditList(Session& session, QWidget* parent);

    /// As the session has them.
    void refresh();

  signals:
    /// registration.edits
    void edits_wanted(QString edits);

  private:
    void take_back();
    void note_slip();

    Session& session_;
    QListWidget* list_;
    QPushButton* take_back_;
    QPushButton* slip_;
};

}  // namespace hitos::window
