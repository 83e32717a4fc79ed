// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

#include "arguments.hpp"
#include "hitos/base/error.hpp"

namespace hitos::python {
namespace {

static_assert(offsetof(StampedPose, pose) == sizeof(double) && sizeof(Pose) == 3 * sizeof(double) &&
              sizeof(Point2) == 2 * sizeof(double));

py::capsule capsule_of(std::shared_ptr<const void> owner) {
    auto held = std::make_unique<std::shared_ptr<const void>>(std::move(owner));
    py::capsule capsule(held.get(),
                        [](void* kept) { delete static_cast<std::shared_ptr<const void>*>(kept); });
    static_cast<void>(held.release());
    return capsule;
}

}  // namespace

py::array view(const py::dtype& type, std::vector<py::ssize_t> shape,
               std::vector<py::ssize_t> strides, const void* data,
               std::shared_ptr<const void> owner) {
    static constexpr double kNothing = 0.0;  // an array of nothing points somewhere too
    py::array array(type, std::move(shape), std::move(strides), data != nullptr ? data : &kNothing,
                    capsule_of(std::move(owner)));
    array.attr("flags").attr("writeable") = false;
    return array;
}

py::array view_of(const Trajectory& trajectory, std::shared_ptr<const void> owner) {
    const double* const first = trajectory.empty() ? nullptr : &trajectory.front().time_s;
    return view_of_members(first, trajectory.size(), sizeof(StampedPose), 4, std::move(owner));
}

py::array view_of(const std::vector<Point2>& points, std::shared_ptr<const void> owner) {
    const double* const first = points.empty() ? nullptr : &points.front().x;
    return view_of_members(first, points.size(), sizeof(Point2), 2, std::move(owner));
}

py::array view_of_segments(const double* first, std::size_t count, std::size_t stride,
                           std::shared_ptr<const void> owner) {
    return view(py::dtype::of<double>(), {static_cast<py::ssize_t>(count), 2, 2},
                {static_cast<py::ssize_t>(stride), sizeof(Point2), sizeof(double)}, first,
                std::move(owner));
}

py::dtype dtype_of(const std::vector<Field>& fields, std::size_t size) {
    py::list names;
    py::list formats;
    py::list offsets;
    for (const Field& field : fields) {
        names.append(field.name);
        formats.append(py::dtype(field.format));
        offsets.append(field.offset);
    }
    return {names, formats, offsets, static_cast<py::ssize_t>(size)};
}

Trajectory trajectory_from(const py::object& array, const char* name) {
    if (!py::isinstance<py::array_t<double>>(array)) {
        refuse_argument(name, "an array of 64-bit floats", array);
    }
    const auto numbers = py::cast<py::array_t<double>>(array);
    if (numbers.ndim() != 2 || numbers.shape(1) != 4) {
        throw py::value_error(std::string(name) +
                              ": expected N rows of t, x, y, theta, found the shape " +
                              py::str(array.attr("shape")).cast<std::string>());
    }
    const auto at = numbers.unchecked<2>();
    Trajectory trajectory;
    trajectory.reserve(static_cast<std::size_t>(at.shape(0)));
    for (py::ssize_t i = 0; i < at.shape(0); ++i) {
        for (py::ssize_t column = 0; column < 4; ++column) {
            // As of files: squares of what is greater are no numbers.
            constexpr double kGreatest = 1e12;
            if (!(std::abs(at(i, column)) <= kGreatest)) {
                throw py::value_error(
                    fmt::format("{}: expected numbers up to {:g}, found {} in row {}, column {}",
                                name, kGreatest, at(i, column), i, column));
            }
        }
        trajectory.push_back({at(i, 0), {at(i, 1), at(i, 2), at(i, 3)}});
    }
    return trajectory;
}

}  // namespace hitos::python
