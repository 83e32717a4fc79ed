// SPDX-License-Identifier: GPL-3.0-or-later
// Tours: logs, recordings and worlds, their scans and their odometry.

#include "tours.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "arrays.hpp"
#include "configuration.hpp"
#include "hitos/capture/tour_summary.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "python_calls.hpp"

namespace hitos::python {
namespace {

/// `argument` is its name, `expected` what it may be.
std::string file_of(const py::object& name, const char* argument, const char* expected) {
    py::detail::make_caster<std::filesystem::path> path;
    if (!path.load(name, true)) refuse_argument(argument, expected, name);
    return source_named(py::detail::cast_op<std::filesystem::path&>(path).string());
}

struct OpenOptions {
    std::string format;
    std::string scan_topic;
    std::string odom_topic;
    double max_range = 0.0;
    std::string odometry;
    std::string early_scans;
    py::object world_set;
    std::uint64_t tour_seed = 0;
};

SourceParams source_of(const py::object& name, const OpenOptions& options) {
    Configuracion configuration;
    configuration.source.file =
        file_of(name, "source", "a path or the name of a world (str, bytes or os.PathLike)");
    const auto set = [&](const char* key, const std::string& value) {
        find_parameter(key).set(configuration, value);
    };
    set("source.format", options.format);
    set("source.scan_topic", options.scan_topic);
    set("source.odom_topic", options.odom_topic);
    set("source.max_range", fmt::format("{}", options.max_range));
    set("source.odometry", options.odometry);
    set("source.early_scans", options.early_scans);
    set("source.world_set", world_set_of(options.world_set));
    set("source.tour_seed", fmt::format("{}", options.tour_seed));
    return configuration.source;
}

/// Gives the scans of a tour one after another.
class ScanIterator {
  public:
    explicit ScanIterator(std::unique_ptr<TourReader> reader) : reader_(std::move(reader)) {}

    std::optional<ScanView> next() {
        return without_python([this]() -> std::optional<ScanView> {
            const std::scoped_lock lock(mutex_);
            std::optional<Scan> scan = reader_->next_scan();
            if (!scan) return std::nullopt;
            return ScanView(std::make_shared<const Scan>(*std::move(scan)));
        });
    }

