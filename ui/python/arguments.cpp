// SPDX-License-Identifier: GPL-3.0-or-later
#include "arguments.hpp"

namespace hitos::python {

std::string found_text(const py::handle& value) {
    constexpr std::size_t kMost = 60;  // characters
    const py::str type = py::type::handle_of(value).attr("__name__");
    py::str shown = py::repr(value);
    if (py::len(shown) > kMost) {
        shown = py::str(shown[py::slice(0, kMost, 1)]) + py::str(" …");
    }
    return py::str("{} ({})").format(shown, type).cast<std::string>();
}

void refuse_argument(const std::string& name, const std::string& expected,
                     const py::handle& found) {
    throw py::type_error(name + ": expected " + expected + ", found " + found_text(found));
}

void require_callable(const py::object& function, const std::string& name, bool or_none) {
    if (PyCallable_Check(function.ptr()) != 0 || (or_none && function.is_none())) return;
    refuse_argument(name, or_none ? "a function or None" : "a function", function);
}

std::string key_of(const py::handle& key, const std::string& name) {
    if (!py::isinstance<py::str>(key)) refuse_argument(name, "keys that are str", key);
    return py::cast<std::string>(key);
}

}  // namespace hitos::python
