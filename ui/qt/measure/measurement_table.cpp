// SPDX-License-Identifier: GPL-3.0-or-later
#include "measurement_table.hpp"

#include <QAction>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

#include "look/flow_layout.hpp"
#include "look/named.hpp"
#include "look/written_number.hpp"

namespace hitos::window {
namespace {

constexpr double kGreatestTrue = 1e5;  // m

QString kind_of_row(const HandMeasurement& measurement) {
    const bool wall = std::ranges::any_of(measurement.places, [](const PickedPlace& place) {
        return place.kind == PickedPlace::Kind::wall;
    });
    if (measurement.quantity == Quantity::angle) {
        return wall ? MeasurementModel::tr("Angle of walls") : MeasurementModel::tr("Angle");
    }
    if (measurement.between_walls()) return MeasurementModel::tr("Wall to wall");
    return wall ? MeasurementModel::tr("Point to wall") : MeasurementModel::tr("Point to point");
}

/// To sort by: what is missing comes first.
double or_least(const std::optional<double>& value) {
    return value.value_or(-std::numeric_limits<double>::infinity());
}

/// Keeps what is being written although the run goes on and with it the values.
class KeepingDelegate final : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void setEditorData(QWidget* editor, const QModelIndex& index) const override {
        const auto* line = qobject_cast<QLineEdit*>(editor);
        if (line == nullptr || !line->isModified()) {
            QStyledItemDelegate::setEditorData(editor, index);
        }
    }
};

}  // namespace

MeasurementModel::MeasurementModel(Measurements& measurements, QObject* parent)
    : FiguresModel({tr("Name"), tr("Kind"), "SLAM", tr("True"), tr("Error"), tr("Error %")},
                   parent),
      measurements_(measurements) {
    connect(&measurements, &Measurements::changed, this, &MeasurementModel::refresh);
    // Those of the old log go before the others come: an edit under way belongs to none of these.
    connect(&measurements, &Measurements::log_changed, this, &MeasurementModel::refresh);
}

void MeasurementModel::refresh() {
    change(static_cast<int>(measurements_.rows().size()),
           [this] { shown_ = measurements_.rows(); });
}

const MeasuredRow& MeasurementModel::row_of(int row) const {
    return shown_[static_cast<std::size_t>(row)];
}

Qt::ItemFlags MeasurementModel::flags(const QModelIndex& index) const {
    const bool written = index.column() == name || index.column() == truth;
    return FiguresModel::flags(index) | (written ? Qt::ItemIsEditable : Qt::NoItemFlags);
}

QVariant MeasurementModel::data(const QModelIndex& index, int role) const {
    const MeasuredRow& row = row_of(index.row());
    if (role == Qt::EditRole) {
        if (index.column() == name) return QString::fromStdString(row.measurement.name);
        if (!row.truth) return QString();
        const bool angle = row.measurement.quantity == Quantity::angle;
        return QString::number(*row.truth * (angle ? kDegreesPerRadian : 1.0), 'f', angle ? 2 : 3);
    }
    if (role == Qt::ToolTipRole) {
        if (index.column() == slam && !row.slam.value) {
            return tr("The map has no such walls or corners there.");
        }
        if (index.column() == truth) {
            return tr("Double click to write the true value; empty: the reference map's");
        }
        return {};
    }
    return FiguresModel::data(index, role);
}

bool MeasurementModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole) return false;
    const QString written = value.toString().trimmed();
    if (written == data(index, role).toString()) return true;  // nothing was changed
    // A row that is just going ends its editor, which writes once more.
    const auto place = static_cast<std::size_t>(index.row());
    const std::vector<MeasuredRow>& rows = measurements_.rows();
    if (place >= rows.size() || rows[place].measurement.name != shown_[place].measurement.name) {
        return false;
    }
    if (index.column() == name) {
        const bool done = measurements_.rename(index.row(), written);
        if (!done) {
            emit refused(tr("“%1” is no name: a word without commas, quotes and #, that no other "
                            "row has.")
                             .arg(written));
        }
        return done;
    }
    if (written.isEmpty()) {
        measurements_.set_truth(index.row(), std::nullopt);
        return true;
    }
    const std::optional<double> number = number_of(written);
    const double given = number.value_or(0.0);
    const bool angle = row_of(index.row()).measurement.quantity == Quantity::angle;
    const bool possible = number && (angle ? given >= 0.0 && given <= 180.0
                                           : given >= kLeastDistance && given <= kGreatestTrue);
    if (!possible) {
        emit refused(angle ? tr("“%1” is no angle from 0 to 180 degrees.").arg(written)
                           : tr("“%1” is no distance in metres, at least 0.001.").arg(written));
        return false;
    }
    measurements_.set_truth(index.row(), angle ? given / kDegreesPerRadian : given);
    return true;
}

QVariant MeasurementModel::key(int row, int column) const {
    const MeasuredRow& shown = row_of(row);
    switch (column) {
        case slam:
            return or_least(shown.slam.value);
        case truth:
            return or_least(shown.truth);
        case error:
            return or_least(shown.error());
        case percent:
            return or_least(shown.error_percent());
        default:
            return text(row, column);
    }
}

