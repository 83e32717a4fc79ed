// Hands out scans and odometry in the normalised form [T 9.2.2].
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hitos/capture/conversor.hpp"
#include "hitos/capture/fuente.hpp"
#include "hitos/capture/scan.hpp"

namespace hitos {

/// What was left out of a log and why.
struct ReadReport {
    struct Skip {
        std::uint64_t line = 0;
        std::string reason;
    };
    static constexpr std::size_t kExamples = 20;

    std::uint64_t scans = 0;
    std::uint64_t odometry = 0;
    std::uint64_t duplicate_scans = 0;   ///< same stamp and same ranges as the scan before
    std::uint64_t stamps_backwards = 0;  ///< readings whose stamp did not advance
    std::uint64_t skipped = 0;           ///< damaged lines, each counted once
    std::vector<Skip> examples;          ///< the first kExamples damaged lines, by line
};

/// The reader that the layers above use: set a source, then ask for scans and odometry in turn;
/// the two sequences are independent.
///
/// * A scan that repeats the stamp and the ranges of the one before is left out and counted.
/// * Poses become twists that reproduce them exactly (twist_between); a reading whose stamp does
///   not advance is put 1 ms after the one before, so that file order and every pose are kept. One
///   that repeats stamp and pose says nothing new and is left out.
/// * Logged velocities are held from the reading before; where the stamp does not advance there is
///   no time to hold them, so such a reading is left out and counted.
/// * Damaged lines are left out, counted and reported with their number. A line that is scan and
///   odometry at once (CARMEN's FLASER) counts when the scan sequence passes over it.
class Procesador {
  public:
    explicit Procesador(std::unique_ptr<Fuente> fuente, ReadOptions options = {});

    /// The next scan; nothing at the end. Throws FileError where the medium fails (a truncated
    /// gzip file hands out what can be read, then counts as damage).
    std::optional<Scan> next_scan();
    /// The next odometry reading; nothing at the end.
    std::optional<Odometria> next_odometry();

    /// Back to the beginning, with a fresh report.
    void restart();

    const ReadReport& report() const { return report_; }
    const Fuente& fuente() const { return *fuente_; }

  private:
    std::optional<Odometria> from_pose(const OdometryRecord& record);
    std::optional<Odometria> from_velocity(const OdometryRecord& record);
    Odometria hand_out(double time_s, const Twist& twist, std::uint64_t line);
    void collect_damage();
    void note_damage(std::uint64_t line, std::string reason);

    std::unique_ptr<Fuente> fuente_;
    ReadOptions options_;
    std::unique_ptr<Conversor> conversor_scans_;
    std::unique_ptr<Conversor> conversor_odometry_;
    ReadReport report_;
    std::optional<Scan> last_scan_;
    std::optional<OdometryRecord> last_odometry_;
    double clock_s_ = 0.0;  ///< time of the last odometry reading handed out
};

}  // namespace hitos
