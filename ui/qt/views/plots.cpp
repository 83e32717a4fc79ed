// SPDX-License-Identifier: GPL-3.0-or-later
#include "plots.hpp"

#include <qcustomplot.h>

#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "hitos/services/evaluation/nees.hpp"
#include "hitos/slam/filters.hpp"
#include "plot_style.hpp"

namespace hitos::window {
namespace {

constexpr int kPlotRefreshMs = 250;
constexpr int kLeastRow = 110;  // pixels
constexpr int kLeastHeight = 60;
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// A figure of every step, or one that is measured now and then against a reference.
struct PlotInfo {
    const char* title = "";  ///< source text
    QColor Colours::*colour = nullptr;
    double (*step)(const StepFigures&) = nullptr;
    std::optional<double> (*measured)(const ErrorPoint&) = nullptr;
    bool from_zero = true;
    bool of_hypotheses = false;  ///< says nothing where there is only one
    /// A figure of every step against the reference; not a number where there is none.
    double Plots::Against::*against = nullptr;
    bool bounds = false;  ///< by powers of ten, with the interval where the NEES should lie
};

/// By Plots::Figure.
const std::array kPlots = {
    PlotInfo{QT_TRANSLATE_NOOP("hitos::window::Plots", "Effective particles (Neff)"),
             &Colours::particle, [](const StepFigures& step) { return step.neff; }, nullptr, true,
             true},
    PlotInfo{QT_TRANSLATE_NOOP("hitos::window::Plots", "Landmarks"), &Colours::landmark,
             [](const StepFigures& step) -> double { return step.lines + step.corners; }},
    PlotInfo{QT_TRANSLATE_NOOP("hitos::window::Plots", "Features in the scan"), &Colours::observed,
             [](const StepFigures& step) -> double { return step.seen_lines + step.seen_corners; }},
    PlotInfo{QT_TRANSLATE_NOOP("hitos::window::Plots", "Best weight (ln)"), &Colours::association,
             [](const StepFigures& step) { return step.best_log_weight; }, nullptr, false, true},
    PlotInfo{QT_TRANSLATE_NOOP("hitos::window::Plots", "Time per step [ms]"), &Colours::muted,
             [](const StepFigures& step) { return step.step_seconds * 1e3; }},
    PlotInfo{QT_TRANSLATE_NOOP("hitos::window::Plots", "Position error [m]"), &Colours::path,
             nullptr, nullptr, true, false, &Plots::Against::position_error_m},
    PlotInfo{QT_TRANSLATE_NOOP("hitos::window::Plots", "NEES of the pose (95 %: 0.2 … 9.3)"),
             &Colours::robot, nullptr, nullptr, false, false, &Plots::Against::nees, true},
    PlotInfo{QT_TRANSLATE_NOOP("hitos::window::Plots", "Trajectory error [m]"), &Colours::path,
             nullptr, [](const ErrorPoint& error) { return error.trajectory_m; }},
    PlotInfo{QT_TRANSLATE_NOOP("hitos::window::Plots", "Landmark error [m]"), &Colours::reference,
             nullptr, [](const ErrorPoint& error) { return error.map_m; }},
};

const PlotInfo& info(Plots::Figure figure) {
    return kPlots[static_cast<std::size_t>(figure)];
}

int columns_for(std::size_t plots, int width) {
    constexpr std::size_t kOneRow = 5;
    constexpr int kLeastWidth = 190;
    const int wished = plots <= kOneRow ? static_cast<int>(plots) : 4;
    return std::max(1, std::min(wished, width / kLeastWidth));
}

}  // namespace

Plots::Plots(Session& session, ReferenceMeter& meter, QWidget* parent)
    : QWidget(parent), session_(session), plot_(new QCustomPlot(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(1, 1, 1, 1);  // where one sees that it has the keyboard
    setObjectName("plots");
    setFocusPolicy(Qt::StrongFocus);
    // Where the room is too low for all rows, they are not squeezed but scrolled.
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(plot_);
    scroll->setMinimumHeight(kLeastHeight);
    column->addWidget(scroll);
    plot_->plotLayout()->clear();
    plot_->plotLayout()->setRowSpacing(2);
    plot_->setMinimumSize(kLeastRow, kLeastRow);  // it cannot paint on nothing
    leave_menu_to_parent(*plot_);
    plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    plot_->installEventFilter(this);
    plot_->setMouseTracking(true);
    follow_clicks();
    clock_.start();
    connect(&session, &Session::restarted, this, &Plots::clear);
    connect(&session, &Session::references_changed, this, &Plots::clear);
    connect(&session, &Session::progress_changed, this,
            [this] { refresh(session_.progress().state != Progress::State::running); });
    connect(&meter, &ReferenceMeter::measured, this,
            [this](const std::shared_ptr<const Measured>& figures) { note_errors(*figures); });
    clear();
}

std::vector<Plots::Figure> Plots::wanted() const {
    std::vector<Figure> wanted;
    const bool several = hypothesis_count(session_.configuration().filter) > 1;
    for (std::size_t i = 0; i < kPlots.size(); ++i) {
        const auto figure = static_cast<Figure>(i);
        const PlotInfo& plot = kPlots[i];
        bool any = plot.step != nullptr && (several || !plot.of_hypotheses);
        if (plot.against != nullptr) {
            any = std::ranges::any_of(
                against_, [](double value) { return std::isfinite(value); }, plot.against);
        } else if (plot.measured != nullptr) {
            any = std::ranges::any_of(course_, [&plot](const ErrorPoint& error) {
                return plot.measured(error).has_value();
            });
        }
        if (any) wanted.push_back(figure);
    }
    return wanted;
}

void Plots::lay_out() {
    const std::vector<Figure> figures = wanted();
    const int columns = columns_for(figures.size(), width());
    if (columns == columns_ && std::ranges::equal(figures, shown_, {}, {}, &Shown::figure)) return;
    columns_ = columns;
    const std::optional<std::pair<double, double>> zoomed =
        zoomed_ && !shown_.empty() ? std::optional(times()) : std::nullopt;
    plot_->clearItems();
    plot_->clearGraphs();
    plot_->plotLayout()->clear();
    shown_.clear();
    filled_ = 0;
    for (std::size_t i = 0; i < figures.size(); ++i) {
        add_plot(figures[i], static_cast<int>(i), columns);
        // Below the lowest of each column.
        if (i + static_cast<std::size_t>(columns) < figures.size()) continue;
        shown_.back().rect->axis(QCPAxis::atBottom)->setLabel(tr("Time [s]"));
    }
    const int rows = (static_cast<int>(figures.size()) + columns - 1) / columns;
    plot_->setMinimumHeight(std::max(1, rows) * kLeastRow);
    updateGeometry();
    if (zoomed) set_times(zoomed->first, zoomed->second);
    restyle();
}

void Plots::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (columns_for(shown_.size(), width()) != columns_) refresh(true);
}

QSize Plots::sizeHint() const {
    constexpr int kMostRows = 2;  // more of them are scrolled
    const QMargins around = layout()->contentsMargins();
    return {QWidget::sizeHint().width(), std::min(plot_->minimumHeight(), kMostRows * kLeastRow) +
                                             around.top() + around.bottom()};
}

void Plots::add_plot(Figure figure, int place, int columns) {
    const int row = place / columns;
    const int column = place % columns;
    QCPAxisRect* rect = add_titled_plot(*plot_, row, column, {});
    for (QCPAxis* axis : rect->axes()) axis->ticker()->setTickCount(4);
    rect->setRangeDrag(Qt::Horizontal);
    rect->setRangeZoom(Qt::Horizontal);
    QCPAxis* time = rect->axis(QCPAxis::atBottom);
    connect(time, QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), this,
            [this](const QCPRange& range) {
                zoomed_ = true;
                set_times(range.lower, range.upper);
            });
    Shown shown{figure, rect, title_of(*plot_, row, column),
                plot_->addGraph(time, rect->axis(QCPAxis::atLeft)), add_line(rect)};
    for (QCPItemPosition* end : shown.now->positions()) {
        end->setTypeX(QCPItemPosition::ptPlotCoords);
        end->setTypeY(QCPItemPosition::ptAxisRectRatio);
    }
    if (info(figure).bounds) {
        QCPAxis* value = rect->axis(QCPAxis::atLeft);
        value->setScaleType(QCPAxis::stLogarithmic);
        value->setTicker(QSharedPointer<QCPAxisTickerLog>::create());
        value->setNumberFormat("eb");
        value->setNumberPrecision(0);
        for (const double bound : {kNeesLow, kNeesHigh}) {
            QCPItemStraightLine* line = add_line(rect);
            for (QCPItemPosition* end : line->positions()) {
                end->setTypeX(QCPItemPosition::ptAxisRectRatio);
                end->setTypeY(QCPItemPosition::ptPlotCoords);
            }
            line->point1->setCoords(0.0, bound);
            line->point2->setCoords(1.0, bound);
            shown.bounds.push_back(line);
        }
    }
    shown_.push_back(shown);
}

