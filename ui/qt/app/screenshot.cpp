// SPDX-License-Identifier: GPL-3.0-or-later
#include "screenshot.hpp"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QPixmap>
#include <QPointer>
#include <QTimer>
#include <functional>

#include "inspect/association_inspector.hpp"
#include "inspect/graph_window.hpp"
#include "look/screen_fit.hpp"
#include "main_window.hpp"
#include "views/picture.hpp"
#include "views/scan_view.hpp"
#include "workers/log_counter.hpp"

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
    if (const QPointer graph = window.findChild<GraphWindow*>()) {
        process_until([&graph] { return !graph || !graph->busy(); });
        if (graph && graph->shown()) write_picture_of(*graph, line);
        return;
    }
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
    for (std::uint64_t piece = 1; piece <= pieces; ++piece)
        run_steps(session, line.steps * piece / pieces - line.steps * (piece - 1) / pieces);
    if (line.show == "associations") {
        show_associations(window, session, line);
    } else {
        write_picture_of(window, line);
    }
}

}  // namespace hitos::window