  private:
    std::mutex mutex_;
    std::unique_ptr<TourReader> reader_;
};

py::array odometry_of(const Tour& tour) {
    auto readings = std::make_shared<std::vector<Odometria>>();
    const std::unique_ptr<TourReader> reader = tour.reopened();
    bool more = true;
    while (more) {
        constexpr int kAtOnce = 10000;
        more = without_python([&] {
            for (int i = 0; i < kAtOnce; ++i) {
                std::optional<Odometria> reading = reader->next_odometry();
                if (!reading) return false;
                readings->push_back(*reading);
            }
            return true;
        });
        if (interrupted()) throw py::error_already_set();
    }
    const double* const first = readings->empty() ? nullptr : &readings->front().time_s;
    return view_of_members(first, readings->size(), sizeof(Odometria), 4, readings);
}

std::string shown_tour(const Tour& tour) {
    return fmt::format("<Tour {} ({})>", tour.reader().name(), tour.reader().format());
}

py::dict dict_of(const ReadReport& report) {
    py::dict values;
    values["scans"] = report.scans;
    values["odometry"] = report.odometry;
    values["duplicate_scans"] = report.duplicate_scans;
    values["stamps_backwards"] = report.stamps_backwards;
    values["early_scans"] = report.early_scans;
    values["early_scans_left_out"] = report.early_scans_left_out;
    values["skipped"] = report.skipped;
    py::list examples;
    for (const ReadReport::Skip& skip : report.examples) {
        examples.append(py::make_tuple(skip.line, skip.reason.english()));
    }
    values["examples"] = examples;
    return values;
}

py::dict summary_of(const Tour& tour) {
    const std::unique_ptr<TourReader> reader = tour.reopened();
    const TourSummary summary = without_python([&] {
        return inspect_tour(*reader, [](double /*fraction*/) {
            return !with_python([] {
                if (interrupted()) throw py::error_already_set();
                return false;
            });
        });
    });
    py::dict values = dict_of(summary.report);
    values["format"] = summary.format;
    values["first_stamp"] = summary.first_stamp_s;
    values["duration"] = summary.duration_s;
    values["distance"] = summary.distance_m;
    return values;
}

std::shared_ptr<Tour> opened(const py::object& source, std::string format, std::string scan_topic,
                             std::string odom_topic, double max_range, std::string odometry,
                             std::string early_scans, py::object world_set, std::uint64_t tour_seed,
                             std::uint64_t seed) {
    SourceParams params = source_of(
        source, {std::move(format), std::move(scan_topic), std::move(odom_topic), max_range,
                 std::move(odometry), std::move(early_scans), std::move(world_set), tour_seed});
    return without_python([&] { return std::make_shared<Tour>(std::move(params), seed); });
}

py::array pose_array(const Pose& pose) {
    auto kept = std::make_shared<const Pose>(pose);
    const double* const first = &kept->x;
    return view(py::dtype::of<double>(), {3}, {sizeof(double)}, first, std::move(kept));
}

py::array landmarks_of(const ScanView& scan) {
    using Seen = LandmarkSighting;
    const std::vector<Field> fields = {{"identity", "i4", offsetof(Seen, identity)},
                                       {"range", "f8", offsetof(Seen, range_m)},
                                       {"bearing", "f8", offsetof(Seen, bearing_rad)}};
    return view_of_rows(
        std::shared_ptr<const std::vector<Seen>>(scan.scan(), &scan.scan()->landmarks), fields);
}

void bind_scan(py::module_& module) {
    py::class_<ScanView>(module, "Scan", R"(One laser scan. Its points are what the laser hit, in
the robot's frame, in the order of the rays; rays without a usable reading leave none. All arrays
are read-only views of the scan's own memory and keep it alive.)")
        .def_property_readonly(
            "time", [](const ScanView& s) { return s.scan()->stamp_s(); }, "Stamp as logged [s].")
        .def_property_readonly(
            "points", [](const ScanView& s) { return view_of(s.scan()->points, s.scan()); },
            "N x 2: x, y of every point in the robot's frame [m].")
        .def_property_readonly(
            "ranges",
            [](const ScanView& s) {
                const auto& polar = *s.polar();
                const double* const first = polar.empty() ? nullptr : &polar.front().x;
                return view_of_members(first, polar.size(), sizeof(Point2), 0, s.polar());
            },
            "N: distance of every point from the laser [m].")
        .def_property_readonly(
            "angles",
            [](const ScanView& s) {
                const auto& polar = *s.polar();
                const double* const first = polar.empty() ? nullptr : &polar.front().y;
                return view_of_members(first, polar.size(), sizeof(Point2), 0, s.polar());
            },
            "N: direction of every point in the laser's frame [rad].")
        .def_property_readonly(
            "rays",
            [](const ScanView& s) {
                const auto& rays = s.scan()->rays;
                return view_of_members(rays.data(), rays.size(), sizeof(std::uint32_t), 0,
                                       s.scan());
            },
            "N: number of the ray of every point; empty where the log does not say.")
        .def_property_readonly(
            "run_starts",
            [](const ScanView& s) {
                const auto& starts = s.scan()->run_starts;
                return view_of_members(starts.data(), starts.size(), sizeof(std::uint32_t), 0,
                                       s.scan());
            },
            "Index of the first point of each run of neighbours.")
        .def_property_readonly(
            "ray_count", [](const ScanView& s) { return s.scan()->fan.count; },
            "Rays of the fan; 0 where the log does not say.")
        .def_property_readonly(
            "first_angle", [](const ScanView& s) { return s.scan()->fan.min_angle_rad; },
            "Angle of ray 0 in the laser's frame [rad].")
        .def_property_readonly(
            "angle_step", [](const ScanView& s) { return s.scan()->fan.step_rad(); },
            "From one ray to the next [rad].")
        .def_property_readonly(
            "max_range", [](const ScanView& s) { return s.scan()->fan.max_range_m; },
            "The laser's greatest range [m]; 0 where the log does not say.")
        .def_property_readonly(
            "laser_pose",
            [](const ScanView& s) { return pose_array(s.scan()->fan.pose_robot_laser); },
            "x, y, theta of the laser in the robot's frame [m, m, rad].")
        .def_property_readonly(
            "line", [](const ScanView& s) { return s.scan()->line; },
            "Line of the log, or number of the message, from 1.")
        .def_property_readonly(
            "landmarks", &landmarks_of,
            R"(Landmarks that a sensor told by themselves, a structured array: identity, -1 where the
sensor does not tell it, range [m] and bearing [rad] in the robot's frame.)")
        .def(
            "__len__", [](const ScanView& s) { return s.scan()->points.size(); },
            "How many points it has.")
        .def("__repr__", [](const ScanView& s) {
            return fmt::format("<Scan at {:.3f} s: {} points>", s.scan()->time_s,
                               s.scan()->points.size());
        });
}

void bind_truth(py::module_& module) {
    using Held = std::shared_ptr<Truth>;
    py::class_<Truth, Held>(module, "Truth",
                            "What is known to be true of a simulated tour, in the "
                            "frame of its first pose.")
        .def_property_readonly(
            "trajectory", [](const Held& truth) { return view_of(truth->path, truth); },
            "N x 4: t, x, y, theta of the robot at every scan [s, m, m, rad].")
        .def_property_readonly(
            "walls",
            [](const Held& truth) {
                const double* const first =
                    truth->walls.empty() ? nullptr : &truth->walls.front().first.x;
                return view_of_segments(first, truth->walls.size(), sizeof(Walls::value_type),
                                        truth);
            },
            "K x 2 x 2: both ends of every wall [m].")
        .def_property_readonly(
            "seed", [](const Held& truth) { return truth->seed; },
            "Seed of the noise of its laser and its odometry.");
}

void bind_tour(py::module_& module) {
    py::class_<ScanIterator>(module, "ScanIterator", "The scans of a tour, one after another.")
        .def(
            "__iter__", [](py::object self) { return self; }, "Itself.")
        .def(
            "__next__",
            [](ScanIterator& scans) {
                std::optional<ScanView> scan = scans.next();
                if (!scan) throw py::stop_iteration();
                return *std::move(scan);
            },
            "The next scan.");
    py::class_<Tour, std::shared_ptr<Tour>>(module, "Tour", R"(A log, a recording or a simulated
world, as hitos.open() gives it. It is not held in memory: every loop over it reads it anew, from
its beginning, and several may go on at a time.

    for scan in hitos.open("bigloop"):
        print(scan.time, scan.ranges.min()))")
        .def(
            "__iter__",
            [](const Tour& tour) { return std::make_unique<ScanIterator>(tour.reopened()); },
            "Its scans, one after another.")
        .def(
            "odometry", &odometry_of,
            R"(Reads all odometry: N x 4 of t, v, v_lateral, w [s, m/s, m/s, rad/s], where the twist
is the one held since the reading before.)")
        .def("summary", &summary_of,
             R"(Reads the whole tour and says what it holds: a dict of format, scans, odometry,
first_stamp, duration [s], distance [m], and what was left out (skipped, duplicate_scans,
stamps_backwards, early_scans_left_out; early_scans are those before the first odometry reading that
are used all the same; `examples` are lines, or messages of a recording, with reasons).)")
        .def_property_readonly(
            "name", [](const Tour& tour) { return tour.reader().name(); }, "Its file.")
        .def_property_readonly(
            "format", [](const Tour& tour) { return tour.reader().format(); },
            "\"carmen\", \"mcap\", … or \"world\".")
        .def_property_readonly("truth", &Tour::truth,
                               "The true path and walls of a simulated tour; None of a log.")
        .def("__repr__", &shown_tour);
}

}  // namespace

const std::shared_ptr<const std::vector<Point2>>& ScanView::polar() const {
    if (!polar_) {
        auto polar = std::make_shared<std::vector<Point2>>();
        polar->reserve(scan_->points.size());
        const Pose pose_laser_robot = inverse(scan_->fan.pose_robot_laser);
        for (const Point2& point : scan_->points) {
            const Point2 seen = transform(pose_laser_robot, point);
            polar->push_back({std::hypot(seen.x, seen.y), std::atan2(seen.y, seen.x)});
        }
        polar_ = std::move(polar);
    }
    return polar_;
}

Tour::Tour(SourceParams source, std::uint64_t seed)
    : source_(std::move(source)), reader_(open_tour(source_, seed)) {}

std::unique_ptr<TourReader> Tour::reopened() const {
    return without_python([this] { return reader_->reopen(); });
}

std::shared_ptr<Truth> Tour::truth() const {
    if (!truth_) {
        auto known = without_python([this] { return reader_->truth(); });
        // Another thread may have been here meanwhile.
        if (known && !truth_) truth_ = std::make_shared<Truth>(*std::move(known));
    }
    return truth_;
}

TourArgument tour_argument(const py::object& tour) {
    if (py::isinstance<Tour>(tour)) return {py::cast<const Tour&>(tour).source(), true};
    SourceParams source;
    source.file =
        file_of(tour, "tour", "a Tour, a path or the name of a world (str, bytes or os.PathLike)");
    return {std::move(source), false};
}

Configuracion configuration_for(const TourArgument& tour, const py::object& given) {
    Configuracion configuration = configuration_from(given, tour.source.file);
    if (tour.opened) {
        const std::string map = std::exchange(configuration.source, tour.source).map;
        configuration.source.map = map;
    } else {
        configuration.source.file = tour.source.file;
    }
    check(configuration);
    return configuration;
}

void bind_tours(py::module_& module) {
    bind_scan(module);
    bind_truth(module);
    bind_tour(module);
    define(module, "open", &opened, py::arg("source"), py::kw_only(), py::arg("format") = "auto",
           py::arg("scan_topic") = "", py::arg("odom_topic") = "", py::arg("max_range") = 0.0,
           py::arg("odometry") = "poses", py::arg("early_scans") = "keep",
           py::arg("world_set") = py::none(), py::arg("tour_seed") = 0, py::arg("seed") = 1,
           R"(Opens a log (Player, Radish, CARMEN, normalised; plain or gzip), a ROS recording (bag,
MCAP, .db3, folder), a world file (.toml) to simulate, or the world of that name that comes with
Hitos, and gives a Tour.

The options are the parameters source.* of a configuration. `world_set` changes values of a world,
e.g. {"laser.sigma": 0.003, "tour.laps": 2}. `seed` draws a world's noise where neither `tour_seed`
nor the world itself says another; a run draws it by its own run.seed. Raises FileError,
FormatError or ConfigurationError.)");
}

}  // namespace hitos::python
