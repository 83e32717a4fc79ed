#include "picture_dialog.hpp"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileInfo>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
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

QByteArray encoded(const QImage& image, const QString& path) {
    constexpr int kJpegQuality = 95;
    const QString suffix = QFileInfo(path).suffix().toLower();
    const bool jpeg = suffix == "jpg" || suffix == "jpeg";
    if (!jpeg && suffix != "png") {
        throw FileError(path.toStdString(),
                        QCoreApplication::translate("PictureDialog",
                                                    "pictures are written as .png, .jpg or .jpeg")
                            .toStdString());
    }
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, jpeg ? "JPG" : "PNG", jpeg ? kJpegQuality : -1)) {
        throw FileError(path.toStdString(), QCoreApplication::translate(
                                                "PictureDialog", "the picture could not be encoded")
                                                .toStdString());
    }
    return bytes;
}

void write_image(const QImage& image, const QString& path) {
    const QByteArray bytes = encoded(image, path);
    write_file(path.toStdString(), {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

}  // namespace hitos::window
