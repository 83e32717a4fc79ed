// SPDX-License-Identifier: GPL-3.0-or-later
// The runs that the window remembers, and the one under way.
#pragma once

#include <QColor>
#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "hitos/services/results/kept_run.hpp"
#include "session/session.hpp"

namespace hitos::window {

/// A run of the list.
struct ListedRun {
    int number = 0;  ///< for people; 0 is the run of the window
    std::shared_ptr<const KeptRun> run;
    QString folder = {};   ///< where it was read from, if from results
    RunFigures told = {};  ///< what that folder tells
};

/// What people call it: "run 3", "this run".
QString name_of(const ListedRun& listed);
/// That of its path in pictures.
QColor colour_of(const ListedRun& listed);
/// The same scans under the same parameters: the results are equal to the last bit.
bool same_run(const KeptRun& a, const KeptRun& b);
/// The name of its log's file.
QString log_of(const KeptRun& run);
/// The same with the folder of results that the run was read from: "aces.log.gz, out/b".
QString source_words(const ListedRun& listed);

/// Keeps every run that is left with more than one scan: by another configuration, another log or
/// a new start; whole where it has been at its end. Of runs that are the same scan for scan one
/// stays, and of more than kMost runs the newest.
class RunList final : public QObject {
    Q_OBJECT

  public:
    static constexpr std::size_t kMost = 40;

    RunList(Session& session, QObject* parent);

    /// The run of the window where there is a source, without scans before it has begun; then those
    /// kept, oldest first.
    std::vector<ListedRun> runs() const;
    /// Whether the run of the window does not go on at the moment.
    bool present_rests() const;
    /// Where the robot of such a run was, as the references tell, or told when its log was that of
    /// the window; null where nothing is known of it. Until changed().
    const Trajectory* reference_of(const KeptRun& run) const;
    /// Reads a folder of results. Throws hitos::Error.
    ListedRun open(const QString& folder);
    void remove(int number);

  signals:
    /// Other runs, or other figures of them.
    void changed();
    /// There is another picture of the run of the window.
    void present_changed();

  private:
    std::shared_ptr<const KeptRun> present() const;
    KeptRun run_at(const Snapshot* state) const;
    void keep_present();
    ListedRun add(ListedRun listed);
    void measure(KeptRun& run) const;
    void measure_listed(ListedRun& listed) const;
    bool of_present_tour(const KeptRun& run) const;
    bool references_missed();
    void measure_anew();

    Session& session_;
    std::vector<ListedRun> kept_;
    std::shared_ptr<const Trajectory> reference_;  ///< of the present tour
    std::optional<Configuracion> referenced_;      ///< of which tour there were references last
    int last_number_ = 0;
    bool rested_ = true;
    mutable std::shared_ptr<const KeptRun> present_;  ///< of the snapshot below; null: unknown
    mutable std::shared_ptr<const Snapshot> of_;
    std::shared_ptr<const Snapshot> ended_;  ///< of the run of the window, where it was at its end
};

}  // namespace hitos::window
