// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_calibration.hpp"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>

#include "plot_style.hpp"
#include "study_plots.hpp"

namespace hitos::window {
namespace {

constexpr int kColumns = 2;

QString name_words(const CalibrationKind& kind) {
    QString words = QCoreApplication::translate("Calibration", kind.name);
    return words.replace(0, 1, words.left(1).toUpper());
}

bool any_has(const std::vector<StudyCell>& cells, const CalibrationKind& kind) {
    return std::ranges::any_of(
        cells, [&](const StudyCell& cell) { return has_shares(cell.figures, kind); });
}

}  // namespace

StudyCalibration::StudyCalibration(QWidget* parent) : QCustomPlot(parent), look_(colours()) {
    plotLayout()->clear();
    plotLayout()->setRowSpacing(2);
    setContextMenuPolicy(Qt::NoContextMenu);
    setFocusPolicy(Qt::NoFocus);
}

bool StudyCalibration::has(const std::vector<StudyCell>& cells) {
    return std::ranges::any_of(kCalibrationKinds,
                               [&](const CalibrationKind& kind) { return any_has(cells, kind); });
}

void StudyCalibration::add_panel(const CalibrationKind& kind) {
    Panel panel;
    const auto place = static_cast<int>(panels_.size());
    panel.kind = &kind;
    panel.row = place / kColumns;
    panel.column = place % kColumns;
    panel.rect = add_titled_plot(*this, panel.row, panel.column, name_words(kind));
    QCPAxis* x = panel.rect->axis(QCPAxis::atBottom);
    QCPAxis* y = panel.rect->axis(QCPAxis::atLeft);
    auto ticker = QSharedPointer<QCPAxisTickerText>::create();
    for (const double region : kRegions)  // the last two are too near for words
        ticker->addTick(region, region < kRegions.back() ? QString::number(region) : QString());
    x->setTicker(ticker);
    x->setRange(kRegions.front() - 0.05, 1.02);
    x->setLabel(StudyPlots::tr("expected share"));
    y->setRange(-0.04, 1.04);  // points at the ends are whole
    y->setLabel(StudyPlots::tr("share seen"));
    panel.ideal = addGraph(x, y);
    panel.ideal->setData({0.0, 1.0}, {0.0, 1.0});
    panel.ideal->setName(StudyPlots::tr("as it ought to be"));
    panels_.push_back(std::move(panel));
}

/// Two plots a row, and in the place behind the last one what the lines stand for.
void StudyCalibration::lay_out(const std::vector<StudyCell>& cells) {
    std::vector<const CalibrationKind*> kinds;
    for (const CalibrationKind& kind : kCalibrationKinds)
        if (any_has(cells, kind)) kinds.push_back(&kind);
    if (std::ranges::equal(kinds, panels_, {}, {}, &Panel::kind)) return;
    clearPlottables();
    plotLayout()->clear();
    plotLayout()->simplify();
    panels_.clear();
    for (const CalibrationKind* kind : kinds) add_panel(*kind);
    const auto place = static_cast<int>(panels_.size());
    // Below all plots it takes no more room than it needs.
    const bool below = place % kColumns == 0;
    const int row = 2 * (place / kColumns) + (below ? 0 : 1);
    legend_ = new FittingLegend([this, below] { return room_of_legend(below); }, below);
    plotLayout()->addElement(row, place % kColumns, legend_);
    if (below) plotLayout()->setRowStretchFactor(row, 0.01);
}

QSize StudyCalibration::room_of_legend(bool below) {
    constexpr int kMostBelow = 3;  // the plots have the rest
    const QSize all = viewport().size();
    if (below) return {all.width(), all.height() / kMostBelow};
    const int row = panels_.back().row;
    const QCPTextElement& title = *title_of(*this, row, 0);
    const QMargins around = title.margins();
    const int above = QFontMetrics(title.font()).height() + around.top() + around.bottom();
    return {all.width() / kColumns, all.height() / (row + 1) - above};
}

void StudyCalibration::draw_panel(Panel& panel, const std::vector<StudyCell>& cells) {
    for (std::size_t i = panel.lines.size(); i < cells.size(); ++i) {
        panel.lines.push_back(
            addGraph(panel.rect->axis(QCPAxis::atBottom), panel.rect->axis(QCPAxis::atLeft)));
    }
    for (; panel.lines.size() > cells.size(); panel.lines.pop_back())
        removeGraph(panel.lines.back());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto shares = shares_in_regions(cells[i].figures, *panel.kind);
        panel.lines[i]->data()->clear();
        panel.lines[i]->setName(names_.at(static_cast<qsizetype>(i)));
        for (std::size_t region = 0; region < kRegions.size(); ++region) {
            if (const auto& seen = shares.at(region))
                panel.lines[i]->addData(kRegions.at(region), *seen);
        }
    }
}

