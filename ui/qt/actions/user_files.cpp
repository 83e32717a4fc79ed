#include "user_files.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include "hitos/services/configuration/archivo_configuracion.hpp"

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

Configuracion read_configuration(const QString& path) {
    Configuracion configuration = ArchivoConfiguracion::read(path.toStdString());
    const QString source = QString::fromStdString(configuration.source.file);
    if (!source.isEmpty() && QFileInfo(source).isRelative() && !QFileInfo::exists(source)) {
        const QString beside = QFileInfo(path).absoluteDir().filePath(source);
        if (QFileInfo::exists(beside)) configuration.source.file = beside.toStdString();
    }
    return configuration;
}

FileKind kind_of(const QString& path) {
    return QFileInfo(path).suffix().toLower() == "cfg" ? FileKind::configuration : FileKind::source;
}

QString shipped_file(const QString& relative) {
    const QString here = QCoreApplication::applicationDirPath();
    for (const QString& folder : {here, here + "/..", here + "/../../..", here + "/../share/hitos",
                                  QStringLiteral("/usr/share/hitos")}) {
        const QFileInfo file(folder + '/' + relative);
        if (file.exists()) return file.canonicalFilePath();
    }
    return {};
}

}  // namespace hitos::window
