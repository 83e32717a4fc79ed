#include "layers.hpp"

#include <QCoreApplication>

namespace hitos::window {

const std::array<LayerInfo, kLayers>& layer_table() {
    static const std::array<LayerInfo, kLayers> table{{
        {Layer::scan, "scan", QT_TRANSLATE_NOOP("Layers", "Scan points"), true},
        {Layer::detected, "detected", QT_TRANSLATE_NOOP("Layers", "Detected features"), true},
        {Layer::particles, "particles", QT_TRANSLATE_NOOP("Layers", "Particle cloud"), true},
        {Layer::landmarks, "landmarks", QT_TRANSLATE_NOOP("Layers", "Landmarks"), true},
        {Layer::uncertainty, "uncertainty", QT_TRANSLATE_NOOP("Layers", "Uncertainty (1, 2, 3 σ)"),
         true},
        {Layer::endless, "endless", QT_TRANSLATE_NOOP("Layers", "Lines without end"), false},
        {Layer::associations, "associations", QT_TRANSLATE_NOOP("Layers", "Associations"), true},
        {Layer::robot, "robot", QT_TRANSLATE_NOOP("Layers", "Robot"), true},
        {Layer::path, "path", QT_TRANSLATE_NOOP("Layers", "Best particle's path"), true},
        {Layer::odometry, "odometry", QT_TRANSLATE_NOOP("Layers", "Odometry path"), false},
        {Layer::reference, "reference", QT_TRANSLATE_NOOP("Layers", "Reference"), true},
        {Layer::names, "names", QT_TRANSLATE_NOOP("Layers", "Landmark numbers"), false},
    }};
    return table;
}

QString layer_name(const LayerInfo& info) {
    return QCoreApplication::translate("Layers", info.name);
}

LayerSet default_layers() {
    LayerSet layers;
    for (const LayerInfo& info : layer_table()) layers.set(info.layer, info.on);
    return layers;
}

}  // namespace hitos::window
