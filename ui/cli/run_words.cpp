// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "damage.hpp"
#include "hitos/base/plural.hpp"

namespace hitos::cli {

void tell_times(const RunTimes& times, std::uint64_t scans, const Report& report) {
    double told = times.before;
    report.say("{:<28}{:>10}{:>8}{:>12}\n", "processor time", "s", "%", "us/scan");
    const auto say = [&](const std::string& name, double seconds) {
        report.say("{:<28}{:>10.3f}{:>8.1f}{:>12.1f}\n", name, seconds, 100.0 * seconds / times.all,
                   1e6 * seconds / static_cast<double>(scans));
    };
    say("before the first scan", times.before);
    for (std::size_t i = 0; i < kRunStages.size(); ++i) {
        say(kRunStages.at(i), times.stages.at(i));
        told += times.stages.at(i);
        if (!times.registration || i != static_cast<std::size_t>(RunStage::registration)) continue;
        for (std::size_t part = 0; part < kRegistrationStages.size(); ++part)
            say(fmt::format("  {}", kRegistrationStages.at(part)), times.registration->at(part));
    }
    say("judging", times.judging);
    told += times.judging;
    for (const RunTimes::File& file : times.files) {
        say(file.name, file.seconds);
        told += file.seconds;
    }
    say("the rest, other threads", times.all - told);
    say("all", times.all);
}

namespace {

/// "  by hand 1 loop closed, 2 loops refused, 1 place fixed"; nothing where nobody changed
/// anything.
void tell_by_hand(const RegistrationFigures& figures, const Report& report) {
    if (!figures.by_hand) return;
    const ChangesByHand& counts = *figures.by_hand;
    std::vector<std::string> words;
    const auto say = [&](std::uint64_t count, const char* one, const char* what) {
        if (count > 0) words.push_back(plural(count, one) + what);
    };
    say(counts.closed, "loop", " closed");
    say(counts.refused, "loop", " refused");
    say(counts.fixed, "place", " fixed");
    say(counts.slips, "slip", "");
    say(counts.anchors, "anchor", "");
    if (!words.empty()) report.say("  by hand {}\n", fmt::join(words, ", "));
}

bool has_lost_tour(const RunSummary& summary) {
    const auto& figures = summary.quality.registration;
    return figures && std::ranges::any_of(figures->later_tours,
                                          [](const SecondTour& tour) { return !tour.found; });
}

/// "910 scans"; of a tour that goes on with a map, how many of them are that map's.
std::string scans_words(const RunSummary& summary) {
    std::string words = plural(summary.scans, "scan");
    const auto& figures = summary.quality.registration;
    if (!figures || figures->later_tours.empty()) return words;
    return fmt::format("{}, {} of them the map's,", words, figures->later_tours.back().begin);
}

}  // namespace

void tell_summary(const RunSummary& summary, const std::string& folder, const Report& report) {
    report.say("{} in {:.1f} s of tour, {} and {}\n", scans_words(summary), summary.duration_s,
               plural(*summary.figures["lines"], "line"),
               plural(*summary.figures["corners"], "corner"));
    report.say("{}", damage_text(summary.report));
    if (summary.searches_cut > 0) {
        report.say("{} cut short; each has the best found until then\n",
                   plural(summary.searches_cut, "joint association"));
    }
    if (summary.map_error) {
        report.say("map error {:.3f} m (after rigid alignment {:.3f} m), {} of {} found\n",
                   summary.map_error->mean_m, summary.aligned_map_error->error.mean_m,
                   summary.map_error->reference_found,
                   plural(summary.map_error->reference_landmarks, "landmark"));
    }
    if (summary.trajectory_error && summary.odometry_error) {
        // Of a tour's begin alone, before it was found, there is none.
        const std::string driving = summary.online_error ? fmt::format(" while driving {:.3f} m,",
                                                                       summary.online_error->rmse_m)
                                                         : "";
        report.say("trajectory error (ATE) {:.3f} m,{} odometry alone {:.3f} m\n",
                   summary.trajectory_error->rmse_m, driving, summary.odometry_error->rmse_m);
        const int poses = summary.trajectory_error->poses;
        if (static_cast<std::uint64_t>(poses) < summary.scans) {
            report.say("  over {} of {}: {}\n", poses, plural(summary.scans, "scan"),
                       has_lost_tour(summary)
                           ? "a tour that was not found lies beside the map, not in its frame"
                           : "the reference has no pose at the times of the others");
        }
        if (summary.online_error && summary.online_error->poses < poses) {
            report.say("  while driving over {}: not before the tour was found in the map\n",
                       summary.online_error->poses);
        }
    }
    if (!summary.distances.empty()) report.say("{}", distance_table(summary.distances));
    if (const auto& figures = summary.quality.registration; figures && figures->scans > 0) {
        const auto closed = std::ranges::count_if(summary.quality.loops, &RunLoop::closed);
        for (const SecondTour& tour : figures->later_tours) {
            if (!tour.found) continue;
            report.say("found in the map after {:.1f} m, at scan {} ({} of its tour)\n", tour.way_m,
                       *tour.found + 1, *tour.found - tour.begin + 1);
        }
        report.say("{} of {} fitted, {} closed, largest correction {:.2f} m\n",
                   figures->scans - figures->unmatched, plural(figures->scans, "scan"),
                   plural(static_cast<std::uint64_t>(closed), "loop"),
                   figures->largest_correction_m);
        tell_by_hand(*figures, report);
        if (figures->drawing && figures->drawing->firm) {
            const Pose start = inverse(figures->drawing->pose);
            report.say(
                "  anchored to a drawing, where the first scan lies at {:.2f}, {:.2f} m, "
                "{:.2f} degrees\n",
                start.x, start.y, start.theta * 180.0 / kPi);
        }
        if (const LoopPrecision precision = precision_of(summary.quality.loops);
            precision.judged > 0) {
            report.say("  {} of {} of them false, the worst {:.2f} m and {:.2f} rad off\n",
                       precision.wrong, precision.judged, precision.worst_m, precision.worst_rad);
        }
    }
    if (summary.quality.findings) {
        for (const TourFinding& finding : *summary.quality.findings)
            report.warn(sentence_of(finding).english());
    }
    for (const Advice& warning : summary.quality.warnings) {
        report.warn(warning.words());
    }
    for (const Advice& advice : summary.advice) report.note(advice.words());
    for (const NotWritten& missing : summary.not_written) {
        std::string reason = missing.reason.english();
        const std::string again = (std::filesystem::path(folder) / missing.file).string() + ": ";
        if (reason.starts_with(again)) reason.erase(0, again.size());
        report.warn(fmt::format("not written: {}: {}", missing.file, reason));
    }
    if (!summary.finished) {
        report.say("stopped: these are the results of the first {}\n",
                   plural(summary.scans, "scan"));
    }
    report.say("results in {}\n", on_one_line(folder));
}

}  // namespace hitos::cli
