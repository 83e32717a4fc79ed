#include "plots.hpp"

#include <qcustomplot.h>

#include <QContextMenuEvent>
#include <QMenu>
#include <QVBoxLayout>

#include "plot_style.hpp"

namespace hitos::window {
namespace {

constexpr int kRefreshMs = 250;
constexpr int kColumns = 3;

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
    add_plot(neff, tr("Effective particles (Neff)"));
    add_plot(landmarks, tr("Landmarks"));
    add_plot(weight, tr("Best weight (ln)"));
    add_plot(step_time, tr("Time per step [ms]"));
    add_plot(map_error, tr("Landmark error [m]"));
    add_plot(path_error, tr("Trajectory error [m]"));
    clock_.start();
    connect(&session, &Session::restarted, this, &Plots::clear);
    connect(&session, &Session::references_changed, this, &Plots::clear_errors);
    connect(&session, &Session::progress_changed, this,
            [this] { refresh(session_.progress().state != Progress::State::running); });
    connect(&meter, &ReferenceMeter::measured, this,
            [this](const std::shared_ptr<const Measured>& figures) { note_errors(*figures); });
    restyle();
}

void Plots::add_plot(std::size_t plot, const QString& title) {
    const int row = static_cast<int>(plot) / kColumns;
    const int column = static_cast<int>(plot) % kColumns;
    QCPAxisRect* rect = add_titled_plot(*plot_, row, column, title);
    for (QCPAxis* axis : rect->axes()) axis->ticker()->setTickCount(4);
    if (plot + kColumns >= kPlots) rect->axis(QCPAxis::atBottom)->setLabel(tr("Time [s]"));
    rects_.push_back(rect);
    graphs_.push_back(plot_->addGraph(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft)));
}

void Plots::restyle() {
    const Colours& c = colours();
    const std::array<QColor, kPlots> line{c.particle, c.landmark,  c.association,
                                          c.muted,    c.reference, c.path};
    plot_->setBackground(c.card);
    const QFont small = plot_font(font());
    for (std::size_t i = 0; i < kPlots; ++i) {
        graphs_[i]->setPen(QPen(line[i], 1.4));
        if (i == map_error || i == path_error) {  // measured now and then
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
    for (const Plot plot : {map_error, path_error}) graphs_[plot]->data()->clear();
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void Plots::refresh(bool at_once) {
    if (!isVisible() || !session_.has_source()) return;
    if (!at_once && clock_.elapsed() < kRefreshMs) return;
    clock_.restart();
    const std::vector<StepFigures> fresh = session_.worker()->figures_since(taken_);
    if (fresh.empty()) return;
    taken_ += fresh.size();
    for (const StepFigures& step : fresh) {
        graphs_[neff]->addData(step.time_s, step.neff);
        graphs_[landmarks]->addData(step.time_s, step.lines + step.corners);
        graphs_[weight]->addData(step.time_s, step.best_log_weight);
        graphs_[step_time]->addData(step.time_s, step.step_seconds * 1e3);
    }
    for (QCPGraph* graph : graphs_) graph->rescaleAxes();
    for (QCPAxisRect* rect : rects_)
        rect->axis(QCPAxis::atBottom)->setRange(0.0, std::max(1.0, fresh.back().time_s));
    for (const Plot plot : {neff, landmarks, step_time, map_error, path_error})
        rects_[plot]->axis(QCPAxis::atLeft)->setRangeLower(0.0);
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void Plots::note_errors(const Measured& figures) {
    if (figures.map) graphs_[map_error]->addData(figures.time_s, figures.map->mean_m);
    if (figures.trajectory) {
        graphs_[path_error]->addData(figures.time_s, figures.trajectory->rmse_m);
    }
    for (const Plot plot : {map_error, path_error}) {
        graphs_[plot]->rescaleValueAxis();
        rects_[plot]->axis(QCPAxis::atLeft)->setRangeLower(0.0);
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
