// Doubts about a tour that is whole: clocks, mounting and units that do not fit each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/capture/scan.hpp"

namespace hitos {

/// Something that a map would show wrong although every line of the tour can be read.
struct TourFinding {
    enum class Kind : std::uint8_t {
        clocks_apart,  ///< scans and odometry share no time; value: seconds between them
        scan_delay,    ///< the scans fit the odometry of another time; value: that less theirs [s]
        mirrored_laser,    ///< the scans turn against the odometry; value: 1
        turned_laser,      ///< the scans move where the odometry does not; value: turn to the left
                           ///< [rad]
        no_odometry,       ///< there are scans and no odometry; value: the scans
        still_odometry,    ///< the scans change and the odometry does not; value: 0
        leaping_odometry,  ///< steps that no robot makes; value: the longest [m]
        odometry_units,    ///< all of it is too fast; value: median speed [m/s]
        laser_units,       ///< readings of a distance that no such laser sees; value: median [m]
        beyond_a_turn,     ///< rays over more than a turn; value: angle from first to last [rad]
        blind_laser,       ///< hardly any scan has a point; value: share of those with none
        frozen_laser       ///< the same ranges while the robot drives; value: share of such scans
    };
    Kind kind = Kind::clocks_apart;
    double value = 0.0;
    Message what;    ///< what was found, with its number, and what it does to a map
    Message remedy;  ///< what to do
};

/// The word of a kind, for programs: "scan-delay".
std::string_view word_of(TourFinding::Kind kind);

/// Takes what is read of a tour, in any order of scans and odometry, and doubts it at the end; what
/// is not later than what was noted is left out, so that a tour may be read again in part. It
/// keeps some hundred pairs of neighbouring scans, each pair from where the odometry moved by about
/// half a metre, and asks how well the later scan of each lies on the earlier one where the
/// odometry puts it; then whether it would lie better if the scans were of another time, or the
/// laser were mounted otherwise. It takes some megabytes at the most, however long the tour is.
class TourExamination {
  public:
    void note(const Scan& scan);
    void note(const Odometria& odometry);

    /// What there is to doubt, gravest first; empty where nothing is.
    std::vector<TourFinding> findings() const;

    /// What the odometry may be like in place of what the tour says.
    struct Hypothesis {
        double delay_s = 0.0;   ///< added to the scans' times
        double turn_rad = 0.0;  ///< of the laser on the robot, to the left
        bool mirrored = false;  ///< the rays go the other way round
        std::size_t every = 1;  ///< asks every n-th pair only
    };
    /// The mean share of a pair's points that lie on the earlier scan, 0 … 1; nothing where fewer
    /// than 10 pairs can be asked.
    std::optional<double> agreement(const Hypothesis& hypothesis) const;

  private:
    /// A scan as the laser saw it: ranges by direction, of a whole turn.
    struct View {
        double time_s = 0.0;
        Pose pose_robot_laser;
        std::vector<float> ranges;      ///< by direction, 0 where nothing is known
        std::vector<float> directions;  ///< of its points, in the laser's frame [rad]
        std::vector<float> distances;   ///< of its points
    };
    struct Pair {
        View first;
        View second;
    };

    View view_of(const Scan& scan) const;
    std::optional<double> agreement(const Pair& pair, const Hypothesis& hypothesis) const;
    std::optional<Pose> pose_at(double time_s) const;
    void keep(const Scan& scan);
    void doubt_readings(std::vector<TourFinding>& found) const;
    void doubt_odometry(std::vector<TourFinding>& found) const;
    void doubt_fit(std::vector<TourFinding>& found) const;

    std::vector<StampedPose> path_;  ///< by the odometry, thinned where it grows long
    std::size_t path_stride_ = 1;
    std::size_t readings_ = 0;
    StampedPose last_;
    double way_m_ = 0.0;
    double turned_rad_ = 0.0;
    double longest_step_m_ = 0.0;
    std::uint64_t longest_step_line_ = 0;
    std::uint64_t leaps_ = 0;
    std::vector<float> speeds_;  ///< of a sample of readings that move

    std::vector<Pair> pairs_;
    std::size_t pair_stride_ = 1;
    std::size_t offered_ = 0;
    std::optional<View> open_;  ///< the earlier scan of the next pair
    double open_way_ = 0.0;     ///< odometer where it was taken
    std::uint64_t scans_ = 0;
    std::uint64_t empty_scans_ = 0;
    std::uint64_t same_scans_ = 0;
    std::uint64_t moved_scans_ = 0;
    double scan_way_ = 0.0;
    double first_scan_s_ = 0.0;
    double last_scan_s_ = 0.0;
    std::vector<Point2> last_points_;
    Fan fan_;
    std::vector<float> medians_;  ///< of the ranges of a sample of scans
};

}  // namespace hitos
