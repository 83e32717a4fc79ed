// SPDX-License-Identifier: GPL-3.0-or-later
// Doubts about a tour that is whole: clocks, mounting and units that do not fit each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include "hitos/capture/greatest_ranges.hpp"
#include "hitos/capture/scan.hpp"
#include "hitos/capture/tour_finding.hpp"
#include "hitos/capture/tour_reader.hpp"

namespace hitos {

struct BestFit;
struct LengthUnit;

/// What the rays of a scan read, 0 where nothing is known.
struct RangesByRay {
    Fan fan;
    std::vector<float> ranges;
};

/// Takes what is read of a tour, in any order of scans and odometry, and doubts it at the end; what
/// is not later than what was noted is left out, so that a tour may be read again in part. It
/// keeps some hundred pairs of neighbouring scans, each pair from where the odometry moved by about
/// half a metre, and asks how well the later scan of each lies on the earlier one where the
/// odometry puts it; then whether it would lie better if the scans were of another time, or the
/// laser were mounted otherwise. Of the longest pauses too it keeps the scans before and after:
/// those of one place, where the odometry says another, tell of a driver that began anew meanwhile,
/// those of two places, where it says one, of a robot that was carried.
/// Of a tour behind another one (Scan::begins_tour) it begins anew. It takes some megabytes at the
/// most, however long the tour is.
class TourExamination {
  public:
    /// `read`: how the tour is read, which what is advised comes on top of.
    explicit TourExamination(ReadOptions read) : read_(std::move(read)) {}
    void note(const Scan& scan);
    void note(const Odometria& odometry);

    /// What there is to doubt, gravest first; empty where nothing is. What the reader `told` counts
    /// first: of one kind its finding stays. Stamps that differ from the times of receipt say
    /// nothing where the scans fit the odometry as they are stamped.
    std::vector<TourFinding> findings(std::vector<TourFinding> told = {}) const;

    /// What the odometry may be like in place of what the tour says.
    struct Hypothesis {
        double delay_s = 0.0;          ///< added to the scans' times
        double gained = 0.0;           ///< added besides, for each second since the first scan
        double set_by_s = 0.0;         ///< added besides, to scans
        double set_at_s = 0.0;         ///< from that time on
        unsigned undone_leaps = 0;     ///< of the stamps, a bit for each: taken for a clock's
        double turn_rad = 0.0;         ///< of the laser on the robot, to the left
        bool mirrored = false;         ///< the rays go the other way round
        double fan_scale = 1.0;        ///< of the angles between them,
        double fan_middle_rad = 0.0;   ///< to either side of this one
        double range_offset_m = 0.0;   ///< of each reading
        double first_ray_s = 0.0;      ///< when it was measured, added to what is told
        double last_ray_s = 0.0;       ///< likewise
        double scale = 1.0;            ///< of the way
        double turn_scale = 1.0;       ///< of the heading, from where the tour begins
        double pair_turn_scale = 1.0;  ///< of the turn from one scan of a pair to the other
        double drift_rad_s = 0.0;      ///< turned besides, each second
        double drift_rad_m = 0.0;      ///< and each metre of way
        Point2 shift = {};             ///< of the laser on the robot [m]
        double near_m = 0.1;           ///< how far apart two points may be that are one
        double near_per_range = 0.02;  ///< and for each metre of their range
    };
    class Fit;

    /// The mean share of a pair's points that lie on the earlier scan, 0 … 1; nothing where fewer
    /// than 10 pairs, or than half of them, lie in the odometry.
    std::optional<double> agreement(const Hypothesis& hypothesis) const;

    /// How much more of the points lie there, closely, than if the robot had driven nowhere, were
    /// the ranges so many metres for one: of a scale that is too large the way tells nothing. And
    /// were the rays' angles so many times as wide.
    /// Nothing where fewer than `least` fit.
    double way_shown(double range_scale, double fan_scale = 1.0, double least = 0.4) const;

  private:
    /// A scan as the laser saw it: ranges by direction, of a whole turn, as its rays part it.
    struct View {
        double time_s = 0.0;
        Pose pose_robot_laser;
        double first_rad = 0.0;         ///< of ranges,
        double step_rad = 0.0;          ///< and from one to the next
        double span_rad = 0.0;          ///< from its fan's first ray to the last
        std::vector<float> ranges;      ///< by direction, 0 where nothing is known
        std::vector<float> directions;  ///< of its points, in the laser's frame [rad]
        std::vector<float> distances;   ///< of its points
        std::vector<double> cosines;    ///< of the directions
        std::vector<double> sines;      ///< likewise
        std::size_t bin_of(double direction_rad) const;
    };
    struct Pair {
        View first;
        View second;
    };
    using Pairs = std::vector<const Pair*>;
    /// The scans round a pause.
    struct Pause {
        Pair scans;
        std::uint64_t line = 0;  ///< of the later one
        double seconds() const { return scans.second.time_s - scans.first.time_s; }
    };

