// What the views draw, each layer with a switch in the View menu.
#pragma once

#include <QString>
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
    reference,
    names
};
inline constexpr std::size_t kLayers = 12;

class LayerSet {
  public:
    bool has(Layer layer) const { return bits_.test(static_cast<std::size_t>(layer)); }
    void set(Layer layer, bool on) { bits_.set(static_cast<std::size_t>(layer), on); }
    friend bool operator==(const LayerSet&, const LayerSet&) = default;

  private:
    std::bitset<kLayers> bits_;
};

struct LayerInfo {
    Layer layer = Layer::scan;
    const char* key = "";   ///< in the settings
    const char* name = "";  ///< source text of layer_name()
    bool on = true;         ///< by default
};

const std::array<LayerInfo, kLayers>& layer_table();
/// The layer's name in the user's language.
QString layer_name(const LayerInfo& info);
LayerSet default_layers();

}  // namespace hitos::window
