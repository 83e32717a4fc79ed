// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot_style.hpp"

#include <qcustomplot.h>

#include <QPicture>
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace hitos::window {

namespace {

/// Goes on in another line where the plot is too narrow for it; Qt's own would be cut.
class Title final : public QCPTextElement {
  public:
    static constexpr int kFlags = Qt::AlignLeft | Qt::TextWordWrap;
    using QCPTextElement::QCPTextElement;

    QSize minimumOuterSizeHint() const override { return {0, height()}; }
    QSize maximumOuterSizeHint() const override { return {QWIDGETSIZE_MAX, height()}; }

  private:
    int height() const {
        const QMargins around = margins();
        const int room = column_width() - around.left() - around.right();
        return QFontMetrics(font()).boundingRect(0, 0, room, 0, kFlags, text()).height() +
               around.top() + around.bottom();
    }
    /// Plots share what columns that are no wider than they need, as a colour scale's, leave.
    int column_width() const {
        const QCustomPlot& plot = *parentPlot();
        QCPLayoutGrid& grid = *plot.plotLayout();  // who asks for a cell that is empty is told off
        int room = plot.viewport().width();
        int plots = grid.columnCount();
        for (int column = 0; column < grid.columnCount(); ++column) {
            for (int row = 0; row < grid.rowCount(); ++row) {
                if (!grid.hasElement(row, column)) continue;
                const QCPLayoutElement* element = grid.element(row, column);
                if (element->maximumSize().width() == QWIDGETSIZE_MAX) continue;
                room -= element->maximumSize().width() + grid.columnSpacing();
                --plots;
                break;
            }
        }
        return room / std::max(plots, 1);
    }
};

}  // namespace

QCPAxisRect* add_titled_plot(QCustomPlot& plot, int row, int column, const QString& title) {
    auto* words = new Title(&plot, title, plot.font());
    words->setTextFlags(Title::kFlags);
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

QColor line_colour(std::size_t number) {
    static const std::array<QColor, kLineColours> colours{
        QColor(0, 114, 178), QColor(213, 94, 0),   QColor(0, 158, 115),  QColor(204, 121, 167),
        QColor(230, 159, 0), QColor(86, 180, 233), QColor(148, 103, 189)};
    return colours[number % colours.size()];
}

namespace {

constexpr double kLeastHigh = 150.0;  // points of a figure, where the plot is as high

/// Draws it with no more numbers along upright axes than have room there.
void draw_plot(QCustomPlot& plot, QCPPainter& painter, const QSize& size) {
    constexpr double kLinesEach = 2.0;
    QPicture measured;  // laid out, and drawn nowhere
    {
        QCPPainter nowhere(&measured);
        plot.toPainter(&nowhere, size.width(), size.height());
    }
    std::vector<std::pair<QCPAxis*, int>> before;
    for (QCPAxisRect* rect : plot.axisRects()) {
        for (QCPAxis* axis : rect->axes(QCPAxis::atLeft | QCPAxis::atRight)) {
            const double line = QFontMetricsF(axis->tickLabelFont()).height();
            const int room = static_cast<int>(rect->height() / (kLinesEach * line));
            const int wanted = axis->ticker()->tickCount();
            if (room >= wanted) continue;
            before.emplace_back(axis, wanted);
            axis->ticker()->setTickCount(std::max(room, 1));
        }
    }
    plot.toPainter(&painter, size.width(), size.height());
    for (const auto& [axis, count] : before) axis->ticker()->setTickCount(count);
}

}  // namespace

FigureOffer figure_of(QCustomPlot& plot, std::function<void(const Colours&)> style,
                      std::function<void(bool)> show_legend) {
    constexpr double kPage = 170.0;  // mm
    FigureOffer offer;
    offer.width = plot.width();
    offer.paper_mm = kPage;
    offer.legend = show_legend != nullptr;
    offer.picture = [&plot, style = std::move(style),
                     show_legend = std::move(show_legend)](const FigureWish& wish) {
        const double high = std::max(wish.points() * plot.height() / plot.width(),
                                     std::min(kLeastHigh, static_cast<double>(plot.height())));
        const double top = FigureFrame(wish, plot.font(), false).around().top();
        Picture picture;
        picture.size = QSizeF(wish.points(), high + top);
        picture.mm_per_point = wish.mm_per_point;
        picture.ground = wish.ground();
        picture.paint = [&plot, style, show_legend, wish, top, high](QPaintDevice& device,
                                                                     double by) {
            style(*wish.colours);
            if (show_legend) show_legend(wish.legend || wish.as_seen);
            QCPPainter painter(&device);
            painter.setMode(QCPPainter::pmVectorized);
            painter.setFont(plot.font());
            painter.scale(by, by);
            painter.fillRect(QRectF(0.0, 0.0, wish.points(), high + top), wish.ground());
            painter.translate(0.0, top);
            FigureFrame(wish, plot.font(), false)
                .paint(painter, {{}, QSizeF(wish.points(), high), 1.0, *wish.colours},
                       *wish.colours);
            draw_plot(plot, painter, {qRound(wish.points()), qRound(high)});
            if (show_legend) show_legend(true);
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
