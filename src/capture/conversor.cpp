#include "hitos/capture/conversor.hpp"

#include "range_conversor.hpp"

namespace hitos {
namespace {

using Maker = std::unique_ptr<RangeConversor> (*)(const ReadOptions&);

std::unique_ptr<Conversor> prepared(Maker make, const Fuente& fuente, const ReadOptions& options) {
    std::unique_ptr<RangeConversor> conversor = make(options);
    if (!(options.max_range_m > 0.0)) {
        // A converter of its own, because looking ahead leaves metadata in it.
        conversor->set_no_return(find_no_return(fuente, *make(options)));
    }
    return conversor;
}

}  // namespace

std::unique_ptr<Conversor> make_conversor(const Fuente& fuente, const ReadOptions& options) {
    switch (fuente.format()) {
        case LogFormat::radish:
            return prepared(make_conversor_radish, fuente, options);
        case LogFormat::carmen:
            return prepared(make_conversor_carmen, fuente, options);
        case LogFormat::normalized:
            return make_conversor_normalizado(options);
        case LogFormat::player:
        case LogFormat::automatic:
            break;
    }
    return prepared(make_conversor_player, fuente, options);
}

}  // namespace hitos