    View view_of(const Scan& scan) const;
    std::optional<double> agreement(const Pair& pair, const Hypothesis& hypothesis) const;
    std::optional<Pose> step_of(const Pair& pair, const Hypothesis& hypothesis) const;
    /// How fast the robot turns at the two scans of a pair [rad/s].
    struct Speeds {
        double first = 0.0;
        double second = 0.0;
    };
    std::optional<Speeds> speeds_of(const Pair& pair, const Hypothesis& hypothesis) const;
    /// Where the robot made `step` between the two scans.
    static std::optional<double> agreement(const Pair& pair, const Pose& step,
                                           const Hypothesis& hypothesis, const Speeds& speeds);
    std::optional<Pose> pose_at(double time_s, double turn_scale = 1.0) const;
    void keep(const Scan& scan);
    void doubt_readings(std::vector<TourFinding>& found) const;
    void doubt_units(std::vector<TourFinding>& found) const;
    /// Readings that say that nothing was seen.
    std::optional<TourFinding> taken_for_walls() const;
    std::optional<GreatestRanges::Code> code_taken_for_walls() const;
    double share_of_points(const GreatestRanges::Code& code) const;
    void doubt_small_unit(double typical, std::vector<TourFinding>& found) const;
    /// What the odometry's metres are, where no robot is so fast; else nothing.
    const LengthUnit* way_unit() const;
    void doubt_speed(std::vector<TourFinding>& found) const;
    void doubt_odometry(std::vector<TourFinding>& found) const;
    void doubt_fit(std::vector<TourFinding>& found) const;
    /// A clock that does not stay as it is, where with it these pairs fit by `least` or better:
    /// looked for in so many steps of the delay to either side.
    std::optional<TourFinding> changing_clock(const Pairs& pairs, const Hypothesis& asked,
                                              double step_s, int steps, double least) const;
    struct SetClock {
        TourFinding finding;
        double agreement;
    };
    /// One that was set where the stamps leap, once or several times.
    std::optional<SetClock> set_clock(const Pairs& pairs, double otherwise) const;
    /// Of these leaps of the stamps, a bit for each, those with which the pairs fit best.
    BestFit best_leaps(const Pairs& pairs, unsigned begin, unsigned offered) const;
    TourFinding told_set(const Hypothesis& set, double fits, double told) const;
    TourFinding told_leaps(unsigned undone, double fits, double told) const;
    void note_leap(const Scan& scan);
    /// From scan to scan, where the stamps do not leap.
    double period_s() const;
    /// What is added to a scan of that stamp where these leaps are undone.
    double undone_s(unsigned leaps, double stamp_s) const;
    /// Whether the stamps of scans or odometry may be of a clock that was set so: they leap then.
    bool may_be_set(const Hypothesis& set) const;
    /// Nothing too where it becomes clear that it is below `least`.
    std::optional<double> agreement(const Pairs& pairs, const Hypothesis& hypothesis,
                                    double least = 0.0) const;
    /// Those of which the odometry says, with this hypothesis, how the robot moved.
    Pairs of_odometry(const Pairs& pairs, const Hypothesis& hypothesis) const;
    /// At least as many as are asked, where there are so many, evenly over the tour.
    Pairs some_pairs(std::size_t asked) const;
    void doubt_mounting(const Fit& fit, double told, const BestFit& mounted,
                        std::vector<TourFinding>& found) const;
    void tell_mounting(const Fit& fit, double told, const BestFit& mounted,
                       std::vector<TourFinding>& found) const;
    bool doubt_turns(const Fit& fit, double told, double otherwise,
                     std::vector<TourFinding>& found) const;
    bool doubt_slight_turn(const Fit& fit, std::vector<TourFinding>& found) const;
    bool doubt_cut_fan(const Fit& fit, const Hypothesis& otherwise,
                       std::vector<TourFinding>& found) const;
    bool doubt_slight_fan(const Fit& fit, std::vector<TourFinding>& found) const;
    void tell_fan(const Fit& fit, double told, const BestFit& mounted,
                  std::vector<TourFinding>& found) const;
    bool doubt_range_offset(const Fit& fit, const BestFit& longer,
                            std::vector<TourFinding>& found) const;
    void tell_range_offset(const Fit& fit, const BestFit& longer,
                           std::vector<TourFinding>& found) const;
    void doubt_lost_rays(std::vector<TourFinding>& found) const;
    bool doubt_ray_times(std::vector<TourFinding>& found) const;
    void tell_ray_times(TourFinding& told) const;
    void doubt_scale(std::vector<TourFinding>& found) const;
    /// What pairs of scans between which the robot turns say of its turns, and of where the laser
    /// sits.
    struct Turning {
        Pairs pairs;
        double rad_per_s = 0.0;  ///< how fast half of them turn, or faster
    };
    Turning turning_pairs() const;
    /// The same of short delays, where it fits turns clearly better than `otherwise` does.
    std::optional<TourFinding> turning_clock(const Turning& turning, double otherwise) const;
    void doubt_turning(std::vector<TourFinding>& found) const;
    bool sits_elsewhere(const Hypothesis& instead) const;
    /// Of some pairs: how the robot moved by the odometry and by the scans.
    struct Motion {
        Pose told;
        Pose seen;
    };
    Hypothesis near_walls() const;
    double slipped_m(const Pair& pair) const;
    std::vector<Motion> motions() const;
    void doubt_slip(std::vector<TourFinding>& found) const;
    bool doubt_dead(std::vector<TourFinding>& found) const;
    void doubt_motion(std::vector<TourFinding>& found) const;
    bool beats_standing(double share) const;
    bool is_scale_of_each(const Pairs& pairs, double scale) const;
    bool fits_throughout(const Pairs& pairs, const Hypothesis& other) const;
    /// Of which so few lie on a wall that by chance any motion fits.
    bool has_few_rays() const { return fan_.count > 0 && fan_.count < kManyRays; }
    static constexpr std::uint32_t kManyRays = 90;
    void doubt_same_scans(std::vector<TourFinding>& found) const;
    void doubt_whole(std::vector<TourFinding>& found) const;
    bool doubt_drift(std::initializer_list<Hypothesis> otherwise,
                     std::vector<TourFinding>& found) const;
    bool doubt_turning_rate(std::vector<TourFinding>& found) const;
    void doubt_stills(std::vector<TourFinding>& found) const;
    void note_still(const Pair& pair, double odometer);
    bool prefers_stamps(const TourFinding& receipts, const std::vector<TourFinding>& own) const;
    void doubt_stamps(std::vector<TourFinding>& found) const;
    void doubt_self_hits(std::vector<TourFinding>& found) const;
    void doubt_stuck_rays(std::vector<TourFinding>& found) const;
    void doubt_heading(std::vector<TourFinding>& found) const;
    /// A laser that is said to sit where no robot reaches.
    void doubt_place(std::vector<TourFinding>& found) const;
    /// Whether the odometry goes most of a way from one reading to the next, and does not drive it.
    bool goes_in_one_step(double begin_s, double end_s, double way) const;
    void settle_axes(TourFinding& told) const;
    void doubt_pauses(std::vector<TourFinding>& found) const;
    std::optional<TourFinding> begun_anew(const Pause& pause, const Pose& step) const;
    std::optional<TourFinding> unseen_way(const Pause& pause, const Pose& step) const;
    void note_self(const Scan& scan);
    void note_pause(const Scan& scan);
    void note_neighbours(const Scan& scan);
    void doubt_foreign_scans(std::vector<TourFinding>& found) const;
    void doubt_coarse_readings(std::vector<TourFinding>& found) const;
    /// What some pairs say without the odometry.
    struct ScansAlone {
        /// The share of points that lie on the earlier scan by the motion that fits best, rising;
        /// of pairs between which the odometry moved.
        std::vector<double> fits;
        double telling = 0.0;  ///< share of pairs that show how the robot moved
    };
    ScansAlone scans_alone() const;
    void settle_scans(std::vector<TourFinding>& found) const;
    void begin_next(bool& begun, std::uint64_t lines_before);

