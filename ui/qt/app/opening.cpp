// SPDX-License-Identifier: GPL-3.0-or-later
#include "opening.hpp"

#include <QString>

#include "actions/configuration_actions.hpp"
#include "dialogs/connect_dialog.hpp"
#include "dialogs/study_dialog.hpp"
#include "hitos/capture/live_source.hpp"
#include "look/user_files.hpp"
#include "main_window.hpp"
#include "measure/measurements.hpp"
#include "runs/runs.hpp"

namespace hitos::window {

void open_named(MainWindow& window, const CommandLine& named_line, Audience audience) {
    const bool alone = audience == Audience::nobody;
    const bool robot = !alone && is_websocket_address(named_line.open);
    CommandLine line = named_line;
    if (robot) {  // what is said of how it is read is not of the ready tour
        line.open.clear();
        line.topics = {};
    }
    ConfigurationActions& actions = window.configuration_actions();
    alone ? actions.start(line) : actions.start_or_warn(line);
    const QString named = QString::fromStdString(line.open);
    if (!named.isEmpty() && kind_of(named) == FileKind::results) window.runs().open(named);
    if (!named.isEmpty() && kind_of(named) == FileKind::graph) window.open_graph(named);
    const QString distances = QString::fromStdString(line.distances);
    if (!distances.isEmpty())
        alone ? window.measurements().open(distances) : window.open_distances(distances);
    if (named_line.open.empty() && line.config.empty()) window.offer_start();
    if (!robot) return;
    SourceParams how;
    if (!line.config.empty()) how.read = window.session().configuration().source.read;
    named_line.topics.choose(how);
    window.open_connection().connect_to(QString::fromStdString(named_line.open), how);
}

void begin(MainWindow& window, Session& session, const CommandLine& line) {
    if (!line.vary.empty()) {
        StudyForm& form = window.open_study().form();
        form.set_assignments(line.vary);
        form.set_runs(line.study_runs);
        if (!line.study_folder.empty()) form.set_folder(QString::fromStdString(line.study_folder));
    }
    if (line.run && !is_websocket_address(line.open)) session.run();
}

}  // namespace hitos::window
