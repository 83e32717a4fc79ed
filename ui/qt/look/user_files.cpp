// SPDX-License-Identifier: GPL-3.0-or-later
#include "user_files.hpp"

#include <QDir>
#include <QFileInfo>
#include <QMap>
#include <QStandardPaths>
#include <optional>

#include "hitos/base/error.hpp"
#include "hitos/base/translatable.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "hitos/services/files/reference_files.hpp"
#include "hitos/workbench/shipped_data.hpp"

namespace hitos::window {
namespace {

constexpr int kMostRecent = 10;
constexpr int kLongestName = 60;  // letters, of which a file system may count each as four
constexpr const char* kRecentKey = "recent/files";
constexpr const char* kSaved = "saved";  // whatever its kind

QString folder_or_default(const QString& folder) {
    return folder.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation)
                            : folder;
}

/// Nothing too where the file cannot be looked into: its reader says why.
std::optional<ReferenceKind> known_reference(const QString& path) {
    try {
        return reference_kind(path.toStdString());
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace

bool is_shipped(const QString& path) {
    const QString folder = QFileInfo(shipped_folder("log")).canonicalFilePath();
    const QString place = QFileInfo(path).dir().canonicalPath() + '/';
    return !folder.isEmpty() && place.startsWith(folder + '/');
}

void check_world_name(const QString& path) {
    if (!is_world_file(path.toStdString())) {
        throw FileError(path.toStdString(),
                        HITOS_TEXT("Errors", "expected a name that ends in .toml"));
    }
    if (is_shipped(path)) {
        throw FileError(
            path.toStdString(),
            HITOS_TEXT("Errors",
                       "lies among the files that come with Hitos; choose another folder"));
    }
}

QString new_file_of_data(const QString& folder, const QString& name, const QString& ending) {
    const QDir place(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + '/' +
                     folder);
    place.mkpath(QStringLiteral("."));
    QString path;
    for (int number = 1; path.isEmpty() || QFileInfo::exists(path); ++number) {
        path = place.filePath(QStringLiteral("%1-%2.%3")
                                  .arg(name.left(kLongestName), QString::number(number), ending));
    }
    return path;
}

QString shipped_folder(const QString& kind) {
    static const QMap<QString, const char*> folders{
        {"config", "config"}, {"log", "data"}, {"map", "data/maps"}, {"distances", "data/worlds"}};
    const char* folder = folders.value(kind, nullptr);
    return folder == nullptr ? QString() : QString::fromStdString(shipped_file(folder).string());
}

UserFiles::UserFiles(const QString& folder, QObject* parent)
    : QObject(parent),
      folder_(folder_or_default(folder)),
      settings_(folder_ + "/window.ini", QSettings::IniFormat) {}

QString UserFiles::init_path() const {
    return folder_ + "/init.cfg";
}

bool UserFiles::has_init() const {
    return QFileInfo::exists(init_path());
}

QString UserFiles::presets_folder() const {
    return folder_ + "/presets";
}

QStringList UserFiles::presets() const {
    const QDir folder(presets_folder());
    QStringList paths;
    for (const QString& name : folder.entryList({"*.cfg"}, QDir::Files)) {
        paths << folder.filePath(name);
    }
    return paths;
}

QStringList UserFiles::recent() const {
    QStringList paths = settings_.value(kRecentKey).toStringList();
    paths.removeIf([](const QString& path) { return !QFileInfo::exists(path); });
    return paths;
}

void UserFiles::note_recent(const QString& path) {
    const QString whole = QFileInfo(path).absoluteFilePath();
    QStringList paths = settings_.value(kRecentKey).toStringList();
    paths.removeAll(whole);
    paths.prepend(whole);
    settings_.setValue(kRecentKey, paths.mid(0, kMostRecent));
    emit recent_changed();
}

void UserFiles::clear_recent() {
    settings_.remove(kRecentKey);
    emit recent_changed();
}

QString UserFiles::noted_folder(const QString& kind) const {
    const QString noted = settings_.value("folders/" + kind).toString();
    return QFileInfo(noted).isDir() ? noted : QString();
}

QString UserFiles::place_to_save(const QString& name) const {
    QString folder = noted_folder(kSaved);
    if (folder.isEmpty()) {
        folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
        if (!QFileInfo(folder).isDir()) folder = QDir::homePath();
    }
    return folder + '/' + name;
}

QString UserFiles::folder_to_open(const QString& kind) const {
    for (const QString& folder : {noted_folder(kind), shipped_folder(kind)}) {
        if (!folder.isEmpty()) return folder;
    }
    return QFileInfo(place_to_save({})).absolutePath();
}

void UserFiles::note_opened(const QString& kind, const QString& path) {
    settings_.setValue("folders/" + kind, QFileInfo(path).absolutePath());
}

void UserFiles::note_saved(const QString& kind, const QString& path) {
    note_opened(kind, path);
    note_opened(kSaved, path);
}

FileKind kind_of(const QString& path) {
    if (QFileInfo(path).isDir()) {
        return is_recording_folder(path.toStdString()) ? FileKind::source : FileKind::results;
    }
    QString name = QFileInfo(path).fileName().toLower();
    if (name.endsWith(".gz")) name.chop(3);
    if (name.endsWith(".cfg")) return FileKind::configuration;
    if (name.endsWith(".g2o")) return FileKind::graph;
    if (const auto kind = known_reference(path))
        return *kind == ReferenceKind::map ? FileKind::map : FileKind::trajectory;
    if (name.endsWith(".map")) return FileKind::map;
    return name.endsWith(".tum") ? FileKind::trajectory : FileKind::source;
}

}  // namespace hitos::window
