// SPDX-License-Identifier: GPL-3.0-or-later
// What the parts of the module tell it of themselves.
#pragma once

#include <pybind11/pybind11.h>

namespace hitos::python {

namespace py = pybind11;

void bind_errors();
void bind_configuration(py::module_& module);
void bind_tours(py::module_& module);
void bind_grids(py::module_& module);
void bind_snapshots(py::module_& module);
void bind_runs(py::module_& module);
void bind_studies(py::module_& module);
void bind_callables(py::module_& module);
void bind_measures(py::module_& module);

}  // namespace hitos::python
