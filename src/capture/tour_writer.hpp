// SPDX-License-Identifier: GPL-3.0-or-later
// What the writers of all formats have in common: order, poses, and the file.
#pragma once

#include <deque>
#include <filesystem>
#include <memory>
#include <string>

#include "hitos/base/atomic_file.hpp"
#include "hitos/capture/log_writer.hpp"

namespace hitos {

/// Holds scans until the pose at their time is known and hands them, with it, to the format.
class TourWriter : public LogWriter {
  public:
    explicit TourWriter(const std::filesystem::path& path) : path_(path), file_(path, true) {}

    void write(const Scan& scan) final;
    void write(const Scan& scan, const Odometria* next) final;
    void write(const Odometria& odometry) final;
    void finish() final;

  protected:
    /// A scan's part that does not depend on the pose, ready to be written.
    struct Prepared {
        Fan fan;                  ///< as said in the file
        std::string text;         ///< of the readings
        double ray_time_s = 0.0;  ///< from one ray to the next
        bool landmarks = false;   ///< the text is of landmarks, not of points
    };

    /// Throws FormatError where the format cannot say the scan.
    virtual Prepared prepare(const Scan& scan) = 0;
    /// Whether the format has words for landmarks that a sensor tells by themselves.
    virtual bool says_landmarks() const { return false; }
    virtual void put_scan(std::string& out, const Prepared& scan, double time_s,
                          const Pose& pose_odom_robot) = 0;
    virtual void put_odometry(std::string& out, const Odometria& odometry,
                              const Pose& pose_odom_robot) = 0;
    /// What the file begins with.
    virtual void put_head(std::string& out) { static_cast<void>(out); }
    /// What it ends with.
    virtual void put_tail(std::string& out) { static_cast<void>(out); }

  private:
    struct Pending {
        double time_s = 0.0;
        std::uint64_t line = 0;  ///< of the reading that the scan carries; 0: it carries none
        Prepared prepared;
    };

    void put_before(const Odometria& reading);
    void put_rest();
    void put_pending(double time_s, const Pose& pose_odom_robot);
    Pose pose_at(double time_s, const Odometria& reading, double begin_s, const Pose& pose) const;
    void flush();

    std::filesystem::path path_;
    AtomicFile file_;
    std::string out_;
    bool has_head_ = false;
    std::deque<Pending> pending_;
    bool has_reading_ = false;
    Odometria last_;             // the newest reading
    double last_begin_s_ = 0.0;  // where its interval begins
    Pose pose_odom_robot_;       // at its time
};

/// A reading with four decimals that neither rounds to "nothing" (0) nor to the greatest range.
double writable_range(double range_m, double max_range_m);

}  // namespace hitos
