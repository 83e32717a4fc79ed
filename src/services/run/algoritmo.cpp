// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/run/algoritmo.hpp"

#include <new>
#include <optional>
#include <typeinfo>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/translatable.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/capture/tour_examination.hpp"
#include "hitos/features/extractor.hpp"
#include "hitos/slam/association_record.hpp"
#include "hitos/slam/filters.hpp"
#include "json_input.hpp"

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
    if (options_.go_back || options_.remember_bytes > 0) {
        auto remembered = std::make_unique<RememberedTour>(
            std::move(reader_),
            options_.go_back ? RememberedTour::kMostBytes : options_.remember_bytes);
        remembered_ = remembered.get();
        reader_ = std::move(remembered);
    }
    // Once: what is read again, after going back, it knows already.
    if (options_.examine) examination_ = std::make_shared<TourExamination>(reader_->options());
    begin();
}

Algoritmo::~Algoritmo() = default;
Algoritmo::Algoritmo(Algoritmo&&) noexcept = default;
Algoritmo& Algoritmo::operator=(Algoritmo&&) noexcept = default;

DoubtsAhead Algoritmo::doubts() const {
    if (doubts_.valid() || !examination_) return doubts_;
    return doubts_of(examination_, reader_->findings(), configuration_.run.threads);
}

void Algoritmo::begin() {
    clock_ = {};
    doubts_ = {};
    if (options_.time_stages) clock_.set_going();
    extractor_ = options_.extractor
                     ? options_.extractor()
                     : make_extractor(configuration_.extraction, configuration_.run.seed);
    state_ = RunState();
    state_.filter =
        make_filter(configuration_.filter, configuration_.run.seed, configuration_.run.threads);
    state_.controls.emplace([from = reader_.get(), doubts = examination_.get()] {
        const std::optional<Odometria> reading = from->next_odometry();
        if (reading && doubts != nullptr) doubts->note(*reading);
        return reading;
    });
    if (needs_registration(configuration_.filter))
        state_.registration =
            std::make_unique<Registration>(configuration_.registration, configuration_.run.threads);
    if (state_.registration && options_.time_stages) state_.registration->time_stages();
    step_grid_.clear();
    step_grid_stale_ = false;
    step_grid_redrawn_ = 0;
    step_grid_change_ = {};
}

bool Algoritmo::step(AssociationRecord* record) {
    if (state_.finished) return false;
    clock_.begin();
    auto scan = reader_->next_scan();
    if (!scan) {
        state_.finished = true;
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
        if (options_.doubts_ahead) doubts_ = doubts();
        clock_.ends(RunStage::reading);
        finish(false);
        clock_.ends(RunStage::rest);
        if (options_.stepped) options_.stepped(*this);
        return false;
    }
    clock_.ends(RunStage::reading);
    if (examination_) examination_->note(*scan);
    // Of a tour that is still to come it may have to be waited for: until then the last scan
    // counts.
    state_.controls->controls_until(*scan, step_controls_);
    state_.scan = std::move(*scan);
    state_.saw_points = state_.saw_points || !state_.scan.points.empty();
    state_.saw_landmarks = state_.saw_landmarks || !state_.scan.landmarks.empty();
    if (state_.scan.begins_tour && steps() > 0) begin_second_tour();
    if (state_.held) {
        state_.observation = {};
    } else {
        extractor_->go_to(steps());  // wherever the run comes from
        extractor_->extract(state_.scan, state_.observation);
    }
    clock_.ends(RunStage::features);
    std::optional<RegisteredStep> registered;
    if (state_.registration) registered = state_.registration->add(state_.scan, step_controls_);
    clock_.ends(RunStage::registration);
    Scan unseen;  // of a map that is held nothing is missing either
    unseen.time_s = state_.scan.time_s;
    try {
        state_.filter->step({state_.held ? unseen : state_.scan, step_controls_, state_.observation,
                             registered ? &*registered : nullptr, record});
    } catch (const std::bad_alloc& shortage) {
        throw Error(out_of_memory(shortage));
    }
    clock_.ends(RunStage::filter);
    if (record != nullptr) record->landmarks = state_.filter->best_map().size();
    note_scan();
    if (options_.step_grid) draw_scan(registered && registered->key);
    if (state_.registration) take_correction();
    state_.online.push_back(
        {state_.scan.stamp_s(), state_.filter->best_pose(), state_.scan.begins_tour.has_value()});
    clock_.ends(RunStage::rest);
    if (options_.stepped) options_.stepped(*this);
    return true;
}

/// What was before is a tour by itself, at its end: its map is that of its own run.
void Algoritmo::begin_second_tour() {
    step_controls_.clear();
    state_.pauses_s += state_.scan.stamp_s() - odometry_trajectory().back().time_s;
    finish(true);
    state_.held = state_.scan.begins_tour->hold;
}

