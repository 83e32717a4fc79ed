// SPDX-License-Identifier: GPL-3.0-or-later
// From the lines of a recording's source to records.
#include <cstring>
#include <type_traits>

#include "formats/formats.hpp"
#include "hitos/base/error.hpp"
#include "ros/recording_lines.hpp"
#include "ros/recording_source.hpp"

namespace hitos {
namespace {

static_assert(std::is_trivially_copyable_v<ScanLine> && std::is_trivially_copyable_v<OdometryLine>);

template <class Line>
Line head_of(const RawLine& line) {
    Line head;
    if (line.text.size() < sizeof head) {
        throw FormatError({}, line.number, HITOS_TEXT("Errors", "the data end early"));
    }
    std::memcpy(static_cast<void*>(&head), line.text.data(), sizeof head);
    return head;
}

class RecordingConversor final : public RangeConversor {
  public:
    using RangeConversor::RangeConversor;

    bool parse_scan(const RawLine& line, Readings& out) override {
        const auto head = head_of<ScanLine>(line);
        out.time_s = head.time_s;
        out.fan = head.fan;
        // By definition readings up to range_max are returns; those at it are no points, as
        // simulators say "no return" so.
        out.max_is_exact = head.fan.max_range_m > 0.0;
        const std::string_view ranges = line.text.substr(sizeof head);
        const std::size_t rays = head.fan.count;
        if (ranges.size() != (head.timed ? 2 : 1) * rays * sizeof(float)) {
            throw FormatError({}, line.number, HITOS_TEXT("Errors", "the data end early"));
        }
        const auto number = [&ranges](std::size_t i) {
            float value = 0.0F;
            std::memcpy(&value, ranges.data() + i * sizeof value, sizeof value);
            return value;
        };
        out.ranges_m.resize(rays);
        for (std::size_t i = 0; i < rays; ++i) out.ranges_m[i] = static_cast<double>(number(i));
        out.ray_times_s.resize(head.timed ? rays : 0);
        for (std::size_t i = 0; i < out.ray_times_s.size(); ++i) {
            out.ray_times_s[i] = number(rays + i);
        }
        return true;
    }

    std::optional<OdometryRecord> odometry(const RawLine& line) override {
        const auto head = head_of<OdometryLine>(line);
        OdometryRecord record;
        record.time_s = head.time_s;
        record.pose_odom_robot = head.pose_odom_robot;
        if (head.has_twist) record.velocity = head.twist;
        record.line = line.number;
        return record;
    }
};

}  // namespace

void put_line(std::string& text, const MountedScan& scan) {
    const ScanLine head{seconds_of(scan.stamp_ns), scan.fan, !scan.ray_times_s.empty()};
    const auto put = [&text](const void* from, std::size_t bytes) {
        text.append(static_cast<const char*>(from), bytes);
    };
    text.clear();
    put(&head, sizeof head);
    put(scan.ranges_m.data(), scan.ranges_m.size() * sizeof(float));
    put(scan.ray_times_s.data(), scan.ray_times_s.size() * sizeof(float));
}

void put_line(std::string& text, const OdometryLine& line) {
    text.resize(sizeof line);
    std::memcpy(text.data(), &line, sizeof line);
}

std::unique_ptr<Conversor> make_recording_conversor(const Fuente& fuente,
                                                    const ReadOptions& options) {
    return make_range_conversor<RecordingConversor>(fuente, options);
}

std::vector<TourFinding> recording_doubts(const Fuente& fuente, const ReadOptions& options) {
    return range_doubts<RecordingConversor>(fuente, options);
}

}  // namespace hitos
