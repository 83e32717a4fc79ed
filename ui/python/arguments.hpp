// SPDX-License-Identifier: GPL-3.0-or-later
// Arguments of functions of Python: what cannot be taken is refused in a sentence that names it.
// pybind11's own error lists every signature and says neither which argument it is nor what ails
// it.
#pragma once

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <concepts>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "hitos/services/configuration/configuracion.hpp"

namespace hitos::python {

/// A value and its type as errors name them: "3 (int)". Long ones are cut.
std::string found_text(const py::handle& value);

/// TypeError: "runs: expected a whole number, found 'x' (str)".
[[noreturn]] void refuse_argument(const std::string& name, const std::string& expected,
                                  const py::handle& found);

/// Refuses what cannot be called, but for None where that is allowed.
void require_callable(const py::object& function, const std::string& name, bool or_none = false);

/// The key of a dict that is the argument `name`; TypeError where it is no text.
std::string key_of(const py::handle& key, const std::string& name);

/// What an argument of the type is to be, in words.
template <class T>
std::string expected_of() {
    if constexpr (std::same_as<T, bool>) {
        return "True or False";
    } else if constexpr (std::integral<T>) {
        return "a whole number from " + std::to_string(std::numeric_limits<T>::min()) + " to " +
               std::to_string(std::numeric_limits<T>::max());
    } else if constexpr (std::floating_point<T>) {
        return "a number";
    } else if constexpr (std::same_as<T, std::string>) {
        return "a str";
    } else if constexpr (std::same_as<T, std::filesystem::path>) {
        return "a path (str, bytes or os.PathLike)";
    } else if constexpr (std::same_as<T, std::vector<std::string>>) {
        return "a sequence of str";
    } else if constexpr (std::same_as<T, py::dict>) {
        return "a dict";
    } else if constexpr (std::same_as<T, Configuracion>) {
        return "a Configuration";
    } else {
        return expected_of<typename T::value_type>() + " or None";  // of an optional
    }
}

/// The argument as that type. Objects as they are: whoever takes them says what they have to be.
template <class T>
T taken(const py::object& given, const std::string& name) {
    if constexpr (std::same_as<T, py::object>) {
        return given;
    } else {
        py::detail::make_caster<T> caster;
        if (!caster.load(given, true)) refuse_argument(name, expected_of<T>(), given);
        return py::detail::cast_op<T>(std::move(caster));
    }
}

/// Any object, which the signature shows as a T.
template <class T>
struct Given {
    py::object object;
};

template <class... A, std::size_t... I>
std::tuple<A...> all_taken(const std::vector<std::string>& names, std::index_sequence<I...> /*i*/,
                           const Given<A>&... given) {
    return {taken<A>(given.object, names.at(I))...};
}

/// The function with arguments that are taken by name.
template <class R, class... A>
auto by_name(R (*function)(A...), std::vector<std::string> names) {
    return [function, names = std::move(names)](Given<std::decay_t<A>>... given) -> R {
        return std::apply(function, all_taken(names, std::index_sequence_for<A...>(), given...));
    };
}
/// The same of a method, whose object is left to pybind11.
template <class R, class Self, class... A>
auto by_name_of_self(R (*function)(Self&, A...), std::vector<std::string> names) {
    return [function, names = std::move(names)](Self& self, Given<std::decay_t<A>>... given) -> R {
        return std::apply(
            function, std::tuple_cat(std::tuple<Self&>(self),
                                     all_taken(names, std::index_sequence_for<A...>(), given...)));
    };
}

/// The names that the py::arg among the attributes of a definition have.
template <class... Extra>
std::vector<std::string> names_in(const Extra&... extra) {
    std::vector<std::string> names;
    const auto note = [&names](const auto& attribute) {
        if constexpr (std::derived_from<std::decay_t<decltype(attribute)>, py::arg>) {
            names.emplace_back(attribute.name);
        }
    };
    (note(extra), ...);
    return names;
}

/// module.def(), cls.def() and py::init() of functions whose arguments are taken by name.
template <class Function, class... Extra>
void define(py::module_& module, const char* name, Function* function, const Extra&... extra) {
    module.def(name, by_name(function, names_in(extra...)), extra...);
}
template <class Class, class Function, class... Extra>
void define_method(Class& cls, const char* name, Function* function, const Extra&... extra) {
    cls.def(name, by_name_of_self(function, names_in(extra...)), extra...);
}
template <class Class, class Function, class... Extra>
void define_init(Class& cls, Function* function, const Extra&... extra) {
    cls.def(py::init(by_name(function, names_in(extra...))), extra...);
}

}  // namespace hitos::python

namespace pybind11::detail {

/// Takes anything; what it is to be, its owner says.
template <class T>
struct type_caster<hitos::python::Given<T>> {
    PYBIND11_TYPE_CASTER(hitos::python::Given<T>, make_caster<T>::name);

    bool load(handle source, bool /*convert*/) {
        value.object = reinterpret_borrow<object>(source);
        return static_cast<bool>(source);
    }
};

}  // namespace pybind11::detail
