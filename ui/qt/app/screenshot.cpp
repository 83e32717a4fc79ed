#include "screenshot.hpp"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFileInfo>
#include <QPixmap>
#include <QSettings>
#include <QTemporaryDir>
#include <QTimer>
#include <functional>
#include <memory>

#include "actions/result_actions.hpp"
#include "dialogs/configuration_dialog.hpp"
#include "dialogs/export_dialog.hpp"
#include "dialogs/run_until_dialog.hpp"
#include "dialogs/source_dialog.hpp"
#include "dialogs/study_dialog.hpp"
#include "hitos/base/error.hpp"
#include "inspect/association_inspector.hpp"
#include "look/screen_fit.hpp"
#include "main_window.hpp"
#include "runs/runs.hpp"
#include "views/map_window.hpp"
#include "views/picture.hpp"
#include "views/scan_view.hpp"
#include "workers/log_counter.hpp"
#include "world/check_line.hpp"
#include "world/live_drive.hpp"
#include "world/world_window.hpp"

namespace hitos::window {
namespace {

void process_until(const std::function<bool()>& done) {
    constexpr int kStepMs = 10;
    while (!done()) {
        QEventLoop loop;
        QTimer::singleShot(kStepMs, &loop, &QEventLoop::quit);
        loop.exec();
    }
}

void settle(int milliseconds) {
    QElapsedTimer clock;
    clock.start();
    process_until([&] { return clock.elapsed() >= milliseconds; });
}

void run_steps(Session& session, std::uint64_t steps) {
    if (steps == 0) return;
    session.run_steps(steps);
    process_until([&] {
        const Progress p = session.progress();
        const bool idle = p.state != Progress::State::running;
        return idle && (p.steps == 0 || session.up_to_date());
    });
    constexpr int kMeasureMs = 700;  // the errors against a reference come a little later
    settle(session.references().map || session.references().trajectory ? kMeasureMs : 100);
}

void write_picture_of(QWidget& widget, const CommandLine& line) {
    apply_size(widget, line.size);
    QApplication::processEvents();  // what scrolls now has its bar
    write_image(widget.grab().toImage(), QString::fromStdString(line.screenshot));
}

void show_map(MapWindow* map, const CommandLine& line) {
    process_until([map] { return !map->builder().state().running; });
    settle(100);
    write_picture_of(*map, line);
}

void show_study(MainWindow& window, const CommandLine& line) {
    const QTemporaryDir scratch;
    StudyDialog& study = window.open_study();
    study.form().set_assignments(line.vary);
    study.form().set_runs(line.study_runs);
    const QString folder = line.study_folder.empty() ? scratch.filePath("study")
                                                     : QString::fromStdString(line.study_folder);
    if (QFileInfo::exists(folder)) {  // there is nobody to ask
        throw FileError(folder.toStdString(),
                        verbatim("exists already; a picture takes a new folder"));
    }
    study.form().set_folder(folder);
    if (!line.vary.empty()) study.start();
    process_until([&study] { return !study.running(); });
    settle(100);
    write_picture_of(study, line);
}

/// Along the way points of the world, goal by goal, until so many scans were made.
void show_drive(MainWindow& window, const Session& session, const CommandLine& line) {
    const std::string file = session.configuration().source.file;
    const std::vector<WayPoint> way = read_world(file).tour.way_points;
    WorldWindow& world = window.open_world_window();
    world.drive_through(QString::fromStdString(file));
    LiveDrive& drive = world.drive();
    if (!drive.active()) return;  // it has said why
    drive.rest();
    for (auto next = way.begin(); drive.tour()->scans() < line.steps;) {
        if (!drive.goal() && next == way.end()) break;
        if (!drive.goal()) drive.set_goal((next++)->at);
        drive.drive_period();
    }
    process_until(
        [&] { return session.progress().steps == drive.tour()->scans() && session.up_to_date(); });
    settle(100);
    write_picture_of(world, line);
    drive.give_up();
}

/// The world as it is drawn, with the verdict on it.
void show_draw(MainWindow& window, const CommandLine& line) {
    WorldWindow& world = window.open_world_window();
    process_until([&world] { return world.check_line().up_to_date(); });
    settle(100);
    write_picture_of(world, line);
}

/// With its first feature, where the scan has one.
void show_associations(MainWindow& window, const Session& session, const CommandLine& line) {
    auto* inspector = window.findChild<AssociationInspector*>();
    const auto snapshot = session.snapshot();
    if (inspector != nullptr && snapshot && !snapshot->associations.empty()) {
        process_until([inspector] { return inspector->record() != nullptr; });
        inspector->choose(0);
        settle(100);
    }
    write_picture_of(window, line);
}

}  // namespace

void take_screenshot(MainWindow& window, Session& session, const CommandLine& line) {
    window.plots_dock().setVisible(line.show == "plots");
    if (line.show == "world") window.scan_view().set_robot_frame(false);
    const QString dock = QString::fromStdString("action_" + line.show + "_dock");
    if (auto* inspect = window.findChild<QAction*>(dock)) inspect->trigger();
    window.show();
    const auto* counter = window.findChild<LogCounter*>();
    process_until([counter] { return !counter->busy(); });
    settle(100);
    // The errors are measured beside the run: for their curves it must not be over at once.
    const std::uint64_t pieces = line.show == "plots" && line.steps > 0 ? 15 : 1;
    for (std::uint64_t piece = 1; piece <= pieces && line.show != "drive"; ++piece)
        run_steps(session, line.steps * piece / pieces - line.steps * (piece - 1) / pieces);
    QtPrompts prompts;
    if (line.show == "source") {
        SourceDialog dialog(session.configuration().source, prompts, {}, &window);
        bool checked = false;
        QObject::connect(&dialog, &SourceDialog::checked, &dialog, [&] { checked = true; });
        dialog.show();
        process_until([&] { return checked; });
        settle(100);
        write_picture_of(dialog, line);
    } else if (line.show == "configuration") {
        ConfigurationDialog dialog(session.configuration(), &window);
        dialog.show();
        settle(100);
        write_picture_of(dialog, line);
    } else if (line.show == "run-until" || line.show == "export") {
        const QTemporaryDir scratch;
        QSettings untouched(scratch.filePath("settings.ini"), QSettings::IniFormat);
        std::unique_ptr<QDialog> shown;
        if (line.show == "export") {
            shown =
                std::make_unique<ExportDialog>(window.grid_view().exportable(), untouched, &window);
        } else {
            shown = std::make_unique<RunUntilDialog>(session, untouched, &window);
        }
        QDialog& dialog = *shown;
        dialog.show();
        settle(100);
        write_picture_of(dialog, line);
    } else if (line.show == "guide") {
        window.findChild<QAction*>("action_guide")->trigger();
        auto* guide = window.findChild<QDialog*>("guide_window");
        if (guide != nullptr) write_picture_of(*guide, line);  // else it has said why
    } else if (line.show == "best-map") {
        window.result_actions().view_best();
        show_map(window.result_actions().best_window(), line);
    } else if (line.show == "odometry") {
        window.result_actions().view_odometry();
        show_map(window.result_actions().odometry_window(), line);
    } else if (line.show == "compare" || line.show == "compare-figures") {
        if (window.runs().comparison() == nullptr) window.runs().compare({});
        CompareWindow& comparison = *window.runs().comparison();
        comparison.show_figures(line.show == "compare-figures");
        process_until([&comparison] { return !comparison.building(); });
        settle(100);
        write_picture_of(comparison, line);
    } else if (line.show == "study") {
        show_study(window, line);
    } else if (line.show == "draw") {
        show_draw(window, line);
    } else if (line.show == "drive") {
        show_drive(window, session, line);
    } else if (line.show == "associations") {
        show_associations(window, session, line);
    } else {
        write_picture_of(window, line);
    }
}

}  // namespace hitos::window
