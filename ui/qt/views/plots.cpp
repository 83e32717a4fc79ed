#include "plots.hpp"

#include <qcustomplot.h>

#include <QContextMenuEvent>
#include <QMenu>
#include <QVBoxLayout>
#include <array>
#include <optional>

#include "plot_style.hpp"

namespace hitos::window {
namespace {

constexpr int kRefreshMs = 250;
constexpr int kColumns = 3;

/// One plot: a figure of every step, or one that is measured now and then against a reference.
struct PlotInfo {
    const char* title = "";  ///< source text
    QColor Colours::*colour = nullptr;
    double (*step)(const StepFigures&) = nullptr;
    std::optional<double> (*measured)(const Measured&) = nullptr;
    bool from_zero = true;
};

/// One entry a plot, row by row.
const std::array kPlots = {
    PlotInfo{QT_TRANSLATE_NOOP("hitos::window::Plots", "Effective particles (Neff)"),
             &Colours::particle, [](const StepFigures& step) { return step.neff; }},
    PlotInfo{QT_TRANSLATE_NOOP("hitos::window::Plots", "Landmarks"), &Colours::landmark,
             [](const StepFigures& step) -> double { return step.lines + step.corners; }},
    PlotInfo{QT_TRANSLATE_NOOP("hitos::window::Plots", "Best weight (ln)"), &Colours::association,
             [](const StepFigures& step) { return step.best_log_weight; }, nullptr, false},
    PlotInfo{QT_TRANSLATE_NOOP("hitos::window::Plots", "Time per step [ms]"), &Colours::muted,
             [](const StepFigures& step) { return step.step_seconds * 1e3; }},
    PlotInfo{QT_TRANSLATE_NOOP("hitos::window::Plots", "Landmark error [m]"), &Colours::reference,
             nullptr,
             [](const Measured& figures) {
                 return figures.map ? std::optional(figures.map->mean_m) : std::nullopt;
             }},
    PlotInfo{QT_TRANSLATE_NOOP("hitos::window::Plots", "Trajectory error [m]"), &Colours::path,
             nullptr, [](const Measured& figures) {
                 return figures.trajectory ? std::optional(figures.trajectory->rmse_m)
                                           : std::nullopt;
             }}};

}  // namespace

Plots::Plots(Session& session, ReferenceMeter& meter, QWidget* parent)
    : QWidget(parent), session_(session), plot_(new QCustomPlot(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(plot_);
    plot_->setMinimumHeight(220);
    plot_->plotLayout()->clear();
    plot_->plotLayout()->setRowSpacing(2);
    plot_->setContextMenuPolicy(Qt::NoContextMenu);
    plot_->setAttribute(Qt::WA_TransparentForMouseEvents);
    for (std::size_t i = 0; i < kPlots.size(); ++i) add_plot(i);
    clock_.start();
    connect(&session, &Session::restarted, this, &Plots::clear);
    connect(&session, &Session::references_changed, this, &Plots::clear_errors);
    connect(&session, &Session::progress_changed, this,
            [this] { refresh(session_.progress().state != Progress::State::running); });
    connect(&meter, &ReferenceMeter::measured, this,
            [this](const std::shared_ptr<const Measured>& figures) { note_errors(*figures); });
    restyle();
}

void Plots::add_plot(std::size_t plot) {
    const int row = static_cast<int>(plot) / kColumns;
    const int column = static_cast<int>(plot) % kColumns;
    QCPAxisRect* rect = add_titled_plot(*plot_, row, column, tr(kPlots[plot].title));
    for (QCPAxis* axis : rect->axes()) axis->ticker()->setTickCount(4);
    if (plot + kColumns >= kPlots.size()) rect->axis(QCPAxis::atBottom)->setLabel(tr("Time [s]"));
    rects_.push_back(rect);
    graphs_.push_back(plot_->addGraph(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft)));
}

void Plots::restyle() {
    const Colours& c = colours();
    plot_->setBackground(c.card);
    const QFont small = plot_font(font());
    for (std::size_t i = 0; i < kPlots.size(); ++i) {
        graphs_[i]->setPen(QPen(c.*kPlots[i].colour, 1.4));
        if (kPlots[i].measured != nullptr) {
            graphs_[i]->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, 4.0));
        }
        const int place = static_cast<int>(i);
        style_plot(*rects_[i], *title_of(*plot_, place / kColumns, place % kColumns), c, small);
    }
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void Plots::clear() {
    taken_ = 0;
    for (QCPGraph* graph : graphs_) graph->data()->clear();
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

/// They were measured against another reference.
void Plots::clear_errors() {
    for (std::size_t i = 0; i < kPlots.size(); ++i) {
        if (kPlots[i].measured != nullptr) graphs_[i]->data()->clear();
    }
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void Plots::refresh(bool at_once) {
    if (!isVisible() || !session_.has_source()) return;
    if (!at_once && clock_.elapsed() < kRefreshMs) return;
    clock_.restart();
    const std::vector<StepFigures> fresh = session_.worker()->figures_since(taken_);
    if (fresh.empty()) return;
    taken_ += fresh.size();
    for (std::size_t i = 0; i < kPlots.size(); ++i) {
        if (kPlots[i].step == nullptr) continue;
        for (const StepFigures& step : fresh) {
            graphs_[i]->addData(step.time_s, kPlots[i].step(step));
        }
    }
    for (QCPGraph* graph : graphs_) graph->rescaleAxes();
    for (QCPAxisRect* rect : rects_)
        rect->axis(QCPAxis::atBottom)->setRange(0.0, std::max(1.0, fresh.back().time_s));
    for (std::size_t i = 0; i < kPlots.size(); ++i) {
        if (kPlots[i].from_zero) rects_[i]->axis(QCPAxis::atLeft)->setRangeLower(0.0);
    }
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void Plots::note_errors(const Measured& figures) {
    for (std::size_t i = 0; i < kPlots.size(); ++i) {
        if (kPlots[i].measured == nullptr) continue;
        if (const std::optional<double> value = kPlots[i].measured(figures)) {
            graphs_[i]->addData(figures.time_s, *value);
        }
        graphs_[i]->rescaleValueAxis();
        if (kPlots[i].from_zero) rects_[i]->axis(QCPAxis::atLeft)->setRangeLower(0.0);
    }
    if (isVisible()) plot_->replot(QCustomPlot::rpQueuedReplot);
}

QImage Plots::picture(double scale) const {
    return plot_->toPixmap(plot_->width(), plot_->height(), scale).toImage();
}

int Plots::points(int plot) const {
    return graphs_[static_cast<std::size_t>(plot)]->data()->size();
}

void Plots::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh(true);
}

void Plots::contextMenuEvent(QContextMenuEvent* event) {
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Save as image…"), this, &Plots::picture_wanted);
    menu->popup(event->globalPos());
}

}  // namespace hitos::window
