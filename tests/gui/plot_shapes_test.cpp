// SPDX-License-Identifier: GPL-3.0-or-later
// Plots as shapes: nothing is drawn beyond where it is clipped, and a legend names what it can.

#include <qcustomplot.h>

#include <QPainter>
#include <QPainterPath>
#include <QRegularExpression>
#include <QSvgRenderer>

#include "gui_fixture.hpp"
#include "tests.hpp"
#include "views/plot_style.hpp"
#include "views/study_calibration.hpp"

namespace hitos::window {
namespace {

QImage rendered(const QByteArray& svg, const QSize& size) {
    QImage image(size, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    QSvgRenderer(svg).render(&painter);
    return image;
}

int dark_pixels(const QImage& image, const QRect& but_for = {}) {
    int dark = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (!but_for.contains(x, y) && image.pixelColor(x, y).lightness() < 128) ++dark;
    return dark;
}

/// One of several values, whose poses, and perhaps landmarks, lie in their regions.
struct ManyValues {
    StudyPlan plan;
    std::vector<StudyCell> cells;

    ManyValues(int values, bool landmarks) {
        StudyPlan::Axis axis{"p", {"filter.particles"}, {""}, {}};
        for (int i = 0; i < values; ++i) {
            axis.values.push_back({std::to_string(i + 1)});
            StudyCell cell;
            for (const CalibrationKind& kind : kCalibrationKinds) {
                if (&kind != &kCalibrationKinds.front() &&
                    (!landmarks || &kind == &kCalibrationKinds.back()))
                    continue;
                for (const double region : kRegions) {
                    const std::vector<double> share{region * (i + 1) / values};
                    cell.figures[word_of_share(kind, region)] = spread_of(share);
                }
            }
            cells.push_back(cell);
        }
        plan.axes.push_back(axis);
    }
};

QStringList named_in(const QCustomPlot& plot) {
    QStringList names;
    for (auto* item : plot.findChildren<QCPPlottableLegendItem*>())
        names << item->plottable()->name();
    return names;
}

QByteArray svg_of(QCustomPlot& plot) {
    FigureWish wish;
    wish.width_mm = 170.0;
    return encoded(figure_of(plot, [](const Colours&) {}).picture(wish), "svg");
}

}  // namespace

void ViewTest::shapes_are_clipped_in_svg_too() {
    const QRect clip(20, 20, 60, 60);
    Picture picture;
    picture.size = QSizeF(100.0, 100.0);
    std::function<void(QPainter&)> draw;
    picture.paint = [&](QPaintDevice& device, double by) {
        QPainter painter(&device);
        painter.scale(by, by);
        painter.setClipRect(clip);
        painter.setPen(QPen(Qt::black, 2.0));
        draw(painter);
        painter.setClipping(false);
        painter.setPen(Qt::NoPen);
        painter.setBrush(Qt::black);
        painter.drawRect(2, 2, 4, 4);  // no longer clipped
    };
    QImage pixels(5, 5, QImage::Format_RGB32);
    pixels.fill(Qt::white);
    for (int y = 0; y < 5; ++y) {
        pixels.setPixelColor(0, y, Qt::black);
        pixels.setPixelColor(1, y, Qt::black);
    }
    const std::vector<std::function<void(QPainter&)>> all{
        [](QPainter& p) { p.drawLine(-50, -20, 150, 120); },
        [](QPainter& p) {
            p.drawPolyline(QPolygonF({{0, 50}, {50, 10}, {50, 60}, {120, 60}}));
        },
        [](QPainter& p) {
            p.setBrush(Qt::black);
            p.drawPolygon(QPolygonF({{0, 50}, {50, 10}, {120, 60}}));
        },
        [](QPainter& p) { p.drawEllipse(10, 30, 50, 50); },
        [](QPainter& p) { p.fillRect(QRect(10, 30, 30, 90), Qt::black); },
        [&](QPainter& p) { p.drawImage(QRectF(50, 50, 50, 50), pixels); },
        [&](QPainter& p) { p.drawImage(QRectF(13, 13, 50, 50), pixels); },
        [&](QPainter& p) { p.drawImage(QRectF(30, 30, 30, 30), pixels, QRectF(0, 0, 3, 3)); }};
    for (std::size_t i = 0; i < all.size(); ++i) {
        draw = all[i];
        const QImage seen = rendered(encoded(picture, "svg"), {100, 100});
        const QImage wanted = image_of(picture);
        const QRect corner(0, 0, 10, 10);
        QVERIFY2(dark_pixels(seen.copy(corner)) >= 16, qPrintable(QString::number(i)));
        const QRect around = clip.adjusted(-1, -1, 1, 1);  // lines are as wide as they are
        QVERIFY2(dark_pixels(seen, around) == dark_pixels(wanted, around),
                 qPrintable(QString::number(i)));
        const int within = dark_pixels(wanted.copy(clip));
        QVERIFY2(std::abs(dark_pixels(seen.copy(clip)) - within) <= 20 + within / 20,
                 qPrintable(QString::number(i)));
    }
}

void ViewTest::lines_of_a_plot_end_with_it_in_svg_too() {
    const ManyValues study(3, false);
    StudyCalibration plot(nullptr);
    plot.resize(640, 400);
    plot.show_results(study.plan, study.cells);
    static const QRegularExpression lines("<polyline[^>]*points=\"([^\"]*)\"");
    const QString svg = QString::fromUtf8(svg_of(plot));
    int points = 0;
    for (const QRegularExpressionMatch& line : lines.globalMatch(svg)) {
        for (const QString& point : line.captured(1).split(' ', Qt::SkipEmptyParts)) {
            const QStringList at = point.split(',');
            QVERIFY2(at[0].toDouble() >= 0.0 && at[1].toDouble() >= 0.0 &&
                         at[0].toDouble() <= 1000.0 && at[1].toDouble() <= 1000.0,
                     qPrintable(line.captured(0)));
            ++points;
        }
    }
    QVERIFY(points > 10);
}

/// In a narrow window it goes on in another line.
void StudyTest::titles_are_told_whole() {
    QCustomPlot plot;
    plot.plotLayout()->clear();
    const QString words =
        "Quality of the map [m²]: every run, mean and standard deviation; dashed: as it ought to "
        "be";
    add_titled_plot(plot, 0, 0, words);
    add_titled_plot(plot, 1, 0, words.section(';', 0, 0));
    plot.setViewport(QRect(0, 0, 250, 400));
    plot.replot();
    for (const int row : {0, 1}) {
        const QCPTextElement& title = *title_of(plot, row, 0);
        const QRect room = title.rect();
        QVERIFY(room.right() <= 250);
        const QRect needed =
            QFontMetrics(title.font())
                .boundingRect(room, Qt::TextWordWrap | Qt::AlignLeft, title.text());
        QVERIFY2(room.contains(needed), qPrintable(title.text()));
    }
    QVERIFY(title_of(plot, 0, 0)->rect().height() > title_of(plot, 1, 0)->rect().height());
}

void StudyTest::the_legend_of_shares_names_what_fits() {
    StudyCalibration plot(nullptr);
    plot.resize(900, 400);
    const auto show = [&plot](int values, bool landmarks) {
        const ManyValues study(values, landmarks);
        plot.show_results(study.plan, study.cells);
        plot.replot();
        return named_in(plot);
    };
    for (const bool landmarks : {false, true}) {
        QCOMPARE(show(3, landmarks).size(), 4);
        QCOMPARE(show(12, landmarks).size(), 13);  // all, and what ought to be
        const QString picture = qEnvironmentVariable("HITOS_PICTURES");
        if (!picture.isEmpty()) {
            plot.grab().save(picture + QString("/calibration-12-%1.png").arg(landmarks));
            write_bytes(svg_of(plot), picture + QString("/calibration-12-%1.svg").arg(landmarks));
        }
        const QStringList some = show(400, landmarks);
        QVERIFY2(some.size() > 12 && some.size() < 401, qPrintable(QString::number(some.size())));
        // In the figure for print as far as there is room in it.
        const QString svg = QString::fromUtf8(svg_of(plot));
        QVERIFY(svg.contains("choose a"));
        QVERIFY(!some.contains("p=399"));
        plot.choose(398);
        plot.replot();
        QVERIFY(named_in(plot).contains("p=399"));
        QCOMPARE(named_in(plot).size(), some.size());
        if (!picture.isEmpty())
            plot.grab().save(picture + QString("/calibration-400-%1.png").arg(landmarks));
        plot.choose({});
        // Points at the ends are not cut.
        for (const QCPAxisRect* rect : plot.axisRects()) {
            const QCPRange range = rect->axis(QCPAxis::atLeft)->range();
            QVERIFY(range.lower < 0.0 && range.upper > 1.0);
        }
    }
}

}  // namespace hitos::window
