// SPDX-License-Identifier: GPL-3.0-or-later
// A line method that is a function of Python.

#include <pybind11/numpy.h>

#include <cmath>
#include <optional>

#include "callables.hpp"
#include "hitos/base/error.hpp"
#include "hitos/features/line_fit.hpp"
#include "python_calls.hpp"
#include "tours.hpp"

namespace hitos::python {
namespace {

/// What the function returned, as numbers.
struct Found {
    std::vector<std::vector<double>> rows;
};

Found found_in(const py::object& returned) {
    const py::array_t<double, py::array::c_style | py::array::forcecast> numbers(returned);
    if (numbers.size() == 0) return {};
    if (numbers.ndim() != 2 || (numbers.shape(1) != 2 && numbers.shape(1) != 4)) {
        throw py::value_error(
            "a line method returned the shape " +
            py::str(numbers.attr("shape")).cast<std::string>() +
            "; expected a row of first, end or of rho, theta, first, end for every line");
    }
    Found found;
    const auto at = numbers.unchecked<2>();
    for (py::ssize_t i = 0; i < at.shape(0); ++i) {
        std::vector<double>& row = found.rows.emplace_back();
        for (py::ssize_t k = 0; k < at.shape(1); ++k) row.push_back(at(i, k));
    }
    return found;
}

class OwnLines final : public MetodoExtraccionRectas {
  public:
    OwnLines(Function function, bool random, std::uint64_t seed)
        : function_(function), random_(random), seed_(seed) {}

    void go_to(std::uint64_t scan) override { number_ = scan; }

    void extract_lines(const Scan& scan, Observation& out) override {
        const auto shown = std::make_shared<const Scan>(scan);  // Python may keep it
        const std::uint64_t number = number_++;
        const Found found = with_python([&] {
            const py::object of = py::cast(ScanView(shown));
            return found_in(random_ ? function_(of, generator(number)) : function_(of));
        });
        for (const std::vector<double>& row : found.rows) keep(scan, row, out);
    }

  private:
    /// The same numbers for the same seed and scan, in whatever order scans are asked for.
    py::object generator(std::uint64_t number) const {
        const py::module_ random = py::module_::import("numpy.random");
        py::list key;
        key.append(seed_);
        key.append(number);
        return random.attr("Generator")(random.attr("Philox")(py::arg("seed") = key));
    }

    static void keep(const Scan& scan, const std::vector<double>& row, Observation& out) {
        const double first = row[row.size() - 2];
        const double end = row[row.size() - 1];
        const auto count = static_cast<double>(scan.points.size());
        const bool whole = first == std::floor(first) && end == std::floor(end);
        if (!whole || !(first >= 0.0) || !(end <= count) || !(end - first >= 2.0)) {
            throw Error(
                message("a line method returned the points [%1, %2) of a scan of %3; "
                        "expected two or more of them, by whole numbers",
                        first, end, scan.points.size()));
        }
        const auto begin = static_cast<std::size_t>(first);
        const auto support =
            std::span(scan.points).subspan(begin, static_cast<std::size_t>(end) - begin);
        const Recta line =
            row.size() == 4 ? normalized(Recta{row[0], row[1]}) : fit_least_squares(support);
        out.lines.push_back({line, static_cast<std::uint32_t>(out.support.size()),
                             static_cast<std::uint32_t>(support.size())});
        out.support.insert(out.support.end(), support.begin(), support.end());
    }

    Function function_;
    bool random_;
    std::uint64_t seed_;
    std::uint64_t number_ = 0;
};

}  // namespace

std::unique_ptr<MetodoExtraccionRectas> line_method_of(Function function, bool random,
                                                       std::uint64_t seed) {
    return std::make_unique<OwnLines>(function, random, seed);
}

}  // namespace hitos::python
