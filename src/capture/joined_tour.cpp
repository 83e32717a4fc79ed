// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/capture/joined_tour.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "laser_pose.hpp"

namespace hitos {
namespace {

/// What both have left out and why, together.
ReadReport together(const ReadReport& a, const ReadReport& b) {
    ReadReport sum = a;
    sum.scans += b.scans;
    sum.odometry += b.odometry;
    sum.duplicate_scans += b.duplicate_scans;
    sum.stamps_backwards += b.stamps_backwards;
    sum.early_scans += b.early_scans;
    sum.early_scans_left_out += b.early_scans_left_out;
    sum.skipped += b.skipped;
    const std::size_t free =
        ReadReport::kExamples - std::min(ReadReport::kExamples, a.examples.size());
    sum.examples.insert(
        sum.examples.end(), b.examples.begin(),
        b.examples.begin() + static_cast<std::ptrdiff_t>(std::min(free, b.examples.size())));
    sum.of_recording = a.of_recording && b.of_recording;
    return sum;
}

class JoinedTour final : public TourReader {
  public:
    JoinedTour(FirstTour first, std::unique_ptr<TourReader> second, TourBegin begin)
        : run_(std::move(first.results)),
          stamps_(std::move(first.stamps_s)),
          first_(std::move(first.reader)),
          second_(std::move(second)),
          begin_(begin) {}

    std::optional<Scan> next_scan() override {
        if (!scans_of_second_) {
            if (std::optional<Scan> scan = first_->next_scan()) {
                check_first(*scan);
                ++read_;
                return scan;
            }
            check_first_whole();
        }
        std::optional<Scan> scan = second_->next_scan();
        if (!scan) {
            if (!scans_of_second_) throw without_scans();
            return scan;
        }
        if (!std::exchange(scans_of_second_, true)) {
            begin_.lines_before = behind().lines;
            scan->begins_tour = begin_;
        }
        put_behind(*scan);
        return scan;
    }
    std::optional<Odometria> next_odometry() override {
        if (!odometry_of_second_) {
            if (std::optional<Odometria> reading = first_->next_odometry()) return reading;
        }
        std::optional<Odometria> reading = second_->next_odometry();
        if (!reading) return reading;
        if (!std::exchange(odometry_of_second_, true)) reading->lines_before = behind().lines;
        put_behind(*reading);
        return reading;
    }
    void restart() override {
        first_->restart();
        second_->restart();
        scans_of_second_ = odometry_of_second_ = false;
        read_ = 0;
    }
    std::unique_ptr<TourReader> reopen() const override {
        return std::make_unique<JoinedTour>(FirstTour{first_->reopen(), run_, stamps_},
                                            second_->reopen(), begin_);
    }
    const ReadReport& report() const override {
        return report_ = together(first_->report(), second_->report());
    }
    std::optional<double> progress() const override {
        const TourReader& now = scans_of_second_ ? *second_ : *first_;
        const std::optional<double> of_now = now.progress();
        if (!of_now) return of_now;
        return 0.5 * (*of_now + (scans_of_second_ ? 1.0 : 0.0));
    }
    std::string name() const override { return second_->name(); }
    std::string format() const override { return second_->format(); }
    ReadOptions options() const override { return second_->options(); }
    std::vector<TourFinding> findings() const override { return second_->findings(); }

  private:
    /// Each scan was made when its run says.
    void check_first(const Scan& scan) const {
        constexpr double kSame = 1e-6;  // [s]
        if (read_ >= stamps_.size() || std::abs(scan.stamp_s() - stamps_[read_]) <= kSame) return;
        throw FileError(run_,
                        HITOS_TEXT("Errors",
                                   "holds the results of a tour whose scan %1 has the stamp %2 s, "
                                   "and in its log %3 that has %4 s: the log has changed; run it "
                                   "again"),
                        read_ + 1, stamps_[read_], first_->name(), scan.stamp_s());
    }
    void check_first_whole() const {
        if (stamps_.empty() || read_ == stamps_.size()) return;
        throw FileError(run_,
                        HITOS_TEXT("Errors",
                                   "holds the results of %1 scans, and its log %2 has %3: "
                                   "it was stopped, or the log has changed; run it again"),
                        stamps_.size(), first_->name(), read_);
    }
    FormatError without_scans() const {
        return {second_->name(), 0,
                message(HITOS_TEXT("Errors",
                                   "%1; expected at least one scan: check the file and its "
                                   "format"),
                        marked(HITOS_TEXT("Errors", "found no readable scan")))};
    }
    /// What is added to the second tour's stamps and lines.
    struct Behind {
        double time_s = 0.0;
        std::uint64_t lines = 0;
    };

    /// Known before either sequence gets there: the sequences do not wait for each other.
    const Behind& behind() {
        if (behind_) return *behind_;
        Behind behind;
        double end_s = -std::numeric_limits<double>::infinity();
        const std::unique_ptr<TourReader> all = first_->reopen();
        const auto note = [&](const auto& item) {
            end_s = std::max(end_s, item.time_s);
            behind.lines = std::max(behind.lines, item.line);
        };
        while (const std::optional<Scan> scan = all->next_scan()) {
            note(*scan);
            end_s = std::max(end_s, scan->stamp_s());  // what paths are stamped with goes on too
        }
        while (const std::optional<Odometria> reading = all->next_odometry()) note(*reading);
        double begin_s = std::numeric_limits<double>::infinity();
        const std::unique_ptr<TourReader> other = second_->reopen();
        if (const std::optional<Scan> scan = other->next_scan())
            begin_s = std::min(scan->time_s, scan->stamp_s());
        if (const std::optional<Odometria> reading = other->next_odometry())
            begin_s = std::min(begin_s, reading->time_s);
        if (begin_s <= end_s) behind.time_s = std::floor(end_s - begin_s) + 1.0;
        return behind_.emplace(behind);
    }
    template <class Item>
    void put_behind(Item& item) {
        item.time_s += behind().time_s;
        item.line += behind().lines;
    }

    std::string run_;
    std::vector<double> stamps_;  // of the first's scans; empty: any
    std::unique_ptr<TourReader> first_;
    std::unique_ptr<TourReader> second_;
    TourBegin begin_;
    std::uint64_t read_ = 0;  // scans of the first
    std::optional<Behind> behind_;
    bool scans_of_second_ = false;
    bool odometry_of_second_ = false;
    mutable ReadReport report_;
};

}  // namespace

std::optional<Pose> start_of(const std::string& text) {
    if (input::trimmed(text).empty()) return std::nullopt;
    constexpr double kMost = 1e6;  // [m], and degrees
    const std::optional<PoseWords> said = pose_words(input::listed(text));
    if (!said ||
        !(std::max({std::abs(said->x), std::abs(said->y), std::abs(said->degrees)}) < kMost)) {
        throw ConfigError("source.start",
                          HITOS_TEXT("Errors",
                                     "found \"%1\", expected a pose in the map as "
                                     "\"x,y,degrees\", in metres"),
                          text);
    }
    return said->pose();
}

std::unique_ptr<TourReader> make_joined_tour(FirstTour first, std::unique_ptr<TourReader> second,
                                             TourBegin begin) {
    return std::make_unique<JoinedTour>(std::move(first), std::move(second), begin);
}

}  // namespace hitos
