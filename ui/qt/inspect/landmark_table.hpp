// SPDX-License-Identifier: GPL-3.0-or-later
// The landmarks of the best hypothesis in numbers.
#pragma once

#include <QWidget>
#include <memory>

#include "look/figures_table.hpp"
#include "session/session.hpp"
#include "views/landmark_painter.hpp"

namespace hitos::window {

class LandmarkModel final : public FiguresModel {
    Q_OBJECT

  public:
    enum Column { number, kind, first, second, sigma_1, sigma_2, correlation, seen, born, last };

    explicit LandmarkModel(QObject* parent);
    void set_snapshot(const std::shared_ptr<const Snapshot>& snapshot);
    /// Null before the first scan.
    const std::shared_ptr<const Snapshot>& snapshot() const { return snapshot_; }

  protected:
    QVariant key(int row, int column) const override;
    QString text(int row, int column) const override;

  private:
    std::shared_ptr<const Snapshot> snapshot_;
};

/// Follows the run while it can be seen.
class LandmarkTable final : public QWidget {
    Q_OBJECT

  public:
    LandmarkTable(Session& session, QWidget* parent);

    FiguresTable& table() const { return *table_; }
    void set_highlight(const hitos::window::PickedLandmark& picked);

  signals:
    void landmark_chosen(hitos::window::PickedLandmark landmark);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void refresh();
    void mark();

    Session& session_;
    LandmarkModel* model_;
    FiguresTable* table_;
    PickedLandmark highlight_;
};

}  // namespace hitos::window
