// SPDX-License-Identifier: GPL-3.0-or-later
// What runs are measured by, and the files that it is read from.

#include "hitos/services/evaluation/measures.hpp"

#include <fmt/format.h>

#include "arguments.hpp"
#include "arrays.hpp"
#include "hitos/services/evaluation/reference_fit.hpp"
#include "hitos/services/files/reference_files.hpp"
#include "hitos/services/files/trajectory_file.hpp"
#include "python_calls.hpp"
#include "references.hpp"

namespace hitos::python {
namespace {

using std::filesystem::path;

std::optional<TrajectoryError> error_of(const py::object& estimate, const py::object& reference,
                                        double tolerance) {
    const Trajectory a = trajectory_from(estimate, "estimate");
    const Trajectory b = trajectory_from(reference, "reference");
    const auto [fit, error] = without_python([&] {
        return std::pair(fit_of_reference(a, b, tolerance), trajectory_error(a, b, tolerance));
    });
    for (const Advice& doubt : fit.doubts()) tell(doubt);
    return error;
}

py::array read(const path& file) {
    auto trajectory = std::make_shared<const Trajectory>(read_trajectory(file));
    const Trajectory& shown = *trajectory;
    return view_of(shown, std::move(trajectory));
}

}  // namespace

References references_of(const std::optional<path>& map, const py::object& trajectory,
                         const std::optional<path>& distances) {
    References references;
    ReferenceFiles named;
    if (map) named.map = map->string();
    if (py::isinstance<py::array>(trajectory)) {
        references.trajectory = trajectory_from(trajectory, "reference_trajectory");
    } else if (!trajectory.is_none()) {
        py::detail::make_caster<path> file;
        if (!file.load(trajectory, true)) {
            refuse_argument("reference_trajectory",
                            "an N x 4 array of 64-bit floats, a path (str, bytes or os.PathLike) "
                            "or None",
                            trajectory);
        }
        named.trajectory = py::detail::cast_op<path>(std::move(file)).string();
    }
    const ReferenceFiles files = by_content(std::move(named));
    if (!files.map.empty()) references.map = read_map(files.map);
    if (!files.trajectory.empty()) {
        if (references.trajectory) {
            throw FormatError(files.trajectory, 0,
                              verbatim("holds a trajectory, and reference_trajectory is another "
                                       "one; expected a map"));
        }
        references.trajectory = read_trajectory(files.trajectory);
    }
    if (distances) references.distances = read_distances(*distances);
    return references;
}

void warn(const std::string& words) {
    if (PyErr_WarnEx(PyExc_UserWarning, words.c_str(), 1) != 0) throw py::error_already_set();
}

void tell(const Advice& doubt) {
    warn(doubt.words());
}

void bind_measures(py::module_& module) {
    py::class_<TrajectoryError>(module, "TrajectoryError", "How far a path is from the true one.")
        .def_readonly("rmse", &TrajectoryError::rmse_m,
                      "ATE: root mean square distance after alignment [m].")
        .def_readonly("mean", &TrajectoryError::mean_m, "Mean distance [m].")
        .def_readonly("maximum", &TrajectoryError::maximum_m, "Greatest distance [m].")
        .def_readonly(
            "heading_rmse", &TrajectoryError::heading_rmse_rad,
            "Root mean square difference of headings [rad]; None where the reference has no "
            "headings.")
        .def_readonly("poses", &TrajectoryError::poses, "Pairs of poses compared.")
        .def("__repr__", [](const TrajectoryError& e) {
            return fmt::format("<TrajectoryError: {:.4f} m over {} poses>", e.rmse_m, e.poses);
        });
    define(module, "trajectory_error", &error_of, py::arg("estimate"), py::arg("reference"),
           py::arg("tolerance") = kSameStamp,
           R"(The absolute trajectory error of a path against the true one, both N x 4 arrays of
t, x, y, theta, after the best rigid alignment (docs/evaluation.md). Between poses of the
reference that are no more than 0.5 s apart, or twice `tolerance`, it is interpolated; elsewhere
stamps have to agree within `tolerance` seconds. Error where the reference is of another time: fewer
than three poses have one of it, both share less than a tenth of the path's time, or stamps agree by
chance alone; a UserWarning where it tells of less than half of the poses, has another clock, shape or size, or has no
headings.)");
    define(module, "read_trajectory", &read, py::arg("path"),
           "Reads a trajectory in TUM format, plain or gzip: N x 4 of t, x, y, theta.");
}

}  // namespace hitos::python
