// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/simulation/drive/perturbed_reader.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/random_stream.hpp"
#include "hitos/capture/derived_tour.hpp"

namespace hitos {
namespace {

constexpr std::uint64_t kScansLeftOut = 3;  // times the copy's number
constexpr double kRangeSigma = 0.01;        // m
constexpr double kLeastRange = 0.02;        // m
constexpr double kStepSigma = 0.03;         // of a step's length and turn
constexpr double kTurnSigma = 0.003;        // rad a step
// The streams of a scan: one for each of its points, and one for the step that leads to it.
constexpr std::uint32_t kStepStream = std::numeric_limits<std::uint32_t>::max();

bool moves(const Twist& twist) {
    return twist.v != 0.0 || twist.v_lateral != 0.0 || twist.w != 0.0;
}

class PerturbedReader final : public DerivedTour {
  public:
    PerturbedReader(std::unique_ptr<TourReader> reader, std::uint64_t copy)
        : DerivedTour(std::move(reader)), copy_(copy), clock_(tour().reopen()) {}

    std::optional<Scan> next_scan() override {
        if (at_.scans == 0) leave_out_scans(tour());
        std::optional<Scan> scan = tour().next_scan();
        if (!scan && at_.scans == 0) {
            throw FileError(name(),
                            HITOS_TEXT("Errors",
                                       "is too short for copy %1, which leaves out the first %2 "
                                       "scans; ask for fewer copies"),
                            copy_, kScansLeftOut * copy_);
        }
        if (scan) perturb(*scan, ++at_.scans);
        return scan;
    }
    std::optional<Odometria> next_odometry() override {
        if (at_.waiting.empty()) read_step();
        if (at_.waiting.empty()) return std::nullopt;
        const Odometria reading = at_.waiting.front();
        at_.waiting.pop_front();
        return reading;
    }
    void restart() override {
        std::unique_ptr<TourReader> clock = clock_->reopen();
        tour().restart();
        clock_ = std::move(clock);
        at_ = {};
    }
    std::unique_ptr<TourReader> reopen() const override {
        return std::make_unique<PerturbedReader>(tour().reopen(), copy_);
    }

    std::optional<Truth> truth() const override { return std::nullopt; }

  private:
    struct Place {
        std::uint64_t scans = 0;
        std::uint64_t steps = 0;
        double time_s = 0.0;            // of the last odometry reading
        std::optional<Odometria> next;  // read, of the next step
        std::deque<Odometria> waiting;  // the rest of this step
    };

    void leave_out_scans(TourReader& reader) const {
        for (std::uint64_t i = 0; i < kScansLeftOut * copy_ && reader.next_scan(); ++i) {
        }
    }

    double scan_time_s() {
        const std::optional<Scan> scan = clock_->next_scan();
        return scan ? scan->time_s : std::numeric_limits<double>::infinity();
    }

    RandomStream stream(std::uint64_t step, std::size_t index) const {
        return {copy_, RandomPurpose::laser_noise, step, static_cast<std::uint32_t>(index)};
    }

    void perturb(Scan& scan, std::uint64_t number) const {
        std::size_t index = 0;
        const auto perturbed = [&](double range) {
            return std::max(kLeastRange,
                            range + kRangeSigma * stream(number, index++).normal_pair()[0]);
        };
        const Pose& laser = scan.fan.pose_robot_laser;
        for (Point2& point : scan.points) {
            const double range = std::hypot(point.x - laser.x, point.y - laser.y);
            if (range == 0.0) continue;
            const double scale = perturbed(range) / range;
            point = {laser.x + scale * (point.x - laser.x), laser.y + scale * (point.y - laser.y)};
        }
        for (LandmarkSighting& seen : scan.landmarks) seen.range_m = perturbed(seen.range_m);
    }

    /// The reading that sets the clock: the last one before the first scan that is left.
    void begin() {
        leave_out_scans(*clock_);
        const double begin_s = scan_time_s();
        std::optional<Odometria> first = tour().next_odometry();
        while (first && (at_.next = tour().next_odometry()) && at_.next->time_s <= begin_s)
            first = at_.next;
        if (!first) return;
        first->twist = {};
        at_.time_s = first->time_s;
        at_.waiting.push_back(*first);
    }

    /// Those up to the next scan that has some before it.
    void read_step() {
        if (++at_.steps == 1) return begin();
        if (!at_.next) return;
        double end_s = scan_time_s();
        while (end_s < at_.next->time_s) {
            end_s = scan_time_s();
            ++at_.steps;
        }
        double moving_s = 0.0;
        for (; at_.next && at_.next->time_s <= end_s; at_.next = tour().next_odometry()) {
            if (moves(at_.next->twist)) moving_s += at_.next->time_s - at_.time_s;
            at_.time_s = at_.next->time_s;
            at_.waiting.push_back(*at_.next);
        }
        const auto [length, turn] = stream(at_.steps, kStepStream).normal_pair();
        const double scale = 1.0 + kStepSigma * length;
        for (Odometria& reading : at_.waiting) {
            Twist& twist = reading.twist;
            if (!moves(twist)) continue;
            twist.v *= scale;
            twist.v_lateral *= scale;
            twist.w *= scale;
            if (moving_s > 0.0) twist.w += kTurnSigma * turn / moving_s;
        }
    }

    std::uint64_t copy_;
    std::unique_ptr<TourReader> clock_;  // its scans say where steps end
    Place at_;
};

}  // namespace

std::unique_ptr<TourReader> make_perturbed_reader(std::unique_ptr<TourReader> reader,
                                                  std::uint64_t copy) {
    return std::make_unique<PerturbedReader>(std::move(reader), copy);
}

}  // namespace hitos
