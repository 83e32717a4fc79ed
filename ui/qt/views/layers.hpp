// What the views draw, each layer with a switch in the View menu.
#pragma once

#include <QString>
#include <QtGlobal>
#include <array>
#include <bitset>
#include <cstddef>

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

struct LayerInfo {
    Layer layer = Layer::scan;
    const char* key = "";   ///< in the settings
    const char* name = "";  ///< source text of layer_name()
    bool on = true;         ///< by default
    /// The name where the algorithm has no particles; null: the same, empty: no such layer.
    const char* alone = nullptr;
};

/// One entry a layer, in the order of the menu.
inline constexpr auto kLayerTable = std::to_array<LayerInfo>({
    {Layer::scan, "scan", QT_TRANSLATE_NOOP("Layers", "Scan points"), true},
    {Layer::detected, "detected", QT_TRANSLATE_NOOP("Layers", "Detected features"), true},
    {Layer::particles, "particles", QT_TRANSLATE_NOOP("Layers", "Particle cloud"), true, ""},
    {Layer::landmarks, "landmarks", QT_TRANSLATE_NOOP("Layers", "Landmarks"), true},
    {Layer::uncertainty, "uncertainty", QT_TRANSLATE_NOOP("Layers", "Uncertainty (1, 2, 3 σ)"),
     true},
    {Layer::endless, "endless", QT_TRANSLATE_NOOP("Layers", "Lines without end"), false},
    {Layer::associations, "associations", QT_TRANSLATE_NOOP("Layers", "Associations"), true},
    {Layer::robot, "robot", QT_TRANSLATE_NOOP("Layers", "Robot"), true},
    {Layer::path, "path", QT_TRANSLATE_NOOP("Layers", "Best particle's path"), true,
     QT_TRANSLATE_NOOP("Layers", "Path")},
    {Layer::odometry, "odometry", QT_TRANSLATE_NOOP("Layers", "Odometry path"), false},
    {Layer::online, "online", QT_TRANSLATE_NOOP("Layers", "Path while driving"), false},
    {Layer::graph, "graph", QT_TRANSLATE_NOOP("Layers", "Key scans and loops"), true},
    {Layer::reference, "reference", QT_TRANSLATE_NOOP("Layers", "Reference"), true},
    {Layer::names, "names", QT_TRANSLATE_NOOP("Layers", "Landmark numbers"), false},
    {Layer::ancestry, "ancestry", QT_TRANSLATE_NOOP("Layers", "Particles' ancestry"), false, ""},
});
inline constexpr std::size_t kLayers = kLayerTable.size();

class LayerSet {
  public:
    bool has(Layer layer) const { return bits_.test(static_cast<std::size_t>(layer)); }
    void set(Layer layer, bool on) { bits_.set(static_cast<std::size_t>(layer), on); }
    friend bool operator==(const LayerSet&, const LayerSet&) = default;

  private:
    std::bitset<kLayers> bits_;
};

/// The layer's name in the user's language; empty where there is none without particles.
QString layer_name(const LayerInfo& info, bool particles);
LayerSet default_layers();

}  // namespace hitos::window
