// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots of runs: what a run is after a scan, as arrays.

#include "snapshots.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <utility>

#include "arrays.hpp"
#include "hitos/services/results/results.hpp"
#include "tours.hpp"

namespace hitos::python {
namespace {

using HeldState = std::shared_ptr<State>;

LandmarkRow row_of(const ICaracteristica& landmark) {
    LandmarkRow row{word_of(to_string(landmark.kind())),
                    kNan,
                    kNan,
                    landmark.point().x,
                    landmark.point().y,
                    landmark.observations,
                    landmark.first_seen,
                    landmark.last_seen,
                    landmark.identity};
    if (const Recta* line = std::get_if<Recta>(&landmark.value)) {
        row.rho = line->rho;
        row.theta = line->theta;
    }
    return row;
}

AssociationRow row_of(const Association& association) {
    constexpr std::array kOutcomes = {"matched", "created", "ignored"};
    return {word_of(to_string(association.kind)), association.observed,
            word_of(kOutcomes.at(static_cast<std::size_t>(association.outcome))),
            association.landmark};
}

std::vector<Field> landmark_fields() {
    return {{"kind", "U7", offsetof(LandmarkRow, kind)},
            {"rho", "f8", offsetof(LandmarkRow, rho)},
            {"theta", "f8", offsetof(LandmarkRow, theta)},
            {"x", "f8", offsetof(LandmarkRow, x)},
            {"y", "f8", offsetof(LandmarkRow, y)},
            {"observations", "i4", offsetof(LandmarkRow, observations)},
            {"first_seen", "u4", offsetof(LandmarkRow, first_seen)},
            {"last_seen", "u4", offsetof(LandmarkRow, last_seen)},
            {"identity", "i4", offsetof(LandmarkRow, identity)}};
}

std::vector<Field> association_fields() {
    return {{"kind", "U7", offsetof(AssociationRow, kind)},
            {"observed", "u4", offsetof(AssociationRow, observed)},
            {"outcome", "U7", offsetof(AssociationRow, outcome)},
            {"landmark", "i4", offsetof(AssociationRow, landmark)}};
}

FiguresRow row_of(const StepFigures& step) {
    const Pose& pose = step.online.pose;
    return {step.time_s,       pose.x,          pose.y,
            pose.theta,        step.neff,       step.best_log_weight,
            step.step_seconds, step.unseen_s,   step.lines,
            step.corners,      step.seen_lines, step.seen_corners,
            step.matched,      step.created,    step.ignored,
            step.skipped,      step.resampled,  step.best_changed,
            step.loop_closed};
}

/// Of the hypotheses: numbers from `first` on.
template <class Number>
py::array of_hypotheses(const HeldState& state, const Number WeightedPose::*member, int columns) {
    const auto& all = state->shown()->hypotheses;
    const auto* const first = all.empty() ? nullptr : &(all.front().*member);
    if constexpr (std::is_same_v<Number, Pose>) {
        return view_of_members(first != nullptr ? &first->x : nullptr, all.size(),
                               sizeof(WeightedPose), columns, state->shown());
    } else {
        return view_of_members(first, all.size(), sizeof(WeightedPose), columns, state->shown());
    }
}

py::array pose_of(const HeldState& state, const Pose Snapshot::*pose) {
    return view(py::dtype::of<double>(), {3}, {sizeof(double)}, &((*state->shown()).*pose).x,
                state->shown());
}

using Class = py::class_<State, HeldState>;

void bind_paths(Class& snapshot) {
    snapshot
        .def_property_readonly(
            "trajectory",
            [](const HeldState& s) { return view_of(s->shown()->best_trajectory, s->shown()); },
            R"(N x 4: t, x, y, theta of the best hypothesis at every scan so far [s, m, m, rad], with
all that was learnt since.)")
        .def_property_readonly(
            "online_trajectory",
            [](const HeldState& s) { return view_of(s->shown()->online_trajectory, s->shown()); },
            "N x 4: likewise, as it was at each scan, before anything later corrected it.")
        .def_property_readonly(
            "odometry",
            [](const HeldState& s) { return view_of(s->shown()->odometry_trajectory, s->shown()); },
            "N x 4: likewise by odometry alone, from (0, 0, 0).")
        .def_property_readonly(
            "pose", [](const HeldState& s) { return pose_of(s, &Snapshot::best_pose); },
            "x, y, theta of the best hypothesis [m, m, rad].")
        .def_property_readonly(
            "mean_pose", [](const HeldState& s) { return pose_of(s, &Snapshot::mean_pose); },
            "x, y, theta: the weighted mean of all hypotheses.")
        .def_property_readonly(
            "pose_covariance",
            [](const HeldState& s) {
                // Eigen keeps columns together.
                return view(py::dtype::of<double>(), {3, 3}, {sizeof(double), 3 * sizeof(double)},
                            s->shown()->pose_covariance.data(), s->shown());
            },
            "3 x 3: covariance of (x, y, theta) about mean_pose.")
        .def_property_readonly(
            "particles",
            [](const HeldState& s) { return of_hypotheses(s, &WeightedPose::pose, 3); },
            "M x 3: x, y, theta of every hypothesis, after resampling.")
        .def_property_readonly(
            "weights",
            [](const HeldState& s) { return of_hypotheses(s, &WeightedPose::weight, 0); },
            "M: their weights, which sum to 1; equal just after resampling.")
        .def_property_readonly(
            "weights_before",
            [](const HeldState& s) { return of_hypotheses(s, &WeightedPose::weight_before, 0); },
            "M: the weight before the last resampling of the one that each was drawn from.")
        .def_property_readonly(
            "best", [](const HeldState& s) { return s->shown()->best_hypothesis; },
            "The place of the best hypothesis in particles.")
        .def_property_readonly(
            "loops",
            [](const HeldState& s) { return parsed(to_json(std::span(s->shown()->loops))); },
            R"(Every place that looked like one of an earlier passage, by scans, as a list of dicts:
scan and earlier, counted from 1, verdict ("closed", or why not), and the figures of
docs/formats.md. Empty where the algorithm registers no scans.)");
}

void bind_map(Class& snapshot) {
    snapshot
        .def_property_readonly(
            "landmarks",
            [](const HeldState& s) { return view_of_rows(s->landmarks(), landmark_fields()); },
            R"(The best hypothesis' map, a structured array, lines before corners: kind ("line",
"corner"), rho [m] and theta [rad] of a line (nan of a corner), x and y [m] of a corner or of the
line's foot, observations, the numbers of the scans first_seen and last_seen, and
the identity that a sensor told, or -1.)")
        .def_property_readonly(
            "covariances",
            [](const HeldState& s) {
                constexpr py::ssize_t kRow = 2 * sizeof(double);
                const auto count = static_cast<py::ssize_t>(s->landmarks()->size());
                return view(py::dtype::of<double>(), {count, 2, 2},
                            {2 * kRow, kRow, sizeof(double)}, s->covariances()->data(),
                            s->covariances());
            },
            "M x 2 x 2: covariance of (rho, theta) of each line and of (x, y) of each corner.")
        .def_property_readonly(
            "segments",
            [](const HeldState& s) {
                const auto& extents = s->shown()->line_extents;
                return view_of_segments(extents.empty() ? nullptr : &extents.front().a.x,
                                        extents.size(), sizeof(LineExtent), s->shown());
            },
            "K x 2 x 2: both ends of the stretches of lines that were seen [m].")
        .def_property_readonly(
            "segment_landmarks",
            [](const HeldState& s) {
                const auto& extents = s->shown()->line_extents;
                return view_of_members(extents.empty() ? nullptr : &extents.front().landmark,
                                       extents.size(), sizeof(LineExtent), 0, s->shown());
            },
            "K: the landmark that each segment belongs to.")
        .def_property_readonly(
            "grid",
            [](const HeldState& s) { return std::const_pointer_cast<GridArray>(s->grid()); },
            R"(The occupancy grid, drawn step by step from where the best hypothesis was; see
draw_grid() for grids along other paths.)");
}

void bind_scan_of(Class& snapshot) {
    snapshot
        .def_property_readonly(
            "scan",
            [](const HeldState& s) {
                return ScanView(std::shared_ptr<const Scan>(s->shown(), &s->shown()->scan));
            },
            "The last scan.")
        .def_property_readonly(
            "observed_lines",
            [](const HeldState& s) {
                const auto& lines = s->shown()->observation.lines;
                return view_of_members(lines.empty() ? nullptr : &lines.front().recta.rho,
                                       lines.size(), sizeof(DetectedLine), 2, s->shown());
            },
            "L x 2: rho, theta of the lines found in it, in the robot's frame [m, rad].")
        .def_property_readonly(
            "observed_corners",
            [](const HeldState& s) {
                const auto& corners = s->shown()->observation.corners;
                return view_of_members(corners.empty() ? nullptr : &corners.front().x,
                                       corners.size(), sizeof(Esquina), 2, s->shown());
            },
            "C x 2: x, y of the corners found in it, in the robot's frame [m].")
        .def_property_readonly(
            "associations",
            [](const HeldState& s) {
                return view_of_rows(s->associations(), association_fields());
            },
            R"(What the best hypothesis made of them, a structured array: kind, observed (the place
in observed_lines or observed_corners), outcome ("matched", "created", "ignored") and landmark (the
place in landmarks; -1 where ignored).)");
}

}  // namespace

