// SPDX-License-Identifier: GPL-3.0-or-later
// What is run: the tour of a log, a world or what comes in, and what it begins with.
#include <QFileInfo>
#include <QTimer>
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "command_line.hpp"
#include "configuration_actions.hpp"
#include "dialogs/source_dialog.hpp"
#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "hitos/services/results/kept_run.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "hitos/workbench/presets.hpp"
#include "look/parameter_text.hpp"
#include "look/words_of.hpp"

namespace hitos::window {
namespace {

bool is_source(const std::string& named) {
    return !named.empty() && kind_of(QString::fromStdString(named)) == FileKind::source;
}

/// Why a file was refused, and how it begins, to see what it is instead.
QString with_beginning(const QString& reason, const std::string& file) {
    constexpr std::size_t kMostLines = 5;
    if (is_recording(file)) return reason;  // its topics take a pass over the whole file
    std::vector<Message> lines = beginning_of(file);
    lines.resize(std::min(lines.size(), kMostLines));
    if (lines.empty()) return reason;
    QString text = reason + "\n\n" + ConfigurationActions::tr("The file begins:");
    for (const Message& line : lines) text += '\n' + words_of(line);
    return text;
}

/// Which parameters were taken, and why.
QString suited_words(const std::string& source) {
    const std::string_view preset = suited_preset(source);
    if (preset.empty()) return ConfigurationActions::tr("Parameters: the defaults");
    const QString why =
        preset == kWorldPreset ? ConfigurationActions::tr("Parameters: %1, because this is a world")
        : preset == kLandmarkPreset
            ? ConfigurationActions::tr("Parameters: %1, because its sensor tells landmarks")
        : preset == kTreePreset
            ? ConfigurationActions::tr("Parameters: %1, because this is a world of trees")
        : is_world_file(source)
            ? ConfigurationActions::tr("Parameters: %1, because this is a world with people")
            : ConfigurationActions::tr("Parameters: %1, because a robot recorded this log");
    return why.arg(translated("Preset", find_preset(preset).label));
}

}  // namespace

void ConfigurationActions::start(const CommandLine& line) {
    const Configuracion configuration = starting_configuration(line, files_);
    expect_used(line.values, line.topics, {configuration.source.file});
    session_.set_configuration(configuration);
    own_.clear();
    if (nobody_chose(line, files_)) own_.push_back(configuration);
    take_references(starting_references(line, configuration));
}

void ConfigurationActions::start_or_warn(const CommandLine& line) {
    std::vector<std::pair<QString, QString>> complaints;
    const QString unusable_log = tr("The log cannot be used");
    const auto possible = [&](const QString& otherwise, const auto& act) {
        try {
            act();
            return true;
        } catch (const FileError& error) {
            const bool log = error.path() == line.open && is_source(line.open);
            complaints.emplace_back(log ? unusable_log : otherwise, words_of(error));
        } catch (const std::exception& error) {
            complaints.emplace_back(otherwise, words_of(error));
        }
        return false;
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
    // What is told besides is opened all the same.
    if (complaints.empty())
        possible(tr("An option has no effect"),
                 [&] { expect_used(line.values, line.topics, {configuration.source.file}); });
    std::optional<Configuracion> to_choose;
    const auto open = [&] {
        try {
            session_.set_configuration(configuration);
        } catch (const ConfigError& error) {
            if (!asks_for_topics(error, configuration.source.read)) throw;
            to_choose = configuration;
            configuration.source.file.clear();
            session_.set_configuration(configuration);
        }
    };
    if (!possible(unusable_log, open)) {
        QString& reason = complaints.back().second;
        reason = with_beginning(reason, configuration.source.file);
        configuration.source.file.clear();
        possible(unusable, [&] { session_.set_configuration(configuration); });
    }
    own_.clear();
    if (nobody_chose(line, files_)) own_.push_back(configuration);
    possible(tr("The reference was not loaded"), [&] {
        if (const auto doubt = take_references(starting_references(line, configuration)))
            complaints.emplace_back(tr("The reference is in doubt"), words_of(*doubt));
    });
    note_named(line);
    QString suited;
    if (complaints.empty()) {
        const std::string source = deciding_source(line, files_, Init::read);
        if (!source.empty()) suited = suited_words(source);
    }
    if (complaints.empty() && !to_choose) {
        if (!suited.isEmpty()) emit notice(suited);
        return;
    }
    QTimer::singleShot(0, this, [this, complaints, to_choose, suited, run = line.run] {
        for (const auto& [title, reason] : complaints) prompts_.warn(window_, title, reason);
        if (to_choose) choose_at_start(*to_choose, suited, run);
    });
}

/// With the references of the command line, and run where it asks for that.
void ConfigurationActions::choose_at_start(const Configuracion& configuration,
                                           const QString& suited, bool run) {
    const References named = session_.user_references();  // those of a log go with it
    const QString map = session_.reference_map_file();
    if (!choose_source(configuration, true, suited)) return;
    if (same_log(session_.configuration(), configuration)) session_.set_references(named, map);
    if (run) session_.run();
}

/// What was opened from outside is as recent as what was opened here.
void ConfigurationActions::note_named(const CommandLine& line) {
    const std::string& log = session_.configuration().source.file;
    if (!line.config.empty()) files_.note_recent(QString::fromStdString(line.config));
    if (line.open.empty()) return;
    const QString named = QString::fromStdString(line.open);
    const FileKind kind = kind_of(named);
    if (kind == FileKind::configuration) {
        files_.note_recent(named);
    } else if (kind != FileKind::results && kind != FileKind::graph && !log.empty()) {
        files_.note_recent(QString::fromStdString(log));
    }
}

void ConfigurationActions::select_source() {
    choose_source(session_.configuration(), false);
}

bool ConfigurationActions::map_incoming(const SourceParams& source,
                                        std::shared_ptr<IncomingTour> tour) {
    const bool had = has_references();
    Configuracion next = session_.configuration();
    const QString suited = suit(next, source.file);
    const OdometryFrom odometry = next.source.read.odometry;
    forget_recording(next);
    next.source.file = source.file;
    next.source.format = source.format;
    next.source.read = source.read;
    next.source.read.odometry = odometry;
    try {
        session_.set_incoming(next, std::move(tour));
    } catch (const std::exception& error) {
        prompts_.warn(window_, tr("The tour that comes in cannot be mapped"), words_of(error));
        return false;
    }
    if (!suited.isEmpty()) own_.push_back(next);
    const QString file = QString::fromStdString(source.file);
    files_.note_recent(file);
    session_.run();
    emit notice(sentences(
        {tr("Maps what comes in: %1").arg(QFileInfo(file).fileName()), suited, lost_words(had)}));
    return true;
}

/// The map of a run whose results are asked for, and a tour that is asked for in it.
void ConfigurationActions::go_on() {
    const QString folder = prompts_.choose_folder(
        window_, tr("The results of the map to go on with"), files_.folder_to_open("results"));
    if (folder.isEmpty()) return;
    try {
        const Configuracion& now = session_.configuration();
        Configuracion next = configuration_to_go_on(folder.toStdString());
        next.run = now.run;
        const std::string world_set = next.source.world_set;
        next.source = now.source;
        next.source.world_set = world_set;
        next.source.map = folder.toStdString();
        next.source.start.clear();
        files_.note_opened("results", folder);
        choose_source(next, false, {}, true);
    } catch (const std::exception& error) {
        prompts_.warn(window_, tr("There is no map to go on with"), words_of(error));
    }
}

/// Asks for the source of a configuration in the form, beginning with its own; `suited` says what
/// that one decided already; `goes_on`: with its map, whatever the file. False where the user would
/// have none.
bool ConfigurationActions::choose_source(Configuracion next, bool confirmed, const QString& suited,
                                         bool goes_on) {
    const Configuracion given = next;
    SourceDialog dialog(given.source, prompts_, files_.folder_to_open("log"), window_);
    if (goes_on) dialog.go_on_with_map();
    while (dialog.exec() == QDialog::Accepted) {
        next = given;
        const SourceParams source = dialog.source();
        const bool same = source.file == given.source.file;
        const QString words = same ? suited : suit(next, source.file);
        // Values of a world that a preset had brought are not the user's.
        const bool brought =
            !same && !words.isEmpty() && source.world_set == given.source.world_set;
        const std::string world_set = brought ? next.source.world_set : source.world_set;
        if (!same && !goes_on) next.registration.edits.clear();
        next.source = source;
        next.source.world_set = world_set;
        if (!(confirmed || guard_.may_begin(next))) continue;
        const TourSummary summary = dialog.summary().value_or(SourceInspection{}).tour;
        if (dialog.summary()) emit inspected(next.source, summary);
        const bool had = has_references();
        if (!use(next)) continue;
        if (!words.isEmpty()) own_.push_back(next);
        const QString file = QString::fromStdString(next.source.file);
        files_.note_opened("log", file);
        files_.note_recent(file);
        const QString loaded =
            tr("Source loaded: %1, %2")
                .arg(QFileInfo(file).fileName(),
                     counted_words(summary.report.scans, tr("1 scan"), tr("%1 scans")));
        emit notice(sentences({loaded, words, lost_words(had)}));
        return true;
    }
    return false;
}

/// Whether its parameters are as Hitos itself took them.
bool ConfigurationActions::is_own(const Configuracion& configuration) const {
    return std::ranges::any_of(own_, [&](Configuracion own) {
        if (own.source.world_set != configuration.source.world_set) return false;
        own.source = configuration.source;
        own.run = configuration.run;
        return differences(own, configuration).empty();
    });
}

/// What another source is decides the parameters, unless the user has chosen them; words of what
/// was taken.
QString ConfigurationActions::suit(Configuracion& next, const std::string& file) const {
    if (file == next.source.file || !is_own(next)) return {};
    try {
        Configuracion suited = suited_configuration(file);
        suited.run = next.run;
        suited.source = with_preset(next.source, suited.source);
        suited.registration.edits = next.registration.edits;
        next = suited;
        return suited_words(file);
    } catch (const Error&) {  // without the presets' files the parameters stay
        return {};
    }
}

bool ConfigurationActions::has_references() const {
    const References& references = session_.user_references();
    return references.map || references.trajectory;
}

/// Another log takes its references away.
QString ConfigurationActions::lost_words(bool had) const {
    return had && !has_references() ? tr("The references, of the former log, are removed")
                                    : QString();
}

bool ConfigurationActions::use_log(const QString& path) {
    const bool had = has_references();
    Configuracion next = session_.configuration();
    const QString suited = suit(next, path.toStdString());
    const ReadOptions former = next.source.read;
    if (next.source.file != path.toStdString()) forget_recording(next);
    next.source.file = path.toStdString();
    next.source.format = kAutoFormat;
    if (!guard_.may_begin(next)) return false;
    try {
        session_.set_configuration(next);
    } catch (const std::exception& error) {
        if (asks_for_topics(error, next.source.read)) return choose_source(next, true, suited);
        prompts_.warn(window_, tr("The log cannot be used"),
                      with_beginning(words_of(error), path.toStdString()));
        return false;
    }
    if (!suited.isEmpty()) own_.push_back(next);
    files_.note_recent(path);
    const QString otherwise =
        former == next.source.read ? QString() : tr("How the former one was read is not applied");
    emit notice(sentences({tr("Source loaded: %1").arg(QFileInfo(path).fileName()), suited,
                           otherwise, lost_words(had)}));
    return true;
}

}  // namespace hitos::window