QString MeasurementModel::text(int row, int column) const {
    const MeasuredRow& shown = row_of(row);
    const Quantity quantity = shown.measurement.quantity;
    switch (column) {
        case name:
            return QString::fromStdString(shown.measurement.name);
        case kind:
            return kind_of_row(shown.measurement);
        case slam:
            return value_words(quantity, shown.slam.value);
        case truth:
            return value_words(quantity, shown.truth);
        case error:
            return value_words(quantity, shown.error());
        default:
            return shown.error_percent() ? QString("%1 %").arg(*shown.error_percent(), 0, 'f', 2)
                                         : QStringLiteral("–");
    }
}

MeasurementTable::MeasurementTable(Measurements& measurements, UserFiles& files, Prompts& prompts,
                                   const QList<QAction*>& measure, QWidget* parent)
    : QWidget(parent), measurements_(measurements), files_(files), prompts_(prompts) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    auto* row = new FlowLayout(nullptr, 4);
    column->addLayout(row);
    for (QAction* action : measure) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setProperty("role", "view");
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        row->addWidget(button);
    }
    row->addWidget(remove_ =
                       add_button(tr("Remove"), "measurement_remove", &MeasurementTable::remove));
    row->addWidget(clear_ = add_button(tr("Clear"), "measurement_clear", &MeasurementTable::clear));
    row->addWidget(add_button(tr("Open…"), "measurement_open", &MeasurementTable::ask_and_open));
    row->addWidget(save_ = add_button(tr("Save…"), "measurement_save", &MeasurementTable::save));
    save_->setToolTip(tr("Write the distances between walls as a file for hitos-cli --distances"));
    means_ = named(new QLabel(this), "measurement_means");
    means_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    column->addWidget(means_);
    auto* model = new MeasurementModel(measurements, this);
    table_ = named(new FiguresTable(model, this), "measurement_table");
    table_->setItemDelegate(new KeepingDelegate(table_));
    table_->setAccessibleName(tr("Measurements"));
    column->addWidget(table_);
    connect(model, &MeasurementModel::refused, this, &MeasurementTable::notice);
    connect(table_, &FiguresTable::row_chosen, &measurements, &Measurements::choose);
    connect(&measurements, &Measurements::changed, this, &MeasurementTable::refresh);
    refresh();
}

QPushButton* MeasurementTable::add_button(const QString& text, const char* name,
                                          void (MeasurementTable::*slot)()) {
    auto* button = named(new QPushButton(text, this), name);
    connect(button, &QPushButton::clicked, this, slot);
    return button;
}

void MeasurementTable::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    emit shown(true);
}

void MeasurementTable::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    emit shown(false);
}

/// The means are those of the paper's table.
void MeasurementTable::refresh() {
    table_->choose(measurements_.chosen());
    remove_->setEnabled(measurements_.chosen() >= 0);
    clear_->setEnabled(!measurements_.rows().empty());
    save_->setEnabled(measurements_.distances() > 0);
    double metres = 0.0;
    double percent = 0.0;
    int count = 0;
    for (const MeasuredRow& row : measurements_.rows()) {
        if (!row.error_percent()) continue;
        metres += std::abs(*row.error());
        percent += *row.error_percent();
        ++count;
    }
    means_->setText(count == 0 ? QString()
                               : tr("Mean error of %1: %2 m, %3 %")
                                     .arg(count)
                                     .arg(metres / count, 0, 'f', 3)
                                     .arg(percent / count, 0, 'f', 2));
}

void MeasurementTable::remove() {
    if (measurements_.chosen() >= 0) measurements_.remove(measurements_.chosen());
}

void MeasurementTable::clear() {
    if (prompts_.confirm(this, {tr("Clear the measurements"),
                                tr("Forget all %1 measurements?").arg(measurements_.rows().size()),
                                {},
                                tr("Clear"),
                                true})) {
        measurements_.clear();
    }
}

void MeasurementTable::ask_and_open() {
    const QString path =
        prompts_.open_file(this, {tr("Open distances file"),
                                  files_.folder_to_open("distances"),
                                  tr("Distances (*.distances *.txt);;All files (*)"),
                                  {}});
    if (!path.isEmpty()) open(path);
}

void MeasurementTable::open(const QString& path) {
    try {
        measurements_.open(path);
    } catch (const std::exception& problem) {
        prompts_.warn(this, tr("The file cannot be used"), words_of(problem));
        return;
    }
    files_.note_opened("distances", path);
}

void MeasurementTable::save() {
    const QString path =
        save_until_done(prompts_, this,
                        {tr("Save as distances file"), files_.place_to_save("walls.distances"),
                         tr("Distances (*.distances *.txt);;All files (*)"), "distances"},
                        [this](const QString& target) { measurements_.save(target); });
    if (path.isEmpty()) return;
    files_.note_saved("distances", path);
    const int untrue = measurements_.distances_without_truth();
    const QString saved = tr("%1 of %2 measurements, those between walls, saved: %3")
                              .arg(measurements_.distances())
                              .arg(measurements_.rows().size())
                              .arg(QDir::toNativeSeparators(path));
    emit notice(untrue == 0 ? saved
                            : tr("%1; %2 without a true value, with what is measured now")
                                  .arg(saved, QString::number(untrue)));
}

}  // namespace hitos::window
