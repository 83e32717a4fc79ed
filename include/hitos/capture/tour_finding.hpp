// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to doubt about a tour that is whole.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hitos/base/message.hpp"

namespace hitos {

/// A parameter of how a source is read, and the whole value that mends it, whatever was set when it
/// was doubted.
struct SourceSetting {
    std::string key;  ///< "source.scan_delay"
    std::string value;
    friend bool operator==(const SourceSetting&, const SourceSetting&) = default;
};

/// One way to mend what was found.
struct Remedy {
    Message words;
    std::vector<SourceSetting> settings = {};  ///< all of them together; where none, words alone
    bool registration = false;                 ///< to map it with registration
};

/// Something that a map would show wrong although every line of the tour can be read.
struct TourFinding {
    enum class Kind : std::uint8_t {
        clocks_apart,  ///< scans and odometry share no time; value: seconds between them
        scan_delay,    ///< the scans fit the odometry of another time; value: that less theirs [s]
        late_stamps,   ///< stamps differ from the times of receipt; value: to add to the scans' [s]
        ray_times,     ///< a sweep that takes longer than from scan to scan; value: its time [s]
        parts_of_a_turn,  ///< messages that hold some and cannot be joined; value: those
        clock_speed,  ///< the laser's clock runs at another speed; value: to be added a second [s]
        clock_set,    ///< it was set during the tour; value: to be added besides from then on [s]
        clock_back,   ///< a sequence's stamps go back to times that were; value: by how much [s]
        broken_stamps,     ///< many are out of line, or of no tour's time; value: share of them, or
                           ///< the step [s]
        coarse_stamps,     ///< several scans share a time; value: share of those
        assumed_mounting,  ///< nothing says where the laser sits; value: the lasers
        two_publishers,    ///< a frame goes to and fro between two places; value: how often
        mirrored_laser,    ///< the scans turn against the odometry; value: 1
        turned_laser,      ///< the scans move where the odometry does not; value: turn to the left
                           ///< [rad]
        wrong_fan,         ///< its rays go over another angle; value: that, by the scans [rad]
        misplaced_laser,   ///< it does not sit where the recording says; value: how far off [m]
        no_odometry,       ///< there are scans and no odometry; value: the scans
        unread_odometry,   ///< its messages cannot be read, the transforms are taken; value: those
        still_odometry,    ///< the scans change and the odometry does not; value: 0, or for how
                           ///< long [s]
        leaping_odometry,  ///< steps that no robot makes in their time; value: the longest [m]
        sideways_odometry,  ///< always off where the robot looks; value: by that, to the left; or
                            ///< headings that turn against its way; value: both together [rad]
        odometry_scale,  ///< it counts too far or too short; value: the way by the scans over its
                         ///< own
        odometry_turns,  ///< it turns too far or too little; value: the turn by the scans over its
                         ///< own
        odometry_units,  ///< all of it is too fast, or turns too far; value: median speed [m/s], or
                         ///< the turn that the scans make of one [rad]
        laser_units,     ///< readings of a distance that no such laser sees, or in coarse steps;
                         ///< value: median [m]
        beyond_a_turn,   ///< rays over more than a turn; value: angle from first to last [rad]
        blind_laser,     ///< hardly any scan has a point; value: share of those with none
        foreign_scans,   ///< scans of another place between others, or that fit nothing; value:
                         ///< share of those with such neighbours, or of their points that fit
        no_return,     ///< readings that say "nothing seen" are taken for walls; value: their range
                       ///< [m]
        self_hits,     ///< rays that always end on the robot; value: how many
        stuck_rays,    ///< rays that always read one number, and see; value: how many
        frozen_laser,  ///< the same ranges while the robot drives; value: share of such scans
        unfit_odometry,  ///< the scans do not lie where it puts them; value: share of their points
                         ///< that do, or how far it is off, of what is driven
        unsure_drawing   ///< a world's drawing may have other walls; value: its place of those
    };
    Kind kind = Kind::clocks_apart;
    double value = 0.0;
    Message what;  ///< what was found, with its number, and what it does to a map
    std::vector<Remedy> remedies = {};   ///< one of them is to be taken, the likeliest first
    std::optional<double> later_s = {};  ///< where scans of another time fit: what is added to it
};

/// The settings as one gives them to a program: "--scan-delay -1.72 --set source.fan_scale=0.5".
std::string options_of(const std::vector<SourceSetting>& settings);
/// All remedies with their options, in one line.
Message advice_of(const TourFinding& finding);
/// What was found and what to do, in one line.
Message sentence_of(const TourFinding& finding);

/// The word of a kind, for programs: "scan-delay".
std::string_view word_of(TourFinding::Kind kind);

}  // namespace hitos
