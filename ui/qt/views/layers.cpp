#include "layers.hpp"

#include <QCoreApplication>

namespace hitos::window {

QString layer_name(const LayerInfo& info) {
    return QCoreApplication::translate("Layers", info.name);
}

LayerSet default_layers() {
    LayerSet layers;
    for (const LayerInfo& info : kLayerTable) layers.set(info.layer, info.on);
    return layers;
}

}  // namespace hitos::window