QCPItemStraightLine* Plots::add_line(QCPAxisRect* rect) {
    auto* line = new QCPItemStraightLine(plot_);
    line->setClipAxisRect(rect);
    for (QCPItemPosition* end : line->positions()) {
        end->setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
        end->setAxisRect(rect);
    }
    return line;
}

void Plots::restyle() {
    style(colours());
    hide_values();
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void Plots::style(const Colours& c) {
    plot_->setBackground(c.card);
    const QFont small = plot_font(font());
    for (const Shown& shown : shown_) {
        const PlotInfo& plot = info(shown.figure);
        shown.graph->setPen(QPen(c.*plot.colour, 1.4));
        shown.now->setPen(QPen(c.accent, 1.0));
        for (QCPItemStraightLine* bound : shown.bounds) {
            bound->setPen(QPen(c.good, 1.0, Qt::DashLine));
        }
        if (plot.measured != nullptr) {
            shown.graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, 4.0));
        }
        style_plot(*shown.rect, *shown.title, c, small);
    }
}

/// Nothing is known of the run, or of what it is measured against.
void Plots::clear() {
    figures_.clear();
    against_.clear();
    position_error_.reset();
    if (const auto& reference = session_.references().trajectory) {
        position_error_.emplace(*reference);
    }
    course_.clear();
    filled_ = 0;
    zoomed_ = false;
    for (const Shown& shown : shown_) shown.graph->data()->clear();
    refresh(true);
}

