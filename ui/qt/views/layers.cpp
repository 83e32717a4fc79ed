#include "layers.hpp"

#include <QCoreApplication>

namespace hitos::window {

QString layer_name(const LayerInfo& info, bool particles) {
    const char* name = particles || info.alone == nullptr ? info.name : info.alone;
    return *name == '\0' ? QString() : QCoreApplication::translate("Layers", name);
}

LayerSet default_layers() {
    LayerSet layers;
    for (const LayerInfo& info : kLayerTable) layers.set(info.layer, info.on);
    return layers;
}

}  // namespace hitos::window
