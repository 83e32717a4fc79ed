// SPDX-License-Identifier: GPL-3.0-or-later
#include "figures_table.hpp"

#include <QFont>
#include <QHeaderView>
#include <QScopedValueRollback>
#include <algorithm>
#include <utility>

namespace hitos::window {

FiguresModel::FiguresModel(QStringList titles, QObject* parent)
    : QAbstractTableModel(parent), titles_(std::move(titles)) {}

int FiguresModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : rows_;
}

int FiguresModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(titles_.size());
}

QVariant FiguresModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    // In a wide column the middle may be out of sight, where words are at its beginning.
    const bool words = rows_ > 0 && key(0, section).typeId() == QMetaType::QString;
    if (role == Qt::TextAlignmentRole && words)
        return static_cast<int>(Qt::AlignVCenter | Qt::AlignLeft);
    return role == Qt::DisplayRole ? QVariant(titles_.value(section)) : QVariant();
}

QVariant FiguresModel::data(const QModelIndex& index, int role) const {
    const int row = index.row();
    switch (role) {
        case Qt::DisplayRole:
            return text(row, index.column());
        case kKeyRole:
            return key(row, index.column());
        case Qt::TextAlignmentRole: {
            const bool words = key(row, index.column()).typeId() == QMetaType::QString;
            return static_cast<int>(Qt::AlignVCenter | (words ? Qt::AlignLeft : Qt::AlignRight));
        }
        case Qt::DecorationRole:
            return index.column() == 0 && colour(row).isValid() ? QVariant(colour(row))
                                                                : QVariant();
        case Qt::FontRole: {
            if (!strong(row)) return {};
            QFont font;
            font.setBold(true);
            return font;
        }
        default:
            return {};
    }
}

void FiguresModel::change(int rows, const std::function<void()>& take) {
    if (rows < rows_) {
        emit shrinking(rows);
        beginRemoveRows({}, rows, rows_ - 1);
        rows_ = rows;
        endRemoveRows();
    }
    const int kept = rows_;
    take();
    if (rows > rows_) {
        beginInsertRows({}, rows_, rows - 1);
        rows_ = rows;
        endInsertRows();
    }
    if (kept > 0) emit dataChanged(index(0, 0), index(kept - 1, columnCount() - 1));
}

FiguresTable::FiguresTable(FiguresModel* model, QWidget* parent) : QTableView(parent) {
    proxy_.setSourceModel(model);
    proxy_.setSortRole(FiguresModel::kKeyRole);
    setModel(&proxy_);
    connect(model, &FiguresModel::shrinking, this, &FiguresTable::leave_rows_from);
    setSortingEnabled(true);
    sortByColumn(0, Qt::AscendingOrder);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setAlternatingRowColors(true);
    setShowGrid(false);
    setWordWrap(false);
    setCornerButtonEnabled(false);
    setTabKeyNavigation(false);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setResizeContentsPrecision(20);  // rows; all of them would cost time
}

/// Qt asks some of the rows in sight, and others have longer numbers.
int FiguresTable::sizeHintForColumn(int column) const {
    constexpr int kMostAsked = 500;
    const QAbstractItemModel& all = *proxy_.sourceModel();
    const int step = 1 + all.rowCount() / kMostAsked;
    QString longest;
    QModelIndex of_longest;
    for (int row = 0; row < all.rowCount(); row += step) {
        const QModelIndex index = all.index(row, column);
        const QString text = index.data().toString();
        if (text.size() <= longest.size()) continue;
        longest = text;
        of_longest = index;
    }
    const int asked = QTableView::sizeHintForColumn(column);
    if (!of_longest.isValid()) return asked;
    // Others of so many letters have digits where this one may have something narrower.
    QString widest = longest;
    for (QChar& letter : widest)
        if (letter == '-' || letter.isDigit()) letter = '0';
    const int more =
        fontMetrics().horizontalAdvance(widest) - fontMetrics().horizontalAdvance(longest);
    return std::max(asked,
                    sizeHintForIndex(proxy_.mapFromSource(of_longest)).width() + std::max(more, 0));
}

/// Else the view would choose another row in the place of one that goes.
void FiguresTable::leave_rows_from(int first) {
    if (proxy_.mapToSource(currentIndex()).row() < first && chosen() < first) return;
    const QScopedValueRollback quiet(telling_, false);
    clearSelection();
    setCurrentIndex({});
}

int FiguresTable::chosen() const {
    const QModelIndexList rows = selectionModel()->selectedRows();
    return rows.isEmpty() ? -1 : proxy_.mapToSource(rows.front()).row();
}

std::vector<int> FiguresTable::chosen_rows() const {
    std::vector<int> rows;
    for (const QModelIndex& index : selectionModel()->selectedRows())
        rows.push_back(proxy_.mapToSource(index).row());
    std::ranges::sort(rows);
    return rows;
}

void FiguresTable::choose(int row) {
    if (row == chosen()) return;
    const QScopedValueRollback quiet(telling_, false);
    if (row < 0) {
        clearSelection();
        return;
    }
    const QModelIndex index = proxy_.mapFromSource(proxy_.sourceModel()->index(row, 0));
    selectRow(index.row());
    scrollTo(index);
}

void FiguresTable::choose_rows(const std::vector<int>& rows) {
    if (rows == chosen_rows()) return;
    const QScopedValueRollback quiet(telling_, false);
    QItemSelection selection;
    for (const int row : rows) {
        const QModelIndex index = proxy_.mapFromSource(proxy_.sourceModel()->index(row, 0));
        selection.select(index, index);
    }
    selectionModel()->select(selection,
                             QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
}

void FiguresTable::selectionChanged(const QItemSelection& selected,
                                    const QItemSelection& deselected) {
    QTableView::selectionChanged(selected, deselected);
    if (telling_ && !selected.isEmpty()) emit row_chosen(chosen());
}

}  // namespace hitos::window