void Plots::refresh(bool at_once) {
    if (!isVisible()) return;
    if (!at_once && clock_.elapsed() < kPlotRefreshMs) return;
    clock_.restart();
    if (session_.has_source()) {
        for (const StepFigures& step : session_.worker()->figures_since(figures_.size())) {
            figures_.push_back(step);
            Against& against = against_.emplace_back();
            if (!position_error_) continue;
            against = {position_error_->at(step.online).value_or(kNothing),
                       nees_of(step, *position_error_).value_or(kNothing)};
        }
    }
    lay_out();
    fill();
}

void Plots::fill() {
    for (const Shown& shown : shown_) {
        const PlotInfo& plot = info(shown.figure);
        if (plot.measured != nullptr) {
            shown.graph->data()->clear();
            for (const ErrorPoint& error : course_) {
                if (const auto value = plot.measured(error)) {
                    shown.graph->addData(error.time_s, *value);
                }
            }
        } else {
            for (std::size_t i = filled_; i < figures_.size(); ++i) {
                const double value =
                    plot.step != nullptr ? plot.step(figures_[i]) : against_[i].*plot.against;
                const bool drawn = std::isfinite(value) && (value > 0.0 || !plot.bounds);
                if (drawn) shown.graph->addData(figures_[i].time_s, value);
            }
        }
        shown.graph->rescaleValueAxis();
        QCPAxis* axis = shown.rect->axis(QCPAxis::atLeft);
        if (plot.from_zero) axis->setRangeLower(0.0);
        if (plot.bounds) {
            axis->setRange(std::min(axis->range().lower, kNeesLow / 2.0),
                           std::max(axis->range().upper, kNeesHigh * 2.0));
        }
        const double now = session_.progress().duration_s;
        shown.now->point1->setCoords(now, 0.0);
        shown.now->point2->setCoords(now, 1.0);
    }
    filled_ = figures_.size();
    if (zoomed_) {
        plot_->replot(QCustomPlot::rpQueuedReplot);
    } else {
        show_all_times();
    }
}

