// SPDX-License-Identifier: GPL-3.0-or-later
// Studies: run_studies(), which window and command line use too.

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "arrays.hpp"
#include "configuration.hpp"
#include "hitos/base/text_table.hpp"
#include "hitos/services/study/study.hpp"
#include "hitos/simulation/worlds/odometry_noise.hpp"
#include "hitos/workbench/study_noise.hpp"
#include "python_calls.hpp"
#include "references.hpp"
#include "tours.hpp"

namespace hitos::python {
namespace {

using std::filesystem::path;

/// A finished study; immutable.
struct StudyTable {
    StudyOutcome outcome;
    std::vector<StudyCell> cells;
    path folder;
};

py::array runs_of(const StudyTable& table) {
    const StudyPlan& plan = table.outcome.plan;
    const std::vector<StudyRecord>& records = table.outcome.records;
    py::list types;
    py::dict columns;
    const auto add = [&](const std::string& name, const char* format, const auto& value_of) {
        py::list column;
        for (std::size_t run = 0; run < records.size(); ++run) column.append(value_of(run));
        types.append(py::make_tuple(name, format));
        columns[py::str(name)] = column;
    };
    add("cell", "i8", [&](std::size_t run) { return plan.cell_of(run); });
    add("seed", "u8", [&](std::size_t run) { return plan.seed_of(run); });
    add("ok", "?", [&](std::size_t run) { return records[run].ok; });
    for (const Measure* measure : taken_measures()) {
        const bool count = measure->is_count();
        add(measure->stem(), count ? "i4" : "f8", [&](std::size_t run) {
            return records[run].figures[*measure].value_or(count ? 0.0 : kNan);
        });
    }
    add("scans", "u8", [&](std::size_t run) { return records[run].scans; });
    add("seconds", "f8", [&](std::size_t run) { return records[run].seconds; });
    py::array all(py::dtype::from_args(types), records.size());
    for (const auto& [name, column] : columns) all[name] = column;
    all.attr("flags").attr("writeable") = false;
    return all;
}

py::object dict_of(const std::optional<Spread>& spread) {
    if (!spread) return py::none();
    py::dict values;
    values["count"] = spread->count;
    values["mean"] = spread->mean;
    values["variance"] = spread->variance;
    values["minimum"] = spread->minimum;
    values["maximum"] = spread->maximum;
    return static_cast<py::object>(values);
}

py::list cells_of(const StudyTable& table) {
    const std::vector<std::string> keys = table.outcome.plan.keys();
    py::list all;
    for (const StudyCell& cell : table.cells) {
        py::dict values;
        py::dict set;
        for (std::size_t i = 0; i < keys.size(); ++i) set[py::str(keys[i])] = cell.texts.at(i);
        values["values"] = set;
        values["finished"] = cell.finished;
        values["failed"] = cell.failed;
        for (const Measure* measure : taken_measures())
            values[py::str(measure->stem())] = dict_of(cell.figures[*measure]);
        all.append(values);
    }
    return all;
}

/// "10:100:10" as the command line has it, or a list of values; the values of a name that sets
/// several keys are tuples.
StudyParameter parameter_of(const std::string& name, const py::handle& values) {
    if (py::isinstance<py::str>(values)) {
        return parse_study_parameter(name + "=" + py::cast<std::string>(values));
    }
    if (!py::isinstance<py::iterable>(values)) {
        refuse_argument("vary", "the values of " + name + " as a list or a str like \"10:100:10\"",
                        values);
    }
    StudyParameter parameter = find_study_parameter(name);
    std::vector<std::string> words;
    for (const py::handle value : py::reinterpret_borrow<py::object>(values)) {
        if (py::isinstance<py::tuple>(value) || py::isinstance<py::list>(value)) {
            for (const py::handle part : py::reinterpret_borrow<py::object>(value)) {
                words.push_back(text_of(part));
            }
        } else {
            words.push_back(text_of(value));
        }
    }
    set_values(parameter, words);
    return parameter;
}

/// The newest that the study has said; written by its threads, read by Python's.
class Said {
  public:
    void note(const StudyProgress& now) {
        const std::scoped_lock lock(mutex_);
        newest_ = now;
    }
    std::optional<StudyProgress> take() {
        const std::scoped_lock lock(mutex_);
        return std::exchange(newest_, std::nullopt);
    }

