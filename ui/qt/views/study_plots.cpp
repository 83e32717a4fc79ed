#include "study_plots.hpp"

#include <qcustomplot.h>

#include <QBuffer>
#include <QContextMenuEvent>
#include <QMenu>
#include <QPageSize>
#include <QPdfWriter>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "plot_style.hpp"

namespace hitos::window {
namespace {

// Pixels round and between the words of the axis.
constexpr int kGap = 14;
constexpr int kLeft = 40;
constexpr int kTop = 4;
constexpr int kRight = 10;
constexpr int kBottom = 20;
constexpr double kRoom = 0.06;  // of the axis, at both ends

QString with_spread(const Spread& spread, int decimals) {
    QString mean = QString::number(spread.mean, 'f', decimals);
    if (!spread.variance) return mean;
    return mean + " ± " + QString::number(std::sqrt(*spread.variance), 'f', decimals);
}

QString landmarks_title() {
    return StudyPlots::tr("Landmarks: every run, mean and standard deviation");
}

}  // namespace

StudyPlots::StudyPlots(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(plot_);
    plot_->plotLayout()->clear();
    plot_->plotLayout()->setRowSpacing(2);
    plot_->setContextMenuPolicy(Qt::NoContextMenu);
    quality_ = make_measure(0, {});
    landmarks_ = make_measure(1, {});
    // Both share the parameter's axis, so their left edges must agree.
    auto* margins = new QCPMarginGroup(plot_);
    for (const Measure* measure : {&quality_, &landmarks_})
        measure->rect->setMarginGroup(QCP::msLeft, margins);
    connect(plot_, &QCustomPlot::mouseMove, this,
            [this](const QMouseEvent* event) { explain(event->pos()); });
    clear();
    restyle();
}

StudyPlots::Quality StudyPlots::quality_of(const StudyPlan& plan,
                                           const std::vector<StudyCell>& cells) {
    constexpr int kErrorDecimals = 4;
    constexpr int kBlurDecimals = 2;
    const auto any = [&](std::optional<Spread> StudyCell::*figures) {
        return std::ranges::any_of(
            cells, [&](const StudyCell& cell) { return (cell.*figures).has_value(); });
    };
    if (plan.has_reference()) {
        return {&StudyCell::error_m, &StudyRecord::error_m,
                tr("Map error [m]: every run, mean and standard deviation"), tr("Map error: %1 m"),
                kErrorDecimals};
    }
    if (any(&StudyCell::trajectory_error_m)) {
        return {&StudyCell::trajectory_error_m, &StudyRecord::trajectory_error_m,
                tr("Trajectory error (ATE) [m]: every run, mean and standard deviation"),
                tr("Trajectory error: %1 m"), kErrorDecimals};
    }
    return {&StudyCell::blur_m2, &StudyRecord::blur_m2,
            tr("Blur of the grid map [m²]: every run, mean and standard deviation"),
            tr("Blur: %1 m²"), kBlurDecimals};
}

StudyPlots::Measure StudyPlots::make_measure(int row, const QString& title) {
    Measure measure;
    measure.rect = add_titled_plot(*plot_, row, 0, title);
    QCPAxis* x = measure.rect->axis(QCPAxis::atBottom);
    QCPAxis* y = measure.rect->axis(QCPAxis::atLeft);
    measure.reference = plot_->addGraph(x, y);
    measure.runs = plot_->addGraph(x, y);
    measure.runs->setLineStyle(QCPGraph::lsNone);
    measure.means = plot_->addGraph(x, y);
    measure.spread = new QCPErrorBars(x, y);
    measure.spread->setDataPlottable(measure.means);
    measure.spread->setSymbolGap(0.0);
    return measure;
}

void StudyPlots::restyle() {
    style(colours());
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void StudyPlots::style(const Colours& c) {
    constexpr double kLine = 1.6;
    constexpr double kDot = 7.0;
    const QFont small = plot_font(font());
    plot_->setBackground(c.card);
    int row = 0;
    for (const Measure* measure : {&quality_, &landmarks_}) {
        const QColor colour = measure == &quality_ ? c.path : c.landmark;
        QColor faint = colour;
        faint.setAlpha(90);
        style_plot(*measure->rect, *title_of(*plot_, row++, 0), c, small);
        measure->means->setPen(QPen(colour, kLine));
        measure->means->setScatterStyle(
            QCPScatterStyle(QCPScatterStyle::ssDisc, colour, colour, kDot));
        measure->spread->setPen(QPen(colour, kLine));
        measure->runs->setScatterStyle(
            QCPScatterStyle(QCPScatterStyle::ssCircle, faint, Qt::transparent, kDot));
        measure->reference->setPen(QPen(c.muted, kLine, Qt::DashLine));
    }
}

void StudyPlots::clear() {
    cells_.clear();
    for (const Measure* measure : {&quality_, &landmarks_}) {
        for (QCPGraph* graph : {measure->runs, measure->means, measure->reference})
            graph->data()->clear();
        measure->spread->data()->clear();
        for (QCPAxis* axis : measure->rect->axes()) axis->setTickLabels(false);
        measure->rect->axis(QCPAxis::atBottom)->setLabel({});
    }
    StudyPlan usual;
    usual.reference_lines = 1;
    shown_ = quality_of(usual, {});
    title_of(*plot_, 0, 0)->setText(shown_.title);
    title_of(*plot_, 1, 0)->setText(landmarks_title());
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void StudyPlots::lay_out_axis(const StudyPlan::Axis& axis) {
    constexpr std::size_t kMostNamed = 12;
    constexpr double kSlant = 20.0;
    x_ = study_abscissa(axis);
    const auto [least, greatest] = std::minmax_element(x_.positions.begin(), x_.positions.end());
    const bool named = !x_.numbers || (x_.logarithmic && x_.positions.size() <= kMostNamed);
    const QFontMetrics metrics(plot_font(font()));
    int widest = 0;
    for (const std::string& word : x_.words) {
        widest = std::max(widest, metrics.horizontalAdvance(QString::fromStdString(word)));
    }
    // Words that would not stand beside each other lean; the last one needs room of its own.
    const auto places = static_cast<int>(x_.words.size());
    const bool slanted = named && places * (widest + kGap) > plot_->width() - kLeft;
    const int right = !named ? kRight : std::max(kRight, slanted ? widest : widest / 2);
    for (const Measure* measure : {&quality_, &landmarks_}) {
        QCPAxis* bottom = measure->rect->axis(QCPAxis::atBottom);
        measure->rect->setMinimumMargins(QMargins(kLeft, kTop, right, kBottom));
        bottom->setScaleType(x_.logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
        if (named) {
            auto ticker = QSharedPointer<QCPAxisTickerText>::create();
            for (std::size_t i = 0; i < x_.positions.size(); ++i)
                ticker->addTick(x_.positions[i], QString::fromStdString(x_.words[i]));
            bottom->setTicker(ticker);
        } else if (x_.logarithmic) {
            bottom->setTicker(QSharedPointer<QCPAxisTickerLog>::create());
        } else {
            bottom->setTicker(QSharedPointer<QCPAxisTicker>::create());
        }
        bottom->setTickLabelRotation(slanted ? kSlant : 0.0);
        if (x_.logarithmic) {
            const double room = std::pow(*greatest / *least, kRoom);
            bottom->setRange(*least / room, *greatest * room);
        } else {
            const double span = *greatest - *least;
            const double room = span > 0.0 ? kRoom * span : std::max(1.0, std::abs(*least));
            bottom->setRange(*least - room, *greatest + room);
        }
        for (QCPAxis* each : measure->rect->axes()) each->setTickLabels(true);
    }
    landmarks_.rect->axis(QCPAxis::atBottom)
        ->setLabel(QString::fromStdString(study_axis_label(axis)).replace("^2", "²"));
}

void StudyPlots::draw(const Measure& measure, std::optional<Spread> StudyCell::*spread) {
    QVector<double> xs;
    QVector<double> means;
    QVector<double> deviations;
    double top = 0.0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const std::optional<Spread>& figures = cells_[i].*spread;
        if (!figures) continue;
        const double deviation = std::sqrt(figures->variance.value_or(0.0));
        xs << x_.positions[i];
        means << figures->mean;
        deviations << deviation;
        top = std::max({top, figures->maximum, figures->mean + deviation});
    }
    // Error bars go by place, so the order must be that of the graph.
    std::vector<qsizetype> order(static_cast<std::size_t>(xs.size()));
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<qsizetype>(i);
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return xs[a] < xs[b]; });
    QVector<double> sorted;
    for (const qsizetype i : order) sorted << deviations[i];
    measure.means->setData(xs, means);
    measure.spread->setData(sorted);
    for (const auto& point : *measure.reference->data()) top = std::max(top, point.value);
    measure.rect->axis(QCPAxis::atLeft)->setRange(0.0, top > 0.0 ? top * (1.0 + kRoom) : 1.0);
}

void StudyPlots::show_results(const StudyPlan& plan, const std::vector<StudyRecord>& records) {
    cells_ = summarize(plan, records);
    shown_ = quality_of(plan, cells_);
    title_of(*plot_, 0, 0)->setText(shown_.title);
    lay_out_axis(plan.axes.front());
    for (const Measure* measure : {&quality_, &landmarks_}) measure->runs->data()->clear();
    for (std::size_t run = 0; run < records.size(); ++run) {
        const StudyRecord& record = records[run];
        if (!record.ok) continue;
        const double x = x_.positions[plan.cell_of(run)];
        if (const std::optional<double>& figure = record.*shown_.run) {
            quality_.runs->addData(x, *figure);
        }
        landmarks_.runs->addData(x, record.lines + record.corners);
    }
    const int known = plan.reference_lines + plan.reference_corners;
    const QCPRange range = landmarks_.rect->axis(QCPAxis::atBottom)->range();
    landmarks_.reference->data()->clear();
    title_of(*plot_, 1, 0)->setText(landmarks_title());
    if (plan.has_reference()) {
        landmarks_.reference->setData({range.lower, range.upper},
                                      {static_cast<double>(known), static_cast<double>(known)});
        title_of(*plot_, 1, 0)
            ->setText(
                tr("Landmarks: every run, mean and standard deviation; dashed: %1 in the reference")
                    .arg(known));
    }
    draw(quality_, shown_.cell);
    draw(landmarks_, &StudyCell::landmarks);
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void StudyPlots::explain(const QPoint& place) {
    constexpr double kNear = 24.0;
    for (const Measure* measure : {&quality_, &landmarks_}) {
        if (!measure->rect->rect().contains(place)) continue;
        const QCPAxis* bottom = measure->rect->axis(QCPAxis::atBottom);
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            if (std::abs(bottom->coordToPixel(x_.positions[i]) - place.x()) > kNear) continue;
            QStringList lines{QString::fromStdString(x_.words[i]),
                              tr("Runs: %1").arg(cells_[i].finished)};
            if (const std::optional<Spread>& figures = cells_[i].*shown_.cell)
                lines << shown_.figure.arg(with_spread(*figures, shown_.decimals));
            if (cells_[i].landmarks)
                lines << tr("Landmarks: %1").arg(with_spread(*cells_[i].landmarks, 1));
            QToolTip::showText(plot_->mapToGlobal(place), lines.join('\n'), plot_);
            return;
        }
    }
    QToolTip::hideText();
}

Picture StudyPlots::picture(double scale) {
    return picture_of(*plot_, scale, [this](const Colours& c) { style(c); });
}

int StudyPlots::means() const {
    return quality_.means->data()->size();
}

QString StudyPlots::quality_title() const {
    return title_of(*plot_, 0, 0)->text();
}

void StudyPlots::contextMenuEvent(QContextMenuEvent* event) {
    if (empty()) return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Copy picture"), this, [this] { copy(picture(kCopyScale)); });
    menu->addAction(tr("Save as image…"), this, &StudyPlots::picture_wanted);
    menu->popup(event->globalPos());
}

}  // namespace hitos::window