/// What can be done about it.
Message Algoritmo::out_of_memory(const std::bad_alloc& shortage) const {
    // The standard library's own says nothing to a user.
    const bool own_words = typeid(shortage) != typeid(std::bad_alloc);
    const Message reason = own_words
                               ? verbatim(shortage.what())
                               : marked(HITOS_TEXT("Errors", "the system gives no more of it"));
    const FilterParams& filter = configuration_.filter;
    const int landmarks = state_.filter->best_count(FeatureKind::line) +
                          state_.filter->best_count(FeatureKind::corner);
    if (slam_algorithms().reads(filter.algorithm, "filter.particles")) {
        return message(HITOS_TEXT("Errors",
                                  "out of memory at scan %1, with %2 landmarks in each map of %3 "
                                  "particles: %4; lower filter.particles, or make fewer landmarks "
                                  "with a higher split_merge.min_length"),
                       steps() + 1, landmarks, filter.particles, reason);
    }
    return message(
        HITOS_TEXT(
            "Errors",
            "out of memory at scan %1, with %2 landmarks in the map: %3; make fewer landmarks with "
            "a higher split_merge.min_length, or use filter.algorithm = fastslam"),
        steps() + 1, landmarks, reason);
}

void Algoritmo::note_scan() {
    state_.line_extents.note(*state_.filter, state_.observation);
    // Where the map is held nothing is looked for in scans.
    state_.suitability.note(step_controls_, !state_.held && !state_.scan.points.empty(),
                            state_.observation, state_.filter->associations());
    if (options_.uncertainty)
        state_.uncertainty.note(state_.scan.stamp_s(), state_.filter->best_map());
    state_.odometry.add(state_.scan.stamp_s(), step_controls_, state_.scan.begins_tour.has_value());
    if (options_.taken) options_.taken(state_.scan, odometry_trajectory().back().pose);
}

void Algoritmo::draw_scan(bool key) {
    step_grid_change_ = {};
    if (state_.registration && !key) return;
    if (key && !state_.held) {
        state_.key_scans.push_back(std::make_shared<const Scan>(state_.scan));
        state_.key_poses.push_back(state_.filter->best_pose());
    }
    if (step_grid_stale_ || state_.held) return;
    step_grid_.add(state_.scan, state_.filter->best_pose());
    step_grid_change_ = step_grid_.last_change();
}

const Grid& Algoritmo::step_grid() const {
    if (std::exchange(step_grid_stale_, false)) {
        step_grid_.clear();
        for (std::size_t k = 0; k < state_.key_scans.size(); ++k) {
            step_grid_.add(*state_.key_scans[k], state_.key_poses[k]);
        }
        ++step_grid_redrawn_;
    }
    return step_grid_;
}

void Algoritmo::finish(bool another_follows) {
    if (!state_.registration) return;
    state_.registration->finish(another_follows);
    clock_.ends(RunStage::registration);
    take_correction();
}

void Algoritmo::take_correction() {
    const auto correction = state_.registration->correction();
    if (!correction) return;
    state_.filter->correct(*correction);
    if (!options_.step_grid) return;
    const std::vector<Pose> path = state_.filter->best_history();
    state_.key_poses.clear();
    const auto keys = state_.registration->keys().first(state_.key_scans.size());
    for (const KeyPose& key : keys) state_.key_poses.push_back(path[key.scan]);
    step_grid_stale_ = true;
}

void Algoritmo::set_edits(const std::string& edits) {
    if (state_.registration) state_.registration->set_edits(edits);
    configuration_.registration.edits = edits;
}

bool Algoritmo::foresee(const std::string& edits) {
    if (!state_.registration || !state_.registration->foresee(edits)) return false;
    take_correction();
    return true;
}

std::uint64_t Algoritmo::untouched_scans(const std::string& edits) const {
    if (!state_.registration) return steps();
    std::vector<std::uint64_t> keys;
    for (const KeyPose& key : state_.registration->keys()) keys.push_back(key.scan);
    return hitos::untouched_scans(parse_graph_edits(configuration_.registration.edits),
                                  parse_graph_edits(edits), keys);
}

std::vector<Advice> Algoritmo::advice() const {
    std::vector<Advice> advice =
        state_.suitability.advice(configuration_, reader_->format() == kWorldFormat);
    for (Advice& reason : advice) {  // the others' preset is in use
        if (state_.registration && reason.preset != kTreePreset) reason.preset = {};
    }
    if (!state_.registration && !configuration_.registration.edits.empty()) {
        advice.push_back({HITOS_TEXT("Advice",
                                     "Changes by hand (%1) are of the graph of key scans; with "
                                     "these parameters there is none, and they change nothing."),
                          kGraphEditsKey, "recorded"});
    }
    const bool of_robot =
        log_formats().knows(reader_->format()) && log_formats().find(reader_->format()).of_robots;
    const bool of_trees = configuration_.extraction.circles.find;  // there are no walls to register
    if (of_robot && !state_.registration && !of_trees && !shows_landmarks_alone()) {
        advice.insert(
            advice.begin(),
            {HITOS_TEXT("Advice",
                        "This is the recording of a robot (%1), and its scans are not registered: "
                        "with registration maps of buildings come out right."),
             reader_->format(), "recorded"});
    }
    if (!is_utf8(configuration_.source.file)) {
        advice.push_back({HITOS_TEXT("Advice",
                                     "The log's name (%1) is no UTF-8, which config.cfg has to be: "
                                     "what opens these results later will not find the log. Rename "
                                     "it and run it again."),
                          in_utf8(configuration_.source.file),
                          {}});
    }
    return advice;
}

void Algoritmo::restart() {
    reader_->restart();
    begin();
}

double Algoritmo::duration_s() const {
    const Trajectory& path = odometry_trajectory();
    return path.empty() ? 0.0 : path.back().time_s - path.front().time_s - state_.pauses_s;
}

}  // namespace hitos
