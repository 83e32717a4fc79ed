// References to measure a run against: a map and a trajectory, from files.

#include "configuration_actions.hpp"
#include "look/words_of.hpp"

namespace hitos::window {

bool ConfigurationActions::use_reference(const QString& path, FileKind kind) {
    try {
        References references = session_.user_references();
        if (kind == FileKind::map) {
            references.map = read_map(path.toStdString());
            session_.set_references(references, path);
            emit notice(tr("Reference map: %1")
                            .arg(counted_words(references.map->size(), tr("1 landmark"),
                                               tr("%1 landmarks"))));
        } else {
            references.trajectory = read_trajectory(path.toStdString());
            session_.set_references(references, session_.reference_map_file());
            emit notice(tr("Reference trajectory: %1")
                            .arg(counted_words(references.trajectory->size(), tr("1 pose"),
                                               tr("%1 poses"))));
        }
    } catch (const std::exception& error) {
        prompts_.warn(window_, tr("The reference was not loaded"), words_of(error));
        return false;
    }
    files_.note_folder("map", path);
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
