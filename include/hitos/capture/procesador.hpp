// SPDX-License-Identifier: GPL-3.0-or-later
// Hands out scans and odometry in the normalised form [T 9.2.2].
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/capture/conversor.hpp"
#include "hitos/capture/fuente.hpp"
#include "hitos/capture/odometry_axes.hpp"
#include "hitos/capture/odometry_steps.hpp"
#include "hitos/capture/scan.hpp"
#include "hitos/capture/scan_clock.hpp"
#include "hitos/capture/stamp_line.hpp"

namespace hitos {

class OdometryTrack;

/// The reader of text logs [T fig 9.4]: raw lines of a source, through the converter of its format.
///
/// * A scan or a reading whose stamp is out of line with those before and behind it is left out as
///   a damaged line is (StampJudge).
/// * A scan that repeats the stamp and the ranges of the one before is left out and counted.
/// * Poses become twists that reproduce them exactly (twist_between); a reading whose stamp does
///   not advance is put 1 ms after the one before, so that file order and every pose are kept. One
///   that repeats stamp and pose says nothing new and is left out.
/// * Logged velocities are held from the reading before; where the stamp does not advance there is
///   no time to hold them, so such a reading is left out and counted.
/// * A scan before the first odometry reading is counted, and left out where the options say so.
///   Without any odometry there is no scan before it.
/// * Where the options let it mend: rays of several times are moved to where they would lie had all
///   been measured at the scan's time, unless a scan is said to take longer than from one to the
///   next; steps that no robot makes go by OdometrySteps.
/// * Damaged lines are left out, counted and reported with their number. A line that is scan and
///   odometry at once (CARMEN's FLASER) counts when the scan sequence passes over it.
class Procesador final : public TourReader {
  public:
    explicit Procesador(std::unique_ptr<Fuente> fuente, ReadOptions options = {});
    ~Procesador() override;
    Procesador(const Procesador&) = delete;
    Procesador& operator=(const Procesador&) = delete;

    /// A truncated gzip file hands out what can be read, then counts as damage.
    std::optional<Scan> next_scan() override;
    std::optional<Odometria> next_odometry() override;
    void restart() override;
    std::unique_ptr<TourReader> reopen() const override;
    const ReadReport& report() const override { return report_; }
    std::optional<double> progress() const override { return fuente_->progress(); }
    std::string name() const override { return fuente_->name(); }
    std::string format() const override;
    ReadOptions options() const override { return options_; }
    std::vector<TourFinding> findings() const override;
    /// Whether there is any odometry; looked for once, also for all that are reopened from this
    /// one.
    bool has_odometry();

  private:
    /// How long the scans' sweeps are said to take, against the time from scan to scan.
    struct Sweeps {
        std::uint64_t scans = 0;
        std::uint64_t too_long = 0;
        double longest_s = 0.0;
        std::array<double, 4> periods_s{};  ///< newest times from scan to scan
        std::optional<double> last_s;
    };
    /// As the log has it, but for those with a broken stamp.
    std::optional<Scan> read_scan();
    std::optional<OdometryRecord> read_odometry();
    void mend(Scan& scan);
    void note_motion(const OdometryRecord& record);
    std::optional<Odometria> from_pose(const OdometryRecord& record);
    std::optional<Odometria> from_velocity(const OdometryRecord& record);
    Odometria hand_out(double time_s, Twist twist, std::uint64_t line);
    void look_ahead();
    /// Whether it was taken before the first odometry reading.
    bool is_early(const Scan& scan);
    void begin_report();
    void collect_damage();
    void note_damage(std::uint64_t line, Message reason);

    std::unique_ptr<Fuente> fuente_;
    ReadOptions options_;
    std::unique_ptr<Conversor> conversor_scans_;
    std::unique_ptr<Conversor> conversor_odometry_;
    ReadReport report_;
    std::optional<Scan> last_scan_;
    std::optional<OdometryRecord> last_odometry_;
    std::unique_ptr<OdometryTrack> track_;  ///< where scans are unwarped
    Sweeps sweeps_;
    StampLine<Scan> scans_;
    StampReturns scan_returns_;  ///< of their times as they are mended
    StampReturns odometry_returns_;
    StampLine<OdometryRecord> records_;
    ScanClock clock_;
    OdometryAxes axes_;
    OdometrySteps steps_;
    bool poses_move_ = false;
    bool velocities_move_ = false;
    std::optional<Pose> first_pose_;
    bool only_poses_ = false;  ///< no reading with a velocity, where these are asked for
    double clock_s_ = 0.0;     ///< time of the last odometry reading handed out
    bool looked_ahead_ = false;
    std::optional<double> odometry_begin_s_;  ///< once looked ahead: nothing where there is none
};

}  // namespace hitos
