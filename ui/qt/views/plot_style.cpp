// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot_style.hpp"

#include <qcustomplot.h>

#include <utility>

namespace hitos::window {

QCPAxisRect* add_titled_plot(QCustomPlot& plot, int row, int column, const QString& title) {
    auto* words = new QCPTextElement(&plot, title, plot.font());
    words->setTextFlags(Qt::AlignLeft);
    words->setMargins(QMargins(8, 4, 4, 0));
    plot.plotLayout()->addElement(2 * row, column, words);
    auto* rect = new QCPAxisRect(&plot);
    rect->setMinimumMargins(QMargins(40, 4, 10, 20));
    plot.plotLayout()->addElement(2 * row + 1, column, rect);
    plot.plotLayout()->setRowStretchFactor(2 * row, 0.01);
    return rect;
}

QCPTextElement* title_of(QCustomPlot& plot, int row, int column) {
    return qobject_cast<QCPTextElement*>(plot.plotLayout()->element(2 * row, column));
}

void leave_menu_to_parent(QCustomPlot& plot) {
    plot.setContextMenuPolicy(Qt::NoContextMenu);
    plot.setAttribute(Qt::WA_NoMousePropagation, false);  // as the library sets it
}

QFont plot_font(const QFont& words) {
    QFont font = words;
    font.setPointSizeF(font.pointSizeF() * 0.85);
    return font;
}

FigureOffer figure_of(QCustomPlot& plot, std::function<void(const Colours&)> style) {
    constexpr double kPage = 170.0;  // mm
    FigureOffer offer;
    offer.width = plot.width();
    offer.paper_mm = kPage;
    offer.picture = [&plot, style = std::move(style)](const FigureWish& wish) {
        const double high = wish.points() * plot.height() / plot.width();
        const double top = FigureFrame(wish, plot.font(), false).around().top();
        Picture picture;
        picture.size = QSizeF(wish.points(), high + top);
        picture.mm_per_point = wish.mm_per_point;
        picture.ground = wish.ground();
        picture.paint = [&plot, style, wish, top, high](QPaintDevice& device, double by) {
            style(*wish.colours);
            QCPPainter painter(&device);
            painter.setMode(QCPPainter::pmVectorized);
            painter.setFont(plot.font());
            painter.scale(by, by);
            painter.fillRect(QRectF(0.0, 0.0, wish.points(), high + top), wish.ground());
            painter.translate(0.0, top);
            FigureFrame(wish, plot.font(), false)
                .paint(painter, {{}, QSizeF(wish.points(), high), 1.0, *wish.colours},
                       *wish.colours);
            plot.toPainter(&painter, qRound(wish.points()), qRound(high));
            style(colours());
        };
        return picture;
    };
    return offer;
}

void style_plot(QCPAxisRect& rect, QCPTextElement& title, const Colours& colours,
                const QFont& font) {
    for (QCPAxis* axis : rect.axes()) {
        axis->setBasePen(QPen(colours.border));
        axis->setTickPen(QPen(colours.border));
        axis->setSubTickPen(Qt::NoPen);
        axis->setTickLabelColor(colours.muted);
        axis->setTickLabelFont(font);
        axis->setLabelColor(colours.muted);
        axis->setLabelFont(font);
        axis->grid()->setPen(QPen(colours.grid_line));
        axis->grid()->setZeroLinePen(QPen(colours.border));
    }
    title.setTextColor(colours.text);
    title.setFont(font);
}

}  // namespace hitos::window
