#include "import_dialog.hpp"

#include <QApplication>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QThreadPool>

#include "app/theme.hpp"
#include "app/words_of.hpp"
#include "workers/background.hpp"

namespace hitos::window {
namespace {

QDoubleSpinBox* length_field(QWidget* parent, const char* name, double greatest) {
    constexpr int kDecimals = 4;
    auto* field = new QDoubleSpinBox(parent);
    field->setObjectName(name);
    field->setDecimals(kDecimals);
    field->setRange(0.0, greatest);
    field->setSingleStep(0.01);
    field->setSuffix(ImportDialog::tr(" m"));
    return field;
}

}  // namespace

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
    tolerance_ = length_field(this, "import_tolerance", 10.0);
    tolerance_->setSpecialValueText(kind == WallSource::map ? tr("0.05 m") : tr("two pixels"));
    tolerance_->setToolTip(kind == WallSource::map
                               ? tr("How far a corner may lie from a line to be on it")
                               : tr("How far a wall may lie from the middle of what is drawn; "
                                    "more gives fewer and straighter walls"));
    form->addRow(tr("Tolerance"), tolerance_);
    verdict_ = new QLabel(this);
    verdict_->setObjectName("import_verdict");
    verdict_->setWordWrap(true);
    form->addRow(verdict_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    find_ = buttons->addButton(tr("Find the walls"), QDialogButtonBox::AcceptRole);
    find_->setDefault(true);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &ImportDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void ImportDialog::accept() {
    ImportOptions options;
    options.tolerance_m = tolerance_->value();
    if (pixel_ != nullptr) options.resolution_m = pixel_->value();
    find_->setEnabled(false);
    set_look(*verdict_, "role", "muted");
    verdict_->setText(tr("Looking for walls…"));
    // Whoever cancels does not wait for the end of it.
    QThreadPool::globalInstance()->start(
        [self = QPointer(this), options, source = source_.toStdString()] {
            begin_background_work();
            std::optional<WorldText> world;
            std::size_t left_out = 0;
            QString problem;
            try {
                world = import_world(source, {}, options, &left_out);
            } catch (const std::exception& error) {
                problem = words_of(error);
            }
            QMetaObject::invokeMethod(qApp, [self, world, left_out, problem] {
                if (self) self->finish(world, left_out, problem);
            });
        });
}

void ImportDialog::finish(const std::optional<WorldText>& world, std::size_t left_out,
                          const QString& problem) {
    find_->setEnabled(true);
    if (!world) {
        set_look(*verdict_, "role", "error");
        verdict_->setText(problem);
        return;
    }
    world_ = world;
    words_ = tr("Walls found: %1, tolerance %2")
                 .arg(world->world().walls.size())
                 .arg(tolerance_->text());
    if (left_out > 0) {
        words_ += tr("; lines without two corners left out: %1").arg(left_out);
    }
    QDialog::accept();
}

}  // namespace hitos::window
