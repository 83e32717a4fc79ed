// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of figures that follow the run: sorted by any column, one row chosen.
#pragma once

#include <QAbstractTableModel>
#include <QColor>
#include <QSortFilterProxyModel>
#include <QStringList>
#include <QTableView>
#include <functional>
#include <vector>

namespace hitos::window {

/// Rows of figures. A change keeps every row in its place, and with it what is chosen.
class FiguresModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    /// What a view sorts by: data() of this role.
    static constexpr int kKeyRole = Qt::UserRole;

    FiguresModel(QStringList titles, QObject* parent);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    QVariant data(const QModelIndex& index, int role) const override;

  signals:
    /// The rows from this one on are about to go.
    void shrinking(int rows);

  protected:
    /// `take` takes over the figures of that many rows.
    void change(int rows, const std::function<void()>& take);

    /// A number or a text to sort by.
    virtual QVariant key(int row, int column) const = 0;
    virtual QString text(int row, int column) const = 0;
    /// Whether the row stands out.
    virtual bool strong(int /*row*/) const { return false; }
    /// The row's own, shown as a patch; none by default.
    virtual QColor colour(int /*row*/) const { return {}; }

  private:
    QStringList titles_;
    int rows_ = 0;
};

class FiguresTable final : public QTableView {
    Q_OBJECT

  public:
    FiguresTable(FiguresModel* model, QWidget* parent);

    /// The chosen row of the model; -1 where there is none.
    int chosen() const;
    /// All of them, ascending, where the table lets several be chosen.
    std::vector<int> chosen_rows() const;
    /// Chooses a row and brings it in sight; -1 chooses none. Nobody is told.
    void choose(int row);
    /// The same for several.
    void choose_rows(const std::vector<int>& rows);

  signals:
    /// The user has chosen a row of the model.
    void row_chosen(int row);

  protected:
    int sizeHintForColumn(int column) const override;
    void selectionChanged(const QItemSelection& selected,
                          const QItemSelection& deselected) override;

  private:
    void leave_rows_from(int first);

    QSortFilterProxyModel proxy_;
    bool telling_ = true;
};

}  // namespace hitos::window
