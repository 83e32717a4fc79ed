// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/evaluation/quality.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <future>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/base/translatable.hpp"
#include "hitos/capture/tour_examination.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "hitos/services/evaluation/measures.hpp"
#include "hitos/slam/robot.hpp"
#include "map_crispness.hpp"

namespace hitos {
namespace {

// docs/evaluation.md has the figures of good and of bad runs.
constexpr double kManyUnmatchedKeys = 0.02;
constexpr double kPoorScore = 0.5;
constexpr double kBlurrier = 1.05;          // than the odometry's map
constexpr double kSamePath = 0.10;          // [m], two cells
constexpr double kSameHeading = 0.02;       // [rad], 10 cm at 5 m
constexpr double kLongWithoutLoop = 100.0;  // [m]
constexpr double kFitsByHand = 0.3;         // score
constexpr double kLargeCorrection = 5.0;    // [m]; of six recorded tours the largest is 4.1
constexpr double kLongEnough = 10.0;        // [m] for a scale
constexpr double kScaleOff = 1.15;
constexpr double kLongestStep = 10.0;         // [m] between scans; of sparse recordings 1.7
constexpr std::uint64_t kManyEarlyScans = 2;  // one may come first by chance

void measure_crispness(const RunEvidence& run, const Trajectory& path,
                       const std::function<bool()>& stop, RunQuality& quality) {
    if (stop && stop()) return;  // there may be nothing to read any more
    MapCrispness best;
    MapCrispness odometry;
    const std::unique_ptr<TourReader> reader = run.reader.reopen();
    for (std::size_t i = 0; i < path.size(); ++i) {
        const std::optional<Scan> scan = reader->next_scan();
        if (!scan) break;
        if (stop && stop()) return;  // of half a tour it says nothing
        best.add(*scan, path[i].pose);
        odometry.add(*scan, run.odometry[i].pose);
    }
    if (best.cells_per_point() == 0.0) return;  // without points it says nothing
    quality.cells_per_point = best.cells_per_point();
    quality.odometry_cells_per_point = odometry.cells_per_point();
}

/// Whether the path is the odometry's but for a few centimetres: where the odometry is right no map
/// is crisper than its own, and one beside it is no worse for being a little less so.
bool follows(const Trajectory& path, const Trajectory& odometry) {
    const auto apart = trajectory_error(path, odometry);
    return apart && apart->rmse_m < kSamePath && apart->heading_rmse_rad < kSameHeading;
}

void warn(std::vector<Advice>& warnings, std::string_view text, std::string figure) {
    warnings.push_back({text, std::move(figure), {}});
}

void warn_of_changes(std::vector<Advice>& warnings, std::string_view text, std::string figure) {
    warnings.push_back({text, std::move(figure), {}, true});
}

double distance(const Pose& a, const Pose& b) {
    return std::hypot(b.x - a.x, b.y - a.y);
}

void warn_of_early_scans(const ReadReport& log, std::vector<Advice>& warnings) {
    if (log.early_scans < kManyEarlyScans) return;
    warn(
        warnings,
        HITOS_TEXT("Advice",
                   "%1 scans lie before the first odometry reading, and the robot is taken to have "
                   "stood still until then: if it moved, leave them out (source.early_scans)."),
        std::to_string(log.early_scans));
}

void warn_of_odometry(const RunEvidence& run, std::vector<Advice>& warnings) {
    const Trajectory& odometry = run.odometry;
    if (odometry.size() < 2) return;
    const bool needed = motion_models().find(run.configuration.filter.motion.model).reads_odometry;
    const Pose& first = odometry.front().pose;
    if (needed && std::ranges::all_of(
                      odometry, [&](const StampedPose& pose) { return pose.pose == first; })) {
        warn(warnings,
             HITOS_TEXT("Advice",
                        "The odometry never moves in %1 scans: either the robot stood still, or "
                        "the log has no odometry and its map is that of one place."),
             std::to_string(odometry.size()));
    }
    std::size_t longest = 1;  // the scan that it leads to
    for (std::size_t i = 2; i < odometry.size(); ++i) {
        if (distance(odometry[i - 1].pose, odometry[i].pose) >
            distance(odometry[longest - 1].pose, odometry[longest].pose)) {
            longest = i;
        }
    }
    const double step = distance(odometry[longest - 1].pose, odometry[longest].pose);
    if (step > kLongestStep) {
        warn(warnings,
             HITOS_TEXT(
                 "Advice",
                 "The odometry jumps from one scan to the next (%1): they have nothing in common, "
                 "and what follows lies where the jump put it until a loop is closed."),
             fmt::format("{0} → {1}, {2:.0f} m", longest, longest + 1, step));
    }
}

/// "151", "151, 152, 312 … (+4)".
std::string counted(const std::vector<std::uint64_t>& scans, std::size_t most = 3) {
    const std::size_t some = scans.size() <= most + 1 ? scans.size() : most;
    const std::span first = std::span(scans).first(some);
    std::vector<std::uint64_t> numbers;
    for (const std::uint64_t scan : first) numbers.push_back(scan + 1);  // counted as people do
    std::string names = fmt::format("{}", fmt::join(numbers, ", "));
    if (scans.size() > some) names += fmt::format(" … (+{})", scans.size() - some);
    return names;
}

/// The breaks that no loop from before them to behind them has joined.
std::vector<std::uint64_t> not_joined(std::vector<std::uint64_t> breaks,
                                      const std::vector<LoopRecord>& loops) {
    std::erase_if(breaks, [&](std::uint64_t scan) {
        return std::ranges::any_of(loops, [scan](const LoopRecord& loop) {
            return loop.earlier < scan && scan <= loop.scan;
        });
    });
    return breaks;
}

/// The ways from key scan to key scan [m], where what trembles between them does not count.
struct DrivenBy {
    double path_m = 0.0;
    double odometry_m = 0.0;
};

DrivenBy driven_by(const Registration& registration, const Trajectory& odometry) {
    constexpr double kCarried = 2.0;  // [m] at a break that the odometry knows nothing of
    DrivenBy driven;
    const std::span<const KeyPose> keys = registration.keys();
    const RegistrationFigures figures = registration.figures();
    const std::vector<std::uint64_t>& breaks = figures.breaks;
    for (std::size_t k = 1; k < keys.size(); ++k) {
        if (std::ranges::count(figures.later_tours, keys[k].scan, &SecondTour::begin) > 0) continue;
        const double path_m = distance(keys[k - 1].pose, keys[k].pose);
        const double odometry_m =
            distance(odometry[keys[k - 1].scan].pose, odometry[keys[k].scan].pose);
        const auto since = std::ranges::upper_bound(breaks, keys[k - 1].scan);
        const bool broken = since != breaks.end() && *since <= keys[k].scan;
        if (broken && path_m - odometry_m > kCarried) continue;
        driven.path_m += path_m;
        driven.odometry_m += odometry_m;
    }
    return driven;
}

void warn_of_scale(const DrivenBy& driven, std::vector<Advice>& warnings) {
    if (driven.path_m < kLongEnough || driven.odometry_m <= 0.0) return;
    const double scale = driven.odometry_m / driven.path_m;
    if (scale > kScaleOff || scale < 1.0 / kScaleOff) {
        warn(warnings,
             HITOS_TEXT("Advice",
                        "The odometry's way is %1 times that by the scans: its scale is wrong, and "
                        "corridors, which only the odometry measures, have a wrong length."),
             fmt::format("{:.2f}", scale));
    }
}

std::vector<std::uint64_t> numbers_of(std::span<const AnchorFigures> anchors) {
    std::vector<std::uint64_t> numbers;
    numbers.reserve(anchors.size());
    for (const AnchorFigures& anchor : anchors) numbers.push_back(anchor.change);
    return numbers;
}

/// That anchors to a drawing bend the map more than anything else in it explains, contradict each
/// other, or say nothing. Returns whether the path may be bent by wrong ones.
bool warn_of_anchors(const RegistrationFigures& figures, std::vector<Advice>& warnings) {
    constexpr double kOffM = 0.15;  // three standard deviations
    constexpr double kOffRad = 0.03;
    if (!figures.drawing) return false;
    if (!figures.drawing->firm) {
        warn_of_changes(
            warnings,
            HITOS_TEXT(
                "Advice",
                "The anchors (no. %1 of the changes by hand) do not say where the drawing lies: "
                "it takes two walls that are not parallel, two points, or one of each, and "
                "further ones to bend the map."),
            counted(numbers_of(figures.anchors)));
    }
    std::vector<AnchorFigures> strained;
    std::vector<AnchorFigures> off;
    for (const AnchorFigures& anchor : figures.anchors) {
        if (anchor.chi_square > anchor.chi_square_limit) strained.push_back(anchor);
        if (anchor.off_m > kOffM || std::abs(anchor.off_rad.value_or(0.0)) > kOffRad)
            off.push_back(anchor);
    }
    if (!off.empty()) {
        warn_of_changes(
            warnings,
            HITOS_TEXT(
                "Advice",
                "Anchors contradict each other or the map (no. %1 of the changes by hand): what "
                "was seen does not lie where the drawing has it. Is each of them the right "
                "wall?"),
            counted(numbers_of(off)));
    }
    // One that is wrong may pull others off, and lie well itself.
    if (!strained.empty()) {
        warn_of_changes(
            warnings,
            HITOS_TEXT("Advice",
                       "Anchors bend the map more than its edges explain (no. %1 of the changes by "
                       "hand): is each of them the right wall, and do walls meet?"),
            counted(numbers_of(strained)));
    }
    return !off.empty() || !strained.empty();
}

/// That changes by hand have met nothing, and why.
void warn_of_unmet(const RegistrationFigures& figures, std::vector<Advice>& warnings) {
    std::vector<std::uint64_t> unmet = figures.edits_unmet;
    std::map<std::uint64_t, std::vector<std::uint64_t>> covered;
    for (const CoveredRefusal& refusal : figures.edits_covered) {
        covered[refusal.by].push_back(refusal.change);
        std::erase(unmet, refusal.change);
    }
    for (const auto& [by, changes] : covered) {
        warn_of_changes(
            warnings,
            HITOS_TEXT("Advice",
                       "A loop that is refused by hand takes its whole stretch with it, and so "
                       "what other refusals name (no. %1 of the list): those behind the arrow "
                       "have met nothing to change, and change nothing."),
            fmt::format("{} → {}", by + 1, counted(changes, 12)));
    }
    if (unmet.empty()) return;
    warn_of_changes(
        warnings,
        HITOS_TEXT("Advice",
                   "Changes by hand have met nothing to change (no. %1 of the list): no loop was "
                   "found there, as where something else joins the passages, or the tour has not "
                   "come to those scans."),
        counted(unmet, 12));
}

void warn_of_registration(const Registration& registration, const Trajectory& odometry,
                          std::vector<Advice>& warnings) {
    const RegistrationFigures figures = registration.figures();
    for (const SecondTour& tour : figures.later_tours) {
        if (tour.found && tour.laid_from != tour.begin) {
            warn(warnings,
                 HITOS_TEXT("Advice",
                            "Of a tour that was found in the map of the one before, what comes "
                            "before a break in it (scan %1) was not: it lies beside that map."),
                 fmt::format("{}", tour.laid_from + 1));
        }
        if (tour.found) continue;
        if (tour.said) {
            warn(warnings,
                 HITOS_TEXT("Advice",
                            "The tour that begins at scan %1 was not found in the map of the one "
                            "before, within 3 m and 30 degrees of where it is said to begin: it "
                            "begins elsewhere, or saw too little of the map. It lies beside that "
                            "map."),
                 fmt::format("{}", tour.begin + 1));
            continue;
        }
        warn(warnings,
             HITOS_TEXT("Advice",
                        "The tour that begins at scan %1 was not found in the map of the one "
                        "before: it saw too little of it, or only what several places there have "
                        "in common. It lies beside that map."),
             fmt::format("{}", tour.begin + 1));
    }
    const double unmatched = figures.scans > 0 ? static_cast<double>(figures.unmatched) /
                                                     static_cast<double>(figures.scans)
                                               : 0.0;
    if (unmatched > kManyUnmatchedKeys) {
        warn(warnings,
             HITOS_TEXT("Advice",
                        "%1 of the scans fitted nothing that was seen before: the robot may have "
                        "been carried, or its laser blind; the map may be in pieces."),
             fmt::format("{:.0f} %", 100.0 * unmatched));
    } else if (const auto breaks = not_joined(figures.breaks, registration.loops());
               !breaks.empty()) {
        warn(warnings,
             HITOS_TEXT("Advice",
                        "What was seen does not follow on what was seen just before (scan %1): the "
                        "robot may have been carried there, the log have a gap, or scans lie too "
                        "far apart for this odometry. The map may be in pieces."),
             counted(breaks));
    }
    if (figures.unmatched < figures.scans && figures.mean_score < kPoorScore) {
        warn(warnings,
             HITOS_TEXT("Advice",
                        "The scans lie badly on each other (score %1 of 1): much moves here, or "
                        "the odometry and the laser do not belong together."),
             fmt::format("{:.2f}", figures.mean_score));
    }
    double moved_m = 0.0;  // by what was found, not by somebody's hand
    for (const LoopRecord& loop : registration.loops())
        if (!loop.by_hand) moved_m = std::max(moved_m, loop.move_m);
    if (moved_m > kLargeCorrection) {
        warn(warnings,
             HITOS_TEXT("Advice",
                        "A loop moved the path by %1 at once: until then the poses told while "
                        "driving were that far off. Look whether walls meet where it closed."),
             fmt::format("{:.1f} m", moved_m));
    }
    const DrivenBy driven = driven_by(registration, odometry);
    const bool anchored_wrongly = warn_of_anchors(figures, warnings);
    if (figures.strained_fix) {
        warn_of_changes(
            warnings,
            HITOS_TEXT("Advice",
                       "A place fixed by hand bends the map more than its edges explain (no. %1 "
                       "of the changes by hand): is it where that scan was (in a file in metres "
                       "and radians)?"),
            fmt::format("{}", *figures.strained_fix + 1));
    }
    std::vector<std::uint64_t> misfits;
    for (const LoopRecord& loop : registration.loops())
        if (loop.by_hand && loop.score < kFitsByHand) misfits.push_back(loop.scan);
    if (!misfits.empty()) {
        warn_of_changes(
            warnings,
            HITOS_TEXT("Advice",
                       "Loops that were closed by hand lie on hardly anything that the earlier "
                       "passage saw (scan %1): is the pose that of the later scan, seen from "
                       "the earlier one (in a file in metres and radians)?"),
            counted(misfits));
    }
    if (!anchored_wrongly && !figures.strained_fix && misfits.empty())
        warn_of_scale(driven, warnings);
    warn_of_unmet(figures, warnings);
    if (registration.loops().empty() && driven.path_m > kLongWithoutLoop) {
        warn(warnings,
             HITOS_TEXT("Advice",
                        "No loop was closed in %1: nothing shows whether the map is bent."),
             fmt::format("{:.0f} m", driven.path_m));
    }
}

}  // namespace

std::vector<Advice> warnings(const RunEvidence& run) {
    std::vector<Advice> warnings;
    warn_of_early_scans(run.reader.report(), warnings);
    warn_of_odometry(run, warnings);
    if (run.registration != nullptr)
        warn_of_registration(*run.registration, run.odometry, warnings);
    return warnings;
}

DoubtsAhead doubts_of(std::shared_ptr<const TourExamination> examination,
                      std::vector<TourFinding> told, int threads) {
    const auto look = [examination = std::move(examination), told = std::move(told)] {
        return examination->findings(told);
    };
    if (threads != 1) {
        try {
            return std::async(std::launch::async, look);
        } catch (const std::system_error&) {  // there are too many threads
        }
    }
    return std::async(std::launch::deferred, look);
}

void take_findings(std::vector<TourFinding> findings, RunQuality& quality) {
    if (quality.registration) {
        for (TourFinding& finding : findings)
            std::erase_if(finding.remedies, &Remedy::registration);
    }
    quality.findings = std::move(findings);
}

RunQuality judge(const RunEvidence& run, const Trajectory& path,
                 const std::function<bool()>& stop) {
    RunQuality quality;
    measure_crispness(run, path, stop, quality);
    quality.warnings = warnings(run);
    if (run.registration != nullptr) {
        quality.registration = run.registration->figures();
        quality.loops =
            run_loops(run.registration->loops(), run.registration->refused_loops(), path);
    }
    if (quality.cells_per_point &&
        *quality.cells_per_point > kBlurrier * *quality.odometry_cells_per_point &&
        !follows(path, run.odometry)) {
        quality.warnings.push_back(
            {HITOS_TEXT("Advice",
                        "The map is less crisp than that of the odometry alone (%1 times the cells "
                        "per point): do not trust it."),
             fmt::format("{:.2f}", *quality.cells_per_point / *quality.odometry_cells_per_point),
             quality.registration || run.configuration.extraction.circles.find ? std::string_view()
                                                                               : "recorded"});
    }
    return quality;
}

}  // namespace hitos
