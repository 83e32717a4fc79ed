// SPDX-License-Identifier: GPL-3.0-or-later
// A log file as a source [T 9.2.2], plain or gzip, streamed in bounded memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/capture/fuente.hpp"
#include "hitos/capture/held_damage.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/capture/tour_reader.hpp"

namespace hitos {

/// A longer line is damage: it is skipped, counted and never held in memory whole.
inline constexpr std::size_t kLongestLine = std::size_t{1} << 20;

/// A text log on disk. Each cursor has its own file handle, so memory does not grow with the file.
class Archivo final : public Fuente {
  public:
    /// Throws FileError where the path is missing, a directory, or cannot be read.
    Archivo(std::filesystem::path path, const LogFormat& format, ReadOptions options = {});
    ~Archivo() override;
    Archivo(const Archivo&) = delete;
    Archivo& operator=(const Archivo&) = delete;

    const LogFormat& format() const override { return format_; }
    std::optional<RawLine> read_scan_line() override;
    std::optional<RawLine> read_odometry_line() override;
    std::optional<double> progress() const override;
    std::string name() const override;
    std::optional<std::pair<std::uint64_t, Message>> take_damage() override {
        return damage_.take();
    }
    std::vector<TourFinding> findings() const override;
    std::unique_ptr<Fuente> reopen() const override;
    std::unique_ptr<Fuente> opening() const override;

  private:
    struct Cursor;
    enum class Part : std::uint8_t { whole, opening };
    Archivo(std::filesystem::path path, const LogFormat& format, ReadOptions options, Part part);
    std::optional<RawLine> read(Cursor& cursor, LineKind wanted);

    std::filesystem::path path_;
    const LogFormat& format_;
    ReadOptions options_;  // as far as its format's doubts depend on them
    Part part_ = Part::whole;
    bool apart_ = false;  // whether the cursors read two files
    std::unique_ptr<Cursor> scans_;
    std::unique_ptr<Cursor> odometry_;
    HeldDamage damage_;
};

/// Opens a log: text, or a ROS recording, which may be a folder. With "auto" the format is found
/// from the first lines or bytes; another word is held against them. Of the options the topics
/// count. Throws ConfigError for a word that no format has and for topics, FileError (missing,
/// directory without a recording, unreadable) or FormatError (empty, not text, of another format
/// than said, of none that Hitos reads), naming what was found and expected.
std::unique_ptr<Fuente> open_log(const std::filesystem::path& path,
                                 std::string_view format = kAutoFormat,
                                 const ReadOptions& options = {});

/// The parameters under which open_log() refuses topics, and a choice that is still to be made.
inline constexpr const char* kScanTopicKey = "source.scan_topic";
inline constexpr const char* kOdomTopicKey = "source.odom_topic";
inline constexpr const char* kSameFramesKey = "source.same_frames";
inline constexpr const char* kLaserPoseKey = "source.laser_pose";
inline constexpr const char* kScanDelayKey = "source.scan_delay";
inline constexpr const char* kScanClockKey = "source.scan_clock";
inline constexpr const char* kOdometryAxesKey = "source.odometry_axes";

/// The format of a ROS recording, by its first bytes, or of a folder; null where the path is
/// neither. Throws FileError.
const LogFormat* recording_format(const std::filesystem::path& path);

/// Whether the path is a ROS recording, by its first bytes, or a folder; false where it is missing.
bool is_recording(const std::filesystem::path& path);

/// Whether the folder holds the files of a ROS recording, also where they cannot be read.
bool is_recording_folder(const std::filesystem::path& folder);

/// The files that a log is read from: itself, or those of a recording's folder.
std::vector<std::filesystem::path> log_files(const std::filesystem::path& path);

}  // namespace hitos
