// SPDX-License-Identifier: GPL-3.0-or-later
// What is changed by hand in the graph of the run, and the way to take it back.
#pragma once

#include <QLineF>
#include <QWidget>
#include <cstdint>
#include <vector>

#include "hitos/registration/graph_edit.hpp"
#include "session/session.hpp"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace hitos::window {

class AnchorDialog;

/// In sight where there is something to take back. A step that slipped and a scan that is fixed
/// where it lies are said here too, and what the last change made of the map.
class EditList final : public QWidget {
    Q_OBJECT

  public:
    /// `table` gets the focus where what has it goes out of use.
    EditList(Session& session, QWidget& table, QWidget* parent);

    /// As the session has them.
    void refresh();
    /// Of the file that drawing_wanted() asks for.
    void open_drawing(const QString& path);

  signals:
    /// registration.edits
    void edits_wanted(QString edits);
    void drawing_wanted();
    /// As AnchorDialog's.
    void drawing_read(const std::vector<QLineF>& walls);

  private:
    void show_anchors();
    void take_back();
    void note_slip();
    void note_fix();
    void add(GraphEdit edit);
    void show_steps();
    void show_effect();
    void show_warnings();

    Session& session_;
    QWidget& table_;
    QListWidget* list_;
    QLabel* warnings_;
    QPushButton* take_back_;
    QPushButton* slip_;
    QPushButton* fix_;
    QLineEdit* at_;
    std::uint64_t at_steps_ = 0;  // whose place stands there
    QPushButton* anchor_;
    AnchorDialog* anchors_ = nullptr;  // once somebody has asked for it
    QPushButton* before_;
    QLabel* effect_;
};

}  // namespace hitos::window
