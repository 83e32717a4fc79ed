// SPDX-License-Identifier: GPL-3.0-or-later
// Registration: every scan matched with what was seen before, loops closed, a path with covariance.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hitos/base/stage_clock.hpp"
#include "hitos/features/control.hpp"
#include "hitos/registration/changed_place.hpp"
#include "hitos/registration/graph_edit.hpp"
#include "hitos/registration/laid_drawing.hpp"
#include "hitos/registration/loop_record.hpp"
#include "hitos/registration/registered_step.hpp"
#include "hitos/registration/registration_params.hpp"

namespace hitos {

/// A tour behind another one (Scan::begins_tour), in what was seen before it.
struct SecondTour {
    std::uint64_t begin = 0;             ///< its first scan
    std::optional<std::uint64_t> found;  ///< the scan at which it was found
    double way_m = 0.0;                  ///< driven until then
    /// Its first scan that was laid in the map: behind a break, what comes before lies beside it.
    std::uint64_t laid_from = 0;
    std::uint64_t beside = 0;  ///< the scan before it that it was found beside
    bool said = false;         ///< somebody said where it begins
};

/// What an anchor to a drawing came to.
struct AnchorFigures {
    std::uint64_t change = 0;       ///< its place among the changes by hand, from 0
    std::uint64_t scan = 0;         ///< from 0
    double off_m = 0.0;             ///< what is seen from what is drawn, of a wall across it
    std::optional<double> off_rad;  ///< likewise the directions of a wall
    /// What the anchors of its scan added to the graph's tension, and what its edges explain.
    double chi_square = 0.0;
    double chi_square_limit = 0.0;
};

/// How many changes by hand of each kind have met what they change, and how many nothing.
struct ChangesByHand {
    std::uint64_t closed = 0;
    std::uint64_t refused = 0;
    std::uint64_t fixed = 0;
    std::uint64_t slips = 0;
    std::uint64_t anchors = 0;
    std::uint64_t met_nothing = 0;
};

/// A refusal by hand that has met nothing, as another one has taken the stretch out in which it
/// names a loop; their places among the changes.
struct CoveredRefusal {
    std::uint64_t change = 0;
    std::uint64_t by = 0;
    friend bool operator==(const CoveredRefusal&, const CoveredRefusal&) = default;
};

/// What a run may be trusted for, without any truth.
struct RegistrationFigures {
    std::uint64_t scans = 0;      ///< that were matched or could not be: those after a motion
    std::uint64_t unmatched = 0;  ///< of these, those that fitted nothing
    /// Scans that cannot follow on the one before: they fitted nothing, or badly and seeing through
    /// what was seen just before. A carried robot shows so, or a gap in the log.
    std::vector<std::uint64_t> breaks;
    double mean_score = 0.0;  ///< of the matched ones, 0 … 1
    std::uint64_t keys = 0;
    std::uint64_t loop_searches = 0;  ///< places that could be an earlier one
    std::uint64_t loops_refused = 0;  ///< that correlated, but for those that stayed alone
    double largest_correction_m = 0.0;
    /// Of the changes by hand, by their places, those that have met nothing to change: refused
    /// loops that nobody has found, scans that have not come.
    std::vector<std::uint64_t> edits_unmet;
    std::vector<CoveredRefusal> edits_covered = {};  ///< of those
    std::optional<ChangesByHand> by_hand = {};       ///< where there are any
    /// The first of those places that bends the graph more than its edges explain, as edits_unmet;
    /// others may pull against a wrong one.
    std::optional<std::uint64_t> strained_fix = {};
    std::vector<SecondTour> later_tours = {};
    std::vector<AnchorFigures> anchors = {};  ///< in the order of the tour
    std::optional<LaidDrawing> drawing = {};  ///< that they anchor the map to
};

/// What a registration does, in this order: looks for points, matches a scan and makes a key of
/// it, looks for loops, closes them, smooths the whole at the end.
enum class RegistrationStage : std::size_t { points, matching, search, closing, smoothing };
inline constexpr std::array kRegistrationStages{"points", "matching", "search", "closing",
                                                "smoothing"};
using RegistrationClock = StageClock<RegistrationStage, kRegistrationStages.size()>;

/// Takes a tour scan by scan. Deterministic: nothing is drawn at random, and several threads do
/// what one does, to the last bit.
class Registration {
  public:
    /// `threads` 0: as many as the machine has; only finish() makes use of several. Throws
    /// ConfigError where the changes by hand are none.
    explicit Registration(const RegistrationParams& params, int threads = 1);
    ~Registration();
    Registration(Registration&&) noexcept;
    Registration& operator=(Registration&&) noexcept;
    /// The same state, to go on from independently; both share the key scans.
    Registration(const Registration& other);
    Registration& operator=(const Registration&) = delete;
    /// Memory that a copy of it takes, about.
    std::size_t bytes() const;

    /// Places the next scan. `controls` lead from the scan before to this one. Throws ConfigError
    /// where a change by hand is of another tour: its scan has another stamp.
    RegisteredStep add(const Scan& scan, std::span<const Control> controls);
    /// What the last add() or finish() corrected, if anything. For a scan that closes a loop: after
    /// the step of that scan.
    std::optional<PathCorrection> correction() const;
    /// From now on the time of its stages is summed up.
    void time_stages();
    /// Processor time of the caller's thread in each [s], by RegistrationStage; all 0 unless they
    /// are timed.
    const RegistrationClock::Seconds& stages() const;

    /// The end of the tour: smooths the whole path. Further scans may follow, and do where another
    /// tour does: else it throws ConfigError where a change by hand names a scan that has not come.
    void finish(bool another_follows = false);

    /// From now on these are the changes by hand. Throws ConfigError where they are none, and is
    /// then what it was.
    void set_edits(const std::string& edits);

    /// The graph at once as other changes by hand bend it: what they name is taken out of it and
    /// put into it, and it is solved from where it stands; correction() says how it moves. Nothing
    /// is matched or looked for anew, so it is near what the tour gives with them and not the same:
    /// to be looked at, no scan may follow. Returns whether it is: not where the graph stays, nor
    /// where a map that is held depends on a change, or where a second tour lies. Throws
    /// ConfigError where they are none.
    bool foresee(const std::string& edits);

    /// A loop from one key scan to an earlier one as their passages lie best on each other, from
    /// `start` on, the pose of the former seen from the latter; nothing is closed. Throws Error
    /// where one is no key scan.
    LoopRecord fitted_loop(std::uint64_t scan, std::uint64_t earlier, const Pose& start) const;

    /// The pose at every scan so far, all corrections applied.
    std::vector<Pose> path() const;
    const std::vector<LoopRecord>& loops() const;  ///< that were closed
    const std::vector<LoopRecord>& refused_loops() const;
    std::span<const KeyPose> keys() const;
    /// With anchors as edges by hand from the first key, as soon as they say anything of the path.
    std::span<const PoseEdge> edges() const;
    /// How much the graph is bent: the sum of its edges' squared Mahalanobis distances.
    double chi_square() const;
    /// Where the anchors among the changes by hand have their drawing; nothing where there are
    /// none.
    std::optional<LaidDrawing> drawing() const;
    RegistrationFigures figures() const;
    /// Those of the figures.
    const std::vector<SecondTour>& later_tours() const;
    /// Of two tours what is gone and what is new, larger than half a metre and more than 0.3 m off
    /// what was there; nothing where the second was not found. It takes some seconds for thousands
    /// of key scans.
    std::vector<ChangedPlace> changes() const;

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hitos
