// SPDX-License-Identifier: GPL-3.0-or-later
// The window saves what comes of a run, a drawn world or the log of a driven tour, for those who
// have its files fail and who kill it (tests/faults/use).
#include <QPushButton>
#include <QTextStream>
#include <exception>

#include "drive_fixture.hpp"
#include "tests.hpp"

namespace hitos::window {
namespace {

struct Order {
    QString from;
    unsigned seed = 0;
    QString to;
};

/// Until the notice has all of `words`, or the window warns; it may be done before it is told.
bool wait_for(Fixture& f, const QString& words) {
    return QTest::qWaitFor(
        [&] { return f.notice().contains(words) || !f.prompts.warnings.isEmpty(); }, kPatienceMs);
}

/// The results of a run along the log `from`, into a folder.
bool save_results(Fixture& f, const Order& order) {
    Configuracion configuration = Fixture::tour(2);
    configuration.source.file = order.from.toStdString();
    configuration.run.seed = order.seed;
    configuration.run.threads = 1;
    configuration.grid.resolution_m = 0.5;
    f.session.set_configuration(configuration);
    f.session.run();
    const bool ended =
        QTest::qWaitFor([&f] { return f.state() != Progress::State::running; }, kPatienceMs);
    if (!ended || f.state() != Progress::State::finished) {
        f.prompts.warnings << "the run has not come to its end";
        return false;
    }
    QAction* const save = f.action("action_save_results");
    if (!QTest::qWaitFor([save] { return save->isEnabled(); }, kPatienceMs)) return false;
    save->trigger();
    return wait_for(f, "saved");
}

/// The world `from` with a longer way, into another file.
bool save_world(Fixture& f, const Order& order) {
    WorldWindow& window = f.window->open_world_window();
    if (!window.world_files().open(order.from)) return false;
    const bool drawn = window.draft().change([&order](WorldText& text) {
        std::vector<Point2> way;
        for (const WayPoint& point : text.world().tour.way_points) way.push_back(point.at);
        way.push_back({0.1 * order.seed, 0.5});
        text.set_way_points(way);
    });
    window.findChild<QAction*>("world_save_as")->trigger();
    return drawn && !window.draft().modified();
}

/// A tour driven through the world `from`, as a log with its true path.
bool save_log(Fixture& f, const Order& order) {
    WorldWindow& window = f.window->open_world_window();
    window.drive_through(order.from);
    LiveDrive& drive = window.drive();
    drive.rest();
    drive.hold(0.3, 0.1 * order.seed);
    for (int period = 0; period < 20; ++period) drive.drive_period();
    window.findChild<QPushButton*>("drive_log")->click();
    const bool told = wait_for(f, order.to);
    drive.give_up();
    return told;
}

}  // namespace

/// {results|world|log} FROM SEED TO; the status is 1 where the window warns of something.
int save_as_told(const QStringList& arguments) {
    QTextStream said(stdout);
    Fixture f(false);
    const Order order{arguments.value(1), arguments.value(2).toUInt(), arguments.value(3)};
    f.prompts.saves = {order.to};
    f.prompts.confirms = {true, true};  // it may write over what is there
    bool saved = false;
    try {
        const QString what = arguments.value(0);
        saved = what == "world" ? save_world(f, order)
                : what == "log" ? save_log(f, order)
                                : save_results(f, order);
    } catch (const std::exception& error) {
        f.prompts.warnings << error.what();
    }
    said << f.notice() << '\n' << f.prompts.warnings.join('\n');
    return saved && f.prompts.warnings.isEmpty() ? 0 : 1;
}

}  // namespace hitos::window