    ReadOptions read_;
    std::vector<TourExamination> next_;  ///< of the tour behind, where one of its sequences begun
    bool scans_of_next_ = false;         ///< the scans are its
    bool odometry_of_next_ = false;
    std::uint64_t lines_before_ = 0;  ///< of the log of the tour before
    std::vector<StampedPose> path_;   ///< by the odometry, thinned where it grows long
    std::vector<double> headings_;    ///< of the path's poses, whole turns counted [rad]
    double heading_rad_ = 0.0;        ///< of the last
    std::size_t path_stride_ = 1;
    std::size_t readings_ = 0;
    StampedPose last_;
    double speed_ = 0.0;  ///< at the last reading, a radian counted as a metre
    double way_m_ = 0.0;
    double turned_rad_ = 0.0;
    double longest_step_m_ = 0.0;
    std::uint64_t longest_step_line_ = 0;
    std::uint64_t leaps_ = 0;
    std::vector<float> speeds_;      ///< of a sample of readings that move
    double speed_way_m_ = 0.0;       ///< of those that came since the last of them,
    double speed_s_ = 0.0;           ///< and how long that took
    std::uint64_t of_no_time_ = 0;   ///< readings whose stamps did not advance,
    double way_in_no_time_m_ = 0.0;  ///< and what was driven in them

