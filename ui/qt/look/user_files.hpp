// SPDX-License-Identifier: GPL-3.0-or-later
// Where the user's own files lie, and the logs and configurations used last.
#pragma once

#include <QObject>
#include <QSettings>
#include <QString>
#include <QStringList>
#include <optional>

#include "hitos/services/configuration/configuracion.hpp"

namespace hitos::window {

/// init.cfg, the window's settings and the recent files, all in one folder.
class UserFiles final : public QObject {
    Q_OBJECT

  public:
    /// The user's configuration folder, or another one.
    explicit UserFiles(const QString& folder = {}, QObject* parent = nullptr);

    QString init_path() const;
    bool has_init() const;
    QSettings& settings() { return settings_; }
    /// Where the user's own presets lie, and those that are there, by name.
    QString presets_folder() const;
    QStringList presets() const;

    /// Newest first; only what still exists.
    QStringList recent() const;
    void note_recent(const QString& path);
    void clear_recent();

    /// Where to save something under this name: where the last thing was saved, whatever it was,
    /// else in the user's documents; never where something was only read. The folder is there.
    QString place_to_save(const QString& name) const;
    /// The folder to look for a file of this kind in ("log", "config", "map"): where the last one
    /// was opened or saved, at first that of those which come with Hitos.
    QString folder_to_open(const QString& kind) const;
    void note_opened(const QString& kind, const QString& path);
    void note_saved(const QString& kind, const QString& path);

  signals:
    void recent_changed();

  private:
    /// Empty where there is none, or no longer.
    QString noted_folder(const QString& kind) const;

    QString folder_;
    QSettings settings_;
};

/// What the user may name on the command line or drop on the window.
enum class FileKind {
    results,        ///< a folder: what a run has left
    configuration,  ///< .cfg
    source,         ///< a log, or a world (.toml)
    map,            ///< .map: a reference
    trajectory,     ///< .tum: likewise
    graph           ///< .g2o: a graph of poses
};
/// By the file's ending; a .txt is whichever it reads as.
FileKind kind_of(const QString& path);

/// A file that is not there yet, in that folder of the program's data, which is made:
/// "NAME-3.toml".
QString new_file_of_data(const QString& folder, const QString& name, const QString& ending);

/// Throws hitos::Error where a world may not be written under that name: without the ending by
/// which it is known, or among those that come with Hitos.
void check_world_name(const QString& path);
bool is_shipped(const QString& path);

/// The folder of the files of this kind that come with Hitos; empty where there is none.
QString shipped_folder(const QString& kind);

}  // namespace hitos::window
