// SPDX-License-Identifier: GPL-3.0-or-later
// What can be exported of a view or plot, and what stands round it: title, axes, legend.
#pragma once

#include <QFontMetricsF>
#include <QMarginsF>
#include <QString>
#include <functional>
#include <vector>

#include "layers.hpp"
#include "picture.hpp"
#include "view_tool.hpp"

namespace hitos::window {

/// How somebody wants a figure.
struct FigureWish {
    double width_mm = 85.0;
    double mm_per_point = kMmPerPoint;  ///< how large a point of the screen gets
    bool legend = false;
    bool axes = false;
    QString title = {};    ///< above it; empty: none
    bool as_seen = false;  ///< with what legend the view has inside on the screen
    LayerSet layers = {};
    const Colours* colours = &light_colours();

    double points() const { return width_mm / mm_per_point; }
    /// Paper is white.
    QColor ground() const { return colours->dark ? colours->canvas : QColor(Qt::white); }
};

/// One way to show what has the focus.
struct FigureOffer {
    QString words;           ///< what is shown
    double width = 0.0;      ///< on the screen [points]
    double paper_mm = 85.0;  ///< as wide as a column
    bool legend = false;     ///< whether it can have one, and axes that can be left out
    bool axes = false;
    bool plain = false;        ///< no title, and letters as large as the picture makes them
    bool for_print = false;    ///< it has letters of its own, and a size on paper
    bool particles = false;    ///< for the names of layers
    QString uncertainty = {};  ///< the name of that layer; empty: as the views draw it
    LayerSet layers = {};      ///< that it can draw,
    LayerSet shown = {};       ///< and that it draws at first
    /// Throws hitos::Error.
    std::function<Picture(const FigureWish&)> picture;

    /// As it is on the screen, in light colours.
    Picture as_seen(double scale) const;
};

/// Pixels of a copied figure for each point of the screen.
inline constexpr double kCopyScale = 2.0;
/// Puts it into the clipboard as it is on the screen, in light colours.
void copy(const FigureOffer& offer);

/// What has the focus, and the ways to show it, the usual one first.
struct Exportable {
    QString words;  ///< "Grid map"
    QString name;   ///< of a file, without ending: "map"
    QFont font;     ///< of its letters on the screen
    std::vector<FigureOffer> offers;
};

/// What a legend has besides layers: a name with a stroke of its colour, or something that is drawn
/// `width` points wide.
struct FigureEntry {
    QString name = {};
    QColor colour = {};
    Qt::PenStyle line = Qt::SolidLine;
    double width = 0.0;
    std::function<void(QPainter&, const QRectF&)> paint = {};
};

/// What stands round the inside of a figure, in its points.
class FigureFrame {
  public:
    FigureFrame(FigureWish wish, const QFont& font, bool particles,
                std::vector<FigureEntry> own = {});

    /// Of title, axes and legend.
    const QMarginsF& around() const { return around_; }
    /// Onto a figure whose inside has the scene's size: the painter's origin is the inside's
    /// corner. `layers` are the colours of the legend. What was drawn beyond the inside is covered.
    void paint(QPainter& painter, const Scene& scene, const Colours& layers) const;

  private:
    void paint_axis(QPainter& painter, const Scene& scene, bool upright) const;
    void lay_out_legend(bool particles, std::vector<FigureEntry> own);

    struct Entry {
        const LayerInfo* layer;  ///< null where it is none of a layer
        FigureEntry own;
        QPointF at;  ///< from the legend's upper left corner
    };
    double width_of(const FigureEntry& entry) const;
    FigureWish wish_;
    QFontMetricsF metrics_;
    QMarginsF around_;
    double axis_room_ = 0.0;  ///< below the inside
    std::vector<Entry> legend_;
};

/// "−0.5": as figures have numbers.
QString figure_number(double value);

}  // namespace hitos::window
