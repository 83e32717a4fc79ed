// SPDX-License-Identifier: GPL-3.0-or-later
// What Python sees of runs.

#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <optional>

#include "arguments.hpp"
#include "arrays.hpp"
#include "configuration.hpp"
#include "hitos/base/error.hpp"
#include "hitos/services/evaluation/distances.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/services/files/trajectory_file.hpp"
#include "hitos/services/results/optional_outputs.hpp"
#include "references.hpp"
#include "runs.hpp"

namespace hitos::python {
namespace {

using std::filesystem::path;

constexpr std::uint64_t kToTheEnd = RunWorker::kToTheEnd;

std::shared_ptr<Run> made_run(const py::object& tour, const py::object& configuration,
                              const std::optional<path>& reference,
                              const py::object& reference_trajectory,
                              const std::optional<path>& distances, bool uncertainty) {
    const TourArgument argument = tour_argument(tour);
    return std::make_shared<Run>(configuration_for(argument, configuration),
                                 references_of(reference, reference_trajectory, distances),
                                 uncertainty);
}

/// Nothing where there was no scan to take.
std::shared_ptr<State> stepped(Run& run, std::uint64_t scans) {
    const std::uint64_t before = run.progress().steps;
    run.advance(scans, py::none());
    // The end of the tour is no scan.
    if (run.progress().steps == before) return nullptr;
    return run.snapshot();
}

std::shared_ptr<State> next(Run& run) {
    std::shared_ptr<State> snapshot = stepped(run, 1);
    if (!snapshot) throw py::stop_iteration();
    return snapshot;
}

/// "svg,g2o", "all", or such words and names one by one.
std::vector<std::string> output_words(const py::object& also) {
    if (also.is_none()) return {};
    std::string list;
    if (py::isinstance<py::str>(also)) {
        list = py::cast<std::string>(also);
    } else {
        const char* const expected = "a str, several of them or None";
        if (!py::isinstance<py::iterable>(also)) refuse_argument("also", expected, also);
        for (const py::handle word : also) {
            if (!py::isinstance<py::str>(word)) refuse_argument("also", expected, word);
            list += py::cast<std::string>(word) + ",";
        }
    }
    return chosen_outputs(list, "also");
}

py::object written(const Result& result, const path& folder, const py::object& also) {
    return parsed(result.run()->write(result.shown()->revision, folder, output_words(also)));
}

std::shared_ptr<Result> finished(Run& run, const py::object& progress) {
    require_callable(progress, "progress", true);
    run.advance(kToTheEnd, progress);
    return run.result();
}

std::shared_ptr<Result> run_to_the_end(const py::object& tour, const py::object& configuration,
                                       const py::object& progress, const std::optional<path>& out,
                                       const std::optional<path>& reference,
                                       const py::object& reference_trajectory,
                                       const std::optional<path>& distances, bool uncertainty,
                                       const py::object& also) {
    require_callable(progress, "progress", true);
    const std::vector<std::string> words = output_words(also);
    if (!out && !words.empty()) {
        throw ConfigError("also", verbatim("names files to write, but there is no folder for them; "
                                           "give out too"));
    }
    const std::shared_ptr<Run> run =
        made_run(tour, configuration, reference, reference_trajectory, distances, uncertainty);
    // A long run is not to end with what could be known before it.
    const std::unique_ptr<StagedFolder> folder = out ? run->folder_for(*out, words) : nullptr;
    run->advance(kToTheEnd, progress);
    std::shared_ptr<Result> result = run->result();
    const bool stopped = run->progress().state != Progress::State::finished;
    if (folder && stopped && holds_finished_run(*out)) {
        warn(
            fmt::format("nothing is written: {} keeps the results of a run to its tour's end, and "
                        "this one was stopped before; write() of its result writes them",
                        out->string()));
    } else if (folder) {
        static_cast<void>(run->write(result->shown()->revision, *folder, words));
    }
    return result;
}

void bind_progress(py::module_& module) {
    py::class_<Progress>(module, "Progress", "How far a run has come.")
        .def_readonly("scans", &Progress::steps, "Scans taken so far.")
        .def_readonly("fraction", &Progress::fraction,
                      "Part of the tour that is read, 0 … 1; None where it cannot be known.")
        .def_readonly("time", &Progress::time_s, "Stamp of the last scan [s].")
        .def_readonly("duration", &Progress::duration_s, "Since the first scan, by stamps [s].")
        .def_readonly("scans_per_second", &Progress::steps_per_second, "Over the last half second.")
        .def_readonly("lines", &Progress::lines, "Line landmarks of the best hypothesis.")
        .def_readonly("corners", &Progress::corners, "Its corner landmarks.")
        .def_readonly("skipped", &Progress::skipped_lines, "Damaged lines of the log so far.")
        .def_property_readonly(
            "neff", [](const Progress& p) { return p.statistics.neff; },
            "Effective particles before the last resampling.")
        .def_property_readonly(
            "finished", [](const Progress& p) { return p.state == Progress::State::finished; },
            "Whether the tour is over.")
        .def("__repr__", [](const Progress& p) {
            return fmt::format("<Progress: {} scans, {} landmarks>", p.steps, p.lines + p.corners);
        });
}

void bind_result(py::module_& module) {
    py::class_<Result, State, std::shared_ptr<Result>> cls(module, "Result",
                                                           R"(What a run has come to:
a Snapshot whose grid has its log-odds too, with the figures of every scan, and what can be written
and measured. Several threads may ask it at once.)");
    cls.def_property_readonly(
           "figures", [](const Result& result) { return view_of(result.figures()); },
           R"(A structured array with a row for every scan: time since the first
one [s], x, y, theta of the pose as it was at that scan, neff, best_log_weight, step_seconds, lines
and corners of the map, seen_lines, seen_corners, matched, created, ignored, unseen [s], skipped,
resampled, best_changed, loop_closed: the columns of docs/formats.md.)")
        .def_property_readonly(
            "summary",
            [](const Result& result) {
                return parsed(result.run()->summary(result.shown()->revision));
            },
            R"(The figures of the run as summary.json has them, as a dict: errors against the truth
or the reference, quality, advice. Reads the tour once more; Error where the run has gone on.)")
        .def_property_readonly(
            "configuration",
            [](const Result& result) { return Configuracion(result.run()->configuration()); },
            "A copy of the configuration that was run.");
    define_method(
        cls, "write", &written, py::arg("folder"), py::arg("also") = py::none(),
        R"(Writes the files of `hitos-cli run --out`, byte for byte but for times: map, segments,
drawing, trajectories, grids, pictures, configuration, summary. They appear together or not at all.
Gives the summary.

also: further files, as the command line's --write has them: their names or their words, one str
with commas between or several ("svg", ["map.svg", "g2o"]), or "all".)");
}

}  // namespace

void bind_runs(py::module_& module) {
    bind_progress(module);
    bind_result(module);
    py::class_<Run, std::shared_ptr<Run>> cls(module, "Run", R"(A run, scan by scan.

    run = hitos.Run("bigloop", {"filter.particles": 50})
    for snapshot in run:
        print(snapshot.scans, snapshot.pose)
    result = run.result()

Snapshots never change: those that are kept stay what they were. A run is for one thread at a time;
several runs go on side by side. A result has seen the whole tour once `finished`.)");
    define_init(cls, &made_run, py::arg("tour"), py::arg("configuration") = py::none(),
                py::kw_only(), py::arg("reference") = py::none(),
                py::arg("reference_trajectory") = py::none(), py::arg("distances") = py::none(),
                py::arg("uncertainty") = false, "Arguments as those of hitos.run().");
    define_method(cls, "step", &stepped, py::arg("scans") = 1,
                  R"(Takes so many scans, or fewer at the end of the tour, and gives the Snapshot
after them; None where the tour was over.)");
    define_method(cls, "finish", &finished, py::arg("progress") = py::none(),
                  "Goes on to the end of the tour and gives the Result; progress as in "
                  "hitos.run().");
    cls.def(
           "__iter__", [](py::object self) { return self; }, "Itself.")
        .def("__next__", &next, "Takes one scan and gives the Snapshot after it.")
        .def("snapshot", &Run::snapshot, "What the run is now.")
        .def("result", &Run::result, "The Result of what was run so far.")
        .def_property_readonly("progress", &Run::progress, "How far it has come.")
        .def_property_readonly(
            "configuration", [](const Run& run) { return Configuracion(run.configuration()); },
            "A copy of its configuration.");
    define(module, "run", &run_to_the_end, py::arg("tour"), py::arg("configuration") = py::none(),
           py::kw_only(), py::arg("progress") = py::none(), py::arg("out") = py::none(),
           py::arg("reference") = py::none(), py::arg("reference_trajectory") = py::none(),
           py::arg("distances") = py::none(), py::arg("uncertainty") = false,
           py::arg("also") = py::none(),
           R"(Runs a tour to its end and gives the Result.

tour: what hitos.open() gave, or takes. A Tour brings its source.* parameters along; of a name the
configuration's stand.
configuration: a Configuration, a dict of parameters over the defaults (over the preset that suits
the tour, as `hitos-cli run` takes it), or None.
progress: called with a Progress some times a second and at the end; False ends the run there.
out: a folder for the files that `hitos-cli run` writes. A run that was ended before does not take
the place of one to its tour's end there, and warns of that.
reference: a map file, reference_trajectory: a TUM file or an N x 4 array of t, x, y, theta (default
for a world: the true path), distances: a file of named distances, to measure the run against; they
show in Result.summary. Files are taken for what they hold, a map or a trajectory. A trajectory of
another tour raises Error; one that tells of less than half of the scans warns.
uncertainty: record the standard deviations of the landmarks, for the files.
also: further files for that folder, as in Result.write().

The interpreter goes on while the run computes. Ctrl+C ends the run after the scan under way, leaves
no files, and raises KeyboardInterrupt. What is wrong with tour or configuration raises Error, one of
FileError, FormatError and ConfigurationError.)");
}

}  // namespace hitos::python
