#include "study_plots.hpp"

#include <qcustomplot.h>

#include <QBuffer>
#include <QContextMenuEvent>
#include <QCoreApplication>
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

/// "Map error"
QString axis_words(const Measure& measure) {
    QString words = QCoreApplication::translate("Measure", measure.plot.c_str());
    return words.replace(0, 1, words.left(1).toUpper());
}

QString unit_of(const Measure& measure) {
    return QString::fromStdString(printed_unit(measure.unit));
}

QString title_words(const Measure& measure) {
    const QString unit = unit_of(measure);
    return StudyPlots::tr("%1: every run, mean and standard deviation")
        .arg(axis_words(measure) + (unit.isEmpty() ? "" : " [" + unit + ']'));
}

/// "Map error: 0.123 ± 0.011 m"
QString figure_words(const Measure& measure, const Spread& spread) {
    QString words =
        axis_words(measure) + ": " + QString::fromStdString(measure.rounded(spread.mean, true));
    if (spread.variance) {
        words += " ± " + QString::fromStdString(measure.rounded(std::sqrt(*spread.variance), true));
    }
    return (words + ' ' + unit_of(measure)).trimmed();
}

/// The error of the map where there is a reference, else the first with a plot that was taken.
const Measure& quality_of(const StudyPlan& plan, const std::vector<StudyCell>& cells) {
    for (const Measure* measure : taken_measures()) {
        if (measure->plot.empty() || measure->is_count()) continue;
        const bool due = measure->of_landmarks() && plan.has_reference();
        if (due || has_figures(cells, *measure)) return *measure;
    }
    return run_measures().find("blur_m2");
}

}  // namespace

StudyPlots::StudyPlots(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(plot_);
    plot_->plotLayout()->clear();
    plot_->plotLayout()->setRowSpacing(2);
    plot_->setContextMenuPolicy(Qt::NoContextMenu);
    quality_ = make_panel(0);
    landmarks_ = make_panel(1);
    landmarks_.measure = &run_measures().find("landmarks");
    // Both share the parameter's axis, so their left edges must agree.
    auto* margins = new QCPMarginGroup(plot_);
    for (const Panel* panel : {&quality_, &landmarks_})
        panel->rect->setMarginGroup(QCP::msLeft, margins);
    connect(plot_, &QCustomPlot::mouseMove, this,
            [this](const QMouseEvent* event) { explain(event->pos()); });
    clear();
    restyle();
}

StudyPlots::Panel StudyPlots::make_panel(int row) {
    Panel panel;
    panel.rect = add_titled_plot(*plot_, row, 0, {});
    QCPAxis* x = panel.rect->axis(QCPAxis::atBottom);
    QCPAxis* y = panel.rect->axis(QCPAxis::atLeft);
    panel.reference = plot_->addGraph(x, y);
    panel.runs = plot_->addGraph(x, y);
    panel.runs->setLineStyle(QCPGraph::lsNone);
    panel.means = plot_->addGraph(x, y);
    panel.spread = new QCPErrorBars(x, y);
    panel.spread->setDataPlottable(panel.means);
    panel.spread->setSymbolGap(0.0);
    return panel;
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
    for (const Panel* panel : {&quality_, &landmarks_}) {
        const QColor colour = panel == &quality_ ? c.path : c.landmark;
        QColor faint = colour;
        faint.setAlpha(90);
        style_plot(*panel->rect, *title_of(*plot_, row++, 0), c, small);
        panel->means->setPen(QPen(colour, kLine));
        panel->means->setScatterStyle(
            QCPScatterStyle(QCPScatterStyle::ssDisc, colour, colour, kDot));
        panel->spread->setPen(QPen(colour, kLine));
        panel->runs->setScatterStyle(
            QCPScatterStyle(QCPScatterStyle::ssCircle, faint, Qt::transparent, kDot));
        panel->reference->setPen(QPen(c.muted, kLine, Qt::DashLine));
    }
}