  private:
    std::mutex mutex_;
    std::optional<StudyProgress> newest_;
};

StudyOutcome conducted(const Study& study, int threads, const py::object& told) {
    const Work under_way;
    Said said;
    std::stop_source stop;
    StudyOptions how;
    how.threads = threads;
    how.stop = stop.get_token();
    if (!told.is_none()) how.observer = [&said](const StudyProgress& now) { said.note(now); };
    std::future<StudyOutcome> done = std::async(std::launch::async, [&] {
        return std::move(run_studies({&study, 1}, how).front());
    });
    const auto end = [&] {
        stop.request_stop();
        without_python([&] { done.wait(); });
    };
    bool going = true;
    while (going) {
        going = without_python([&] { return done.wait_for(kPoll) != std::future_status::ready; });
        try {
            if (interrupted()) throw py::error_already_set();
            const std::optional<StudyProgress> now = said.take();
            if (now && told(*now).ptr() == Py_False) end();
        } catch (const py::error_already_set&) {
            end();
            throw;
        }
    }
    return without_python([&] { return done.get(); });
}

std::shared_ptr<StudyTable> study_of(const py::object& tour, const py::dict& vary,
                                     const py::object& configuration, const path& out, int runs,
                                     std::uint64_t first_seed, int threads,
                                     const std::optional<path>& reference,
                                     const py::object& reference_trajectory, double odometry_noise,
                                     const std::string& noise_kind, const std::string& pictures,
                                     const py::object& progress) {
    require_callable(progress, "progress", true);
    Study study;
    study.configuration = configuration_for(tour_argument(tour), configuration);
    References references = references_of(reference, reference_trajectory);
    if (references.map) study.reference = *std::move(references.map);
    study.reference_trajectory = std::move(references.trajectory);
    for (const auto& [name, values] : vary) {
        study.parameters.push_back(parameter_of(key_of(name, "vary"), values));
    }
    check_values(study.configuration, study.parameters);
    study.seeds = runs;
    study.first_seed = first_seed;
    study.pictures = parse_study_pictures(pictures, "pictures");
    study.layout = study_in_folder(out);
    set_study_source(study, odometry_noise, parse_noise_kind(noise_kind, "noise_kind"));
    auto table = std::make_shared<StudyTable>();
    table->outcome = conducted(study, threads, progress);
    table->folder = study.layout.folder;
    check_any(table->outcome);
    for (const Advice& doubt : table->outcome.doubts) tell(doubt);
    table->cells = summarize(table->outcome.plan, table->outcome.records);
    return table;
}

void bind_study_progress(py::module_& module) {
    py::class_<StudyProgress>(module, "StudyProgress", "How far a study has come.")
        .def_readonly("runs", &StudyProgress::runs, "Runs to do, without those found done.")
        .def_readonly("finished", &StudyProgress::finished, "Of these, the failed among them.")
        .def_readonly("failed", &StudyProgress::failed, "Runs that failed.")
        .def_readonly("reused", &StudyProgress::reused, "Runs found done in the folder.")
        .def_readonly("fraction", &StudyProgress::fraction, "Part of the runs to do, 0 … 1.")
        .def_readonly("running", &StudyProgress::running, "What a run under way is.")
        .def_readonly("failure", &StudyProgress::failure,
                      "A run that has just failed, with the reason; else \"\".");
}

std::string with_figures(std::string help) {
    for (const Measure* measure : taken_measures())
        help +=
            fmt::format("\n{}: {}", with_unit(measure->stem(), measure->unit), measure->purpose);
    return help;
}

void bind_table(py::module_& module) {
    const std::string runs_help = with_figures(
        R"(A structured array with a row for every run: cell (the place in cells), seed, ok, the
figures, scans, seconds; nan where there is nothing to measure against. The figures are)");
    const std::string cells_help = with_figures(
        R"(One dict for every value, or pair of values: "values" (key to text), "finished" and
"failed" runs, and for every figure a dict of count, mean, variance, minimum and maximum over the
runs, or None. The figures are)");
    py::class_<StudyTable, std::shared_ptr<StudyTable>>(module, "Study", R"(What a study has found:
values of parameters, each run with several seeds.)")
        .def_property_readonly("runs", &runs_of, runs_help.c_str())
        .def_property_readonly("cells", &cells_of, cells_help.c_str())
        .def_property_readonly(
            "keys", [](const StudyTable& t) { return t.outcome.plan.keys(); },
            "The keys that were varied.")
        .def_property_readonly(
            "computed", [](const StudyTable& t) { return t.outcome.computed; },
            "Runs done by this call.")
        .def_property_readonly(
            "reused", [](const StudyTable& t) { return t.outcome.reused; },
            "Runs found done in the folder.")
        .def_property_readonly(
            "failed", [](const StudyTable& t) { return t.outcome.failed; }, "Runs that failed.")
        .def_property_readonly(
            "stopped", [](const StudyTable& t) { return t.outcome.stopped; },
            "Whether it was stopped before every run was done.")
        .def_property_readonly(
            "folder", [](const StudyTable& t) { return t.folder.string(); },
            "Where its files lie: tables, plots, the map of every run.")
        .def(
            "to_csv", [](const StudyTable& t) { return summary_csv(t.outcome.plan, t.cells); },
            "The summary as comma-separated text.")
        .def(
            "to_markdown",
            [](const StudyTable& t) { return summary_markdown(t.outcome.plan, t.cells); },
            "The summary as a table.")
        .def("__repr__", [](const StudyTable& t) {
            return fmt::format("<Study of {} values, {} runs>", t.cells.size(),
                               t.outcome.records.size());
        });
}

}  // namespace

void bind_studies(py::module_& module) {
    bind_study_progress(module);
    bind_table(module);
    define(
        module, "study", &study_of, py::arg("tour"), py::arg("vary"),
        py::arg("configuration") = py::none(), py::kw_only(), py::arg("out"), py::arg("runs") = 5,
        py::arg("first_seed") = 1, py::arg("threads") = 0, py::arg("reference") = py::none(),
        py::arg("reference_trajectory") = py::none(), py::arg("odometry_noise") = 0.0,
        py::arg("noise_kind") = "relative-sigma", py::arg("pictures") = "none",
        py::arg("progress") = py::none(),
        R"(Runs values of parameters with several seeds each, as `hitos-cli study` does, and gives a
Study. Tables, plots and the runs lie in the folder `out`; a study that was stopped goes on there.

vary: the values of none, one or two parameters, by key or by the thesis's name:
{"filter.particles": [20, 50, 100]}, {"p": "20:100:20"}, {"sensor": [(0.04, 0.00122)]}.
runs: runs of each value, with the seeds from first_seed on. threads: runs at a time, 0 for as many
as the machine has. reference, reference_trajectory: as in hitos.run(). odometry_noise: level of the
noise that every run gets on its odometry; the thesis uses 0.1. pictures: "none", "first" or "all".
progress: called with a StudyProgress; False stops the study. Ctrl+C stops it and raises
KeyboardInterrupt; what is done stays done.)");
}

}  // namespace hitos::python
