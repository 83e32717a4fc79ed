// Saving a view as JPG or PNG [T use case 8.2.2.10].
#pragma once

#include <QDialog>
#include <memory>

#include "views/canvas_view.hpp"

namespace hitos::window {

namespace Ui {
class PictureDialog;
}

/// Asks what part of a view to save, and how large.
class PictureDialog final : public QDialog {
    Q_OBJECT

  public:
    PictureDialog(const CanvasView& view, QWidget* parent);
    ~PictureDialog() override;

    bool whole() const;
    double scale() const;

  private:
    std::unique_ptr<Ui::PictureDialog> ui_;
};

/// The image as the content of a .png, .jpg or .jpeg file; throws hitos::Error for another kind.
QByteArray encoded(const QImage& image, const QString& path);

/// Writes the image atomically. Throws hitos::Error.
void write_image(const QImage& image, const QString& path);

}  // namespace hitos::window