    /// Pairs that saw the robot move while the odometry stood.
    struct Still {
        double begin_s = 0.0;
        double end_s = 0.0;
        std::size_t pairs = 0;
    };
    Still still_;                     ///< up to now,
    std::optional<View> still_view_;  ///< from where it began
    Still longest_still_;

    std::vector<Pair> pairs_;
    std::size_t pair_stride_ = 1;
    std::size_t offered_ = 0;
    std::optional<View> open_;  ///< the earlier scan of the next pair
    double open_way_ = 0.0;     ///< odometer where it was taken
    std::uint64_t scans_ = 0;
    std::uint64_t empty_scans_ = 0;
    std::uint64_t same_scans_ = 0;
    std::uint64_t same_run_ = 0;           ///< the newest ones in a row,
    double same_run_begin_ = 0.0;          ///< from where on the way
    std::uint64_t longest_same_run_ = 0;   ///< of those that are long on the way too
    std::uint64_t scans_of_one_time_ = 0;  ///< as the scan before
    std::uint64_t last_scan_line_ = 0;
    /// Readings of one direction, nearer than any robot is large and beyond.
    struct Direction {
        float near_m = 0.0F;      ///< newest one, smoothed; 0: none
        std::uint32_t near = 0;   ///< how often it was where it was before a turn
        float far_m = 0.0F;       ///< newest one beyond; 0: none
        std::uint32_t stuck = 0;  ///< how often it was the number that it was before a turn
    };
    std::vector<Direction> directions_;
    std::uint64_t turns_ = 0;         ///< how often the robot turned between two scans
    double heading_noted_rad_ = 0.0;  ///< heading_rad_ at the newest of them
    /// Of the way, by twice its direction on the robot, so that ahead and back are one [m].
    double along_m_ = 0.0;
    double across_m_ = 0.0;
    std::uint64_t moved_scans_ = 0;
    double scan_way_ = 0.0;
    double first_scan_s_ = 0.0;
    double last_scan_s_ = 0.0;
    /// Where a scan's stamp does not follow on the one before.
    struct StampLeap {
        double after_s = 0.0;    ///< stamp before it
        double by_s = 0.0;       ///< to the next
        double elapsed_s = 0.0;  ///< of the tour before it, as ScanClock counts
    };
    static constexpr double kLeastLeap = 0.25;  ///< ahead [s]; back all are
    static constexpr std::size_t kMostLeaps = 16;
    std::vector<StampLeap> stamp_leaps_;  ///< the longest ones, in their order
    double last_stamp_s_ = 0.0;           ///< of the newest line,
    double elapsed_s_ = 0.0;              ///< and of the tour there
    std::vector<Point2> last_points_;
    RangesByRay last_ranges_;           ///< of the newest scan
    RangesByRay ranges_before_;         ///< of the one before
    std::optional<double> last_alike_;  ///< both
    std::uint64_t steady_scans_ = 0;    ///< whose neighbours are alike,
    std::uint64_t foreign_scans_ = 0;   ///< and these: unlike both
    Fan last_fan_;
    std::vector<Pause> pauses_;  ///< the longest ones
    Fan fan_;
    std::vector<std::uint32_t> seen_rays_;  ///< how often each had a reading
    float first_ray_s_ = 0.0F;              ///< as the longest sweep says that was believed
    float last_ray_s_ = 0.0F;
    std::vector<float> medians_;  ///< of the ranges of a sample of scans,
    GreatestRanges greatest_;     ///< and the greatest of these ranges,
    std::uint64_t sampled_ = 0;   ///< of so many
};

/// How well some pairs of a tour fit a hypothesis: their mean agreement, 0 where there is none or
/// where it is below `least`, which is known sooner.
class TourExamination::Fit {
  public:
    Fit(const TourExamination& tour, Pairs pairs) : tour_(&tour), pairs_(std::move(pairs)) {}
    double operator()(const Hypothesis& hypothesis, double least = 0.0) const {
        return tour_->agreement(pairs_, hypothesis, least).value_or(0.0);
    }

  private:
    const TourExamination* tour_;
    Pairs pairs_;
};

}  // namespace hitos
