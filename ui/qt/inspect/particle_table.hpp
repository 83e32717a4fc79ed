// SPDX-License-Identifier: GPL-3.0-or-later
// The particles in numbers, and what one of them believes.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "look/figures_table.hpp"
#include "session/session.hpp"

class QLabel;
class QPushButton;

namespace hitos::window {

class ParticleModel final : public FiguresModel {
    Q_OBJECT

  public:
    enum Column { number, weight, weight_now, x, y, heading, from };

    explicit ParticleModel(QObject* parent);
    void set_snapshot(const std::shared_ptr<const Snapshot>& snapshot);

  protected:
    QVariant key(int row, int column) const override;
    QString text(int row, int column) const override;
    /// The best one.
    bool strong(int row) const override;

  private:
    std::shared_ptr<const Snapshot> snapshot_;
};

/// Follows the run while it can be seen. The chosen particle's map and path are part of the
/// session's snapshots as long.
class ParticleTable final : public QWidget {
    Q_OBJECT

  public:
    ParticleTable(Session& session, QWidget* parent);

    FiguresTable& table() const { return *table_; }
    /// Nothing: none.
    void choose(std::optional<std::size_t> particle);
    std::optional<std::size_t> chosen() const { return chosen_; }

  signals:
    void grid_wanted(int particle);
    void map_wanted(int particle);
    void path_wanted(int particle);

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    QPushButton* add_button(const QString& text, const char* name,
                            void (ParticleTable::*wanted)(int));
    void refresh();
    void want();

    Session& session_;
    ParticleModel* model_;
    FiguresTable* table_;
    QLabel* none_;  // instead of the table, where there are none
    QWidget* buttons_;
    std::optional<std::size_t> chosen_;
};

}  // namespace hitos::window
