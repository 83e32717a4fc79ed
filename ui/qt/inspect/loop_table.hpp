// SPDX-License-Identifier: GPL-3.0-or-later
// The places that looked like an earlier one, in numbers, and both passages of the chosen one.
#pragma once

#include <QLineF>
#include <QPointF>
#include <QTimer>
#include <QWidget>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "hitos/registration/graph_edit.hpp"
#include "look/figures_table.hpp"
#include "session/session.hpp"

class QComboBox;
class QLabel;
class QPushButton;
class QScrollArea;
class QSpinBox;

namespace hitos::window {

class EditList;
class LoopModel;
class LoopView;

/// Follows the run while it can be seen; key scans are part of the session's snapshots as long.
class LoopTable final : public QWidget {
    Q_OBJECT

  public:
    LoopTable(Session& session, QWidget* parent);

    FiguresTable& table() const { return *table_; }
    LoopView& view() const { return *view_; }
    /// The table has the keyboard, and where nothing is chosen its first row is.
    void take_keys();
    /// One of the run, or one that somebody proposes; nothing: none.
    void choose(const std::optional<RunLoop>& loop);
    /// Whether places of the map are the scans of a loop to be chosen.
    bool takes_places() const;
    /// The scan made nearest to it is the later one of a loop, then the earlier one.
    void take_place(const QPointF& world_m);
    /// Whose walls the run is to be anchored to.
    void open_drawing(const QString& path);

  signals:
    /// It is chosen and in sight; nothing: none is.
    void loop_shown(std::optional<hitos::RunLoop> loop);
    /// The graph is to be changed by hand: registration.edits.
    void edits_wanted(QString edits);
    /// For open_drawing().
    void drawing_wanted();
    /// As AnchorDialog's.
    void drawing_read(const std::vector<QLineF>& walls);
    void picture_wanted();

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    QWidget* made_bar(QWidget* parent);
    QPushButton* add_button(QWidget* parent, const char* name, void (LoopTable::*pressed)());
    QSpinBox* add_number(QWidget* parent, const char* name, const QString& words);
    void refresh();
    void show_chosen();
    void show_change();
    void show_reason();
    void want();
    void to_scan() { go_to(false); }
    void to_earlier() { go_to(true); }
    void go_to(bool earlier);
    void change();
    void fit();
    void poll();
    void forget_other_tour();
    void propose();
    std::vector<GraphEdit> edits() const;
    void take_loops();

    Session& session_;
    LoopModel* model_;
    QComboBox* which_;
    FiguresTable* table_;
    QLabel* reason_;
    QLabel* none_;  // instead of all, where there are none
    QScrollArea* scroll_;
    QWidget* there_;
    QSpinBox* scan_;
    QSpinBox* earlier_;
    QPushButton* to_scan_;
    QPushButton* to_earlier_;
    QPushButton* change_;
    QPushButton* fit_;
    QPushButton* pick_;
    LoopView* view_;
    EditList* edits_;
    std::vector<RunLoop> loops_;  // of the run
    std::optional<RunLoop> chosen_;
    bool proposed_ = false;              // chosen_ need not be of the run
    std::optional<Configuracion> tour_;  // that chosen_ is of,
    quint64 drive_ = 0;                  // and its number where it was driven
    std::optional<std::uint64_t> first_place_;
    QTimer timer_;
    std::future<LoopRecord> fitted_;
    std::optional<LoopRecord> measured_;  // of the pose that was fitted
};

}  // namespace hitos::window
