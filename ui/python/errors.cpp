// SPDX-License-Identifier: GPL-3.0-or-later
// From the errors of Hitos to exceptions of Python, and the other way for functions of Python.

#include <new>

#include "hitos/base/error.hpp"
#include "python_calls.hpp"

namespace hitos::python {
namespace {

std::shared_ptr<PyObject> kept(py::object object) {
    return {object.release().ptr(), [](PyObject* value) {
                // After the interpreter's end there is nothing to give back.
                if (Py_IsInitialized() == 0) return;
                const LockHeld lock;
                Py_DECREF(value);
            }};
}

std::string words_of(const py::error_already_set& raised) {
    return py::str(raised.type().attr("__name__")).cast<std::string>() + ": " +
           py::str(raised.value()).cast<std::string>();
}

template <class Fill>
void raise(const char* name, const Error& error, const Fill& fill) {
    const py::object type = py::module_::import("hitos.errors").attr(name);
    const py::object value = type(error.what());
    fill(value);
    PyErr_SetObject(type.ptr(), value.ptr());
}

void translate(std::exception_ptr thrown) {  // NOLINT(performance-*): pybind11 asks for a value
    try {
        if (thrown) std::rethrow_exception(thrown);
    } catch (const PythonFailure& failure) {
        failure.restore();
    } catch (const FileError& error) {
        raise("FileError", error,
              [&](const py::object& value) { value.attr("path") = error.path(); });
    } catch (const FormatError& error) {
        raise("FormatError", error, [&](const py::object& value) {
            value.attr("path") = error.path();
            value.attr("line") = error.line();
        });
    } catch (const ConfigError& error) {
        raise("ConfigurationError", error,
              [&](const py::object& value) { value.attr("key") = error.key(); });
    } catch (const Error& error) {
        raise("Error", error, [](const py::object& /*value*/) {});
    }
}

}  // namespace

PythonFailure::PythonFailure(const py::error_already_set& raised)
    : Error(verbatim(words_of(raised))),
      value_(kept(raised.value())),
      trace_(raised.trace() ? kept(raised.trace()) : nullptr) {}

void PythonFailure::restore() const {
    // Where it was raised; what an earlier restore() went through stays away.
    if (trace_) PyException_SetTraceback(value_.get(), trace_.get());
    PyErr_SetObject(py::type::handle_of(value_.get()).ptr(), value_.get());
}

void bind_errors() {
    py::register_exception_translator(translate);
}

}  // namespace hitos::python
