#include "user_files.hpp"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace hitos::window {
namespace {

constexpr int kMostRecent = 10;
constexpr const char* kRecentKey = "recent/files";

QString folder_or_default(const QString& folder) {
    return folder.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation)
                            : folder;
}

}  // namespace

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

QString UserFiles::last_folder(const QString& kind) const {
    const QString home = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return settings_.value("folders/" + kind, home).toString();
}

void UserFiles::note_folder(const QString& kind, const QString& path) {
    settings_.setValue("folders/" + kind, QFileInfo(path).absolutePath());
}

FileKind kind_of(const QString& path) {
    return QFileInfo(path).suffix().toLower() == "cfg" ? FileKind::configuration : FileKind::source;
}

}  // namespace hitos::window
