// SPDX-License-Identifier: GPL-3.0-or-later
// Registration on recorded tours: errors, events and time. No particle, no landmark, unless there
// is a preset, whose algorithm then takes every step too; the times are those of registration and
// algorithm together, without reading, lines, grids and files.
//
// usage: build/release/bench/bench_registration [--copies N] [--set NAME=VALUE]...
//            [--preset NAME] TOUR...
//
// TOUR is a world (.toml), whose copies have other seeds, or TOUR.log.gz and TOUR.gt.tum.gz are
// read. Copies are of the kind that tests/bench/real_tours makes: the first 3 n seconds left out,
// 10 mm of noise on ranges, 3 % on every step of the odometry and 3 mrad on its heading; copy 0 is
// the log as it is.

#include "hitos/registration/registration.hpp"

#include <fmt/core.h>

#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "hitos/features/control.hpp"
#include "hitos/features/extractor.hpp"
#include "hitos/services/evaluation/measures.hpp"
#include "hitos/services/files/trajectory_file.hpp"
#include "hitos/slam/filters.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/presets.hpp"

namespace {

using namespace hitos;
using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

struct Noise {
    int copy;
    std::mt19937_64 random;
    std::normal_distribution<double> normal;

    explicit Noise(int n) : copy(n), random(static_cast<std::uint64_t>(n) * 77 + 5) {}
    double draw() { return normal(random); }

    void disturb(Scan& scan) {
        if (copy == 0) return;
        for (Point2& p : scan.points) {
            const double range = std::hypot(p.x, p.y);
            const double factor = range > 0.0 ? std::max(0.02, range + 0.01 * draw()) / range : 1.0;
            p = {p.x * factor, p.y * factor};
        }
    }
    void disturb(std::vector<Control>& controls) {
        if (copy == 0) return;
        const double way = 1.0 + 0.03 * draw();
        const double turn = 1.0 + 0.03 * draw();
        const DrivenWay driven = driven_way(controls);
        const double extra = 0.003 * draw();
        if (!driven.moved()) return;
        for (Control& control : controls) {
            control.twist.v *= way;
            control.twist.v_lateral *= way;
            control.twist.w *= turn;
        }
        const double last = controls.back().duration_s;
        if (last > 0.0) controls.back().twist.w += extra / last;
    }
};

bool set(RegistrationParams& p, const std::string& assignment) {
    const std::size_t sign = assignment.find('=');
    if (sign == std::string::npos) return false;
    const std::string name = assignment.substr(0, sign);
    const double value = std::stod(assignment.substr(sign + 1));
    const std::map<std::string, double*> reals{{"range", &p.range_m},
                                               {"key_distance", &p.key_distance_m},
                                               {"key_angle", &p.key_angle_rad},
                                               {"point_sigma", &p.point_sigma_m},
                                               {"odometry_scale", &p.odometry_scale},
                                               {"loop_score", &p.loop_score}};
    const std::map<std::string, int*> integers{{"key_scans", &p.key_scans},
                                               {"loops_agree", &p.loops_agree},
                                               {"final_passes", &p.final_passes}};
    const std::map<std::string, bool*> choices{{"robust_prior", &p.robust_prior},
                                               {"search", &p.search},
                                               {"calibrate", &p.calibrate},
                                               {"loops", &p.loops}};
    if (const auto real = reals.find(name); real != reals.end()) {
        *real->second = value;
    } else if (const auto integer = integers.find(name); integer != integers.end()) {
        *integer->second = static_cast<int>(value);
    } else if (const auto choice = choices.find(name); choice != choices.end()) {
        *choice->second = value != 0.0;
    } else {
        return false;
    }
    return true;
}

double ate(const Trajectory& stamps, const std::vector<Pose>& poses, const Trajectory& reference) {
    Trajectory path;
    for (std::size_t i = 0; i < poses.size(); ++i) path.push_back({stamps[i].time_s, poses[i]});
    const auto error = trajectory_error(path, reference);
    return error ? error->rmse_m : -1.0;
}

/// The algorithm of a preset, beside the registration; nothing where there is no preset.
class Follower {
  public:
    explicit Follower(const std::string& preset) {
        if (preset.empty()) return;
        const Configuracion c = preset_configuration(preset);
        extractor_ = make_extractor(c.extraction, c.run.seed);
        filter_ = make_filter(c.filter, c.run.seed, 1);
    }
    void see(const Scan& scan) {
        if (filter_) extractor_->extract(scan, seen_);
    }
    void step(const Scan& scan, const std::vector<Control>& controls, const RegisteredStep& step,
              const std::optional<PathCorrection>& correction) {
        if (!filter_) return;
        filter_->step({scan, controls, seen_, &step});
        if (correction) filter_->correct(*correction);
    }

