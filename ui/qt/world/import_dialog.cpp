// SPDX-License-Identifier: GPL-3.0-or-later
#include "import_dialog.hpp"

#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QThreadPool>

#include "hitos/simulation/drawings/dxf_walls.hpp"
#include "look/named.hpp"
#include "look/theme.hpp"
#include "look/words_of.hpp"
#include "session/background.hpp"

namespace hitos::window {
namespace {

QDoubleSpinBox* length_field(QWidget* parent, const char* name, double greatest) {
    constexpr int kDecimals = 4;
    auto* field = named(new QDoubleSpinBox(parent), name);
    field->setDecimals(kDecimals);
    field->setRange(0.0, greatest);
    field->setSingleStep(0.01);
    field->setSuffix(ImportDialog::tr(" m"));
    return field;
}

}  // namespace

QString found_words(const WorldText& world, const ImportReport& report) {
    QStringList words{ImportDialog::tr("Walls found: %1").arg(world.world().walls.size())};
    for (const auto* messages : {&report.notes, &report.warnings}) {
        for (const Message& message : *messages) words << words_of(message);
    }
    return words.join(QStringLiteral("; "));
}

ImportDialog::ImportDialog(const QString& source, WallSource kind, QWidget* parent)
    : QDialog(parent), source_(source), kind_(kind) {
    setObjectName("import_dialog");
    setWindowTitle(tr("Walls of %1").arg(QFileInfo(source).fileName()));
    auto* form = new QFormLayout(this);
    if (kind == WallSource::picture) {
        constexpr double kUsual = 0.05;  // as most grids of robots have
        pixel_ = length_field(this, "import_pixel", 100.0);
        pixel_->setValue(kUsual);
        pixel_->setToolTip(
            tr("How long a side of a pixel is. The YAML file of map_server beside "
               "a picture says it: open that one instead, if there is one."));
        form->addRow(tr("A pixel"), pixel_);
    }
    if (kind == WallSource::drawing) {
        ask_for_layer_and_unit(*form);
    } else {
        ask_for_tolerance(*form);
    }
    verdict_ = named(new QLabel(this), "import_verdict");
    verdict_->setWordWrap(true);
    form->addRow(verdict_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    find_ = buttons->addButton(tr("Find the walls"), QDialogButtonBox::AcceptRole);
    find_->setDefault(true);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &ImportDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ImportDialog::ask_for_tolerance(QFormLayout& form) {
    tolerance_ = length_field(this, "import_tolerance", 10.0);
    tolerance_->setSpecialValueText(kind_ == WallSource::map ? tr("0.05 m") : tr("two pixels"));
    tolerance_->setToolTip(kind_ == WallSource::map
                               ? tr("How far a corner may lie from a line to be on it")
                               : tr("How far a wall may lie from the middle of what is drawn; "
                                    "more gives fewer and straighter walls"));
    form.addRow(tr("Tolerance"), tolerance_);
}

void ImportDialog::ask_for_layer_and_unit(QFormLayout& form) {
    unit_ = named(new QComboBox(this), "import_unit");
    unit_->addItem(tr("as the drawing says, else metres"), 0.0);
    for (const DrawingUnit& unit : kDrawingUnits)
        unit_->addItem(QCoreApplication::translate("DrawingUnit", unit.name), unit.metres);
    form.addRow(tr("Unit"), unit_);
    layer_ = named(new QLineEdit(this), "import_layer");
    layer_->setPlaceholderText(tr("all that are shown"));
    layer_->setToolTip(tr("The layers whose entities are walls, apart by commas"));
    form.addRow(tr("Layers"), layer_);
}

void ImportDialog::tell(const std::vector<Message>& doubts) {
    QStringList words;
    for (const Message& doubt : doubts) words << words_of(doubt);
    verdict_->setText(words.join(QStringLiteral("\n")));
    set_look(*verdict_, "role", "warning");
}

void ImportDialog::accept() {
    ImportOptions options;
    if (tolerance_ != nullptr) options.tolerance_m = tolerance_->value();
    if (unit_ != nullptr) {
        options.layer = layer_->text().trimmed().toStdString();
        const double unit_m = unit_->currentData().toDouble();
        if (unit_m > 0.0) options.unit_m = unit_m;
    }
    if (pixel_ != nullptr) options.resolution_m = pixel_->value();
    find_->setEnabled(false);
    set_look(*verdict_, "role", "muted");
    verdict_->setText(tr("Looking for walls…"));
    // Whoever cancels does not wait for the end of it.
    QThreadPool::globalInstance()->start(
        [self = QPointer(this), options, source = source_.toStdString()] {
            begin_background_work();
            std::optional<WorldText> world;
            ImportReport report;
            QString problem;
            try {
                world = import_world(source, {}, options, &report);
            } catch (const std::exception& error) {
                problem = words_of(error);
            }
            QMetaObject::invokeMethod(qApp, [self, world, report, problem] {
                if (self) self->finish(world, report, problem);
            });
        });
}

void ImportDialog::finish(const std::optional<WorldText>& world, const ImportReport& report,
                          const QString& problem) {
    find_->setEnabled(true);
    if (!world) {
        set_look(*verdict_, "role", "error");
        verdict_->setText(problem);
        return;
    }
    world_ = world;
    words_ = tolerance_ == nullptr ? found_words(*world, report)
                                   : tr("Walls found: %1, tolerance %2")
                                         .arg(world->world().walls.size())
                                         .arg(tolerance_->text());
    if (report.left_out > 0) {
        words_ += tr("; lines without two corners left out: %1").arg(report.left_out);
    }
    QDialog::accept();
}

}  // namespace hitos::window
