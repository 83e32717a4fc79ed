// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of Python that find lines and propose poses.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "hitos/features/line_methods.hpp"
#include "hitos/slam/proposal.hpp"

namespace hitos::python {

/// A function of Python for as long as the process lives: registries are never emptied, and end
/// after the interpreter.
class Function {
  public:
    explicit Function(py::object function) : function_(function.release().ptr()) {}
    /// With the interpreter's lock held.
    template <class... Arguments>
    py::object operator()(Arguments&&... arguments) const {
        return py::reinterpret_borrow<py::object>(function_)(std::forward<Arguments>(arguments)...);
    }

  private:
    PyObject* function_;
};

/// What proposals are told of a step.
struct Motion {
    Pose displacement;  ///< of the robot in its own frame
    double path_m = 0.0;
    double turned_rad = 0.0;
    bool moved = false;
    bool first = false;
    std::vector<Control> controls;
    std::shared_ptr<const Scan> scan;
};

std::unique_ptr<MetodoExtraccionRectas> line_method_of(Function function, bool random,
                                                       std::uint64_t seed);
std::unique_ptr<Proposal> proposal_of(Function function, bool weighted);

}  // namespace hitos::python
