// SPDX-License-Identifier: GPL-3.0-or-later
// What the views draw, each layer with a switch in the View menu.
#pragma once

#include <QIcon>
#include <QString>
#include <QtGlobal>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "look/theme.hpp"

class QPainter;

namespace hitos::window {

enum class Layer : std::size_t {
    scan,
    detected,
    particles,
    landmarks,
    uncertainty,
    endless,
    associations,
    robot,
    path,
    odometry,
    online,
    graph,
    reference,
    names,
    ancestry
};

/// What a layer's sign in the legend looks like.
enum class Sign : std::uint8_t { points, squares, stroke, dashes, arrows, ellipse, text, robot };

struct LayerInfo {
    Layer layer = Layer::scan;
    const char* key = "";   ///< in the settings
    const char* name = "";  ///< source text of layer_name()
    bool on = true;         ///< by default
    Sign sign = Sign::stroke;
    QColor Colours::*colour = &Colours::text;
    bool in_scan = false;         ///< whether the view of the last scan draws it,
    bool in_grid = false;         ///< and that of the grid map
    const char* meaning = "";     ///< for tool tips
    const char* alone = nullptr;  ///< the name where the algorithm has no particles; null: the
                                  ///< same, empty: no such layer
};

/// One entry a layer, in the order of the menu.
inline constexpr auto kLayerTable = std::to_array<LayerInfo>({
    {Layer::scan, "scan", QT_TRANSLATE_NOOP("Layers", "Scan points"), true, Sign::points,
     &Colours::scan, true, false,
     QT_TRANSLATE_NOOP("Layers", "Where the laser's rays of the last scan ended")},
    {Layer::detected, "detected", QT_TRANSLATE_NOOP("Layers", "Detected features"), true,
     Sign::squares, &Colours::observed, true, false,
     QT_TRANSLATE_NOOP("Layers", "Lines and corners that were found in the last scan")},
    {Layer::particles, "particles", QT_TRANSLATE_NOOP("Layers", "Particle cloud"), true,
     Sign::arrows, &Colours::particle, true, false,
     QT_TRANSLATE_NOOP("Layers",
                       "Where each particle believes that the robot is; the heavier, the "
                       "stronger its colour"),
     ""},
    {Layer::landmarks, "landmarks", QT_TRANSLATE_NOOP("Layers", "Landmarks"), true, Sign::stroke,
     &Colours::landmark, true, false,
     QT_TRANSLATE_NOOP("Layers", "The map's lines, as far as they were seen, and its corners")},
    {Layer::uncertainty, "uncertainty", QT_TRANSLATE_NOOP("Layers", "Uncertainty (1, 2, 3 σ)"),
     true, Sign::ellipse, &Colours::landmark, true, true,
     QT_TRANSLATE_NOOP("Layers",
                       "How well landmarks and the robot's place are known: bands and "
                       "ellipses of one, two and three standard deviations")},
    {Layer::endless, "endless", QT_TRANSLATE_NOOP("Layers", "Lines without end"), false,
     Sign::dashes, &Colours::landmark, true, false,
     QT_TRANSLATE_NOOP("Layers", "The map's lines as the filter has them: without ends")},
    {Layer::associations, "associations", QT_TRANSLATE_NOOP("Layers", "Associations"), true,
     Sign::stroke, &Colours::association, true, false,
     QT_TRANSLATE_NOOP("Layers",
                       "From each feature to the landmark that it was taken for; a ring "
                       "with a cross is a new landmark, a grey cross was left out")},
    {Layer::robot, "robot", QT_TRANSLATE_NOOP("Layers", "Robot"), true, Sign::robot,
     &Colours::robot, true, true, QT_TRANSLATE_NOOP("Layers", "Where the robot is by the map")},
    {Layer::path, "path", QT_TRANSLATE_NOOP("Layers", "Best particle's path"), true, Sign::stroke,
     &Colours::path, true, true,
     QT_TRANSLATE_NOOP("Layers", "The way that the robot went, as the map has it now"),
     QT_TRANSLATE_NOOP("Layers", "Path")},
    {Layer::odometry, "odometry", QT_TRANSLATE_NOOP("Layers", "Odometry path"), false, Sign::dashes,
     &Colours::odometry, false, true, QT_TRANSLATE_NOOP("Layers", "The way by the odometry alone")},
    {Layer::online, "online", QT_TRANSLATE_NOOP("Layers", "Path while driving"), false,
     Sign::stroke, &Colours::path, false, true,
     QT_TRANSLATE_NOOP("Layers",
                       "The way as it was thought to be at each scan, before anything "
                       "later corrected it")},
    {Layer::graph, "graph", QT_TRANSLATE_NOOP("Layers", "Key scans and loops"), true, Sign::points,
     &Colours::end, false, true,
     QT_TRANSLATE_NOOP("Layers",
                       "The scans that registration keeps, and lines between those that "
                       "a closed loop joins")},
    {Layer::reference, "reference", QT_TRANSLATE_NOOP("Layers", "Reference"), true, Sign::dashes,
     &Colours::reference, false, true,
     QT_TRANSLATE_NOOP("Layers",
                       "The map and the path that this run is compared with, and the drawing "
                       "that it is anchored to")},
    {Layer::names, "names", QT_TRANSLATE_NOOP("Layers", "Landmark numbers"), false, Sign::text,
     &Colours::landmark, true, false,
     QT_TRANSLATE_NOOP("Layers", "Their numbers, as tables and files have them")},
    {Layer::ancestry, "ancestry", QT_TRANSLATE_NOOP("Layers", "Particles' ancestry"), false,
     Sign::stroke, &Colours::particle, true, true,
     QT_TRANSLATE_NOOP("Layers",
                       "From where the particles of now come: paths of all, which are "
                       "one where resampling left one ancestor"),
     ""},
});
inline constexpr std::size_t kLayers = kLayerTable.size();

class LayerSet {
  public:
    LayerSet() = default;
    LayerSet(std::initializer_list<Layer> layers) {
        for (const Layer layer : layers) set(layer, true);
    }
    bool has(Layer layer) const { return bits_.test(static_cast<std::size_t>(layer)); }
    void set(Layer layer, bool on) { bits_.set(static_cast<std::size_t>(layer), on); }
    friend LayerSet operator&(LayerSet a, const LayerSet& b) {
        a.bits_ &= b.bits_;
        return a;
    }
    friend bool operator==(const LayerSet&, const LayerSet&) = default;

  private:
    std::bitset<kLayers> bits_;
};

/// The layer's name in the user's language; empty where there is none without particles.
QString layer_name(const LayerInfo& info, bool particles);
QString layer_meaning(const LayerInfo& info);
/// What stands for it in legends, 16 x 16 from the painter's origin.
void paint_sign(QPainter& painter, const LayerInfo& info, const QColor& colour);
/// The same in the colours in use.
QIcon layer_sign(const LayerInfo& info);
LayerSet default_layers();

}  // namespace hitos::window
