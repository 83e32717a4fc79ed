// SPDX-License-Identifier: GPL-3.0-or-later
// Configuration files, and single assignments of --set.
#include <algorithm>
#include <string>

#include "hitos/base/text_input.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/configuration/configuracion.hpp"
#include "hitos/simulation/worlds/world.hpp"
#include "hitos/simulation/worlds/world_key.hpp"
#include "laws.hpp"
#include "targets.hpp"

namespace hitos::fuzz {
namespace {

constexpr const char* kConfigurationName = "input";

bool equal(const Configuracion& a, const Configuracion& b) {
    return std::ranges::all_of(parameters(), [&](const ConfigParameter& parameter) {
        return parameter.get(a) == parameter.get(b);
    });
}

/// What was read is allowed, and is the same once written and read again.
void require_sound(const Configuracion& configuration) {
    check(configuration);
    const std::string text = ArchivoConfiguracion::to_text(configuration);
    const Configuracion again = ArchivoConfiguracion::parse(text, kConfigurationName);
    require(equal(configuration, again), "a configuration reads back to the last bit");
    require(ArchivoConfiguracion::to_text(again) == text, "a configuration is written one way");
}

const World& small_world() {
    static const World some_world =
        parse_world("walls = [[[0, 0], [4, 0], [4, 3]]]\n[tour]\nway_points = [[1, 1], [2, 1]]\n",
                    kConfigurationName);
    return some_world;
}

bool is_set_in_configuration(std::string_view assignment) {
    Configuracion configuration;
    if (!unless_refused([&] { return set_parameter(configuration, assignment), true; })) {
        return false;
    }
    const std::string_view key = assignment.substr(0, assignment.find('='));
    const ConfigParameter& parameter = find_parameter(input::trimmed(key));
    require(parameter.allows(parameter.get(configuration)), "a value that is set is allowed");
    Configuracion other;
    parameter.set(other, parameter.text(configuration));
    require(parameter.get(other) == parameter.get(configuration), "a value's text is the value");
    // Values that are each allowed can be impossible together; paths need not be UTF-8.
    unless_refused([&] { return check(configuration), true; });
    if (parameter.type == ConfigParameter::Type::text) {
        unless_refused([&] { return ArchivoConfiguracion::to_text(configuration); });
    }
    return true;
}

bool is_set_in_world(std::string_view assignment) {
    World world = small_world();
    if (!unless_refused([&] { return set_world_value(world, assignment), true; })) return false;
    require(std::ranges::all_of(world_keys(),
                                [&](const WorldKey& key) { return key.allows(key.get(world)); }),
            "a world's value that is set is allowed");
    unless_refused([&] { return check(world), true; });
    return true;
}

}  // namespace

bool check_configuration(std::string_view input) {
    const auto parsed =
        unless_refused([&] { return ArchivoConfiguracion::parse(input, kConfigurationName); });
    if (parsed) require_sound(*parsed);
    const std::filesystem::path& file = file_of(input);
    const auto read = unless_refused([&] { return ArchivoConfiguracion::read(file); });
    return read.has_value();
}

bool check_assignment(std::string_view input) {
    const bool in_configuration = is_set_in_configuration(input);
    const bool in_world = is_set_in_world(input);
    return in_configuration || in_world;
}

}  // namespace hitos::fuzz
