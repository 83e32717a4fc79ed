// SPDX-License-Identifier: GPL-3.0-or-later
// Runs an Algoritmo on a worker thread for windows and command lines [T fig 9.14].
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <future>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/services/evaluation/run_loops.hpp"
#include "hitos/services/grid/grid_tiles.hpp"
#include "hitos/services/run/algoritmo.hpp"
#include "hitos/services/run/pace.hpp"
#include "hitos/services/run/run_checkpoint.hpp"
#include "hitos/services/run/shown_grid.hpp"
#include "hitos/services/run/step_figures.hpp"

namespace hitos {

/// What of a state only some views need: a snapshot has it where it was asked for.
struct SnapshotParts {
    std::optional<std::size_t> particle;  ///< map and path of one of the hypotheses
    bool ancestry = false;
    bool joint_covariance = false;
    bool key_scans = false;
    friend bool operator==(const SnapshotParts&, const SnapshotParts&) = default;
};

/// What one hypothesis believes.
struct ParticleDetails {
    std::size_t number = 0;  ///< place in Snapshot::hypotheses
    LandmarkMap map;
    std::vector<LineExtent> line_extents;
    Trajectory path;
};

ParticleDetails details_of(const Algoritmo& run, std::size_t hypothesis);

/// Everything a view needs of the state after a step; immutable once published.
struct Snapshot {
    SnapshotParts parts;  ///< what was asked for
    std::string source;   ///< as TourReader::name()
    std::uint64_t steps = 0;
    std::uint64_t revision = 0;  ///< as Algoritmo::revision()
    bool grid_behind = false;    ///< step_grid is the one from before a correction
    bool foreseen = false;       ///< as Algoritmo::foresee(): the run is not there yet
    Scan scan;
    Observation observation;
    std::vector<Association> associations;
    Pose best_pose;
    LandmarkMap best_map;
    std::vector<LineExtent> line_extents;  ///< segments of the lines of best_map
    std::vector<WeightedPose> hypotheses;
    std::size_t best_hypothesis = 0;
    Pose mean_pose;  ///< of all hypotheses
    Eigen::Matrix3d pose_covariance = Eigen::Matrix3d::Zero();
    Eigen::MatrixXd joint_covariance;  ///< where asked for; as SlamFilter::joint_covariance()
    std::optional<ParticleDetails> particle;  ///< where asked for and there
    std::vector<HistoryBranch> ancestry;      ///< where asked for
    Trajectory best_trajectory;
    Trajectory online_trajectory;         ///< as Algoritmo::online_trajectory()
    std::vector<KeyPose> keys;            ///< of registration; empty without
    std::vector<RunLoop> loops;           ///< likewise, the refused ones too
    std::vector<SecondTour> later_tours;  ///< likewise
    /// Those of the keys, where asked for and the run draws its grid.
    std::vector<std::shared_ptr<const Scan>> key_scans;
    std::optional<double> chi_square;    ///< likewise: as Registration::chi_square()
    std::optional<LaidDrawing> drawing;  ///< likewise: as Registration::drawing()
    Trajectory odometry_trajectory;
    GridTiles step_grid;
    std::vector<Advice> advice;  ///< of a finished run: what speaks against it
    /// The states that the run could go back to, by scans.
    std::vector<std::shared_ptr<const RunCheckpoint>> checkpoints;
    double seconds = 0.0;  ///< of the worker's time that making it took
};

/// Of the state as it is, without its grid and checkpoints, which are the worker's.
Snapshot snapshot_of(const Algoritmo& run, const SnapshotParts& parts);

/// How far a run has come; cheap to ask for.
struct Progress {
    enum class State { ready, running, paused, finished, failed };
    State state = State::ready;
    std::uint64_t steps = 0;
    std::uint64_t revision = 0;      ///< a snapshot of the same one shows this state
    std::optional<double> fraction;  ///< of the source read, 0 … 1
    double time_s = 0.0;             ///< stamp of the last scan
    double duration_s = 0.0;         ///< since the first one
    double steps_per_second = 0.0;   ///< over the last half second of running
    int lines = 0;
    int corners = 0;
    FilterStatistics statistics;
    double step_seconds = 0.0;  ///< wall time of the last step
    std::uint64_t skipped_lines = 0;
    bool waits = false;                        ///< running, for its pace: it has time to spare
    StopReason stopped_by = StopReason::none;  ///< of the rules that the run was given
    Message error;                             ///< what ended a failed run
    std::exception_ptr failure;                ///< the same, to be thrown again
};

/// A run on its own thread. Every member may be called from any thread and returns without waiting
/// for a step, except wait(), and futures that the caller chooses to wait for.
class RunWorker {
  public:
    RunWorker(const Configuracion& configuration, std::unique_ptr<TourReader> reader,
              const AlgoritmoOptions& options = {});
    /// Ends the worker after the step under way.
    ~RunWorker();
    RunWorker(const RunWorker&) = delete;
    RunWorker& operator=(const RunWorker&) = delete;

    static constexpr std::uint64_t kToTheEnd = std::numeric_limits<std::uint64_t>::max();

