// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture.hpp"

#include <QBuffer>
#include <QClipboard>
#include <QCoreApplication>
#include <QFileInfo>
#include <QGuiApplication>
#include <QPageSize>
#include <QPdfWriter>
#include <QSvgGenerator>

#include "clipping_device.hpp"
#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"

namespace hitos::window {
namespace {

constexpr int kDotsPerInch = 96;  // of the screen's points

QString picture_words(const char* text) {
    return QCoreApplication::translate("Picture", text);
}

QString ending_of(const QString& path) {
    return QFileInfo(path).suffix().toLower();
}

QByteArray pixels_of(const QImage& image, const QString& ending) {
    constexpr int kJpegQuality = 95;
    const bool jpeg = ending != "png";
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!image.save(&buffer, jpeg ? "JPG" : "PNG", jpeg ? kJpegQuality : -1)) {
        throw Error(
            verbatim(picture_words(QT_TRANSLATE_NOOP("Picture", "the picture could not be encoded"))
                         .toStdString()));
    }
    return bytes;
}

/// How much larger points are than the dots of a device of shapes.
double by_of(const Picture& picture) {
    return picture.mm_per_point / kMmPerPoint;
}

QByteArray svg_of(const Picture& picture) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QSvgGenerator device;
    device.setOutputDevice(&buffer);
    device.setSize((picture.size * by_of(picture)).toSize());
    device.setViewBox(QRectF(QPointF(), picture.size));
    device.setResolution(kDotsPerInch);
    device.setTitle("Hitos");
    ClippingDevice clipped(device);
    picture.paint(clipped, 1.0);
    return bytes;
}

QByteArray pdf_of(const Picture& picture) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter device(&buffer);
        device.setResolution(kDotsPerInch);
        device.setPageSize(QPageSize(picture.size * picture.mm_per_point, QPageSize::Millimeter, {},
                                     QPageSize::ExactMatch));
        device.setPageMargins({});
        device.setTitle("Hitos");
        picture.paint(device, by_of(picture));
    }
    return bytes;
}

void check_ending(const QString& path, const QStringList& known) {
    if (known.contains(ending_of(path))) return;
    throw FileError(
        path.toStdString(),
        verbatim(picture_words(QT_TRANSLATE_NOOP("Picture", "pictures are written as %1"))
                     .arg("." + known.join(", ."))
                     .toStdString()));
}

}  // namespace

void check_size(const Picture& picture) {
    constexpr int kLongestSide = 16000;
    const QSize pixels = picture.pixels();
    if (std::max(pixels.width(), pixels.height()) <= kLongestSide) return;
    throw Error(verbatim(picture_words(QT_TRANSLATE_NOOP("Picture",
                                                         "The picture would have %1 × %2 "
                                                         "pixels and may have %3 a side; choose "
                                                         "a smaller one."))
                             .arg(pixels.width())
                             .arg(pixels.height())
                             .arg(kLongestSide)
                             .toStdString()));
}

QImage image_of(const Picture& picture) {
    check_size(picture);
    QImage image(picture.pixels().expandedTo({1, 1}), QImage::Format_RGB32);
    image.fill(picture.ground);
    picture.paint(image, picture.scale);
    // After it, for letters go by them.
    const int dots = qRound(picture.scale / picture.mm_per_point * 1000.0);  // in a metre
    image.setDotsPerMeterX(dots);
    image.setDotsPerMeterY(dots);
    return image;
}

void copy(const Picture& picture) {
    QGuiApplication::clipboard()->setImage(image_of(picture));
}

QString picture_filter() {
    return picture_words(QT_TRANSLATE_NOOP("Picture", "Pictures (*.png *.jpg *.jpeg *.svg *.pdf)"));
}

QByteArray encoded(const Picture& picture, const QString& ending) {
    if (picture.shapes && (ending == "svg" || ending == "pdf")) return picture.shapes(ending);
    if (ending == "svg") return svg_of(picture);
    if (ending == "pdf") return pdf_of(picture);
    return pixels_of(image_of(picture), ending);
}

void write_bytes(const QByteArray& bytes, const QString& path) {
    write_file(path.toStdString(), {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

void write_picture(const Picture& picture, const QString& path) {
    check_ending(path, {"png", "jpg", "jpeg", "svg", "pdf"});
    write_bytes(encoded(picture, ending_of(path)), path);
}

void write_image(const QImage& image, const QString& path) {
    check_ending(path, {"png", "jpg", "jpeg"});
    write_bytes(pixels_of(image, ending_of(path)), path);
}

}  // namespace hitos::window
