// What runs are measured by, and the files that it is read from.

#include "hitos/services/evaluation/measures.hpp"

#include <fmt/format.h>

#include "arguments.hpp"
#include "arrays.hpp"
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
    return without_python([&] { return trajectory_error(a, b, tolerance); });
}

py::array read(const path& file) {
    auto trajectory = std::make_shared<const Trajectory>(read_trajectory(file));
    const Trajectory& shown = *trajectory;
    return view_of(shown, std::move(trajectory));
}

}  // namespace

std::optional<Trajectory> reference_trajectory_of(const py::object& given) {
    if (given.is_none()) return std::nullopt;
    if (py::isinstance<py::array>(given)) return trajectory_from(given, "reference_trajectory");
    py::detail::make_caster<path> file;
    if (!file.load(given, true)) {
        refuse_argument("reference_trajectory",
                        "an N x 4 array of 64-bit floats, a path (str, bytes or os.PathLike) or "
                        "None",
                        given);
    }
    return read_trajectory(py::detail::cast_op<path>(std::move(file)));
}

References references_of(const std::optional<path>& map, const py::object& trajectory,
                         const std::optional<path>& distances) {
    References references;
    if (map) references.map = read_map(*map);
    references.trajectory = reference_trajectory_of(trajectory);
    if (distances) references.distances = read_distances(*distances);
    return references;
}

void bind_measures(py::module_& module) {
    py::class_<TrajectoryError>(module, "TrajectoryError", "How far a path is from the true one.")
        .def_readonly("rmse", &TrajectoryError::rmse_m,
                      "ATE: root mean square distance after alignment [m].")
        .def_readonly("mean", &TrajectoryError::mean_m, "Mean distance [m].")
        .def_readonly("maximum", &TrajectoryError::maximum_m, "Greatest distance [m].")
        .def_readonly("heading_rmse", &TrajectoryError::heading_rmse_rad,
                      "Root mean square difference of headings [rad].")
        .def_readonly("poses", &TrajectoryError::poses, "Pairs of poses compared.")
        .def("__repr__", [](const TrajectoryError& e) {
            return fmt::format("<TrajectoryError: {:.4f} m over {} poses>", e.rmse_m, e.poses);
        });
    define(module, "trajectory_error", &error_of, py::arg("estimate"), py::arg("reference"),
           py::arg("tolerance") = kSameStamp,
           R"(The absolute trajectory error of a path against the true one, both N x 4 arrays of
t, x, y, theta, after the best rigid alignment (docs/evaluation.md). Between poses of the
reference that are no more than 0.5 s apart, or twice `tolerance`, it is interpolated; elsewhere
stamps have to agree within `tolerance` seconds. None where nothing can be compared.)");
    define(module, "read_trajectory", &read, py::arg("path"),
           "Reads a trajectory in TUM format, plain or gzip: N x 4 of t, x, y, theta.");
}

}  // namespace hitos::python
