// SPDX-License-Identifier: GPL-3.0-or-later
// What the window works on: a configuration, its run, and what it is compared with.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>

#include "hitos/services/results/kept_run.hpp"
#include "hitos/services/results/results.hpp"
#include "hitos/services/run/run_worker.hpp"

namespace hitos {
class SimulatedTour;
}

namespace hitos::window {

class IncomingTour;

/// Whether it is of a run at its end, behind the last scan.
inline bool has_ended(const Snapshot& state) {
    return state.revision > state.steps;
}

/// Holds the configuration and the RunWorker that runs it, and tells the views what is new at the
/// rate of the screen. Snapshots are asked for so seldom that making and painting them takes no
/// more than kShare of the time, or kShareOfWaiting where the run waits for its pace anyway.
class Session final : public QObject {
    Q_OBJECT

  public:
    static constexpr double kShare = 0.05;
    static constexpr double kShareOfWaiting = 0.4;

    explicit Session(QObject* parent = nullptr);
    ~Session() override;

    const Configuracion& configuration() const { return configuration_; }
    /// Starts anew with this configuration. Throws hitos::Error and changes nothing where the
    /// configuration or its source is not possible; without a source there is nothing to run. The
    /// references belong to the log: with another one they go.
    void set_configuration(const Configuracion& configuration);

    /// Other changes by hand of the graph (RegistrationParams::edits): what they do not touch of
    /// the run stays, and it goes to where it was. Throws hitos::Error where they are none.
    void set_edits(const std::string& edits);

    /// The same on a tour that is being driven through the world of the configuration's source. The
    /// run has what was driven so far and goes on by follow(); changes of the configuration begin
    /// anew on the same tour, until its source is another one.
    void set_live(const Configuracion& configuration, std::shared_ptr<const SimulatedTour> tour);
    /// The tour that is or was driven; null where the run is of a log or world.
    const std::shared_ptr<const SimulatedTour>& live_tour() const { return live_; }
    /// Which of those that were driven so far that is; 0: none.
    quint64 drive() const { return live_ ? last_drive_ : 0; }
    /// The same, or the one that the run of a world goes along; null where it is of a log.
    const std::shared_ptr<const SimulatedTour>& simulated_tour() const { return simulated_; }
    /// The same on a tour that comes in, which the configuration's source names; it is so for as
    /// long as the source is that file, however it is read.
    void set_incoming(const Configuracion& configuration, std::shared_ptr<IncomingTour> tour);
    /// The tour that comes or came in; null where the run is of another one.
    const std::shared_ptr<IncomingTour>& incoming_tour() const { return incoming_; }
    /// Whether it is still being driven, or comes in.
    bool is_live() const;
    /// Takes notice of what has come since: the truth of a driven tour grows, and the run goes on
    /// to the newest scan, and to the end where there is one, unless the user has stopped it or
    /// gone back.
    void follow();

    bool has_source() const { return worker_ != nullptr; }
    /// Null without a source.
    RunWorker* worker() const { return worker_.get(); }
    /// The newest one; null before the first. While show_before() asks for it, the one from before
    /// the last changes by hand.
    std::shared_ptr<const Snapshot> snapshot() const { return shows_before_ ? before_ : snapshot_; }
    /// That of the run as it is or was; null before, and where what is shown is foreseen.
    std::shared_ptr<const Snapshot> of_run() const {
        return snapshot_ && !snapshot_->foreseen ? snapshot_ : nullptr;
    }
    /// What was there before the last changes by hand, where the same scans are shown again with
    /// others; else null.
    std::shared_ptr<const Snapshot> before_edits() const;
    bool shows_before() const { return shows_before_; }
    /// Until something else is asked of the run.
    void show_before(bool before);
    Progress progress() const;
    /// Wall time [s] that the first `steps` steps took, each the first time that it was done.
    double computed_seconds(std::uint64_t steps = RunWorker::kToTheEnd) const;
    /// Whether the snapshot is of the run as it is now, with all that is wanted.
    bool up_to_date() const { return shows(progress()); }
    /// Parts that somebody looks at; a view changes those of its own.
    const SnapshotParts& parts() const { return parts_; }
    void want(const SnapshotParts& parts);

    /// What the user named, and the truth that the tour itself knows where the user named nothing.
    const References& references() const { return references_; }
    const References& user_references() const { return user_references_; }
    /// Of the user's. `map_file` is where the map was read; empty where it is not known.
    void set_references(const References& references, const QString& map_file = {});
    const QString& reference_map_file() const { return reference_map_file_; }

    /// To the end, or until a rule is met; of a tour that is being driven as far as it is, and on
    /// with it.
    void run(const StopRules& rules = {});
    void run_steps(quint64 steps);
    /// Of this run and those to come.
    void set_pace(const Pace& pace);
    const Pace& pace() const { return pace_; }
    void pause();
    void restart();
    /// To the state after that many scans (at least one), and no further.
    void seek(quint64 steps);
    /// A view says how long it took to paint.
    void note_cost(double seconds) { paint_seconds_ += seconds; }

  signals:
    /// The run is about to be given up, for another one or to begin anew; it is still there.
    void leaving();
    void configuration_changed();
    /// The run is at its beginning: earlier pictures mean nothing.
    void restarted();
    void snapshot_changed();
    /// State or figures changed; at most ten times a second but at once on a change of state.
    void progress_changed();
    void references_changed();
    void failed(QString reason);

  private:
    void open(const Configuracion& configuration, std::shared_ptr<const SimulatedTour> live,
              std::shared_ptr<IncomingTour> incoming);
    /// Of a live tour, that are there.
    std::uint64_t scans_there() const;
    void give_up_incoming(std::shared_ptr<IncomingTour> former) const;
    void note_truth();
    /// Wherever the run stands, it goes to that scan.
    void go_to(quint64 steps);
    void tick();
    bool shows(const Progress& progress) const {
        const bool running = progress.state == Progress::State::running && !progress.waits;
        return snapshot_ && !snapshot_->foreseen && snapshot_->revision == progress.revision &&
               snapshot_->parts == parts_ && (running || !snapshot_->grid_behind);
    }
    void wake();
    void retire();
    void begin_anew();
    void join_references();

    Configuracion configuration_;
    std::shared_ptr<const SimulatedTour> live_;
    quint64 last_drive_ = 0;
    std::shared_ptr<const SimulatedTour> simulated_;
    std::shared_ptr<IncomingTour> incoming_;
    bool opening_ = false;    ///< a source, which may take its time
    bool following_ = false;  ///< the run goes where the live tour is
    References user_references_;
    References references_;       ///< with the truth
    std::optional<Truth> truth_;  ///< of the tour
    QString reference_map_file_;
    Pace pace_;
    std::unique_ptr<RunWorker> worker_;
    std::shared_ptr<const Snapshot> snapshot_;
    std::shared_ptr<const Snapshot> before_;  ///< the last changes by hand, of the run
    std::string edits_before_;                ///< of it
    bool shows_before_ = false;
    QTimer timer_;
    QElapsedTimer clock_;
    Progress told_;
    qint64 told_ms_ = 0;
    qint64 request_not_before_us_ = 0;
    bool requested_ = false;
    SnapshotParts parts_;
    double paint_seconds_ = 0.0;
};

}  // namespace hitos::window
