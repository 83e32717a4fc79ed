// SPDX-License-Identifier: GPL-3.0-or-later
// Configurations, parameters and presets.

#include "configuration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "arguments.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/parameter.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/results/kept_run.hpp"
#include "hitos/workbench/presets.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "python_calls.hpp"

namespace hitos::python {
namespace {

py::object object_of(const ConfigParameter::Value& value) {
    return std::visit([](const auto& held) -> py::object { return py::cast(held); }, value);
}

py::object get(const Configuracion& configuration, const std::string& key) {
    return object_of(find_parameter(key).get(configuration));
}

void set(Configuracion& configuration, const std::string& key, const py::object& value) {
    find_parameter(key).set(configuration, text_of(value));
}

/// `name` is the argument's.
void update_from(Configuracion& configuration, const py::dict& values, const char* name) {
    Configuracion changed = configuration;  // all or nothing
    for (const auto& [key, value] : values) {
        set(changed, key_of(key, name), py::reinterpret_borrow<py::object>(value));
    }
    check(changed);
    configuration = std::move(changed);
}

void update(Configuracion& configuration, const py::dict& values) {
    update_from(configuration, values, "values");
}

Configuracion configuration_of(const std::optional<py::dict>& values,
                               const std::optional<std::string>& preset,
                               const std::optional<std::filesystem::path>& file) {
    if (preset && file) {
        throw ConfigError("preset", verbatim("was given beside a file; choose one of them"));
    }
    Configuracion configuration;
    if (preset) configuration = preset_configuration(*preset);
    if (file) configuration = ArchivoConfiguracion::read(*file);
    if (values) update(configuration, *values);
    return configuration;
}

bool contains(const Configuracion& /*any*/, const std::string& key) {
    return std::ranges::find(parameters(), key, &ConfigParameter::key) != parameters().end();
}

void write(const Configuracion& configuration, const std::filesystem::path& path) {
    ArchivoConfiguracion::write(configuration, path);
}

py::list keys() {
    py::list all;
    for (const ConfigParameter& parameter : parameters()) all.append(parameter.key);
    return all;
}

py::dict dict_of(const Configuracion& configuration) {
    py::dict values;
    for (const ConfigParameter& parameter : parameters()) {
        values[py::str(parameter.key)] = object_of(parameter.get(configuration));
    }
    return values;
}

py::list different(const Configuracion& a, const Configuracion& b) {
    py::list differing;
    for (const ConfigParameter* parameter : differences(a, b)) differing.append(parameter->key);
    return differing;
}

std::string shown(const Configuracion& configuration) {
    std::string changed;
    const Configuracion defaults;
    for (const ConfigParameter& parameter : parameters()) {
        if (parameter.text(configuration) == parameter.text(defaults)) continue;
        const py::object value = object_of(parameter.get(configuration));
        changed += fmt::format("{}{}: {}", changed.empty() ? "" : ", ",
                               py::repr(py::str(parameter.key)).cast<std::string>(),
                               py::repr(value).cast<std::string>());
    }
    return "Configuration({" + changed + "})";
}

/// Nothing for words.
std::optional<double> bound_of(const ConfigParameter& parameter, double bound) {
    using Type = ConfigParameter::Type;
    const bool number = parameter.type == Type::real || parameter.type == Type::integer;
    return number ? std::optional(bound) : std::nullopt;
}

void bind_parameter(py::module_& module) {
    py::class_<ConfigParameter>(module, "Parameter", R"(One parameter of a configuration: its key,
meaning, unit, range and default; hitos.parameters() gives all of them.)")
        .def_property_readonly(
            "key", [](const ConfigParameter& p) { return p.key; }, "\"filter.particles\"")
        .def_property_readonly(
            "description", [](const ConfigParameter& p) { return p.description; }, "What it means.")
        .def_property_readonly(
            "unit", [](const ConfigParameter& p) { return p.unit; }, "\"m\", \"rad\" … or \"\".")
        .def_property_readonly(
            "symbol", [](const ConfigParameter& p) { return p.symbol; },
            "What the thesis calls it, or \"\".")
        .def_property_readonly(
            "allowed", [](const ConfigParameter& p) { return p.allowed(); },
            "The values that it can take, in words.")
        .def_property_readonly(
            "default", [](const ConfigParameter& p) { return object_of(p.get(Configuracion())); },
            "Its value where nobody chooses.")
        .def_property_readonly(
            "minimum", [](const ConfigParameter& p) { return bound_of(p, p.minimum); },
            "The least value of a number; None for words.")
        .def_property_readonly(
            "maximum", [](const ConfigParameter& p) { return bound_of(p, p.maximum); },
            "The greatest value of a number; None for words.")
        .def_property_readonly(
            "choices",
            [](const ConfigParameter& p) {
                py::dict words;
                for (const ParameterChoice& choice : p.choices) {
                    words[py::str(choice.word)] = choice.purpose;
                }
                return words;
            },
            "The words among which it chooses, each with its purpose; empty for the others.")
        .def_property_readonly(
            "read_where",
            [](const ConfigParameter& p) {
                py::dict needed;
                for (const auto& condition : p.conditions) {
                    needed[py::str(condition.key)] = condition.needed;
                }
                return needed;
            },
            "What other parameters must be for this one to have an effect.")
        .def("__repr__", [](const ConfigParameter& p) {
            return fmt::format("<Parameter {}: {}>", p.key, p.allowed());
        });
}

}  // namespace

std::string text_of(const py::handle& value) {
    auto plain = py::reinterpret_borrow<py::object>(value);
    if (py::isinstance<py::str>(plain)) return py::cast<std::string>(plain);
    // A number of numpy as Python's own: float32(0.1) is not 0.1, and says so.
    if (py::hasattr(plain, "item") && !py::hasattr(plain, "__len__")) plain = plain.attr("item")();
    if (py::isinstance<py::bool_>(plain)) return py::cast<bool>(plain) ? "on" : "off";
    return py::repr(plain).cast<std::string>();
}

std::string world_set_of(const py::object& values) {
    if (values.is_none()) return {};
    if (py::isinstance<py::str>(values)) return py::cast<std::string>(values);
    std::string all;
    if (!py::isinstance<py::dict>(values)) {
        refuse_argument("world_set", "a dict, a str or None", values);
    }
    for (const auto& [key, value] : py::cast<py::dict>(values)) {
        if (!all.empty()) all += ' ';
        all += key_of(key, "world_set");
        all += '=';
        all += text_of(value);
    }
    return all;
}

Configuracion configuration_from(const py::object& given, const std::string& source) {
    if (py::isinstance<Configuracion>(given)) return py::cast<Configuracion>(given);
    Configuracion configuration = suited_configuration(source);
    if (given.is_none()) return configuration;
    if (!py::isinstance<py::dict>(given)) {
        refuse_argument("configuration", "a Configuration, a dict or None", given);
    }
    update_from(configuration, py::cast<py::dict>(given), "configuration");
    return configuration;
}

void bind_configuration(py::module_& module) {
    bind_parameter(module);
    py::class_<Configuracion> configuration(module, "Configuration",
                                            R"(Every parameter of a run, by its key.

    c = hitos.Configuration({"filter.particles": 200}, preset="recorded")
    c["split_merge.dmax"] = 0.03

Keys, meanings and ranges are those of hitos.parameters() and of `hitos-cli parameters`. Values
are checked when they are set: an unknown key or an impossible value raises ConfigurationError,
which names near keys or what is allowed, and changes nothing. A parameter of whole numbers takes
no floats.)");
    define_init(configuration, &configuration_of, py::arg("values") = py::none(), py::kw_only(),
                py::arg("preset") = py::none(), py::arg("file") = py::none(),
                R"(The defaults, or a preset, or a configuration file, with `values` over them.)");
    define_method(configuration, "__getitem__", &get, py::arg("key"), "The value of a parameter.");
    define_method(configuration, "__setitem__", &set, py::arg("key"), py::arg("value"),
                  "Sets a parameter.");
    define_method(configuration, "__contains__", &contains, py::arg("key"),
                  "Whether there is such a parameter.");
    define_method(configuration, "update", &update, py::arg("values"),
                  "Sets all values of a dict, or none of them where one is impossible.");
    define_method(
        configuration, "differences", &different, py::arg("other"),
        R"(The keys in which two configurations differ, but for the log and what changes no
result; those without effect in both are left out.)");
    define_method(configuration, "write", &write, py::arg("path"),
                  "Writes to_text() into a file: whole, or not at all.");
    configuration
        .def(
            "__iter__", [](const Configuracion&) { return py::iter(keys()); },
            "The keys, group by group.")
        .def(
            "__len__", [](const Configuracion&) { return parameters().size(); },
            "How many parameters there are.")
        .def(
            "__eq__",
            [](const Configuracion& a, const Configuracion& b) {
                return dict_of(a).equal(dict_of(b));
            },
            py::arg("other"), py::is_operator(), "Whether all values are the same.")
        .def(
            "keys", [](const Configuracion&) { return keys(); }, "All keys, group by group.")
        .def("to_dict", &dict_of, "All keys with their values.")
        .def(
            "copy", [](const Configuracion& c) { return Configuracion(c); },
            "A configuration of its own with the same values.")
        .def("to_text", &ArchivoConfiguracion::to_text,
             "A commented configuration file; reading it gives the same values to the last bit.")
        .def("__repr__", &shown)
        .attr("__hash__") = py::none();
    module.def(
        "parameters",
        [] {
            py::list all;
            for (const ConfigParameter& parameter : parameters()) all.append(parameter);
            return all;
        },
        R"(Every parameter that there is, as `hitos-cli parameters` lists them. Line methods and
proposals of one's own are added before this is first called.)");
    module.def(
        "presets",
        [] {
            py::dict all;
            for (const Preset& preset : presets()) all[py::str(preset.word)] = preset.purpose;
            return all;
        },
        "The names of the configurations that come with Hitos, each with its purpose.");
    module.def("worlds", &shipped_worlds, "The names of the worlds that come with Hitos.");
}

}  // namespace hitos::python
