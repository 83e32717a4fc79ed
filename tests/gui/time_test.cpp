// SPDX-License-Identifier: GPL-3.0-or-later
// Time as a control: the time line, the pace, and running until something happens.

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHelpEvent>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QToolButton>
#include <QToolTip>
#include <iterator>
#include <set>

#include "actions/configuration_actions.hpp"
#include "actions/pace_control.hpp"
#include "dialogs/run_until_dialog.hpp"
#include "gui_fixture.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "tests.hpp"
#include "views/plots.hpp"
#include "views/time_line.hpp"
#include "workers/log_counter.hpp"

namespace hitos::window {
namespace {

using State = Progress::State;

template <class Widget>
Widget& child(const QObject& parent, const char* name) {
    auto* found = parent.findChild<Widget*>(name);
    if (found == nullptr) qFatal("no widget %s", name);
    return *found;
}

/// Opens "run until", ticks these lines and runs.
void run_until(Fixture& f, const std::vector<std::pair<const char*, double>>& lines) {
    in_dialog<RunUntilDialog>([lines](RunUntilDialog& dialog) {
        for (auto* box : dialog.findChildren<QCheckBox*>()) box->setChecked(false);
        for (const auto& [name, value] : lines) {
            child<QCheckBox>(dialog, qPrintable(QString("until_") + name)).setChecked(true);
            auto* box = dialog.findChild<QAbstractSpinBox*>(QString("value_") + name);
            if (box != nullptr) box->setProperty("value", value);
        }
        child<QPushButton>(dialog, "run_until_run").click();
    });
    f.trigger("action_run_until");
    QTRY_VERIFY(f.state() != State::running && f.shows_everything());
}

}  // namespace

void TimeTest::the_time_line_goes_to_any_scan() {
    Fixture f;
    auto* line = f.window->findChild<TimeLine*>("time_line");
    QTRY_VERIFY(line->maximum() > 100);  // the whole log is counted
    const auto shown_at = [&f](int scan) {
        return f.state() == State::paused && f.steps() == static_cast<quint64>(scan) &&
               f.shows_everything();
    };
    const auto click = [&](int scan) {
        QTest::mouseClick(line, Qt::LeftButton, {}, QPoint(line->x_of(scan), line->height() / 2));
        return line->scan_at(line->x_of(scan));
    };
    const int there = click(60);
    QTRY_VERIFY(shown_at(there));
    QTRY_COMPARE(line->value(), there);
    const Trajectory path = f.session.snapshot()->best_trajectory;
    const int further = click(90);
    QTRY_VERIFY(shown_at(further));
    // Back to where it was: the same state.
    QCOMPARE(click(60), there);
    QTRY_VERIFY(shown_at(there));
    QVERIFY(f.session.snapshot()->best_trajectory == path);
    // A drag ends where it ends, from the end of the tour too.
    f.run_to_end();
    const int x = line->x_of(30);
    QTest::mousePress(line, Qt::LeftButton, {}, QPoint(line->x_of(80), 5));
    for (int at = line->x_of(80); at >= x; --at) {
        QMouseEvent move(QEvent::MouseMove, QPointF(at, 5), line->mapToGlobal(QPointF(at, 5)),
                         Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(line, &move);
    }
    QTest::mouseRelease(line, Qt::LeftButton, {}, QPoint(x, 5));
    QTRY_VERIFY(shown_at(line->scan_at(x)));
    f.trigger("action_run");
    QTRY_COMPARE(f.state(), State::finished);
}

void TimeTest::the_time_line_goes_by_keys() {
    Fixture f;
    auto* line = f.window->findChild<TimeLine*>("time_line");
    QTRY_VERIFY(line->maximum() > 100);
    line->setFocus();
    const auto press = [&](Qt::Key key, Qt::KeyboardModifiers with, quint64 scan) {
        QTest::keyClick(line, key, with);
        QTRY_VERIFY(f.state() == State::paused && f.steps() == scan);
        QTRY_COMPARE(line->value(), static_cast<int>(scan));
    };
    press(Qt::Key_Right, {}, 1);
    press(Qt::Key_Right, Qt::ShiftModifier, 11);
    press(Qt::Key_Right, {}, 12);
    press(Qt::Key_Left, {}, 11);
    press(Qt::Key_Left, Qt::ShiftModifier, 1);
    press(Qt::Key_Left, {}, 1);
    // To the end is to where the path is smoothed, not to the scan before.
    QTest::keyClick(line, Qt::Key_End);
    QTRY_VERIFY(f.state() == State::finished && f.shows_everything());
    QCOMPARE(line->value(), line->maximum());
    const Trajectory path = f.session.snapshot()->best_trajectory;
    press(Qt::Key_Left, {}, static_cast<quint64>(line->maximum()) - 1);
    QTest::keyClick(line, Qt::Key_Right);
    QTRY_VERIFY(f.state() == State::finished && f.shows_everything());
    QVERIFY(f.session.snapshot()->best_trajectory == path);
    press(Qt::Key_Home, {}, 1);
    // Faster than the run: every press counts.
    for (int i = 0; i < 20; ++i) QTest::keyClick(line, Qt::Key_Right);
    QTRY_VERIFY2(f.state() == State::paused && f.steps() == 21,
                 qPrintable(QString::number(f.steps())));
    // Stopped on the way to the end, keys go on from where it stopped.
    QTest::keyClick(line, Qt::Key_End);
    f.session.pause();
    QTRY_VERIFY(f.state() != State::running && line->value() == static_cast<int>(f.steps()));
    const quint64 stopped = f.steps();
    press(Qt::Key_Left, {}, std::max<quint64>(stopped, 2) - 1);
    press(Qt::Key_Home, {}, 1);
    press(Qt::Key_Right, Qt::ShiftModifier, 11);
    press(Qt::Key_Right, Qt::ShiftModifier, 21);
    // The space bar runs and stops as elsewhere.
    QTRY_VERIFY(f.action("action_run")->isEnabled());
    QTest::keyClick(line, Qt::Key_Space);
    QTRY_VERIFY(f.steps() > 21);
}

void TimeTest::keys_go_from_event_to_event() {
    Fixture f;
    auto* line = f.window->findChild<TimeLine*>("time_line");
    QVERIFY(!f.action("action_previous_event")->isEnabled());
    f.run_to_end();
    QVERIFY(!f.action("action_next_event")->isEnabled());
    std::set<int> events;
    for (const TimeLine::Mark& mark : line->marks())
        if (mark.kind != TimeLine::Mark::Kind::filter) events.insert(mark.scan);
    QVERIFY(events.size() > 3);
    const auto there = [&f](int scan) {
        return f.state() == State::paused && f.steps() == static_cast<quint64>(scan) &&
               f.shows_everything();
    };
    auto event = events.rbegin();
    if (*event == static_cast<int>(f.steps())) ++event;
    f.trigger("action_previous_event");
    QTRY_VERIFY(there(*event));
    // By keys, also where the line has the keyboard; pressed twice it goes two further.
    const int second = *std::next(event, 2);
    line->setFocus();
    QTest::keyClick(f.window.get(), Qt::Key_Left, Qt::ControlModifier);
    QTest::keyClick(line, Qt::Key_Left, Qt::ControlModifier);
    QTRY_VERIFY(there(second));
    f.trigger("action_next_event");
    QTRY_VERIFY(there(*std::next(event)));
}

void TimeTest::the_time_line_tells_what_happened() {
    Fixture f;
    auto* line = f.window->findChild<TimeLine*>("time_line");
    f.run_to_end();
    QTRY_VERIFY(!line->marks().empty());
    const auto marks = line->marks().size();
    const std::vector<StepFigures> figures = f.session.worker()->figures_since(0);
    const auto told = [line](const QString& words) {
        QList<int> scans;
        for (const TimeLine::Mark& mark : line->marks()) {
            if (mark.text.startsWith(words)) scans << mark.scan;
        }
        return scans;
    };
    const auto happened = [&figures](const auto& what) {
        QList<int> scans;
        for (std::size_t i = 0; i < figures.size(); ++i) {
            if (what(figures[i])) scans << static_cast<int>(i) + 1;
        }
        return scans;
    };
    const QList<int> born = happened([](const StepFigures& step) { return step.created > 0; });
    QVERIFY(!born.isEmpty());
    QCOMPARE(told("new landmarks"), born);
    QCOMPARE(told("another particle"),
             happened([](const StepFigures& step) { return step.best_changed; }));
    QCOMPARE(told("a landmark seen again").isEmpty(), false);
    const QPoint place(line->x_of(born.back()), line->height() / 2);
    QHelpEvent asked(QEvent::ToolTip, place, line->mapToGlobal(place));
    QApplication::sendEvent(line, &asked);
    QVERIFY2(QToolTip::text().contains("new landmarks"), qPrintable(QToolTip::text()));
    QTest::keyClick(line, Qt::Key_Home);
    QTRY_VERIFY(f.state() == State::paused && f.steps() == 1);
    QCOMPARE(line->marks().size(), marks);  // what is known stays known
    f.trigger("action_restart");
    QTRY_VERIFY(line->marks().empty());
    QCOMPARE(line->value(), 0);
}

void TimeTest::at_a_first_start_one_sees_what_happens() {
    Fixture f;
    f.files.settings().clear();
    MainWindow first(f.session, f.files, f.prompts);
    QCOMPARE(f.session.pace(), (Pace{Pace::Kind::recorded, 10.0}));  // 210 s in 21
    auto& full = child<QAction>(first, "action_full_speed");
    QVERIFY(!full.isChecked());
    full.trigger();
    QCOMPARE(f.session.pace(), Pace{});
    auto& paces = child<QComboBox>(first, "pace");
    QCOMPARE(paces.currentText(), QString("maximum"));
    const MainWindow second(f.session, f.files, f.prompts);
    QCOMPARE(f.session.pace(), Pace{});  // it is remembered
}

void TimeTest::the_pace_suits_the_tour_until_one_is_chosen() {
    Fixture f(false);
    f.window.reset();  // whose pace would be the session's too
    f.files.settings().clear();
    MainWindow first(f.session, f.files, f.prompts);
    auto& paces = child<QComboBox>(first, "pace");
    const auto log = [&](int seconds) {
        const QString text =
            QString("ODOM 0 0 0\nLASER 0 2 1 0 1 1\nODOM %1 0.1 0\nLASER %1 2 1 0 1 1\n");
        return f.write(QString("%1.txt").arg(seconds), text.arg(seconds).toUtf8());
    };
    const auto pace_of = [&](int seconds) {
        if (!first.configuration_actions().open(log(seconds))) return QString("not opened");
        (void)QTest::qWaitFor([&] { return !first.findChild<LogCounter*>()->busy(); }, kPatienceMs);
        return paces.currentText();
    };
    QCOMPARE(pace_of(29), QString("recorded × 1"));
    QCOMPARE(pace_of(290), QString("recorded × 10"));
    QCOMPARE(f.session.pace(), (Pace{Pace::Kind::recorded, 10.0}));
    QCOMPARE(pace_of(4000), QString("recorded × 250"));
    QCOMPARE(pace_of(90'000), QString("recorded × 1000"));
    child<QAction>(first, "action_full_speed").trigger();
    QCOMPARE(paces.currentText(), QString("maximum"));
    child<QAction>(first, "action_full_speed").trigger();
    QCOMPARE(paces.currentText(), QString("recorded × 1000"));
    const int chosen = paces.findText("recorded × 2");
    paces.setCurrentIndex(chosen);
    emit paces.activated(chosen);
    QCOMPARE(pace_of(300), QString("recorded × 2"));
}

void TimeTest::the_pace_is_chosen_and_changed_while_running() {
    Fixture f;
    auto& paces = child<QComboBox>(*f.window, "pace");
    auto& full = child<QAction>(*f.window, "action_full_speed");
    const int slowest = paces.findText("1 scans/s");
    QVERIFY(slowest >= 0);
    paces.setCurrentIndex(slowest);
    emit paces.activated(slowest);
    QVERIFY(!full.isChecked());
    QCOMPARE(f.session.pace(), (Pace{Pace::Kind::scans, 1.0}));
    f.trigger("action_run");
    QTRY_VERIFY(f.steps() >= 1);
    QCOMPARE(f.state(), State::running);
    // While it waits for the next scan it stops at once, and all is shown.
    f.trigger("action_stop");
    QTRY_VERIFY(f.state() == State::paused && f.shows_everything());
    QVERIFY(f.steps() < 1050);
    f.trigger("action_run");
    QTest::keyClick(f.window.get(), Qt::Key_Space, Qt::ControlModifier);
    QVERIFY(full.isChecked());
    QTRY_COMPARE(f.state(), State::finished);
    // Another log is run at the same pace.
    full.trigger();
    f.session.set_configuration(Fixture::tour(10));
    QCOMPARE(f.session.pace(), (Pace{Pace::Kind::scans, 1.0}));
}

void TimeTest::at_the_end_run_until_says_so() {
    Fixture f;
    f.run_to_end();
    in_dialog<RunUntilDialog>([](RunUntilDialog& dialog) {
        for (auto* box : dialog.findChildren<QCheckBox*>()) box->setChecked(false);
        child<QCheckBox>(dialog, "until_born").setChecked(true);
        child<QPushButton>(dialog, "run_until_run").click();
        QVERIFY(dialog.isVisible());
        QVERIFY(child<QLabel>(dialog, "hint").text().startsWith("The tour is over"));
        dialog.reject();
    });
    f.trigger("action_run_until");
    run_until(f, {{"to_scan", 40}});
    QCOMPARE(f.steps(), 40U);
}

void TimeTest::it_runs_so_far_and_back() {
    Fixture f;
    run_until(f, {{"more", 25}});
    QCOMPARE(f.steps(), 25U);
    run_until(f, {{"to_scan", 60}});
    QCOMPARE(f.steps(), 60U);
    run_until(f, {{"to_scan", 40}});
    QCOMPARE(f.steps(), 40U);
    run_until(f, {{"to_time", 16.0}});  // five scans a second
    QCOMPARE(f.steps(), 81U);
    run_until(f, {{"to_time", 10.0}});
    QCOMPARE(f.steps(), 51U);
    run_until(f, {{"more", 5}, {"to_scan", 90}});
    QCOMPARE(f.steps(), 56U);
}

void TimeTest::it_runs_until_something_happens() {
    Fixture f;
    run_until(f, {{"born", 0}});
    QCOMPARE(f.steps(), 1U);
    QTRY_VERIFY2(f.notice().contains("landmark was born"), qPrintable(f.notice()));
    run_until(f, {{"again", 20.0}});
    QCOMPARE(f.state(), State::paused);
    const std::vector<StepFigures> figures = f.session.worker()->figures_since(0);
    QCOMPARE(figures.size(), f.steps());
    QVERIFY(figures.back().unseen_s >= 20.0);
    QVERIFY(figures[figures.size() - 2].unseen_s < 20.0);
    QTRY_VERIFY2(f.notice().contains("seen again"), qPrintable(f.notice()));
    run_until(f, {{"neff", 1e6}});
    QCOMPARE(f.steps(), figures.size() + 1);
    QTRY_VERIFY2(f.notice().contains("Neff"), qPrintable(f.notice()));
}

void TimeTest::it_runs_until_the_error_is_too_great() {
    Fixture f;
    in_dialog<RunUntilDialog>([](RunUntilDialog& dialog) {
        QVERIFY(!child<QCheckBox>(dialog, "until_error").isEnabled());
        dialog.reject();
    });
    f.trigger("action_run_until");
    References references;
    references.trajectory.emplace();
    Algoritmo run(Fixture::tour(10), open_tour(Fixture::tour(10)));
    for (int i = 0; i < 60 && run.step(); ++i) {
        StampedPose there = run.online_trajectory().back();
        if (i >= 44) there.pose.y += 2.0;
        references.trajectory->push_back(there);
    }
    f.session.set_references(references);
    run_until(f, {{"error", 0.5}});
    QCOMPARE(f.steps(), 45U);
    QTRY_VERIFY2(f.notice().contains("position error"), qPrintable(f.notice()));
    f.trigger("action_plots_dock");
    QTRY_COMPARE(f.window->plots().points(Plots::position_error), 45);
}

}  // namespace hitos::window