    /// Runs `steps` further steps, or to the end of the source, at the pace that is set; stops
    /// before where a rule is met.
    void run(std::uint64_t steps = kToTheEnd, const StopRules& rules = {});
    /// Of run() from now on; seek() is always as fast as possible.
    void set_pace(const Pace& pace);
    /// What the rules measure the position by; nothing by default.
    void set_reference(std::optional<Trajectory> reference);
    /// Stops after the step under way; until its end the run counts as running.
    void pause();
    /// Stops and goes back to the beginning.
    void restart();
    /// Goes to the state after that many scans, or after the last one before the end, and stops
    /// there: the state of a run forwards, to the last bit. Back it goes from the nearest
    /// checkpoint, or from the beginning where the options ask for none.
    void seek(std::uint64_t steps);
    /// Other changes by hand of the graph (RegistrationParams::edits): the run goes back to before
    /// the first scan that they touch, and as fast as possible to where it was, or was sent to by
    /// seek(), and rests there. What was published before is forgotten; where the run rested, or is
    /// on its way by other such changes, there is a foreseen snapshot at once, and no other until
    /// the run rests again. A failed run begins anew.
    /// Throws ConfigError where they are none.
    void set_edits(const std::string& edits);
    /// Blocks until nothing is left to do (end, failure, pause, steps done).
    void wait();
    /// The same, but no longer than `time`.
    void wait_for(std::chrono::milliseconds time);

    Progress progress() const;

    /// Asks for a snapshot of the state after the step under way (at once where none is, or where
    /// that one waits for a tour that is still to come); it is made on the worker and handed out by
    /// latest_snapshot().
    void request_snapshot(const SnapshotParts& parts = {});
    std::shared_ptr<const Snapshot> latest_snapshot() const;

    /// The figures of every step from number `first` (0 is the first scan) on. After a restart
    /// they begin anew; going back forgets none. Those of the last step alone where the options
    /// keep none.
    std::vector<StepFigures> figures_since(std::uint64_t first) const;

    /// As Algoritmo::weighed(), from the nearest checkpoint: while the run rests it takes no longer
    /// than going back to a scan.
    std::future<std::shared_ptr<const AssociationRecord>> weighed();

    /// Calls `task` with the run between two steps, on the worker.
    template <class Task>
    auto with_run(Task task) -> std::future<std::invoke_result_t<Task, const Algoritmo&>> {
        using Result = std::invoke_result_t<Task, const Algoritmo&>;
        auto packaged =
            std::make_shared<std::packaged_task<Result(const Algoritmo&)>>(std::move(task));
        auto future = packaged->get_future();
        post([packaged](const Algoritmo& run) { (*packaged)(run); });
        return future;
    }

  private:
    bool idle() const;  // with the mutex held
    void post(std::function<void(const Algoritmo&)> task);
    void work(const std::stop_token& stop);
    void work_until(const std::stop_token& stop);
    /// Ends the run by an exception that nobody handles any more.
    void fail(Message error, std::exception_ptr failure);
    // These hold the lock as they begin and end, and let it go while they work.
    void step(std::unique_lock<std::mutex>& lock);
    /// To the nearest state before those steps, from where they are still to do.
    void go_to(std::uint64_t steps, std::unique_lock<std::mutex>& lock);
    /// Takes the wanted changes by hand, and goes to a state that they do not touch.
    void take_edits(std::unique_lock<std::mutex>& lock);
    /// A picture of the run as it will about be, from where it is or from the last one.
    void foresee(const std::string& edits, bool from_the_last, std::unique_lock<std::mutex>& lock);
    /// To a checkpoint, or to the beginning.
    void leave_for(const RunCheckpoint* checkpoint);
    enum class Rest : std::uint8_t { none, between_scans };
    void publish_snapshot(std::unique_lock<std::mutex>& lock, bool foreseen = false,
                          Rest rest = Rest::none);
    /// In a step that waits for the next scan of a tour that is still to come.
    void answer_meanwhile();
    void begin_rate();  // of steps, from where the run is
    void note_progress();
    const StepFigures& noted_figures();
    bool waits_for_pace() const;  // with the mutex held
    /// Whether nobody wants to see where the run is: it is soon where it was sent to.
    bool passes_by() const;  // likewise
    void note_due();         // likewise

    const std::shared_ptr<FileGrowth> growth_;  // of a tour that is still to come; else null
    Algoritmo run_;                             // the worker's own, once it runs
    ShownGrid grid_;                            // likewise
    RunCheckpoints checkpoints_;
    bool takes_scan_ = false;  // likewise: it may wait for it, and is whole until it has it
    std::shared_ptr<const RunCheckpoint> bent_;  // the state that was foreseen

    mutable std::mutex mutex_;
    std::condition_variable_any wake_;
    std::condition_variable idle_;
    std::uint64_t budget_ = 0;  // steps still asked for
    StopRules rules_;
    Pacer pacer_;
    bool paced_ = false;                  // these steps are
    Pacer::Clock::time_point due_;        // the next one, where they are
    std::optional<PositionError> error_;  // up to the last of figures_
    bool restart_wanted_ = false;
    std::optional<std::uint64_t> seek_wanted_;
    std::uint64_t seek_target_ = 0;  // of the last seek
    std::optional<std::string> edits_wanted_;
    std::uint64_t edit_target_ = 0;  // where the run goes to with them
    std::chrono::steady_clock::time_point seek_began_;
    std::optional<SnapshotParts> snapshot_wanted_;
    SnapshotParts parts_;    // of the last one
    bool foreseen_ = false;  // what was published is, until the run rests or is sent elsewhere
    bool busy_ = false;
    bool stepping_ = false;  // a step is under way
    std::vector<std::function<void(const Algoritmo&)>> tasks_;
    Progress progress_;
    std::shared_ptr<const Snapshot> snapshot_;
    std::vector<StepFigures> figures_;
    std::chrono::steady_clock::time_point rate_since_;
    std::uint64_t rate_steps_ = 0;

    std::jthread worker_;  // last: it uses everything above
};

}  // namespace hitos