py::object parsed(const std::string& json) {
    return py::module_::import("json").attr("loads")(json);
}

Word word_of(std::string_view text) {
    Word word{};
    std::copy_n(text.begin(), std::min(text.size(), word.size()), word.begin());
    return word;
}

State::State(std::shared_ptr<const Snapshot> shown, bool finished)
    : shown_(std::move(shown)), finished_(finished) {
    auto rows = std::make_shared<std::vector<LandmarkRow>>();
    auto covariances = std::make_shared<std::vector<double>>();
    for (const ICaracteristica& landmark : shown_->best_map) {
        rows->push_back(row_of(landmark));
        const Eigen::Matrix2d& c = landmark.covariance;
        covariances->insert(covariances->end(), {c(0, 0), c(0, 1), c(1, 0), c(1, 1)});
    }
    landmarks_ = std::move(rows);
    covariances_ = std::move(covariances);
}

std::shared_ptr<const GridArray> State::grid() const {
    if (!grid_) grid_ = python::array_of(shown_->step_grid);
    return grid_;
}

std::shared_ptr<const std::vector<AssociationRow>> State::associations() const {
    if (!associations_) {
        auto rows = std::make_shared<std::vector<AssociationRow>>();
        for (const Association& one : shown_->associations) rows->push_back(row_of(one));
        associations_ = std::move(rows);
    }
    return associations_;
}

