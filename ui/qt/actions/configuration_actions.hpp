// SPDX-License-Identifier: GPL-3.0-or-later
// The use cases that change what is run: source, configuration files, form, default [T 8.2.2.1-5].
#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "hitos/capture/tour_summary.hpp"
#include "hitos/services/files/reference_files.hpp"
#include "look/prompts.hpp"
#include "look/user_files.hpp"
#include "session/run_guard.hpp"
#include "session/session.hpp"

class QWidget;

namespace hitos::window {

struct CommandLine;

/// Whether a change from one to the other is none: nothing for undo.
bool same_configuration(const Configuracion& a, const Configuracion& b);
/// The source as it is, but for what a preset brings of one.
SourceParams with_preset(const SourceParams& source, const SourceParams& preset);
/// Those that are not empty, in one line.
QString sentences(QStringList parts);

class ConfigurationActions final : public QObject {
    Q_OBJECT

  public:
    ConfigurationActions(Session& session, UserFiles& files, Prompts& prompts,
                         const RunGuard& guard, QWidget* window);

    /// Takes what the command line and the user's files ask for. Throws hitos::Error.
    void start(const CommandLine& line);
    /// The same for somebody who looks: what is not possible is left out, and told as soon as the
    /// window answers.
    void start_or_warn(const CommandLine& line);
    /// Opens what the user named or dropped. False where that was not possible, which the user was
    /// told, or where the user would not lose the run.
    /// An empty path is nothing to open.
    bool open(const QString& path, bool confirmed = false);

    /// Each of several: configurations, then logs, then the references to compare with.
    void open_all(QStringList paths);

    void select_source();
    /// The tour that comes in, which is read as `source` says, and runs at once. False where that
    /// is not possible, which the user was told.
    bool map_incoming(const SourceParams& source, std::shared_ptr<IncomingTour> tour);
    /// With the map of a run that was saved.
    void go_on();
    void configure();
    void configure_group(ParameterGroup group);
    void load();
    /// The configuration that comes with Hitos under that word; the source stays.
    void use_preset(std::string_view word, bool confirmed = false);
    /// That of another run. False as open().
    bool use_again(const Configuracion& configuration);
    /// The same, and runs to the end at once; threads as the user has them.
    void look_at_run(Configuracion configuration);
    /// Other changes by hand of the graph; the run goes to where it was.
    void use_edits(const std::string& edits);
    void save();
    /// A configuration of the user's own, among the presets from then on.
    void save_preset();
    /// To the configuration before the last change, with its log, and forwards again.
    void undo();
    void redo();
    /// What they would set: "Particles 10"; empty where there is nothing.
    QString undo_words() const;
    QString redo_words() const;
    void set_default();
    void load_reference_map();
    void load_reference_trajectory();
    void remove_references();
    bool has_references() const;

  signals:
    void notice(QString text);
    /// What a source holds that is about to be used.
    void inspected(const SourceParams& source, const TourSummary& tour);
    /// A folder of results is among what was opened.
    void results_named(QString folder);
    /// Likewise a graph of poses.
    void graph_named(QString path);
    /// What can be undone or redone is another.
    void history_changed();

  private:
    void note_change();
    void go_to(std::vector<Configuracion>& there, std::vector<Configuracion>& back,
               const QString& words);
    void save_as(const QString& start, const QString& title);
    bool load_file(const QString& path, bool confirmed);
    bool use_log(const QString& path);
    QString lost_words(bool had) const;
    bool is_own(const Configuracion& configuration) const;
    QString suit(Configuracion& next, const std::string& file) const;
    bool choose_source(Configuracion next, bool confirmed, const QString& suited = {},
                       bool goes_on = false);
    void choose_at_start(const Configuracion& configuration, const QString& suited, bool run);
    bool use_reference(const QString& path, FileKind kind);
    std::optional<Advice> take_references(const ReferenceFiles& files);
    void load_reference(FileKind kind, const QString& title, const QString& filters);
    void note_named(const CommandLine& line);
    bool use(const Configuracion& configuration);

    Session& session_;
    UserFiles& files_;
    Prompts& prompts_;
    const RunGuard& guard_;
    QWidget* window_;
    std::vector<Configuracion> before_;  ///< the last at the back
    std::vector<Configuracion> after_;   ///< undone ones, the next at the back
    Configuracion now_;
    std::vector<Configuracion> own_;  ///< what Hitos itself took; none once the user chose
    bool in_history_ = false;         ///< undoing or redoing, which is no change
};

}  // namespace hitos::window
