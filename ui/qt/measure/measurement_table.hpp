// SPDX-License-Identifier: GPL-3.0-or-later
// What is measured, as a table: names and true values are written into it.
#pragma once

#include <QWidget>

#include "look/figures_table.hpp"
#include "look/prompts.hpp"
#include "look/user_files.hpp"
#include "measurements.hpp"

class QAction;
class QLabel;
class QPushButton;

namespace hitos::window {

class MeasurementModel final : public FiguresModel {
    Q_OBJECT

  public:
    enum Column { name, kind, slam, truth, error, percent };

    MeasurementModel(Measurements& measurements, QObject* parent);

    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  signals:
    /// What was written cannot be.
    void refused(QString reason);

  protected:
    QVariant key(int row, int column) const override;
    QString text(int row, int column) const override;

  private:
    void refresh();
    const MeasuredRow& row_of(int row) const;

    Measurements& measurements_;
    std::vector<MeasuredRow> shown_;
};

/// With buttons to measure, and to read and write distances files.
class MeasurementTable final : public QWidget {
    Q_OBJECT

  public:
    /// `measure` are the actions that begin to measure.
    MeasurementTable(Measurements& measurements, UserFiles& files, Prompts& prompts,
                     const QList<QAction*>& measure, QWidget* parent);

    FiguresTable& table() const { return *table_; }
    /// Adds the distances of a file; one that cannot be used is told.
    void open(const QString& path);

  signals:
    void notice(QString text);
    /// It can be seen, or not.
    void shown(bool on);

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    QPushButton* add_button(const QString& text, const char* name,
                            void (MeasurementTable::*slot)());
    void refresh();
    void remove();
    void clear();
    void ask_and_open();
    void save();

    Measurements& measurements_;
    UserFiles& files_;
    Prompts& prompts_;
    FiguresTable* table_;
    QPushButton* remove_;
    QPushButton* clear_;
    QPushButton* save_;
    QLabel* means_;
};

}  // namespace hitos::window
