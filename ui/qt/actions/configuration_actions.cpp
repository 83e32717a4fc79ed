#include "configuration_actions.hpp"

#include <QDir>
#include <QFileInfo>
#include <QTimer>
#include <QWidget>
#include <utility>
#include <vector>

#include "app/command_line.hpp"
#include "dialogs/configuration_dialog.hpp"
#include "dialogs/parameter_text.hpp"
#include "dialogs/source_dialog.hpp"
#include "hitos/base/error.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/workbench/presets.hpp"

namespace hitos::window {

ConfigurationActions::ConfigurationActions(Session& session, UserFiles& files, Prompts& prompts,
                                           QWidget* window)
    : QObject(window), session_(session), files_(files), prompts_(prompts), window_(window) {}

void ConfigurationActions::start(const CommandLine& line) {
    const Configuracion configuration = starting_configuration(line, files_);
    const References references = starting_references(line, configuration);
    session_.set_configuration(configuration);
    session_.set_references(references,
                            QString::fromStdString(starting_reference_map(line, configuration)));
}

void ConfigurationActions::start_or_warn(const CommandLine& line) {
    std::vector<std::pair<QString, QString>> complaints;
    const auto possible = [&complaints](const QString& otherwise, const auto& act) {
        try {
            act();
            return true;
        } catch (const std::exception& error) {
            complaints.emplace_back(otherwise, words_of(error));
            return false;
        }
    };
    Configuracion configuration;
    const auto read = [&](Init init) {
        return [&, init] { configuration = starting_configuration(line, files_, init); };
    };
    const QString unusable = tr("The configuration cannot be used");
    if (!possible(unusable, read(Init::read))) {
        const std::size_t told = complaints.size();
        if (!possible(unusable, read(Init::ignored))) {
            possible(unusable, [&] { configuration = starting_configuration({}, files_); });
            configuration.source.file.clear();
            complaints.resize(told);
        }
    }
    if (!possible(tr("The log cannot be used"),
                  [&] { session_.set_configuration(configuration); })) {
        configuration.source.file.clear();
        possible(unusable, [&] { session_.set_configuration(configuration); });
    }
    possible(tr("The reference was not loaded"), [&] {
        session_.set_references(
            starting_references(line, configuration),
            QString::fromStdString(starting_reference_map(line, configuration)));
    });
    if (complaints.empty()) return;
    QTimer::singleShot(0, this, [this, complaints] {
        for (const auto& [title, reason] : complaints) prompts_.warn(window_, title, reason);
    });
}

bool ConfigurationActions::use(const Configuracion& configuration) {
    try {
        session_.set_configuration(configuration);
        return true;
    } catch (const std::exception& error) {
        prompts_.warn(window_, tr("The configuration cannot be used"), words_of(error));
        return false;
    }
}

void ConfigurationActions::select_source(const QString& path) {
    SourceParams source = session_.configuration().source;
    if (!path.isEmpty()) source.file = path.toStdString();
    SourceDialog dialog(source, prompts_, files_.last_folder("log"), window_);
    while (dialog.exec() == QDialog::Accepted) {
        Configuracion next = session_.configuration();
        next.source = dialog.source();
        if (!use(next)) continue;
        const QString file = QString::fromStdString(next.source.file);
        files_.note_folder("log", file);
        files_.note_recent(file);
        const TourSummary summary = dialog.summary().value_or(SourceInspection{}).tour;
        emit notice(tr("Source loaded: %1, %2 scans")
                        .arg(QFileInfo(file).fileName())
                        .arg(summary.report.scans));
        return;
    }
}

bool ConfigurationActions::use_log(const QString& path) {
    Configuracion next = session_.configuration();
    next.source.file = path.toStdString();
    next.source.format = kAutoFormat;
    try {
        session_.set_configuration(next);
    } catch (const std::exception& error) {
        prompts_.warn(window_, tr("The log cannot be used"), words_of(error));
        return false;
    }
    files_.note_recent(path);
    emit notice(tr("Source loaded: %1").arg(QFileInfo(path).fileName()));
    return true;
}

bool ConfigurationActions::open(const QString& path, bool confirmed) {
    if (path.isEmpty()) return false;
    return kind_of(path) == FileKind::configuration ? load_file(path, confirmed) : use_log(path);
}

bool ConfigurationActions::load_file(const QString& path, bool confirmed) {
    Configuracion next;
    try {
        next = ArchivoConfiguracion::read(path.toStdString());
    } catch (const std::exception& error) {
        prompts_.warn(window_, tr("The configuration was not loaded"), words_of(error));
        return false;
    }
    // A file that names no log is about the parameters alone.
    if (next.source.file.empty()) next.source = session_.configuration().source;
    if (!confirmed &&
        !prompts_.confirm(window_,
                          {tr("Load configuration"),
                           tr("Replace the configuration by %1?").arg(QFileInfo(path).fileName()),
                           tr("The run starts from the beginning."), tr("Load")})) {
        return true;  // the user's own wish, nothing to mend
    }
    if (!use(next)) return false;
    files_.note_folder("config", path);
    files_.note_recent(path);
    emit notice(tr("Configuration loaded: %1").arg(QFileInfo(path).fileName()));
    return true;
}

void ConfigurationActions::use_preset(std::string_view word) {
    Configuracion next;
    try {
        next = preset_configuration(word);
    } catch (const std::exception& error) {
        prompts_.warn(window_, tr("The configuration was not loaded"), words_of(error));
        return;
    }
    const std::string world_set = next.source.world_set;
    next.source = session_.configuration().source;
    next.source.world_set = world_set;
    const QString name = translated("Preset", find_preset(word).label);
    if (!prompts_.confirm(window_, {tr("Preset"), tr("Replace the configuration by %1?").arg(name),
                                    tr("The run starts from the beginning."), tr("Load")})) {
        return;
    }
    if (use(next)) emit notice(tr("Configuration loaded: %1").arg(name));
}

void ConfigurationActions::load() {
    QString start = files_.last_folder("config");
    for (;;) {
        const QString path = prompts_.open_file(
            window_,
            {tr("Load configuration"), start, tr("Configurations (*.cfg);;All files (*)"), {}});
        if (path.isEmpty()) return;
        if (load_file(path, false)) return;
        start = path;
    }
}

void ConfigurationActions::save() {
    const QString path = save_until_done(
        prompts_, window_,
        {tr("Save configuration"), files_.last_folder("config") + "/hitos.cfg",
         tr("Configurations (*.cfg);;All files (*)"), "cfg"},
        [this](const QString& target) {
            ArchivoConfiguracion::write(session_.configuration(), target.toStdString());
        });
    if (path.isEmpty()) return;
    files_.note_folder("config", path);
    files_.note_recent(path);
    emit notice(tr("Configuration saved: %1").arg(QDir::toNativeSeparators(path)));
}

void ConfigurationActions::configure() {
    configure_group(ParameterGroup::particle_filter);
}

void ConfigurationActions::configure_group(ParameterGroup group) {
    if (group == ParameterGroup::source) {
        select_source();
        return;
    }
    ConfigurationDialog dialog(session_.configuration(), prompts_, window_);
    dialog.show_group(group);
    while (dialog.exec() == QDialog::Accepted) {
        if (!use(dialog.configuration())) continue;
        emit notice(tr("The configuration has changed"));
        return;
    }
}

void ConfigurationActions::set_default() {
    const QString path = files_.init_path();
    if (!prompts_.confirm(window_,
                          {tr("Set as default"), tr("Start with this configuration from now on?"),
                           tr("%1 is overwritten.").arg(QDir::toNativeSeparators(path)),
                           tr("Set as default"), files_.has_init()})) {
        return;
    }
    try {
        QDir().mkpath(QFileInfo(path).absolutePath());
        ArchivoConfiguracion::write(session_.configuration(), path.toStdString());
        emit notice(tr("Default configuration written: %1").arg(QDir::toNativeSeparators(path)));
    } catch (const std::exception& error) {
        tell_not_written(prompts_, window_, words_of(error));
    }
}

void ConfigurationActions::load_reference_map() {
    for (;;) {
        const QString path = prompts_.open_file(window_, {tr("Load reference map"),
                                                          files_.last_folder("map"),
                                                          tr("Maps (*.map *.txt);;All files (*)"),
                                                          {}});
        if (path.isEmpty()) return;
        try {
            References references = session_.user_references();
            references.map = read_map(path.toStdString());
            session_.set_references(references, path);
            files_.note_folder("map", path);
            emit notice(tr("Reference map: %1 landmarks").arg(references.map->size()));
            return;
        } catch (const std::exception& error) {
            prompts_.warn(window_, tr("The reference was not loaded"), words_of(error));
        }
    }
}

void ConfigurationActions::load_reference_trajectory() {
    for (;;) {
        const QString path =
            prompts_.open_file(window_, {tr("Load reference trajectory"),
                                         files_.last_folder("map"),
                                         tr("Trajectories (*.tum *.txt *.gz);;All files (*)"),
                                         {}});
        if (path.isEmpty()) return;
        try {
            References references = session_.user_references();
            references.trajectory = read_trajectory(path.toStdString());
            session_.set_references(references, session_.reference_map_file());
            files_.note_folder("map", path);
            emit notice(tr("Reference trajectory: %1 poses").arg(references.trajectory->size()));
            return;
        } catch (const std::exception& error) {
            prompts_.warn(window_, tr("The reference was not loaded"), words_of(error));
        }
    }
}

void ConfigurationActions::remove_references() {
    session_.set_references({});
    emit notice(tr("References removed"));
}

}  // namespace hitos::window
