// SPDX-License-Identifier: GPL-3.0-or-later
#include "fitting_legend.hpp"

#include <algorithm>
#include <utility>

#include "study_plots.hpp"

namespace hitos::window {
namespace {

/// A sentence below the names, over all of their columns.
class LegendNote final : public QCPAbstractLegendItem {
  public:
    LegendNote(QCPLegend* legend, QString words, const QSize& size)
        : QCPAbstractLegendItem(legend), words_(std::move(words)), size_(size) {}

  protected:
    void draw(QCPPainter* painter) override {
        painter->setFont(font());
        painter->setPen(textColor());
        painter->drawText(QRect(rect().topLeft(), size_), Qt::AlignLeft | Qt::TextWordWrap, words_);
    }
    QSize minimumOuterSizeHint() const override { return {0, size_.height()}; }
    QRect clipRect() const override { return parentPlot()->viewport(); }

  private:
    QString words_;
    QSize size_;
};

}  // namespace

FittingLegend::FittingLegend(Room room, bool below) : room_(std::move(room)), below_(below) {}

void FittingLegend::parentPlotInitialized(QCustomPlot* plot) {
    QCPLayoutInset::parentPlotInitialized(plot);
    legend_ = new QCPLegend;
    addElement(legend_, Qt::AlignLeft | Qt::AlignTop);
    legend_->setLayer("legend");
    legend_->setBorderPen(Qt::NoPen);
    legend_->setBrush(Qt::NoBrush);
}

void FittingLegend::show_lines(std::vector<QCPGraph*> lines) {
    lines_ = std::move(lines);
}

void FittingLegend::forget_lines() {
    legend_->clearItems();
    lines_.clear();
}

void FittingLegend::style(const QFont& font, const QColor& text) {
    legend_->setFont(font);
    legend_->setTextColor(text);
}

void FittingLegend::update(UpdatePhase phase) {
    if (phase == upPreparation) fit();
    QCPLayoutInset::update(phase);
}

void FittingLegend::fit() {
    legend_->clearItems();
    if (lines_.empty()) return;
    const QFontMetrics letters(legend_->font());
    const QMargins around = legend_->margins();
    const QSize room = room_().shrunkBy(around);
    const int high =
        std::max(legend_->iconSize().height(), letters.height()) + legend_->rowSpacing();
    int longest = 0;
    for (const QCPGraph* line : lines_)
        longest = std::max(longest, letters.horizontalAdvance(line->name()));
    const int wide = legend_->iconSize().width() + legend_->iconTextPadding() + longest +
                     legend_->columnSpacing();
    const auto all = static_cast<int>(lines_.size());
    const int columns = std::clamp(room.width() / wide, 1, all);
    int rows = std::max(room.height() / high, 2);
    if (below_) rows = std::min(rows, (all + columns - 1) / columns);
    QString words;
    QSize size;
    int named = all;
    if (rows * columns < all) {
        const auto say = [&] {
            named = std::min(std::max(rows, 1) * columns, all);
            words = StudyPlots::tr("and %1 more: choose a value to see its name").arg(all - named);
            size = letters
                       .boundingRect(QRect(QPoint(), QSize(room.width(), room.height())),
                                     Qt::AlignLeft | Qt::TextWordWrap, words)
                       .size();
        };
        say();
        rows = std::max(rows - (size.height() + high - 1) / high, 1);
        say();
    }
    for (int i = 0; i < named; ++i) {
        auto line = static_cast<std::size_t>(i);
        if (i + 1 == named && chosen_ && *chosen_ + 1 > line) line = *chosen_ + 1;
        legend_->addElement(i % rows, i / rows,
                            new QCPPlottableLegendItem(legend_, lines_.at(line)));
    }
    if (!words.isEmpty()) legend_->addElement(rows, 0, new LegendNote(legend_, words, size));
    if (below_) {
        setMinimumSize(
            0, std::min(rows, named) * high + size.height() + around.top() + around.bottom());
    }
}

}  // namespace hitos::window