void StudyCalibration::show_results(const StudyPlan& plan, const std::vector<StudyCell>& cells) {
    names_.clear();
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
        names_ << QString::fromStdString(plan.cell_label(cell));
    if (legend_ != nullptr) legend_->forget_lines();
    lay_out(cells);
    for (Panel& panel : panels_) draw_panel(panel, cells);
    style(look_);
    if (!panels_.empty()) {
        std::vector<QCPGraph*> lines{panels_.front().ideal};
        lines.insert(lines.end(), panels_.front().lines.begin(), panels_.front().lines.end());
        legend_->show_lines(std::move(lines));
        legend_->choose(chosen_);
    }
    replot(QCustomPlot::rpQueuedReplot);
}

void StudyCalibration::colour_lines(const std::optional<std::size_t>& chosen_line) {
    constexpr double kLine = 1.6;
    constexpr double kDot = 6.0;
    constexpr int kFaint = 60;
    constexpr std::array kStyles{Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
    for (const Panel& panel : panels_) {
        panel.ideal->setPen(QPen(look_.muted, kLine, Qt::DashLine));
        for (std::size_t i = 0; i < panel.lines.size(); ++i) {
            const bool chosen = chosen_line == i;
            QColor colour = line_colour(i);
            if (chosen_line && !chosen) colour.setAlpha(kFaint);
            QCPGraph* line = panel.lines[i];
            const Qt::PenStyle style = kStyles.at(i / kLineColours % kStyles.size());
            line->setPen(QPen(colour, chosen ? 1.5 * kLine : kLine, style));
            line->setScatterStyle({QCPScatterStyle::ssDisc, colour, colour, kDot});
        }
    }
}

void StudyCalibration::style(const Colours& colours, bool screen) {
    const std::optional<std::size_t> chosen = screen ? chosen_ : std::nullopt;
    look_ = colours;
    const QFont small = plot_font(font());
    setBackground(colours.card);
    for (const Panel& panel : panels_)
        style_plot(*panel.rect, *title_of(*this, panel.row, panel.column), colours, small);
    if (legend_ != nullptr) {
        legend_->style(small, colours.text);
        legend_->choose(chosen);
    }
    colour_lines(chosen);
}

void StudyCalibration::choose(std::optional<std::size_t> cell) {
    chosen_ = cell;
    if (legend_ != nullptr) legend_->choose(cell);
    colour_lines(chosen_);
    replot(QCustomPlot::rpQueuedReplot);
}

std::optional<std::size_t> StudyCalibration::cell_at(const QPoint& place) const {
    double nearest = 12.0;  // pixels
    std::optional<std::size_t> cell;
    for (const Panel& panel : panels_) {
        if (!panel.rect->rect().contains(place)) continue;
        for (std::size_t i = 0; i < panel.lines.size(); ++i) {
            const double away = panel.lines[i]->selectTest(place, false);
            if (away < 0.0 || away >= nearest) continue;
            nearest = away;
            cell = i;
        }
    }
    return cell;
}

QPoint StudyCalibration::middle_of(std::size_t cell) const {
    for (const Panel& panel : panels_) {
        const auto& points = *panel.lines.at(cell)->data();
        if (points.isEmpty()) continue;
        const QCPGraphData& point = *points.at(points.size() / 2);
        return panel.lines.at(cell)->coordsToPixels(point.key, point.value).toPoint();
    }
    return rect().center();
}

QStringList StudyCalibration::words_of(const StudyCell& cell) {
    QStringList lines;
    for (const CalibrationKind& kind : kCalibrationKinds) {
        const auto shares = shares_in_regions(cell.figures, kind);
        QStringList regions;
        QStringList told;
        for (std::size_t i = 0; i < kRegions.size(); ++i) {
            const auto& share = shares.at(i);
            regions << QString::number(100.0 * kRegions.at(i));
            told << (share ? QString::number(*share, 'f', 2) : QString("–"));
        }
        const std::optional<NeesFigure> nees = nees_figure(cell.figures, kind);
        if (!has_shares(cell.figures, kind) || !nees) continue;
        lines << StudyPlots::tr(
                     "%1 in the region of %2 %: %3; NEES %4 (%5 to %6 where it is as sure as it "
                     "may be)")
                     .arg(name_words(kind), regions.join(", "), told.join(", "))
                     .arg(nees->mean, 0, 'f', 2)
                     .arg(nees->interval.low, 0, 'f', 2)
                     .arg(nees->interval.high, 0, 'f', 2);
    }
    return lines;
}

}  // namespace hitos::window
