// Hands out scans and odometry in the normalised form [T 9.2.2].
#pragma once

#include <array>
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
    std::uint64_t skipped = 0;           ///< damaged lines
    std::vector<Skip> examples;          ///< the first kExamples damaged lines, by line
};

/// The reader that the layers above use: set a source, then ask for scans and odometry in turn;
/// the two sequences are independent.
///
/// * A scan that repeats the stamp and the ranges of the one before is left out and counted.
/// * Poses become twists that reproduce them exactly (twist_between); a reading whose stamp does
///   not advance is put 1 ms after the one before, so that file order and every pose are kept.
/// * Damaged lines are left out, counted and reported with their number.
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

/// Counts of a whole log, for dialogs and summaries.
struct LogSummary {
    LogFormat format = LogFormat::automatic;
    ReadReport report;
    double first_stamp_s = 0.0;
    double duration_s = 0.0;
    Fan fan;  ///< of the first scan
    std::vector<std::string> first_lines;
};

}  // namespace hitos