  private:
    std::unique_ptr<Extractor> extractor_;
    std::unique_ptr<SlamFilter> filter_;
    Observation seen_;
};

void run(const std::string& tour, int copy, const RegistrationParams& params,
         const std::string& preset) {
    SourceParams source;
    source.file = is_world_file(tour) ? tour : tour + ".log.gz";
    const auto log = open_tour(source, static_cast<std::uint64_t>(copy) + 1);
    const Trajectory reference =
        is_world_file(tour) ? log->truth()->path : read_trajectory(tour + ".gt.tum.gz");

    ControlTrack track([&] { return log->next_odometry(); });
    Noise noise(is_world_file(tour) ? 0 : copy);  // a world has noise of its own
    Registration registration(params);
    Follower follower(preset);
    OdometryPath odometry;
    std::vector<Pose> online;
    std::vector<Control> controls;
    double total = 0.0;
    std::vector<double> times;
    std::optional<double> first_s;
    while (auto scan = log->next_scan()) {
        track.controls_until(*scan, controls);
        if (!first_s) first_s = scan->time_s;
        if (scan->time_s < *first_s + 3.0 * copy) continue;
        if (online.empty()) controls.clear();
        noise.disturb(*scan);
        noise.disturb(controls);
        odometry.add(scan->time_s, controls);
        follower.see(*scan);
        const auto begin = Clock::now();
        const RegisteredStep step = registration.add(*scan, controls);
        follower.step(*scan, controls, step, registration.correction());
        times.push_back(ms_since(begin));
        total += times.back();
        online.push_back(registration.correction() ? registration.path().back() : step.pose);
    }
    const auto before_finish = registration.path();
    const auto begin = Clock::now();
    registration.finish();
    const double last = ms_since(begin);
    const Trajectory& stamps = odometry.trajectory();
    std::vector<Pose> wheels;
    for (const StampedPose& pose : stamps) wheels.push_back(pose.pose);
    const RegistrationFigures f = registration.figures();
    std::sort(times.begin(), times.end());
    const auto n = static_cast<double>(times.size());
    const std::size_t slow = times.size() * 9 / 10;
    const double slowest =
        std::reduce(times.begin() + static_cast<std::ptrdiff_t>(slow), times.end()) /
        static_cast<double>(times.size() - slow);
    fmt::print(
        "{:18} {} odometry {:6.2f} online {:6.3f} path {:6.3f} final {:6.3f} | score {:.2f} "
        "unmatched {}/{} keys {} edges {} loops {}/{} refused {} largest {:.2f} | ms/scan {:.2f} "
        "(90 % {:.2f}, slowest tenth {:.2f}, worst {:.0f}) + {:.2f}\n",
        tour.substr(tour.find_last_of('/') + 1), copy, ate(stamps, wheels, reference),
        ate(stamps, online, reference), ate(stamps, before_finish, reference),
        ate(stamps, registration.path(), reference), f.mean_score, f.unmatched, f.scans, f.keys,
        registration.edges().size(), registration.loops().size(), f.loop_searches, f.loops_refused,
        f.largest_correction_m, total / n, times[slow], slowest, times.back(), last / n);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    RegistrationParams params;
    int copies = 0;
    std::string preset;
    std::vector<std::string> tours;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--copies" && i + 1 < argc) {
            copies = std::stoi(argv[++i]);
        } else if (word == "--preset" && i + 1 < argc) {
            preset = argv[++i];
        } else if (word == "--set" && i + 1 < argc) {
            if (!set(params, argv[++i])) {
                fmt::print(stderr, "found --set {}, expected NAME=VALUE\n", argv[i]);
                return 1;
            }
        } else {
            tours.push_back(word);
        }
    }
    for (const std::string& tour : tours) {
        for (int copy = copies > 0 ? 1 : 0; copy <= copies; ++copy) run(tour, copy, params, preset);
    }
}
