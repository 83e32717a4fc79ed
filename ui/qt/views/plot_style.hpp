// SPDX-License-Identifier: GPL-3.0-or-later
// How plots look, whatever they show.
#pragma once

#include <QColor>
#include <QFont>
#include <QString>
#include <cstddef>
#include <functional>

#include "figure.hpp"
#include "look/theme.hpp"

class QCPAxisRect;
class QCPTextElement;
class QCustomPlot;

namespace hitos::window {

/// Adds a plot with its title above: it takes the rows 2 `row` and 2 `row` + 1 of the layout.
QCPAxisRect* add_titled_plot(QCustomPlot& plot, int row, int column, const QString& title);
QCPTextElement* title_of(QCustomPlot& plot, int row, int column);

/// A right click on the plot is one on the widget that it is part of.
void leave_menu_to_parent(QCustomPlot& plot);
/// The letters of titles and axes beside words in this font.
QFont plot_font(const QFont& words);
/// Of the lines of a plot, or the runs over a grid, by number: Okabe and Ito's colours (2008),
/// which all eyes tell apart; after kLineColours of them they begin again.
inline constexpr std::size_t kLineColours = 7;
QColor line_colour(std::size_t number);
/// The plots as a figure as wide as is wished and of the same shape, but never lower than letters
/// need; `style` gives them colours. Where they have a legend that can be left out,
/// `show_legend` does so.
FigureOffer figure_of(QCustomPlot& plot, std::function<void(const Colours&)> style,
                      std::function<void(bool)> show_legend = {});
void style_plot(QCPAxisRect& rect, QCPTextElement& title, const Colours& colours,
                const QFont& font);

}  // namespace hitos::window
