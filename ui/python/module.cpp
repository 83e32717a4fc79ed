// SPDX-License-Identifier: GPL-3.0-or-later
// The extension module behind `import hitos`; hitos/__init__.py gives out what is in here.

#include "bindings.hpp"
#include "ending.hpp"
#include "hitos/services/results/results.hpp"

// NOLINTNEXTLINE: what the macro makes is pybind11's
PYBIND11_MODULE(_hitos, module) {
    using namespace hitos::python;
    // Classes and functions are asked for, and shown, as parts of the package.
    module.attr("__name__") = "hitos";
    py::options how;
    how.disable_enum_members_docstring();
    bind_errors();
    bind_ending();
    bind_configuration(module);
    bind_tours(module);
    bind_grids(module);
    bind_snapshots(module);
    bind_runs(module);
    bind_studies(module);
    bind_callables(module);
    bind_measures(module);
    module.attr("__version__") = hitos::version();
    module.attr("__name__") = "hitos._hitos";
}
