// SPDX-License-Identifier: GPL-3.0-or-later
// References to measure a run against: a map and a trajectory, from files.

#include <QFileInfo>

#include "configuration_actions.hpp"
#include "hitos/services/evaluation/reference_fit.hpp"
#include "look/words_of.hpp"

namespace hitos::window {

/// Beside those that are in use. Gives what there is to doubt of them; throws hitos::Error, as of a
/// trajectory of another tour, and changes nothing.
std::optional<Advice> ConfigurationActions::take_references(const ReferenceFiles& files) {
    References references = session_.user_references();
    std::optional<Advice> doubt;
    QString map_file = session_.reference_map_file();
    if (!files.map.empty()) {
        references.map = read_map(files.map);
        map_file = QFileInfo(QString::fromStdString(files.map)).absoluteFilePath();
    }
    if (!files.trajectory.empty()) {
        references.trajectory = read_trajectory(files.trajectory);
        // A tour that is being driven is not over.
        if (session_.has_source() && !session_.live_tour()) {
            const auto fit = [&path = *references.trajectory](const Algoritmo& run) {
                return fit_by_odometry(run.reader(), path);
            };
            const std::vector<Advice> doubts = session_.worker()->with_run(fit).get().doubts();
            if (!doubts.empty()) doubt = doubts.front();
        }
    }
    session_.set_references(references, map_file);
    return doubt;
}

/// What the file holds counts, and what it was taken for where that cannot be seen.
bool ConfigurationActions::use_reference(const QString& path, FileKind kind) {
    const std::string file = path.toStdString();
    try {
        if (const auto held = reference_kind(file))
            kind = *held == ReferenceKind::map ? FileKind::map : FileKind::trajectory;
        const bool map = kind == FileKind::map;
        const auto doubt =
            take_references(map ? ReferenceFiles{file, {}} : ReferenceFiles{{}, file});
        const References& used = session_.user_references();
        emit notice(
            map ? tr("Reference map: %1")
                      .arg(counted_words(used.map->size(), tr("1 landmark"), tr("%1 landmarks")))
                : tr("Reference trajectory: %1")
                      .arg(counted_words(used.trajectory->size(), tr("1 pose"), tr("%1 poses"))));
        if (doubt) prompts_.warn(window_, tr("The reference is in doubt"), words_of(*doubt));
    } catch (const std::exception& error) {
        prompts_.warn(window_, tr("The reference was not loaded"), words_of(error));
        return false;
    }
    files_.note_opened("map", path);
    files_.note_recent(path);
    return true;
}

void ConfigurationActions::load_reference_map() {
    load_reference(FileKind::map, tr("Load reference map"),
                   tr("Maps (*.map *.txt);;All files (*)"));
}

void ConfigurationActions::load_reference_trajectory() {
    load_reference(FileKind::trajectory, tr("Load reference trajectory"),
                   tr("Trajectories (*.tum *.txt *.gz);;All files (*)"));
}

void ConfigurationActions::load_reference(FileKind kind, const QString& title,
                                          const QString& filters) {
    for (;;) {
        const QString path =
            prompts_.open_file(window_, {title, files_.folder_to_open("map"), filters, {}});
        if (path.isEmpty() || use_reference(path, kind)) return;
    }
}

void ConfigurationActions::remove_references() {
    session_.set_references({});
    emit notice(tr("References removed"));
}

}  // namespace hitos::window
