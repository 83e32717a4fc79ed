#include "hitos/services/run/algoritmo.hpp"

#include <new>
#include <optional>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/translatable.hpp"
#include "hitos/capture/tour_examination.hpp"
#include "hitos/features/extractor.hpp"
#include "hitos/slam/filters.hpp"

namespace hitos {
namespace {

Message nothing_found(const ReadReport& log) {
    if (log.early_scans_left_out > 0) {
        return message(HITOS_TEXT("Errors",
                                  "found no scan behind the first odometry reading; %1 before it "
                                  "were left out, use them with source.early_scans=keep"),
                       log.early_scans_left_out);
    }
    if (log.examples.empty()) return message(HITOS_TEXT("Errors", "found no readable scan"));
    return message(
        HITOS_TEXT(
            "Errors",
            "found no readable scan; of the log %1 parts were skipped as damaged, the first is %2"),
        log.skipped, log.placed(log.examples.front()));
}

}  // namespace

Algoritmo::Algoritmo(const Configuracion& configuration, std::unique_ptr<TourReader> reader,
                     AlgoritmoOptions options)
    : configuration_(configuration),
      options_(std::move(options)),
      reader_(std::move(reader)),
      step_grid_(configuration.grid) {
    check(configuration_);
    if (options_.go_back) {
        auto remembered = std::make_unique<RememberedTour>(std::move(reader_));
        remembered_ = remembered.get();
        reader_ = std::move(remembered);
    }
    // Once: what is read again, after going back, it knows already.
    if (options_.examine) examination_ = std::make_unique<TourExamination>();
    begin();
}

Algoritmo::~Algoritmo() = default;
Algoritmo::Algoritmo(Algoritmo&&) noexcept = default;
Algoritmo& Algoritmo::operator=(Algoritmo&&) noexcept = default;

void Algoritmo::begin() {
    extractor_ = options_.extractor
                     ? options_.extractor()
                     : make_extractor(configuration_.extraction, configuration_.run.seed);
    filter_ =
        make_filter(configuration_.filter, configuration_.run.seed, configuration_.run.threads);
    controls_ = std::make_unique<ControlTrack>([from = reader_.get(), doubts = examination_.get()] {
        const std::optional<Odometria> reading = from->next_odometry();
        if (reading && doubts != nullptr) doubts->note(*reading);
        return reading;
    });
    registration_ = needs_registration(configuration_.filter)
                        ? std::make_unique<Registration>(configuration_.registration)
                        : nullptr;
    step_grid_.clear();
    step_grid_stale_ = false;
    step_grid_redrawn_ = 0;
    step_grid_change_ = {};
    key_scans_.clear();
    key_poses_.clear();
    online_.clear();
    line_extents_.clear();
    suitability_.clear();
    uncertainty_.clear();
    scan_ = {};
    observation_.clear();
    odometry_ = {};
    finished_ = false;
}

bool Algoritmo::step(AssociationRecord* record) {
    if (finished_) return false;
    auto scan = reader_->next_scan();
    if (!scan) {
        finished_ = true;
        if (steps() == 0) {
            throw FormatError(
                reader().name(), 0,
                HITOS_TEXT("Errors",
                           "%1; expected at least one scan: check the file and its format"),
                nothing_found(report()));
        }
        // Nothing comes of odometry after the last scan, but the log has it: report() is of all.
        while (const std::optional<Odometria> reading = reader_->next_odometry()) {
            if (examination_) examination_->note(*reading);
        }
        finish();
        return false;
    }
    scan_ = std::move(*scan);
    if (examination_) examination_->note(scan_);
    controls_->controls_until(scan_, step_controls_);
    extractor_->go_to(steps());  // wherever the run comes from
    extractor_->extract(scan_, observation_);
    std::optional<RegisteredStep> registered;
    if (registration_) registered = registration_->add(scan_, step_controls_);
    try {
        filter_->step(
            {scan_, step_controls_, observation_, registered ? &*registered : nullptr, record});
    } catch (const std::bad_alloc& shortage) {
        throw Error(out_of_memory(shortage.what()));
    }
    note_scan();
    if (options_.step_grid) draw_scan(registered && registered->key);
    if (registration_) take_correction();
    online_.push_back({scan_.time_s, filter_->best_pose()});
    return true;
}

/// What can be done about it.
Message Algoritmo::out_of_memory(const char* reason) const {
    const FilterParams& filter = configuration_.filter;
    const int landmarks =
        filter_->best_count(FeatureKind::line) + filter_->best_count(FeatureKind::corner);
    if (slam_algorithms().reads(filter.algorithm, "filter.particles")) {
        return message(HITOS_TEXT("Errors",
                                  "out of memory at scan %1, with %2 landmarks in each map of %3 "
                                  "particles: %4; lower filter.particles, or make fewer landmarks "
                                  "with a higher split_merge.min_length"),
                       steps() + 1, landmarks, filter.particles, verbatim(reason));
    }
    return message(
        HITOS_TEXT(
            "Errors",
            "out of memory at scan %1, with %2 landmarks in the map: %3; make fewer landmarks with "
            "a higher split_merge.min_length, or use filter.algorithm = fastslam"),
        steps() + 1, landmarks, verbatim(reason));
}

void Algoritmo::note_scan() {
    line_extents_.note(*filter_, observation_);
    suitability_.note(step_controls_, observation_, filter_->associations());
    if (options_.uncertainty) uncertainty_.note(scan_.time_s, filter_->best_map());
    odometry_.add(scan_.time_s, step_controls_);
}

void Algoritmo::draw_scan(bool key) {
    step_grid_change_ = {};
    if (registration_ && !key) return;
    if (key) {
        key_scans_.push_back(std::make_shared<const Scan>(scan_));
        key_poses_.push_back(filter_->best_pose());
    }
    if (step_grid_stale_) return;
    step_grid_.add(scan_, filter_->best_pose());
    step_grid_change_ = step_grid_.last_change();
}

const Grid& Algoritmo::step_grid() const {
    if (std::exchange(step_grid_stale_, false)) {
        step_grid_.clear();
        for (std::size_t k = 0; k < key_scans_.size(); ++k) {
            step_grid_.add(*key_scans_[k], key_poses_[k]);
        }
        ++step_grid_redrawn_;
    }
    return step_grid_;
}

void Algoritmo::finish() {
    if (!registration_) return;
    registration_->finish();
    take_correction();
}

void Algoritmo::take_correction() {
    const auto correction = registration_->correction();
    if (!correction) return;
    filter_->correct(*correction);
    if (!options_.step_grid) return;
    const std::vector<Pose> path = filter_->best_history();
    key_poses_.clear();
    for (const KeyPose& key : registration_->keys()) key_poses_.push_back(path[key.scan]);
    step_grid_stale_ = true;
}

std::vector<Advice> Algoritmo::advice() const {
    std::vector<Advice> advice =
        suitability_.advice(configuration_, reader_->format() == kWorldFormat);
    if (registration_) {  // the preset to try is in use
        for (Advice& reason : advice) reason.preset = {};
    }
    // What simulators write may be replayed as the thesis did; these formats come from robots.
    const bool recording = reader_->format() == "carmen" || reader_->format() == "radish" ||
                           reader_->report().of_recording;
    if (recording && !registration_) {
        advice.insert(
            advice.begin(),
            {HITOS_TEXT("Advice",
                        "This is the recording of a robot (%1), and its scans are not registered: "
                        "with registration maps of buildings come out right."),
             reader_->format(), "recorded"});
    }
    return advice;
}

void Algoritmo::restart() {
    reader_->restart();
    begin();
}

double Algoritmo::duration_s() const {
    const Trajectory& path = odometry_trajectory();
    return path.empty() ? 0.0 : path.back().time_s - path.front().time_s;
}

Trajectory Algoritmo::best_trajectory() const {
    return stamped(filter_->best_history());
}

Trajectory Algoritmo::trajectory_of(std::size_t hypothesis) const {
    return stamped(filter_->history(hypothesis));
}

Trajectory Algoritmo::stamped(const std::vector<Pose>& poses) const {
    Trajectory trajectory;
    trajectory.reserve(poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i) {
        trajectory.push_back({odometry_trajectory()[i].time_s, poses[i]});
    }
    return trajectory;
}

}  // namespace hitos
