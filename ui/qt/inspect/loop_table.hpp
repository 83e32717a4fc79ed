// The places that looked like an earlier one, in numbers, and both passages of the chosen one.
#pragma once

#include <QWidget>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "hitos/registration/graph_edit.hpp"
#include "look/figures_table.hpp"
#include "session/session.hpp"

class QComboBox;
class QLabel;
class QPushButton;

namespace hitos::window {

class LoopView;

class LoopModel final : public FiguresModel {
    Q_OBJECT

  public:
    enum Column { scan, earlier, verdict, score, overlap, through, chi, way, moved, weight, error };

    explicit LoopModel(QObject* parent);
    void set_loops(std::vector<RunLoop> loops);
    const std::vector<RunLoop>& loops() const { return loops_; }

  protected:
    QVariant key(int row, int column) const override;
    QString text(int row, int column) const override;
    /// Closed ones.
    bool strong(int row) const override;

  private:
    std::optional<double> figure(int row, int column) const;

    std::vector<RunLoop> loops_;
};

/// Follows the run while it can be seen; key scans are part of the session's snapshots as long.
class LoopTable final : public QWidget {
    Q_OBJECT

  public:
    LoopTable(Session& session, QWidget* parent);

    FiguresTable& table() const { return *table_; }
    LoopView& view() const { return *view_; }
    /// Nothing, or what the run does not list: none.
    void choose(const std::optional<RunLoop>& loop);

  signals:
    /// It is chosen and in sight; nothing: none is.
    void loop_shown(std::optional<hitos::RunLoop> loop);
    /// The graph is to be changed by hand: registration.edits.
    void edits_wanted(QString edits);
    void picture_wanted();

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void refresh();
    void show_chosen();
    void show_change(const std::optional<RunLoop>& loop);
    void want();
    void go_to(bool earlier);
    QPushButton* add_button(const char* name, void (LoopTable::*pressed)());
    void to_scan() { go_to(false); }
    void to_earlier() { go_to(true); }
    void change();
    std::vector<GraphEdit> edits() const;
    std::vector<RunLoop> listed() const;

    Session& session_;
    LoopModel* model_;
    QComboBox* which_;
    FiguresTable* table_;
    QLabel* reason_;
    QLabel* none_;  // instead of all, where there are none
    QWidget* there_;
    QPushButton* to_scan_;
    QPushButton* to_earlier_;
    QPushButton* change_;
    LoopView* view_;
    std::optional<RunLoop> chosen_;
};

}  // namespace hitos::window
