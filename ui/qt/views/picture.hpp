// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures for files and the clipboard: pixels, or shapes for print.
#pragma once

#include <QByteArray>
#include <QColor>
#include <QImage>
#include <QSize>
#include <QString>
#include <functional>

class QPaintDevice;

namespace hitos::window {

/// What a point of the screen is as long as, at 96 to the inch.
inline constexpr double kMmPerPoint = 25.4 / 96.0;

/// Something that can be painted at any scale.
struct Picture {
    QSizeF size;                        ///< in points of the screen
    double scale = 1.0;                 ///< pixels of a file of pixels for each of them
    double mm_per_point = kMmPerPoint;  ///< how large they are on paper
    /// Paints on a device that has `scale` of its units for each point of the screen.
    std::function<void(QPaintDevice& device, double scale)> paint;
    /// The bytes of an SVG ("svg") or PDF, where somebody else makes them.
    std::function<QByteArray(const QString& ending)> shapes = {};
    QColor ground = Qt::white;

    QSize pixels() const { return (size * scale).toSize(); }
};

/// Throws hitos::Error where a file of pixels would have too many of them.
void check_size(const Picture& picture);
/// In pixels; throws what check_size() does.
QImage image_of(const Picture& picture);
/// To the clipboard, in pixels.
void copy(const Picture& picture);

/// The content of a file of that ending ("jpg", "svg" …). Throws hitos::Error.
QByteArray encoded(const Picture& picture, const QString& ending);
/// Atomically. Throws hitos::FileError.
void write_bytes(const QByteArray& bytes, const QString& path);
/// The endings that write_picture() knows, for a file dialog.
QString picture_filter();
/// Writes the picture atomically as the ending says: .png, .jpg and .jpeg of pixels, .svg and .pdf
/// of shapes. Throws hitos::Error, for another ending too.
void write_picture(const Picture& picture, const QString& path);

/// Writes the image atomically as .png or .jpg. Throws hitos::Error.
void write_image(const QImage& image, const QString& path);

}  // namespace hitos::window
