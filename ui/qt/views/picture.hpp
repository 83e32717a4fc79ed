// Pictures for files and the clipboard: pixels, or shapes for print.
#pragma once

#include <QImage>
#include <QSize>
#include <QString>
#include <functional>

class QCustomPlot;
class QPaintDevice;

namespace hitos::window {

struct Colours;

/// Something that can be painted at any scale.
struct Picture {
    QSizeF size;         ///< in points of the screen
    double scale = 1.0;  ///< pixels of a file of pixels for each of them
    /// Paints on a device that has `scale` of its units for each point of the screen.
    std::function<void(QPaintDevice& device, double scale)> paint;

    QSize pixels() const { return (size * scale).toSize(); }
};

/// `style` gives the plot its colours; the picture's are the light ones, whatever the screen's.
Picture picture_of(QCustomPlot& plot, double scale, std::function<void(const Colours&)> style);

QImage image_of(const Picture& picture);

/// Pixels of a copied picture for each point of the screen.
inline constexpr double kCopyScale = 2.0;
/// Puts it into the clipboard.
void copy(const Picture& picture);

/// The endings that write_picture() knows, for a file dialog.
QString picture_filter();
/// Writes the picture atomically as the ending says: .png, .jpg and .jpeg of pixels, .svg and .pdf
/// of shapes. Throws hitos::Error, for another ending too.
void write_picture(const Picture& picture, const QString& path);

/// Writes the image atomically as .png or .jpg. Throws hitos::Error.
void write_image(const QImage& image, const QString& path);

}  // namespace hitos::window
