// SPDX-License-Identifier: GPL-3.0-or-later
// Arrays of numpy that show memory of C++, and the other way.
#pragma once

#include <pybind11/numpy.h>

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bindings.hpp"
#include "hitos/base/geometry.hpp"

namespace hitos::python {

/// What stands where there is no figure.
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A read-only array that shows what `data` points to, which `owner` keeps alive, and nothing is
/// copied.
py::array view(const py::dtype& type, std::vector<py::ssize_t> shape,
               std::vector<py::ssize_t> strides, const void* data,
               std::shared_ptr<const void> owner);

/// `columns` numbers that follow each other in memory, from `first` on, in each of `count` items
/// that are `stride` bytes apart; `count` 0: `first` is not looked at. With columns 0 an array of
/// one dimension.
template <class Number>
py::array view_of_members(const Number* first, std::size_t count, std::size_t stride, int columns,
                          std::shared_ptr<const void> owner) {
    std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(count)};
    std::vector<py::ssize_t> strides{static_cast<py::ssize_t>(stride)};
    if (columns > 0) {
        shape.push_back(columns);
        strides.push_back(sizeof(Number));
    }
    return view(py::dtype::of<Number>(), std::move(shape), std::move(strides), first,
                std::move(owner));
}

/// N x 4: t, x, y, theta.
py::array view_of(const Trajectory& trajectory, std::shared_ptr<const void> owner);
/// N x 2: x, y.
py::array view_of(const std::vector<Point2>& points, std::shared_ptr<const void> owner);
/// N x 2 x 2: both ends of segments, whose first coordinate is `first`.
py::array view_of_segments(const double* first, std::size_t count, std::size_t stride,
                           std::shared_ptr<const void> owner);

/// A field of a structured array.
struct Field {
    const char* name;
    const char* format;
    std::size_t offset;
};
py::dtype dtype_of(const std::vector<Field>& fields, std::size_t size);

/// A structured array of rows.
template <class Row>
py::array view_of_rows(std::shared_ptr<const std::vector<Row>> rows,
                       const std::vector<Field>& fields) {
    const void* const data = rows->data();
    const auto count = static_cast<py::ssize_t>(rows->size());
    return view(dtype_of(fields, sizeof(Row)), {count}, {sizeof(Row)}, data, std::move(rows));
}

/// A path from an N x 4 array of 64-bit floats. Raises TypeError for other numbers, ValueError for
/// another shape; nothing is cast in silence. `name` is the argument's.
Trajectory trajectory_from(const py::object& array, const char* name);

}  // namespace hitos::python
