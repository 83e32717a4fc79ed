// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_heat.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "hitos/services/study/study_abscissa.hpp"
#include "plot_style.hpp"
#include "study_plots.hpp"

namespace hitos::window {
namespace {

constexpr double kHalf = 0.5;  // of a cell, in its axis's numbers

/// With as many decimals as the tables have, and more where the cells' means lie closer.
QString as_written(const Measure& measure, double mean, double span) {
    constexpr double kMost = 6.0;
    const double two_digits = std::min(1.0 - std::floor(std::log10(span)), kMost);
    const int usual = measure.decimals + (measure.is_count() ? 1 : 0);
    return QString::number(mean, 'f', std::max(usual, static_cast<int>(two_digits)));
}

/// What can be read on a cell of that colour.
QColor ink_on(const QColor& cell) {
    constexpr int kMiddle = 140;
    return qGray(cell.rgb()) > kMiddle ? QColor(Qt::black) : QColor(Qt::white);
}

/// Words at 0, 1, 2 …, no longer than `longest`; as many are left out as there is no room for.
void name_places(QCPAxis& axis, const StudyPlan::Axis& parameter, int longest, int room, int each) {
    const QFontMetrics metrics(axis.tickLabelFont());
    const std::vector<std::string> words = study_abscissa(parameter).words;
    const auto fit = static_cast<std::size_t>(std::max(1, room / each));
    const std::size_t step = (words.size() + fit - 1) / fit;
    auto ticker = QSharedPointer<QCPAxisTickerText>::create();
    for (std::size_t i = 0; i < words.size(); i += step) {
        const QString word = QString::fromStdString(words[i]);
        ticker->addTick(static_cast<double>(i), metrics.elidedText(word, Qt::ElideMiddle, longest));
    }
    axis.setTicker(ticker);
    axis.setRange(-kHalf, static_cast<double>(words.size()) - kHalf);
    axis.setLabel(QString::fromStdString(study_axis_label(parameter)).replace("^2", "²"));
}

/// In a widget of that size.
void name_axes(QCPAxisRect& rect, const StudyPlan& plan, const QSize& size) {
    constexpr int kGap = 10;
    constexpr int kSlack = 2;      // an advance is rounded
    constexpr int kLongest = 120;  // word at an axis
    constexpr int kAround = 200;   // what axes and scale take of the width
    QCPAxis* across = rect.axis(QCPAxis::atBottom);
    const QFontMetrics metrics(across->tickLabelFont());
    int widest = 0;
    for (const std::string& word : study_abscissa(plan.axes[0]).words)
        widest = std::max(widest, metrics.horizontalAdvance(QString::fromStdString(word)) + kSlack);
    const int room = size.width() - kAround;
    const int share = room / static_cast<int>(plan.axes[0].values.size()) - kGap;
    const int longest = std::min(widest, std::max(kLongest / 2, share));
    name_places(*across, plan.axes[0], longest, room, longest + kGap);
    name_places(*rect.axis(QCPAxis::atLeft), plan.axes[1], kLongest, size.height(),
                metrics.height() + kGap);
}

}  // namespace

QString axis_words(const Measure& measure) {
    QString words = QCoreApplication::translate("Measure", measure.plot.c_str());
    return words.replace(0, 1, words.left(1).toUpper());
}

QString unit_of(const Measure& measure) {
    return QString::fromStdString(printed_unit(measure.unit));
}

std::optional<std::size_t> best_cell(const std::vector<StudyCell>& cells, const Measure& measure) {
    std::optional<std::size_t> best;
    double least = 0.0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto& figures = cells[i].figures[measure];
        if (!figures) continue;
        const double away =
            measure.target ? std::abs(figures->mean - *measure.target) : figures->mean;
        if (best && !(away < least)) continue;
        best = i;
        least = away;
    }
    return best;
}

/// Painted as shapes, so that they are sharp in PDF and SVG.
class StudyHeat::Cells final : public QCPAbstractItem {
  public:
    using QCPAbstractItem::QCPAbstractItem;

