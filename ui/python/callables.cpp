// SPDX-License-Identifier: GPL-3.0-or-later
// Line methods and proposals of Python, added to the registries where every program adds its own.

#include "callables.hpp"

#include <string>
#include <vector>

#include "arguments.hpp"
#include "arrays.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "tours.hpp"

namespace hitos::python {
namespace {

using Keys = std::vector<std::string>;

/// What every entry of a registry says.
template <class Entry>
Entry entry_of(const std::string& word, const py::object& function, const std::string& label,
               const std::string& purpose, const Keys& reads) {
    require_callable(function, "function");
    Entry entry;
    entry.word = word;
    entry.label = label.empty() ? word : label;
    entry.purpose = purpose;
    entry.reads = reads;
    return entry;
}

void add_line_method(const std::string& word, const py::object& function, const std::string& label,
                     const std::string& purpose, const Keys& reads, bool random) {
    auto entry = entry_of<LineMethodEntry>(word, function, label, purpose, reads);
    entry.random = random;
    entry.make = [own = Function(function), random](const ExtractionParams& /*params*/,
                                                    std::uint64_t seed) {
        return line_method_of(own, random, seed);
    };
    line_methods().add(std::move(entry));
}

void add_proposal(const std::string& word, const py::object& function, const std::string& label,
                  const std::string& purpose, const Keys& reads, bool weighted) {
    auto entry = entry_of<ProposalEntry>(word, function, label, purpose, reads);
    entry.make = [own = Function(function), weighted](const FilterParams& /*params*/) {
        return proposal_of(own, weighted);
    };
    proposals().add(std::move(entry));
}

void bind_motion(py::module_& module) {
    using Held = std::shared_ptr<Motion>;
    py::class_<Motion, Held>(module, "Motion",
                             "How the robot moved between two scans, as a proposal is told.")
        .def_property_readonly(
            "displacement",
            [](const Held& m) {
                return view(py::dtype::of<double>(), {3}, {sizeof(double)}, &m->displacement.x, m);
            },
            "x, y, theta of the robot in the frame where it was before, by odometry [m, m, rad].")
        .def_readonly("path", &Motion::path_m, "Length of the way [m].")
        .def_readonly("turned", &Motion::turned_rad, "Sum of absolute turns [rad].")
        .def_readonly("moved", &Motion::moved, "Whether it moved at all.")
        .def_readonly("first", &Motion::first,
                      "Whether this is the first scan, at which nothing is uncertain.")
        .def_property_readonly(
            "controls",
            [](const Held& m) {
                const double* const first =
                    m->controls.empty() ? nullptr : &m->controls.front().twist.v;
                return view_of_members(first, m->controls.size(), sizeof(Control), 4, m);
            },
            "K x 4: v, v_lateral, w and how long each was held [m/s, m/s, rad/s, s].")
        .def_property_readonly(
            "scan", [](const Held& m) { return ScanView(m->scan); },
            "The scan at the end of the way.");
}

}  // namespace

void bind_callables(py::module_& module) {
    bind_motion(module);
    define(
        module, "add_line_method", &add_line_method, py::arg("word"), py::arg("function"),
        py::kw_only(), py::arg("label") = "", py::arg("purpose") = "", py::arg("reads") = Keys(),
        py::arg("random") = false,
        R"(Adds a line method of one's own, which the parameter features.method then chooses by `word`.

function(scan) takes a Scan and returns a row for every line: `first, end`, the line through the
points [first, end) of scan.points by total least squares, or `rho, theta, first, end` where the
function fits it itself (robot's frame, m and rad). With random=True it is function(scan, generator)
with a numpy Generator that depends on seed and scan alone, so that runs repeat to the bit.

To be called before anything is read or run, or parameters() asked for. `reads` are keys of
parameters that only some methods read. The function is called on the threads of runs, one call at a
time; what it raises ends the run and arrives as it is.)");
    define(
        module, "add_proposal", &add_proposal, py::arg("word"), py::arg("function"), py::kw_only(),
        py::arg("label") = "", py::arg("purpose") = "", py::arg("reads") = Keys(),
        py::arg("weighted") = false,
        R"(Adds a proposal of one's own, which the parameter filter.proposal then chooses by `word`:
where FastSLAM's particles draw their new poses.

function(poses, motion, normals) takes some particles' poses, N x 3 of x, y, theta, a Motion, and N x
3 standard normal numbers, and returns the new poses, N x 3. The numbers belong to seed, scan and
particle (at the first scan they are 0), so that a function which draws from them alone, row by row,
gives the same run to the bit, whatever the number of threads. N is at most 64 and says nothing: rows
must not depend on each other. With weighted=True it is called for one particle at a time and returns
(poses, log_weights), ln of the motion model's density over the proposal's.

Python works on one thread: a run of 100 particles calls it twice a scan, a weighted one a hundred
times. Otherwise as add_line_method().)");
}

}  // namespace hitos::python
