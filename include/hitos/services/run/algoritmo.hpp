// SPDX-License-Identifier: GPL-3.0-or-later
// One run of one algorithm over one source, step by step: the only run loop of Hitos.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <vector>

#include "hitos/capture/remembered_tour.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "hitos/services/configuration/configuracion.hpp"
#include "hitos/services/evaluation/quality.hpp"
#include "hitos/services/evaluation/run_evidence.hpp"
#include "hitos/services/grid/grid.hpp"
#include "hitos/services/run/run_state.hpp"
#include "hitos/services/run/stage_seconds.hpp"

namespace hitos {

class Algoritmo;
class Extractor;

/// What a run does besides mapping.
struct AlgoritmoOptions {
    /// Build the grid map step by step from whichever particle is best at each step.
    bool step_grid = true;
    /// Record the standard deviations of the best hypothesis' landmarks after every scan.
    bool uncertainty = false;
    /// Draw the whole tour's grid along this particle's own path too [T 9.2.5]: a place in
    /// SlamFilter::hypotheses().
    std::optional<std::size_t> grid_of = std::nullopt;
    /// Remember the tour, so that the run can go back.
    bool go_back = false;
    /// Else, so that nobody has to read it again once the run is at its end; none: do not.
    std::size_t remember_bytes = std::size_t{128} << 20;
    /// Keep the figures of every step (RunWorker does), some 300 bytes each; else of the last one.
    bool figures = true;
    /// Doubt what is read of the tour.
    bool examine = true;
    /// Look for what there is to doubt as soon as the tour is over, beside all that comes then.
    bool doubts_ahead = false;
    /// Measure what the stages of its steps take.
    bool time_stages = false;
    /// Told after every scan, on the thread of the run: the scan, and its pose by odometry alone.
    std::function<void(const Scan& scan, const Pose& pose)> taken = nullptr;
    /// Told after every step, the one that finds the tour over too, on the thread of the run.
    std::function<void(const Algoritmo& run)> stepped = nullptr;
    /// Makes what finds the features; null: the one that the configuration asks for.
    std::function<std::unique_ptr<Extractor>()> extractor = nullptr;
};

/// All that a run is after a scan; immutable.
struct RunCheckpoint;

/// Owns the whole chain reader → scans and controls → features → filter. Not thread-safe; RunWorker
/// runs it on a thread of its own.
class Algoritmo {
  public:
    Algoritmo(const Configuracion& configuration, std::unique_ptr<TourReader> reader,
              AlgoritmoOptions options = {});
    ~Algoritmo();
    Algoritmo(Algoritmo&&) noexcept;
    Algoritmo& operator=(Algoritmo&&) noexcept;

    /// Takes the next scan and everything the odometry says up to it. False at the end of the
    /// log. Throws FormatError where the log ends without a single scan. `record`, where it is not
    /// null, takes what the filter weighs.
    bool step(AssociationRecord* record = nullptr);
    bool finished() const { return state_.finished; }
    /// From the beginning of the tour, as if nothing had been done.
    void restart();
    /// The state as it is, to come back to; null where the options do not ask for it, the
    /// algorithm cannot be copied, the tour is too long to be remembered, or over, unless
    /// `over_too`.
    std::shared_ptr<const RunCheckpoint> checkpoint(bool over_too = false) const;
    /// Goes back to it, or ahead: what follows is the same as it was, to the last bit. It must be
    /// of this run, since its last restart().
    void go_to(const RunCheckpoint& checkpoint);
    /// What the filter weighed at the last scan, in all its hypotheses: the tour is run again from
    /// a checkpoint before that scan, from its beginning where that is null, and the run then is
    /// what it was. Null where it cannot go back, or has not taken a scan.
    std::unique_ptr<const AssociationRecord> weighed(const RunCheckpoint* before);
    /// Other changes by hand of the graph, from now on: the run goes on with them. Throws
    /// ConfigError where they are none.
    void set_edits(const std::string& edits);
    /// The state at once as other changes by hand bend the graph (Registration::foresee()), to be
    /// looked at: go_to(), rewind() or restart() has to follow where it is true. Throws ConfigError
    /// where they are none.
    bool foresee(const std::string& edits);
    /// How many scans are the same with them.
    std::uint64_t untouched_scans(const std::string& edits) const;
    /// To the beginning, reading what is remembered again; where nothing is it is a restart(), and
    /// false: what checkpoints there are belong to another reading.
    bool rewind();

