#include "picture_dialog.hpp"

#include "ui_picture_dialog.h"

namespace hitos::window {

PictureDialog::PictureDialog(const CanvasView& view, QWidget* parent)
    : QDialog(parent), ui_(std::make_unique<Ui::PictureDialog>()) {
    ui_->setupUi(this);
    const auto refresh = [this, &view] {
        const QSize size = view.picture_size(whole(), scale());
        ui_->pixels->setText(tr("%1 × %2 pixels").arg(size.width()).arg(size.height()));
    };
    connect(ui_->whole, &QRadioButton::toggled, this, refresh);
    connect(ui_->scale, &QDoubleSpinBox::valueChanged, this, refresh);
    connect(ui_->buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(ui_->buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    refresh();
}

PictureDialog::~PictureDialog() = default;

bool PictureDialog::whole() const {
    return ui_->whole->isChecked();
}

double PictureDialog::scale() const {
    return ui_->scale->value();
}

}  // namespace hitos::window