std::shared_ptr<const std::vector<FiguresRow>> rows_of(const std::vector<StepFigures>& figures) {
    auto rows = std::make_shared<std::vector<FiguresRow>>();
    for (const StepFigures& step : figures) rows->push_back(row_of(step));
    return rows;
}

py::array view_of(const std::shared_ptr<const std::vector<FiguresRow>>& figures) {
    return view_of_rows<FiguresRow>(
        figures, {{"time", "f8", offsetof(FiguresRow, time)},
                  {"x", "f8", offsetof(FiguresRow, x)},
                  {"y", "f8", offsetof(FiguresRow, y)},
                  {"theta", "f8", offsetof(FiguresRow, theta)},
                  {"neff", "f8", offsetof(FiguresRow, neff)},
                  {"best_log_weight", "f8", offsetof(FiguresRow, best_log_weight)},
                  {"step_seconds", "f8", offsetof(FiguresRow, step_seconds)},
                  {"unseen", "f8", offsetof(FiguresRow, unseen)},
                  {"lines", "i4", offsetof(FiguresRow, lines)},
                  {"corners", "i4", offsetof(FiguresRow, corners)},
                  {"seen_lines", "i4", offsetof(FiguresRow, seen_lines)},
                  {"seen_corners", "i4", offsetof(FiguresRow, seen_corners)},
                  {"matched", "i4", offsetof(FiguresRow, matched)},
                  {"created", "i4", offsetof(FiguresRow, created)},
                  {"ignored", "i4", offsetof(FiguresRow, ignored)},
                  {"skipped", "u8", offsetof(FiguresRow, skipped)},
                  {"resampled", "?", offsetof(FiguresRow, resampled)},
                  {"best_changed", "?", offsetof(FiguresRow, best_changed)},
                  {"loop_closed", "?", offsetof(FiguresRow, loop_closed)}});
}

void bind_snapshots(py::module_& module) {
    Class snapshot(module, "Snapshot", R"(What a run is after a scan. It never changes, and outlives
its run: all arrays are read-only views of its own memory and keep it alive. Poses are of the robot
in the world, whose origin is the robot's first pose: metres and radians.)");
    snapshot
        .def_property_readonly(
            "scans", [](const HeldState& s) { return s->shown()->steps; }, "Scans taken so far.")
        .def_property_readonly(
            "finished", [](const HeldState& s) { return s->finished(); },
            "Whether the tour is over, and what smooths the path has done it.")
        .def_property_readonly(
            "time", [](const HeldState& s) { return s->shown()->scan.stamp_s(); },
            "Stamp of the last scan [s].")
        .def("__repr__", [](const HeldState& s) {
            return fmt::format("<{} after {} scans: {} landmarks, {} particles>",
                               s->finished() ? "Finished run" : "Run", s->shown()->steps,
                               s->landmarks()->size(), s->shown()->hypotheses.size());
        });
    bind_paths(snapshot);
    bind_map(snapshot);
    bind_scan_of(snapshot);
}

}  // namespace hitos::python