    const Configuracion& configuration() const { return configuration_; }
    const AlgoritmoOptions& options() const { return options_; }
    const TourReader& reader() const { return *reader_; }
    const SlamFilter& filter() const { return *state_.filter; }
    /// Null where the algorithm asks for none.
    const Registration* registration() const { return state_.registration.get(); }
    /// The tours behind the first one; none where scans are not registered.
    std::vector<SecondTour> later_tours() const { return state_.later_tours(); }
    const Scan& scan() const { return state_.scan; }  ///< the last one
    /// Those of registration's keys; empty where no grid is drawn.
    const std::vector<std::shared_ptr<const Scan>>& key_scans() const { return state_.key_scans; }
    const Observation& observation() const { return state_.observation; }  ///< its features
    /// All 0 unless the options ask for it.
    const StageSeconds& stages() const { return clock_.seconds(); }
    /// Processor time of the program until there was this run [s].
    double seconds_before() const { return seconds_before_; }
    /// Memory that its state takes, about.
    std::size_t state_bytes() const { return state_.bytes(); }
    /// Whether a sensor told landmarks so far, and no laser showed what is between them.
    bool shows_landmarks_alone() const { return state_.saw_landmarks && !state_.saw_points; }
    const ReadReport& report() const { return reader_->report(); }
    /// With registration it is of the key scans, and drawn anew when it is asked for after a
    /// correction, each scan at its corrected place.
    const Grid& step_grid() const;
    /// Whether it will be drawn anew when it is asked for.
    bool step_grid_stale() const { return step_grid_stale_; }
    /// How often it was drawn anew.
    std::uint64_t step_grid_redrawn() const { return step_grid_redrawn_; }
    /// No cell out of it was changed by the last step, as long as the grid is not drawn anew.
    CellArea step_grid_change() const { return step_grid_change_; }
    /// Where lines were seen at every scan so far.
    const LineExtents& line_extents() const { return state_.line_extents; }
    /// Whether tour and configuration suit each other, as far as the run shows.
    const Suitability& suitability() const { return state_.suitability; }
    /// What doubts the tour; null where the options do not ask for it.
    const TourExamination* examination() const { return examination_.get(); }
    /// What there is to doubt in the tour as far as it was read; not valid where the options do not
    /// ask for it. The run has to rest until it is there.
    DoubtsAhead doubts() const;
    /// To be judged by.
    RunEvidence evidence() const {
        // Without points there was nothing to register, and that says nothing of the map.
        return {configuration_, *reader_, odometry_trajectory(),
                shows_landmarks_alone() ? nullptr : registration()};
    }
    /// Of what speaks against the configuration so far; a recording that is run without
    /// registration is offered it.
    std::vector<Advice> advice() const;
    /// Empty unless the options ask for it.
    const UncertaintyRecord& uncertainty() const { return state_.uncertainty; }

    /// Scans so far.
    std::uint64_t steps() const { return odometry_trajectory().size(); }
    /// Counts what changed the run: every scan, and the end of the tour, which moves path and map.
    std::uint64_t revision() const { return steps() + (finished() ? 1 : 0); }
    /// Between the stamps of the first and the last scan so far [s].
    double duration_s() const;
    /// The best hypothesis' pose at every scan so far.
    Trajectory best_trajectory() const { return state_.best_trajectory(); }
    /// What the robot would have had while driving: the best hypothesis' pose at every scan so far
    /// as it was at that scan, before anything later corrected it.
    const Trajectory& online_trajectory() const { return state_.online; }
    /// Any hypothesis' pose at every scan so far.
    Trajectory trajectory_of(std::size_t hypothesis) const {
        return state_.stamped(state_.filter->history(hypothesis));
    }
    /// The pose by odometry alone at every scan so far, from (0, 0, 0) at the first reading.
    const Trajectory& odometry_trajectory() const { return state_.odometry.trajectory(); }

  private:
    void begin();
    /// All that it is now; nothing where the algorithm cannot be copied.
    std::optional<RunCheckpoint> copy() const;
    Message out_of_memory(const std::bad_alloc& shortage) const;
    /// Takes the scan into every part of the run that keeps something of it.
    void note_scan();
    void draw_scan(bool key);
    void begin_second_tour();
    /// The end of a tour.
    void finish(bool another_follows);
    /// Carries a correction by registration, if there is one, to the filter and the grid.
    void take_correction();

    Configuracion configuration_;
    AlgoritmoOptions options_;
    std::unique_ptr<TourReader> reader_;
    RememberedTour* remembered_ = nullptr;  // the reader, where the options ask for it
    std::shared_ptr<TourExamination> examination_;
    DoubtsAhead doubts_;  // of the whole tour, where the options ask for them ahead
    std::unique_ptr<Extractor> extractor_;
    RunState state_;
    // Drawing waits until somebody looks.
    mutable Grid step_grid_;
    mutable bool step_grid_stale_ = false;
    mutable std::uint64_t step_grid_redrawn_ = 0;
    CellArea step_grid_change_;
    std::vector<Control> step_controls_;
    RunClock clock_;
    double seconds_before_ = process_seconds();
};

}  // namespace hitos
