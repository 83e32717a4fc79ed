// SPDX-License-Identifier: GPL-3.0-or-later
#include "configuration_actions.hpp"

#include <QDir>
#include <QFileInfo>
#include <QWidget>
#include <algorithm>
#include <utility>
#include <vector>

#include "dialogs/configuration_dialog.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/results/kept_run.hpp"
#include "hitos/workbench/presets.hpp"
#include "hitos/workbench/source_inspection.hpp"
#include "look/parameter_text.hpp"
#include "look/words_of.hpp"

namespace hitos::window {
namespace {

/// Whether a preset brought the way in which the odometry is taken, and not the user.
bool has_odometry_of_a_preset(const Configuracion& configuration) {
    return std::ranges::any_of(presets(), [&](const Preset& preset) {
        Configuracion made = preset_configuration(preset.word);
        if (made.source.read.odometry != configuration.source.read.odometry) return false;
        made.source = configuration.source;
        made.run = configuration.run;
        made.registration.edits = configuration.registration.edits;
        return differences(made, configuration).empty();
    });
}

}  // namespace

SourceParams with_preset(const SourceParams& source, const SourceParams& preset) {
    SourceParams both = source;
    both.world_set = preset.world_set;
    both.read.odometry = preset.read.odometry;
    return both;
}

QString sentences(QStringList parts) {
    parts.removeAll(QString());
    return parts.join(QStringLiteral(". "));
}

ConfigurationActions::ConfigurationActions(Session& session, UserFiles& files, Prompts& prompts,
                                           const RunGuard& guard, QWidget* window)
    : QObject(window),
      session_(session),
      files_(files),
      prompts_(prompts),
      guard_(guard),
      window_(window),
      now_(session.configuration()) {
    connect(&session, &Session::configuration_changed, this, &ConfigurationActions::note_change);
}

bool ConfigurationActions::use_again(const Configuracion& configuration) {
    if (!guard_.may_begin(configuration)) return false;
    const bool had = has_references();
    if (!use(configuration)) return false;
    if (const QString lost = lost_words(had); !lost.isEmpty()) emit notice(lost);
    return true;
}

void ConfigurationActions::look_at_run(Configuracion configuration) {
    configuration.run.threads = session_.configuration().run.threads;
    if (use_again(configuration)) session_.seek(RunWorker::kToTheEnd);
}

void ConfigurationActions::use_edits(const std::string& edits) {
    Configuracion next = session_.configuration();
    next.registration.edits = edits;
    if (use(next)) emit notice(tr("The graph is changed by hand; what follows is done again"));
}

/// Where the topics of its recording are still to be chosen, the form asks for them.
bool ConfigurationActions::use(const Configuracion& configuration) {
    try {
        const std::string& edits = configuration.registration.edits;
        Configuracion edited = session_.configuration();
        // What other changes by hand do not touch of the run stays.
        if (std::exchange(edited.registration.edits, edits) != edits &&
            same_configuration(edited, configuration)) {
            session_.set_edits(edits);
        } else {
            session_.set_configuration(configuration);
        }
        return true;
    } catch (const std::exception& error) {
        if (asks_for_topics(error, configuration.source.read)) {
            return choose_source(configuration, true);
        }
        prompts_.warn(window_, tr("The configuration cannot be used"), words_of(error));
        return false;
    }
}

bool ConfigurationActions::open(const QString& path, bool confirmed) {
    if (path.isEmpty()) return false;
    const FileKind kind = kind_of(path);
    if (kind == FileKind::configuration) return load_file(path, confirmed);
    if (kind == FileKind::source) return use_log(path);
    if (kind == FileKind::results) {
        emit results_named(path);
        return true;
    }
    if (kind == FileKind::graph) {
        emit graph_named(path);
        return true;
    }
    return use_reference(path, kind);
}

void ConfigurationActions::open_all(QStringList paths) {
    const auto order = [](const QString& path) { return static_cast<int>(kind_of(path)); };
    std::ranges::stable_sort(paths, {}, order);  // a reference belongs to the log before it
    for (const QString& path : paths) {
        if (!open(path)) return;  // what follows is about it
    }
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
    if (!confirmed && guard_.ends_tour(next) && !guard_.may_leave()) return true;
    const bool had = has_references();
    if (!use(next)) return false;
    own_.clear();
    files_.note_opened("config", path);
    files_.note_recent(path);
    emit notice(sentences(
        {tr("Configuration loaded: %1").arg(QFileInfo(path).fileName()), lost_words(had)}));
    return true;
}

void ConfigurationActions::use_preset(std::string_view word, bool confirmed) {
    const Configuracion& now = session_.configuration();
    Configuracion next;
    try {
        next = preset_configuration(word);
        // What the user has set stays where the preset says nothing of it.
        if (next.source.read.odometry == ReadOptions().odometry && !has_odometry_of_a_preset(now))
            next.source.read.odometry = now.source.read.odometry;
    } catch (const std::exception& error) {
        prompts_.warn(window_, tr("The configuration was not loaded"), words_of(error));
        return;
    }
    next.source = with_preset(now.source, next.source);
    next.registration.edits = now.registration.edits;
    const QString name = translated("Preset", find_preset(word).label);
    if (!confirmed &&
        !prompts_.confirm(window_, {tr("Preset"), tr("Replace the configuration by %1?").arg(name),
                                    tr("The run starts from the beginning."), tr("Load")})) {
        return;
    }
    if (!use(next)) return;
    own_.clear();
    emit notice(tr("Configuration loaded: %1").arg(name));
}

void ConfigurationActions::load() {
    QString start = files_.folder_to_open("config");
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
    save_as(files_.place_to_save("hitos.cfg"), tr("Save configuration"));
}

void ConfigurationActions::save_preset() {
    QDir().mkpath(files_.presets_folder());
    save_as(files_.presets_folder() + "/hitos.cfg", tr("Save as preset"));
}

void ConfigurationActions::save_as(const QString& start, const QString& title) {
    const QString path = save_until_done(
        prompts_, window_, {title, start, tr("Configurations (*.cfg);;All files (*)"), "cfg"},
        [this](const QString& target) {
            ArchivoConfiguracion::write(session_.configuration(), target.toStdString());
        });
    if (path.isEmpty()) return;
    if (QFileInfo(path).absolutePath() != QFileInfo(files_.presets_folder()).absoluteFilePath()) {
        files_.note_saved("config", path);  // presets have a menu of their own
    }
    files_.note_recent(path);
    emit notice(tr("Configuration saved: %1").arg(QDir::toNativeSeparators(path)));
}

bool same_configuration(const Configuracion& a, const Configuracion& b) {
    return a.source.file == b.source.file &&
           ArchivoConfiguracion::to_text(a) == ArchivoConfiguracion::to_text(b);
}

/// Keeps the configuration that was, unless there was no log to run it on.
void ConfigurationActions::note_change() {
    constexpr std::size_t kMost = 50;
    const Configuracion& next = session_.configuration();
    if (!in_history_ && !now_.source.file.empty() && !same_configuration(now_, next)) {
        before_.push_back(now_);
        if (before_.size() > kMost) before_.erase(before_.begin());
        after_.clear();
    }
    now_ = next;
    emit history_changed();
}

void ConfigurationActions::undo() {
    go_to(before_, after_, tr("Undone, now: %1"));
}

void ConfigurationActions::redo() {
    go_to(after_, before_, tr("Redone, now: %1"));
}

QString ConfigurationActions::undo_words() const {
    return !before_.empty() ? change_words(before_.back(), now_) : QString();
}

QString ConfigurationActions::redo_words() const {
    return !after_.empty() ? change_words(after_.back(), now_) : QString();
}

void ConfigurationActions::go_to(std::vector<Configuracion>& there,
                                 std::vector<Configuracion>& back, const QString& words) {
    if (there.empty() || !guard_.may_begin(there.back())) return;
    const Configuracion from = now_;
    const bool had = has_references();
    in_history_ = true;
    const bool done = use(there.back());
    in_history_ = false;
    if (!done) return;
    there.pop_back();
    back.push_back(from);
    emit history_changed();
    emit notice(sentences({words.arg(change_words(now_, from)), lost_words(had)}));
}

void ConfigurationActions::configure() {
    configure_group(ParameterGroup::particle_filter);
}

void ConfigurationActions::configure_group(ParameterGroup group) {
    if (group == ParameterGroup::source) {
        select_source();
        return;
    }
    ConfigurationDialog dialog(session_.configuration(), window_);
    dialog.show_group(group);
    while (dialog.exec() == QDialog::Accepted) {
        if (!guard_.may_begin(dialog.configuration()) || !use(dialog.configuration())) continue;
        emit notice(tr("The configuration has changed"));
        window_->activateWindow();  // two dialogs have closed at once
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
        own_.clear();
        emit notice(tr("Default configuration written: %1").arg(QDir::toNativeSeparators(path)));
    } catch (const std::exception& error) {
        tell_not_written(prompts_, window_, words_of(error));
    }
}

}  // namespace hitos::window
