// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/procesador.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "hitos/base/digest.hpp"
#include "hitos/base/error.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/capture/odometry_track.hpp"
#include "remedies.hpp"
#include "stamp_doubts.hpp"

namespace hitos {
namespace {

/// Odometry has no readings to judge; a stated range spares its converter the look ahead.
ReadOptions without_look_ahead(ReadOptions options) {
    if (!(options.max_range_m > 0.0)) options.max_range_m = 1.0;
    return options;
}

constexpr double kRepairStep = 1e-3;
/// Of a line that is a scan's too: that one's stamp is told.
constexpr std::uint64_t kTold = 0;

void scale(OdometryRecord& record, double factor) {
    if (record.pose_odom_robot) {
        record.pose_odom_robot->x *= factor;
        record.pose_odom_robot->y *= factor;
    }
    if (record.velocity) {
        record.velocity->v *= factor;
        record.velocity->v_lateral *= factor;
    }
}

void turn(Twist& twist, double factor) {
    twist.w *= factor;
    if (factor < 0.0) twist.v_lateral = -twist.v_lateral;
}

}  // namespace

Procesador::Procesador(std::unique_ptr<Fuente> fuente, ReadOptions options)
    : fuente_(std::move(fuente)),
      options_(std::move(options)),
      conversor_scans_(fuente_->format().make_conversor(*fuente_, options_)),
      conversor_odometry_(fuente_->format().make_conversor(*fuente_, without_look_ahead(options_))),
      clock_(options_.scan_clock),
      axes_(options_.odometry_axes) {
    begin_report();
}

Procesador::~Procesador() = default;

void Procesador::begin_report() {
    report_ = {};
    report_.of_recording = fuente_->format().open != nullptr;
}

void Procesador::restart() {
    // All that can throw comes first, so that a failure leaves the reader where it was.
    std::unique_ptr<Fuente> fresh = fuente_->reopen();
    std::unique_ptr<Conversor> scans = fresh->format().make_conversor(*fresh, options_);
    std::unique_ptr<Conversor> odometry =
        fresh->format().make_conversor(*fresh, without_look_ahead(options_));
    fuente_ = std::move(fresh);
    conversor_scans_ = std::move(scans);
    conversor_odometry_ = std::move(odometry);
    begin_report();
    last_scan_.reset();
    last_odometry_.reset();
    track_.reset();
    sweeps_ = {};
    scan_returns_ = odometry_returns_ = {};
    scans_ = {};
    records_ = {};
    clock_ = ScanClock(options_.scan_clock);
    axes_ = OdometryAxes(options_.odometry_axes);
    steps_ = {};
    poses_move_ = velocities_move_ = false;
    first_pose_.reset();
    clock_s_ = 0.0;
}

std::unique_ptr<TourReader> Procesador::reopen() const {
    auto again = std::make_unique<Procesador>(fuente_->reopen(), options_);
    again->looked_ahead_ = looked_ahead_;
    again->odometry_begin_s_ = odometry_begin_s_;
    again->only_poses_ = only_poses_;
    return again;
}

std::string Procesador::format() const {
    return fuente_->format().word;
}

void Procesador::note_damage(std::uint64_t line, Message reason) {
    ++report_.skipped;
    // Two cursors find damage in two orders; the report has it in the log's.
    std::vector<ReadReport::Skip>& examples = report_.examples;
    const auto place = std::upper_bound(
        examples.begin(), examples.end(), line,
        [](std::uint64_t number, const ReadReport::Skip& skip) { return number < skip.line; });
    if (place == examples.end() && examples.size() >= ReadReport::kExamples) return;
    examples.insert(place, {line, std::move(reason)});
    if (examples.size() > ReadReport::kExamples) examples.pop_back();
}

void Procesador::collect_damage() {
    while (std::optional<std::pair<std::uint64_t, Message>> damage = fuente_->take_damage()) {
        note_damage(damage->first, std::move(damage->second));
    }
}

std::optional<Scan> Procesador::read_scan() {
    for (;;) {
        std::optional<Scan> next = scans_.take(
            [this](std::uint64_t line, Message reason) { note_damage(line, std::move(reason)); });
        if (next || scans_.ended()) return next;
        const std::optional<RawLine> line = fuente_->read_scan_line();
        collect_damage();
        try {
            std::optional<Scan> scan =
                line ? conversor_scans_->scan(*line) : conversor_scans_->last_scan();
            if (scan) {
                if (line) scan->mark.value = short_digest(line->text);
                const double time_s = scan->time_s;
                const std::uint64_t number = scan->line;
                scans_.add(time_s, number, *std::move(scan));
            } else if (!line) {
                scans_.end();
            }
        } catch (const FormatError& error) {
            note_damage(line ? line->number : 0, error.problem());
        }
    }
}

std::optional<Scan> Procesador::next_scan() {
    while (std::optional<Scan> scan = read_scan()) {
        if (last_scan_ && last_scan_->time_s == scan->time_s &&
            last_scan_->points == scan->points && last_scan_->rays == scan->rays &&
            last_scan_->run_starts == scan->run_starts &&
            last_scan_->landmarks == scan->landmarks) {
            ++report_.duplicate_scans;
            continue;
        }
        last_scan_ = *scan;
        const double late_s = options_.scan_delay_s + clock_.added(scan->time_s);
        if (late_s != 0.0) {
            const double logged_s = scan->time_s;
            scan->time_s += late_s;
            scan->delay_s = scan->time_s - logged_s;
            scan->carries_odometry = false;
        }
        scan_returns_.note(scan->time_s, scan->line);
        if (is_early(*scan)) {
            if (options_.leave_out_early_scans) {
                ++report_.early_scans_left_out;
                continue;
            }
            ++report_.early_scans;
        }
        if (options_.mend != Mend::nothing && !scan->times_s.empty()) mend(*scan);
        ++report_.scans;
        return scan;
    }
    return std::nullopt;
}

void Procesador::mend(Scan& scan) {
    // A sweep ends before the next one begins; what says otherwise is wrong.
    constexpr double kLongest = 1.5;      // times that between two scans,
    constexpr double kSlowestTurn = 2.0;  // and of any laser [s]
    const auto [first, last] = std::ranges::minmax(scan.times_s);
    const auto sweep_s = static_cast<double>(last - first);
    if (sweeps_.last_s) {
        sweeps_.periods_s.at(sweeps_.scans % sweeps_.periods_s.size()) =
            scan.time_s - *sweeps_.last_s;
    }
    sweeps_.last_s = scan.time_s;
    ++sweeps_.scans;
    const double period_s = std::ranges::max(sweeps_.periods_s);
    if (sweep_s > kSlowestTurn || (period_s > 0.0 && sweep_s > kLongest * period_s)) {
        ++sweeps_.too_long;
        sweeps_.longest_s = std::max(sweeps_.longest_s, sweep_s);
        scan.times_s.clear();
        return;
    }
    if (!track_) {
        // By a reader of its own: what this one's odometry sequence reads belongs to that sequence.
        auto ahead = std::make_shared<Procesador>(fuente_->reopen(), without_look_ahead(options_));
        track_ = std::make_unique<OdometryTrack>([ahead] { return ahead->next_odometry(); });
    }
    scan.first_s = scan.times_s.front();
    scan.last_s = scan.times_s.back();
    unwarp(scan, *track_);
}

std::vector<TourFinding> Procesador::findings() const {
    std::vector<TourFinding> found;
    try {
        found = fuente_->findings();
    } catch (const FileError&) {  // it reads the beginning again, and the file may be gone
    }
    if (2 * sweeps_.too_long > sweeps_.scans) {
        found.push_back(
            {TourFinding::Kind::ray_times,
             sweeps_.longest_s,
             message(HITOS_TEXT("Errors",
                                "a scan's rays are said to take %1 s, more than from one scan to "
                                "the next; they are taken to be of one time"),
                     fmt::format("{:.3g}", sweeps_.longest_s)),
             {{marked(HITOS_TEXT("Errors",
                                 "let the driver say how long it takes from one ray to the next "
                                 "(time_increment)"))}}});
    }
    doubt_returns(scan_returns_, odometry_returns_, report_, found);
    doubt_broken_stamps(scans_.broken(), records_.broken(), found);
    steps_.tell(found, options_);
    const auto still = [&](OdometryFrom asked, Message what, Remedy remedy) {
        if (options_.odometry != asked || report_.odometry < 2) return;
        found.push_back(
            {TourFinding::Kind::still_odometry, 0.0, std::move(what), {std::move(remedy)}});
    };
    if (velocities_move_ && first_pose_ && !poses_move_) {
        still(OdometryFrom::poses,
              marked(HITOS_TEXT("Errors",
                                "the odometry's poses never change although its velocities do; all "
                                "scans are put on one place")),
              take_velocities());
    }
    if (poses_move_ && !velocities_move_) {
        still(OdometryFrom::velocities,
              marked(HITOS_TEXT("Errors",
                                "the odometry's velocities are 0 although its poses change; all "
                                "scans are put on one place")),
              take_poses());
    }
    if (only_poses_) {
        found.push_back({TourFinding::Kind::no_odometry,
                         static_cast<double>(report_.scans),
                         marked(HITOS_TEXT("Errors",
                                           "the odometry has poses and no velocities, which are "
                                           "asked for: none of it is used")),
                         {take_poses()}});
    }
    return found;
}

void Procesador::look_ahead() {
    if (looked_ahead_) return;
    // By a reader of its own: what this one's odometry sequence loses belongs to that sequence.
    ReadOptions of_opening = without_look_ahead(options_);
    of_opening.opening_bytes = 0;
    Procesador ahead(fuente_->opening(), of_opening);
    const std::optional<Odometria> first = ahead.next_odometry();
    if (first) odometry_begin_s_ = first->time_s;
    only_poses_ = ahead.only_poses_;
    looked_ahead_ = true;
}

bool Procesador::has_odometry() {
    look_ahead();
    return odometry_begin_s_.has_value();
}

bool Procesador::is_early(const Scan& scan) {
    if (scan.carries_odometry) return false;
    look_ahead();
    return odometry_begin_s_ && scan.time_s < *odometry_begin_s_;
}

std::optional<OdometryRecord> Procesador::read_odometry() {
    for (;;) {
        std::optional<OdometryRecord> next =
            records_.take([this](std::uint64_t line, Message reason) {
                if (line != kTold) note_damage(line, std::move(reason));
            });
        if (next || records_.ended()) return next;
        const std::optional<RawLine> line = fuente_->read_odometry_line();
        collect_damage();
        if (!line) {
            records_.end();
            continue;
        }
        try {
            if (std::optional<OdometryRecord> record = conversor_odometry_->odometry(*line)) {
                records_.add(record->time_s, line->shared ? kTold : line->number, *record);
            }
        } catch (const FormatError& error) {
            if (!line->shared) note_damage(line->number, error.problem());
        }
    }
}

std::optional<Odometria> Procesador::next_odometry() {
    // Live, who has none at first has none: it would be waited for to the tour's end.
    if (options_.opening_bytes > 0 && !has_odometry()) return std::nullopt;
    while (std::optional<OdometryRecord> record = read_odometry()) {
        if (record->pose_odom_robot)
            record->pose_odom_robot = axes_.taken(*record->pose_odom_robot);
        scale(*record, options_.odometry_scale);  // leaps are those of metres
        const bool by_pose =
            record->pose_odom_robot && options_.odometry != OdometryFrom::velocities;
        note_motion(*record);
        odometry_returns_.note(record->time_s, record->line);
        const std::optional<Odometria> reading =
            by_pose ? from_pose(*record) : from_velocity(*record);
        if (reading) return reading;
    }
    return std::nullopt;
}

/// Rounding is no motion.
void Procesador::note_motion(const OdometryRecord& record) {
    constexpr double kMoves = 1e-3;  // [m], [rad], [m/s], [rad/s]
    const auto beyond = [](double x, double y, double turn) {
        return std::hypot(x, y) > kMoves || std::abs(turn) > kMoves;
    };
    if (const auto& twist = record.velocity; twist && beyond(twist->v, twist->v_lateral, twist->w))
        velocities_move_ = true;
    if (!record.pose_odom_robot) return;
    if (!first_pose_) first_pose_ = record.pose_odom_robot;
    const Pose step = between(*first_pose_, *record.pose_odom_robot);
    if (beyond(step.x, step.y, step.theta)) poses_move_ = true;
}

std::optional<Odometria> Procesador::from_pose(const OdometryRecord& record) {
    const Pose pose = *record.pose_odom_robot;
    if (!last_odometry_) {
        last_odometry_ = record;
        return hand_out(record.time_s, {}, record.line);
    }
    const Pose before = *last_odometry_->pose_odom_robot;
    if (record.time_s == last_odometry_->time_s && pose == before) return std::nullopt;
    double time_s = record.time_s;
    if (!(time_s > clock_s_)) {
        ++report_.stamps_backwards;
        time_s = clock_s_ + kRepairStep;
    }
    const Pose step =
        options_.mend == Mend::all ? steps_.taken(*last_odometry_, record) : between(before, pose);
    last_odometry_ = record;
    return hand_out(time_s, twist_between(step, time_s - clock_s_), record.line);
}

std::optional<Odometria> Procesador::from_velocity(const OdometryRecord& record) {
    only_poses_ = !record.velocity && report_.odometry == 0;
    if (!record.velocity) return std::nullopt;  // a scan's pose among velocities
    if (!last_odometry_) {
        last_odometry_ = record;
        return hand_out(record.time_s, {}, record.line);
    }
    if (!(record.time_s > clock_s_)) {
        const bool repeated =
            record.time_s == last_odometry_->time_s && record.velocity == last_odometry_->velocity;
        if (!repeated) ++report_.stamps_backwards;
        return std::nullopt;
    }
    last_odometry_ = record;
    return hand_out(record.time_s, *record.velocity, record.line);
}

Odometria Procesador::hand_out(double time_s, Twist twist, std::uint64_t line) {
    clock_s_ = time_s;
    turn(twist, options_.odometry_turns);
    ++report_.odometry;
    return {time_s, twist, line};
}

}  // namespace hitos
