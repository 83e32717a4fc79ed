// SPDX-License-Identifier: GPL-3.0-or-later
// Anchors the scan that is shown to a drawing, or to a place whose coordinates are known.
#pragma once

#include <QDialog>
#include <QLineF>
#include <memory>
#include <optional>
#include <vector>

#include "hitos/registration/graph_edit.hpp"
#include "session/session.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace hitos::window {

class WallView;

/// The drawing beside the scan; a wall or a place is chosen in both, or their numbers are written,
/// and the graph is told that they are the same. It stays open: the map behind it shows at once
/// what came of it.
class AnchorDialog final : public QDialog {
    Q_OBJECT

  public:
    AnchorDialog(Session& session, QWidget* parent);

    /// What shows walls (walls_as_drawn()); where it cannot be read the dialog says why.
    void open_drawing(const QString& path);
    /// As the session has it.
    void refresh();
    /// What the last change made of the map.
    void tell(const QString& effect);

  signals:
    /// A file is to be chosen, for open_drawing().
    void drawing_wanted();
    /// Its walls, in its own frame [m].
    void drawing_read(const std::vector<QLineF>& walls);
    /// Another change by hand, of the scan that is shown.
    void anchored(const hitos::GraphEdit& anchor);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    QWidget* made_side(WallView* view, QLineEdit* line, const QString& words);
    bool of_points() const;
    void change_kind();
    void show_scan();
    void show_over_drawing();
    void take_drawn();
    void take_seen();
    void take_written();
    QString unread_words() const;
    void show_state();
    QString words_of_fit(const GraphEdit& edit) const;
    std::optional<GraphEdit> edit() const;
    void anchor();

    Session& session_;
    QComboBox* kind_;
    QPushButton* open_;
    QComboBox* unit_;
    QLabel* notes_;
    WallView* drawing_;
    WallView* scan_;
    QLineEdit* drawn_;
    QLineEdit* seen_;
    QLabel* state_;
    QLabel* effect_;
    QPushButton* anchor_;
    QString file_;
    std::shared_ptr<const Snapshot> shown_;  ///< whose scan it is
    std::vector<double> bearings_;           ///< of the scan's walls, in their order
    // The numbers as they are, not as few decimals have them; empty where they are none.
    std::vector<double> drawn_numbers_;
    std::vector<double> seen_numbers_;
};

}  // namespace hitos::window