void StudyPlots::clear() {
    cells_.clear();
    for (const Panel* panel : {&quality_, &landmarks_}) {
        for (QCPGraph* graph : {panel->runs, panel->means, panel->reference})
            graph->data()->clear();
        panel->spread->data()->clear();
        for (QCPAxis* axis : panel->rect->axes()) axis->setTickLabels(false);
        panel->rect->axis(QCPAxis::atBottom)->setLabel({});
    }
    StudyPlan usual;
    usual.reference_lines = 1;
    quality_.measure = &quality_of(usual, {});
    show_titles({});
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void StudyPlots::lay_out_axis(const StudyPlan::Axis& axis) {
    constexpr std::size_t kMostNamed = 12;
    constexpr double kSlant = 20.0;
    x_ = study_abscissa(axis);
    const auto [least, greatest] = x_.range(kRoom);
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
    for (const Panel* panel : {&quality_, &landmarks_}) {
        QCPAxis* bottom = panel->rect->axis(QCPAxis::atBottom);
        panel->rect->setMinimumMargins(QMargins(kLeft, kTop, right, kBottom));
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
        bottom->setRange(least, greatest);
        for (QCPAxis* each : panel->rect->axes()) each->setTickLabels(true);
    }
    landmarks_.rect->axis(QCPAxis::atBottom)
        ->setLabel(QString::fromStdString(study_axis_label(axis)).replace("^2", "²"));
}

void StudyPlots::show_titles(const StudyPlan& plan) {
    title_of(*plot_, 0, 0)->setText(title_words(*quality_.measure));
    QString landmarks = title_words(*landmarks_.measure);
    if (plan.has_reference()) {
        landmarks +=
            tr("; dashed: %1 in the reference").arg(plan.reference_lines + plan.reference_corners);
    }
    title_of(*plot_, 1, 0)->setText(landmarks);
}

void StudyPlots::draw(const Panel& panel) {
    QVector<double> xs;
    QVector<double> means;
    QVector<double> deviations;
    double top = 0.0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const std::optional<Spread>& figures = cells_[i].figures[*panel.measure];
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
    panel.means->setData(xs, means);
    panel.spread->setData(sorted);
    for (const auto& point : *panel.reference->data()) top = std::max(top, point.value);
    panel.rect->axis(QCPAxis::atLeft)->setRange(0.0, top > 0.0 ? top * (1.0 + kRoom) : 1.0);
}

void StudyPlots::show_results(const StudyPlan& plan, const std::vector<StudyRecord>& records) {
    cells_ = summarize(plan, records);
    quality_.measure = &quality_of(plan, cells_);
    show_titles(plan);
    lay_out_axis(plan.axes.front());
    for (const Panel* panel : {&quality_, &landmarks_}) {
        panel->runs->data()->clear();
        for (std::size_t run = 0; run < records.size(); ++run) {
            if (const auto& figure = records[run].figures[*panel->measure])
                panel->runs->addData(x_.positions[plan.cell_of(run)], *figure);
        }
    }
    const QCPRange range = landmarks_.rect->axis(QCPAxis::atBottom)->range();
    landmarks_.reference->data()->clear();
    if (plan.has_reference()) {
        const double known = plan.reference_lines + plan.reference_corners;
        landmarks_.reference->setData({range.lower, range.upper}, {known, known});
    }
    draw(quality_);
    draw(landmarks_);
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void StudyPlots::explain(const QPoint& place) {
    constexpr double kNear = 24.0;
    for (const Panel* panel : {&quality_, &landmarks_}) {
        if (!panel->rect->rect().contains(place)) continue;
        const QCPAxis* bottom = panel->rect->axis(QCPAxis::atBottom);
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            if (std::abs(bottom->coordToPixel(x_.positions[i]) - place.x()) > kNear) continue;
            QStringList lines{QString::fromStdString(x_.words[i]),
                              tr("Runs: %1").arg(cells_[i].finished)};
            for (const Panel* told : {&quality_, &landmarks_}) {
                if (const auto& spread = cells_[i].figures[*told->measure])
                    lines << figure_words(*told->measure, *spread);
            }
            QToolTip::showText(plot_->mapToGlobal(place), lines.join('\n'), plot_);
            return;
        }
    }
    QToolTip::hideText();
}

Exportable StudyPlots::exportable() {
    return {tr("Study"), "study", plot_font(font()), {figure_of(*plot_, [this](const Colours& c) {
                style(c);
            })}};
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
    menu->addAction(tr("Copy picture"), this, [this] { copy(exportable().offers.front()); });
    menu->addAction(tr("Save as image…"), this, &StudyPlots::picture_wanted);
    menu->popup(event->globalPos());
}

}  // namespace hitos::window