    double selectTest(const QPointF& /*place*/, bool /*selectable*/,
                      QVariant* /*details*/) const override {
        return -1.0;
    }
    /// Of a cell, in pixels.
    QRectF place_of(std::size_t cell) const {
        const std::size_t column = cell / rows;
        const auto x = static_cast<double>(column);
        const auto y = static_cast<double>(cell % rows);
        const QCPAxis* across = clipAxisRect()->axis(QCPAxis::atBottom);
        const QCPAxis* up = clipAxisRect()->axis(QCPAxis::atLeft);
        return {
            QPointF(across->coordToPixel(x - kHalf), up->coordToPixel(y + kHalf)),
            QPointF(across->coordToPixel(x + kHalf), up->coordToPixel(y - kHalf)),
        };
    }

    struct Cell {
        std::optional<double> share;  ///< of the scale; nothing where there is no mean
        QString words;
        bool failed = false;  ///< all of its runs
    };
    std::vector<Cell> cells;
    std::size_t rows = 1;  ///< values of the second parameter
    std::optional<std::size_t> best;
    std::optional<std::size_t> chosen;
    Colours look;
    QFont letters;

  protected:
    void draw(QCPPainter* painter) override {
        painter->setFont(letters);
        for (std::size_t i = 0; i < cells.size(); ++i) draw_cell(*painter, cells[i], place_of(i));
        if (best) frame(*painter, place_of(*best), Qt::SolidLine, Qt::black);
        const bool on_screen = !painter->modes().testFlag(QCPPainter::pmVectorized);
        if (chosen && on_screen) {
            const QRectF place = place_of(*chosen);
            const double in = std::min({5.0, place.width() / 8.0, place.height() / 8.0});
            frame(*painter, place.adjusted(in, in, -in, -in), Qt::DashLine, light_colours().accent);
        }
        for (std::size_t i = 0; i < cells.size(); ++i) write_words(*painter, cells[i], place_of(i));
    }

  private:
    QColor ground_of(const Cell& cell) const {
        return cell.share ? heat_colour(*cell.share) : look.card;
    }

    void draw_cell(QCPPainter& painter, const Cell& cell, const QRectF& place) const {
        painter.setPen(QPen(look.card));
        painter.setBrush(ground_of(cell));
        painter.drawRect(place);
        if (cell.failed) {
            painter.setBrush(QBrush(look.muted, Qt::BDiagPattern));
            painter.drawRect(place);
        }
    }

    /// Where they have room.
    void write_words(QCPPainter& painter, const Cell& cell, const QRectF& place) const {
        constexpr int kRound = 6;
        const QFontMetrics metrics(letters);
        if (metrics.horizontalAdvance(cell.words) + kRound > place.width() ||
            metrics.height() > place.height()) {
            return;
        }
        painter.setPen(ink_on(ground_of(cell)));
        painter.drawText(place, Qt::AlignCenter, cell.words);
    }