void Plots::set_times(double from_s, double to_s) {
    for (const Shown& shown : shown_) {
        QCPAxis* axis = shown.rect->axis(QCPAxis::atBottom);
        const QSignalBlocker quiet(axis);
        axis->setRange(from_s, to_s);
    }
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void Plots::show_all_times() {
    zoomed_ = false;
    set_times(0.0, figures_.empty() ? 1.0 : std::max(1.0, figures_.back().time_s));
}

void Plots::note_errors(const Measured& figures) {
    course_ = figures.course;
    refresh(true);
}

void Plots::show_values(const QPoint& place) {
    const QCPAxisRect* under = plot_->axisRectAt(place);
    if (under == nullptr || figures_.empty()) {
        hide_values();
        return;
    }
    const double time_s = under->axis(QCPAxis::atBottom)->pixelToCoord(place.x());
    for (const Shown& shown : shown_) {
        const auto& points = *shown.graph->data();
        auto at = points.findEnd(time_s, false);  // the first behind it
        const QString title = tr(info(shown.figure).title);
        if (at == points.constBegin()) {
            shown.title->setText(title);
            continue;
        }
        --at;
        shown.title->setText(
            QString("%1: %2 (%3 s)").arg(title).arg(at->value, 0, 'g', 4).arg(at->key, 0, 'f', 1));
    }
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void Plots::hide_values() {
    for (const Shown& shown : shown_) shown.title->setText(tr(info(shown.figure).title));
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

Exportable Plots::exportable() {
    return {tr("Plots"), "plots", plot_font(font()), {figure_of(*plot_, [this](const Colours& c) {
                style(c);
            })}};
}

const Plots::Shown* Plots::find(Figure figure) const {
    const auto found = std::ranges::find(shown_, figure, &Shown::figure);
    return found == shown_.end() ? nullptr : &*found;
}

bool Plots::shows(Figure figure) const {
    return find(figure) != nullptr;
}

int Plots::points(Figure figure) const {
    const Shown* shown = find(figure);
    return shown == nullptr ? 0 : shown->graph->data()->size();
}

QString Plots::title(Figure figure) const {
    const Shown* shown = find(figure);
    return shown == nullptr ? QString() : shown->title->text();
}

QPoint Plots::place_of(double time_s) const {
    if (shown_.empty()) return {};
    const QCPAxisRect& rect = *shown_.front().rect;
    return plot_->mapTo(
        this,
        QPoint(static_cast<int>(std::lround(rect.axis(QCPAxis::atBottom)->coordToPixel(time_s))),
               rect.center().y()));
}

std::pair<double, double> Plots::times() const {
    if (shown_.empty()) return {};
    const QCPRange range = shown_.front().rect->axis(QCPAxis::atBottom)->range();
    return {range.lower, range.upper};
}

void Plots::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh(true);
}

}  // namespace hitos::window