    /// On a ground of its own, to be seen on any colour.
    static void frame(QCPPainter& painter, const QRectF& place, Qt::PenStyle style,
                      const QColor& colour) {
        constexpr double kWide = 4.5;
        constexpr double kNarrow = 2.5;
        constexpr double kIn = kWide / 2.0;
        const QRectF line = place.adjusted(kIn, kIn, -kIn, -kIn);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(Qt::white, kWide, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
        painter.drawRect(line);
        painter.setPen(QPen(colour, kNarrow, style, Qt::FlatCap, Qt::MiterJoin));
        painter.drawRect(line);
    }
};

StudyHeat::StudyHeat(QWidget* parent) : QCustomPlot(parent) {
    constexpr int kBar = 14;
    plotLayout()->clear();
    plotLayout()->setRowSpacing(2);
    setContextMenuPolicy(Qt::NoContextMenu);
    setFocusPolicy(Qt::NoFocus);
    rect_ = add_titled_plot(*this, 0, 0, {});
    for (QCPAxis* axis : rect_->axes()) axis->grid()->setVisible(false);
    scale_ = new QCPColorScale(this);
    scale_->setType(QCPAxis::atRight);
    scale_->setBarWidth(kBar);
    scale_->setRangeDrag(false);
    scale_->setRangeZoom(false);
    plotLayout()->addElement(1, 1, scale_);
    auto* edges = new QCPMarginGroup(this);
    rect_->setMarginGroup(QCP::msTop | QCP::msBottom, edges);
    scale_->setMarginGroup(QCP::msTop | QCP::msBottom, edges);
    QCPColorGradient gradient;
    gradient.clearColorStops();
    constexpr int kStops = 16;
    for (int i = 0; i <= kStops; ++i) {
        const double share = static_cast<double>(i) / kStops;
        gradient.setColorStopAt(share, heat_colour(share));
    }
    scale_->setGradient(gradient);
    cells_ = new Cells(this);
    cells_->setClipAxisRect(rect_);
}

void StudyHeat::style(const Colours& colours) {
    const QFont small = plot_font(font());
    setBackground(colours.card);
    style_plot(*rect_, *title_of(*this, 0, 0), colours, small);
    style_plot(*scale_->axis()->axisRect(), *title_of(*this, 0, 0), colours, small);
    cells_->look = colours;
    cells_->letters = small;
}

void StudyHeat::show_results(const StudyPlan& plan, const std::vector<StudyCell>& cells,
                             const Measure& measure) {
    double least = HUGE_VAL;
    double greatest = -HUGE_VAL;
    // What darkens: the figure, or how far it is from what it ought to be.
    const auto depth = [&](double mean) {
        return measure.target ? std::abs(mean - *measure.target) : mean;
    };
    for (const StudyCell& cell : cells) {
        const auto& figures = cell.figures[measure];
        if (!figures) continue;
        least = std::min(least, depth(figures->mean));
        greatest = std::max(greatest, depth(figures->mean));
    }
    const bool any = least <= greatest;
    const double span = greatest > least ? greatest - least : 1.0;
    cells_->cells.clear();
    for (const StudyCell& cell : cells) {
        Cells::Cell& shown = cells_->cells.emplace_back();
        shown.failed = cell.finished == 0 && cell.failed > 0;
        if (const auto& figures = cell.figures[measure]) {
            shown.share = (depth(figures->mean) - least) / span;
            shown.words = as_written(measure, figures->mean, span);
        }
    }
    cells_->rows = plan.axes[1].values.size();
    cells_->best = best_cell(cells, measure);
    const QString unit = unit_of(measure);
    title_of(*this, 0, 0)
        ->setText(StudyPlots::tr("%1: mean over the runs; framed: the best")
                      .arg(axis_words(measure) + (unit.isEmpty() ? "" : " [" + unit + ']')));
    name_axes(*rect_, plan, parentWidget()->size());
    auto ends = QSharedPointer<QCPAxisTickerText>::create();
    if (any) {
        for (const double end : {least, greatest})
            ends->addTick(end, (as_written(measure, end, span) + ' ' + unit).trimmed());
        scale_->setDataRange({least, least + span});
    }
    scale_->axis()->setTicker(ends);
    scale_->setLabel(measure.target ? StudyPlots::tr("away from %1").arg(*measure.target)
                                    : axis_words(measure));
    replot(QCustomPlot::rpQueuedReplot);
}

void StudyHeat::choose(std::optional<std::size_t> cell) {
    cells_->chosen = cell;
    replot(QCustomPlot::rpQueuedReplot);
}

std::optional<std::size_t> StudyHeat::cell_at(const QPoint& place) const {
    for (std::size_t i = 0; i < cells_->cells.size(); ++i)
        if (cells_->place_of(i).contains(place)) return i;
    return std::nullopt;
}

QPoint StudyHeat::middle_of(std::size_t cell) const {
    return cells_->place_of(cell).center().toPoint();
}

}  // namespace hitos::window
