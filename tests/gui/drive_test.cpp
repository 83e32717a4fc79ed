// SPDX-License-Identifier: GPL-3.0-or-later
// A robot driven through a world while it is mapped.

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QStandardPaths>
#include <QToolButton>

#include "drive_fixture.hpp"
#include "hitos/services/results/kept_run.hpp"
#include "hitos/simulation/worlds/world.hpp"
#include "runs/compare_window.hpp"
#include "runs/run_list.hpp"
#include "runs/runs.hpp"
#include "tests.hpp"
#include "views/time_line.hpp"

namespace hitos::window {

void DriveTest::keys_drive_the_robot_and_the_run_follows() {
    DriveFixture f;
    WorldView& view = f.world_window().view();
    QTest::keyPress(&view, Qt::Key_Up);
    f.periods(20);
    const Pose ahead = f.drive().tour()->pose_now();
    QVERIFY(ahead.x > 0.5);
    QVERIFY(std::abs(ahead.y) < 1e-9);
    QTest::keyPress(&view, Qt::Key_A);
    f.periods(10);
    QVERIFY(f.drive().tour()->pose_now().theta > 0.1);
    QTest::keyRelease(&view, Qt::Key_A);
    QTest::keyRelease(&view, Qt::Key_Up);
    f.periods(30);
    QCOMPARE(f.drive().tour()->twist_now(), Twist{});
    QVERIFY(f.steps() > 0 || f.state() == Progress::State::running);
    QTRY_VERIFY(f.caught_up());
    QCOMPARE(f.session.references().trajectory->size(), f.drive().tour()->scans());
    QVERIFY(!f.session.snapshot()->best_map.empty());
    // Whoever looks elsewhere drives no further.
    QTest::keyPress(&view, Qt::Key_Down);
    f.window->setFocus();
    view.clearFocus();
    f.periods(5);
    QCOMPARE(f.drive().tour()->twist_now(), Twist{});
}

void DriveTest::a_click_is_where_it_drives() {
    DriveFixture f;
    f.drive().set_goal(Point2{3.0, 1.5});
    for (int k = 0; k < 600 && f.drive().goal(); ++k) f.periods(1);
    QVERIFY(!f.drive().goal());
    const Pose there = f.drive().tour()->pose_now();
    QVERIFY(std::hypot(there.x - 3.0, there.y - 1.5) < 0.15);
    // By the mouse, in the middle of the view.
    WorldView& view = f.world_window().view();
    QTest::mouseClick(&view, Qt::LeftButton, {}, view.rect().center());
    const QPointF middle = view.world_at(QRectF(view.rect()).center());
    QVERIFY(f.drive().goal());
    QVERIFY(std::hypot(f.drive().goal()->x - middle.x(), f.drive().goal()->y - middle.y()) < 0.1);
    f.drive().hold(1.0, 0.0);  // who takes the keys needs no goal
    QVERIFY(!f.drive().goal());
}

void DriveTest::a_click_leads_away_from_a_wall() {
    DriveFixture f;
    const auto told = [&] { return f.world_window().findChild<QLabel*>("drive_figures")->text(); };
    const auto pose = [&] { return f.drive().tour()->pose_now(); };
    const auto away = [&](const Point2& goal) {
        return std::hypot(pose().x - goal.x, pose().y - goal.y);
    };
    f.drive().set_goal(Point2{3.0, 1.5});  // past the door
    for (int k = 0; k < 600 && f.drive().goal(); ++k) f.periods(1);
    // Straight into the wall, askew into it, and into the corner; then anywhere.
    for (const Point2& wall : {Point2{4.99, 0.5}, Point2{5.5, 2.0}, Point2{5.5, 3.5}}) {
        for (const Point2& goal :
             {Point2{2.8, 0.5}, Point2{4.3, -1.5}, Point2{3.0, 2.4}, Point2{4.0, 2.4}}) {
            f.drive().set_goal(wall);
            for (int k = 0; k < 3000 && f.drive().barred() == 0; ++k) f.periods(1);
            QCOMPARE(f.drive().barred(), 1);
            QVERIFY2(told().contains("the Down key or S backs off"), qPrintable(told()));
            f.drive().set_goal(goal);
            for (int k = 0; k < 3000 && f.drive().goal(); ++k) f.periods(1);
            QVERIFY2(!f.drive().goal(),
                     qPrintable(QString("%1 m of %2, %3").arg(away(goal)).arg(goal.x).arg(goal.y)));
            QVERIFY(away(goal) < 0.15);
            QVERIFY(!told().contains("backs off"));
        }
    }
    // The keys free it too.
    f.drive().set_goal(Point2{5.5, pose().y});
    for (int k = 0; k < 3000 && f.drive().barred() == 0; ++k) f.periods(1);
    f.drive().hold(-1.0, 0.0);
    f.periods(20);
    QCOMPARE(f.drive().barred(), 0);
    for (int k = 0; k < 3000 && f.drive().barred() == 0; ++k) f.periods(1);
    QVERIFY2(told().contains("the Up key or W"), qPrintable(told()));
    f.drive().hold(0.0, 0.0);
    f.periods(1);
    QVERIFY(!told().contains("the Up key or W"));
}

void DriveTest::what_is_told_of_a_tour_goes_with_the_next() {
    QStandardPaths::setTestModeEnabled(true);
    DriveFixture f;
    const auto* told = f.world_window().findChild<QLabel*>("world_notice");
    auto* drive = f.world_window().findChild<QPushButton*>("world_drive");
    f.periods(static_cast<int>(6.0 * f.drive().tour()->world().robot.control_rate_hz));
    drive->click();  // back to drawing
    QVERIFY2(told->text().contains("was kept as"), qPrintable(told->text()));
    drive->click();
    QVERIFY(f.drive().active());
    QCOMPARE(told->text(), QString());
    QStandardPaths::setTestModeEnabled(false);
}

void DriveTest::the_goal_is_dragged() {
    DriveFixture f;
    WorldView& view = f.world_window().view();
    const QPoint from = view.rect().center();
    const QPoint to = from + QPoint(40, -25);
    // A press, two moves and a release, as a hand does it.
    const auto drag = [&view](const QPoint& begin, const QPoint& end) {
        QTest::mousePress(&view, Qt::LeftButton, {}, begin);
        QTest::mouseMove(&view, (begin + end) / 2);
        QTest::mouseMove(&view, end);
        QTest::mouseRelease(&view, Qt::LeftButton, {}, end);
    };
    const auto goal_is_at = [&](const QPoint& pixel) {
        const QPointF there = view.world_at(pixel);
        return f.drive().goal() &&
               std::hypot(f.drive().goal()->x - there.x(), f.drive().goal()->y - there.y()) < 1e-9;
    };
    QTest::mouseClick(&view, Qt::LeftButton, {}, from);
    const QPointF centre = view.camera().centre;
    drag(from + QPoint(3, 2), to);
    QVERIFY(goal_is_at(to));
    QCOMPARE(view.camera().centre, centre);
    f.periods(5);
    QVERIFY(f.drive().goal());  // it is on its way there
    // A click on it is a click, and elsewhere the view is dragged.
    QTest::mouseClick(&view, Qt::LeftButton, {}, to);
    QVERIFY(goal_is_at(to));
    const Point2 goal = *f.drive().goal();
    drag(to + QPoint(30, 30), to + QPoint(60, 30));
    QVERIFY(f.drive().goal()->x == goal.x && f.drive().goal()->y == goal.y);
    QVERIFY(view.camera().centre != centre);
    // Where it has arrived meanwhile, it is led on.
    view.fit();
    const QPoint middle = view.rect().center();
    QTest::mouseClick(&view, Qt::LeftButton, {}, middle);
    QTest::mousePress(&view, Qt::LeftButton, {}, middle);
    f.drive().set_goal(std::nullopt);
    QTest::mouseMove(&view, middle + QPoint(20, 0));
    QVERIFY(goal_is_at(middle + QPoint(20, 0)));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, middle + QPoint(20, 0));
}

void DriveTest::what_is_kept_is_the_same_run() {
    DriveFixture f;
    f.drive().hold(1.0, 0.2);
    f.periods(60);
    f.drive().hold(0.0, 1.0);
    f.periods(40);
    QTRY_VERIFY(f.caught_up());
    const Trajectory live_path = f.session.snapshot()->best_trajectory;
    const auto live_map = f.session.snapshot()->best_map;
    f.prompts.saves << f.path("kept.toml");
    QTest::mouseClick(f.world_window().findChild<QPushButton*>("drive_keep"), Qt::LeftButton);
    QVERIFY2(f.prompts.warnings.isEmpty(), qPrintable(f.prompts.warnings.join('\n')));
    QVERIFY(!f.drive().active());
    QTRY_VERIFY(f.state() == Progress::State::finished && f.shows_everything());
    QVERIFY(f.steps() >= live_path.size());
    // The file's comments stay, and a run of it from the beginning is the same.
    const QByteArray text = Fixture::read(f.path("kept.toml"));
    QVERIFY(text.contains("# A room with a door."));
    QVERIFY(text.contains("# all round"));
    QVERIFY(!text.contains("way_points"));
    f.session.seek(live_path.size());
    QTRY_VERIFY(f.steps() == live_path.size() && f.shows_everything());
    QVERIFY(f.session.snapshot()->best_trajectory == live_path);
    const LandmarkMap& again = f.session.snapshot()->best_map;
    QCOMPARE(again.size(), live_map.size());
    for (std::size_t i = 0; i < again.size(); ++i) {
        QVERIFY(again[i].point() == live_map[i].point());
        QVERIFY(again[i].covariance == live_map[i].covariance);
    }
}

void DriveTest::the_same_keys_give_the_same_bytes() {
    QList<QByteArray> worlds;
    QList<QByteArray> maps;
    for (int time = 0; time < 2; ++time) {
        DriveFixture f;
        WorldView& view = f.world_window().view();
        QTest::keyPress(&view, Qt::Key_Up);
        f.periods(25);
        QTest::keyPress(&view, Qt::Key_A);
        f.periods(30);
        QTest::keyRelease(&view, Qt::Key_Up);
        f.periods(10);
        QTest::keyRelease(&view, Qt::Key_A);
        f.drive().set_goal(Point2{3.0, 1.5});
        f.periods(60);
        f.drive().keep(f.path("kept.toml"));
        QTRY_VERIFY(f.state() == Progress::State::finished && f.shows_everything());
        f.prompts.saves << f.path("kept.map");
        f.trigger("action_save_map");
        worlds << Fixture::read(f.path("kept.toml"));
        maps << Fixture::read(f.path("kept.map"));
    }
    QVERIFY(!worlds[0].isEmpty() && !maps[0].isEmpty());
    QCOMPARE(worlds[0], worlds[1]);
    QCOMPARE(maps[0], maps[1]);
}

void DriveTest::the_run_may_stand_still_or_go_back_meanwhile() {
    DriveFixture f;
    f.drive().hold(0.4, 0.1);
    f.periods(40);
    QTRY_VERIFY(f.caught_up());
    QVERIFY(f.action("action_stop")->isEnabled());  // it waits for the next scan
    f.trigger("action_stop");
    const quint64 stopped = f.steps();
    f.periods(20);
    QTest::qWait(50);
    QCOMPARE(f.steps(), stopped);
    f.session.seek(3);
    QTRY_COMPARE(f.steps(), quint64{3});
    f.periods(20);
    QTest::qWait(50);
    QCOMPARE(f.steps(), quint64{3});
    f.trigger("action_step");
    QTRY_COMPARE(f.steps(), quint64{4});
    f.trigger("action_run");
    QTRY_VERIFY(f.caught_up());
    f.periods(20);
    QTRY_VERIFY(f.caught_up());
    QVERIFY(!f.action("action_save_results")->isEnabled());  // it has no file yet
}

void DriveTest::parameters_change_on_the_way() {
    DriveFixture f;
    f.drive().hold(0.5, 0.3);
    f.periods(40);
    QTRY_VERIFY(f.caught_up());
    Configuracion other = f.session.configuration();
    other.filter.particles = 17;
    f.session.set_configuration(other);
    QVERIFY(f.drive().active());
    f.periods(10);
    QTRY_VERIFY(f.caught_up());
    QCOMPARE(f.session.snapshot()->hypotheses.size(), std::size_t{17});
}

void DriveTest::what_happens_is_kept_too() {
    DriveFixture f;
    f.periods(20);
    auto* kinds = f.world_window().findChild<QComboBox*>("disturbance");
    auto* now = f.world_window().findChild<QPushButton*>("button_disturb");
    QCOMPARE(kinds->count(), static_cast<int>(kDisturbances.size()));
    for (int kind = 0; kind < kinds->count(); ++kind) {
        kinds->setCurrentIndex(kind);
        QTest::mouseClick(now, Qt::LeftButton);
        f.periods(12);
    }
    QVERIFY2(f.prompts.warnings.isEmpty(), qPrintable(f.prompts.warnings.join('\n')));
    QTRY_VERIFY(f.caught_up());
    // Each stands on the time line, at the first scan after it.
    const auto& marks = f.window->findChild<TimeLine*>()->marks();
    const auto disturbances = [&marks] {
        return static_cast<std::size_t>(
            std::ranges::count(marks, TimeLine::Mark::Kind::disturbance, &TimeLine::Mark::kind));
    };
    QTRY_COMPARE(disturbances(), kDisturbances.size());
    const auto push = std::ranges::find(marks, QString("Push the robot"), &TimeLine::Mark::text);
    QVERIFY(push != marks.end());
    QCOMPARE(push->scan, 11);  // after 2 s, with 5 scans a second
    f.drive().keep(f.path("kept.toml"));
    const World kept = read_world(f.path("kept.toml").toStdString());
    QCOMPARE(kept.tour.events.size(), kDisturbances.size());
    for (std::size_t i = 0; i < kDisturbances.size(); ++i) {
        QCOMPARE(kept.tour.events[i].kind, static_cast<DisturbanceKind>(i));
    }
    QVERIFY(kept.tour.commands.size() == 1);
}

void DriveTest::what_was_driven_is_another_tour_than_the_worlds() {
    DriveFixture f;
    f.drive().hold(0.3, 0.0);
    f.periods(20);
    QTRY_VERIFY(f.caught_up());
    f.drive().keep(f.path("kept.toml"));
    Configuracion in_the_room = Fixture::tour(10);
    in_the_room.source.file = f.path("room.toml").toStdString();
    f.session.set_configuration(in_the_room);
    f.run_steps(5);
    const RunList& list = f.window->runs().list();
    QCOMPARE(list.runs().size(), std::size_t{2});
    const ListedRun present = list.runs().front();
    const ListedRun driven = list.runs().back();
    QVERIFY(same_log(driven.run->configuration, present.run->configuration));
    QVERIFY(!same_tour(*driven.run, *present.run));
    QCOMPARE(source_words(driven), QString("room.toml, driven"));
    QCOMPARE(source_words(present), QString("room.toml"));
    QVERIFY(list.reference_of(*present.run) != nullptr);
    // It was driven elsewhere, and where that was it still knows.
    const Trajectory* truth = list.reference_of(*driven.run);
    QVERIFY(truth != nullptr && truth->size() >= driven.run->path.size());
    QVERIFY(*truth != *list.reference_of(*present.run));
    f.window->runs().compare({present, driven});
    const auto* verdict = f.window->runs().comparison()->findChild<QLabel*>("compare_verdict");
    QVERIFY2(verdict->text().contains("The logs differ: room.toml and room.toml, driven"),
             qPrintable(verdict->text()));
    QVERIFY2(verdict->text().contains("is not laid"), qPrintable(verdict->text()));
}

void DriveTest::a_tour_that_is_given_up_is_rescued() {
    DriveFixture f;
    QString rescued;
    QObject::connect(&f.drive(), &LiveDrive::rescued, &f.drive(),
                     [&](const QString& path) { rescued = path; });
    f.drive().hold(0.3, 0.0);
    f.periods(70);
    f.session.set_configuration(Fixture::tour(10));
    QVERIFY(!f.drive().active());
    QVERIFY(!rescued.isEmpty());
    const World world = read_world(rescued.toStdString());
    QCOMPARE(world.tour.commands.size(), std::size_t{1});
    QCOMPARE(world.tour.commands[0].duration_s, 7.0);
    QFile::remove(rescued);
    // What was hardly begun leaves nothing.
    rescued.clear();
    f.world_window().drive_through(f.path("room.toml"));
    f.drive().rest();
    f.periods(10);
    f.session.set_configuration(Fixture::tour(10));
    QVERIFY(rescued.isEmpty());
}

void DriveTest::a_tour_that_ends_with_the_program_is_rescued() {
    QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/driven");
    const QStringList before = folder.entryList(QDir::Files);
    DriveFixture f;
    f.drive().hold(0.3, 0.0);
    f.periods(70);
    f.window.reset();
    folder.refresh();
    const QStringList after = folder.entryList(QDir::Files);
    QCOMPARE(after.size(), before.size() + 1);
    for (const QString& file : after) {
        if (!before.contains(file)) QVERIFY(folder.remove(file));
    }
}

void DriveTest::bad_worlds_leave_what_was_there() {
    DriveFixture f;
    f.periods(20);
    QTRY_VERIFY(f.caught_up());
    const auto tour = f.drive().tour();
    for (const char* text : {"walls = 3\n",
                             "walls = [[[0.1, -1], [0.1, 1]]]\n[tour]\n"
                             "commands = [[0, 0, 1]]\n"}) {  // and on the robot
        f.prompts.warnings.clear();
        f.world_window().drive_through(f.write("bad.toml", text));
        QCOMPARE(f.prompts.warnings.size(), 1);
        QVERIFY(f.prompts.warnings[0].contains("bad.toml"));
        QVERIFY(f.drive().tour() == tour);
    }
    // A disturbance that cannot be.
    Disturbance box;
    box.kind = DisturbanceKind::open;
    box.values = {7.0, 0.0, 0.0};
    QVERIFY_THROWS_EXCEPTION(std::exception, f.drive().disturb(box));
    f.periods(5);
    QTRY_VERIFY(f.caught_up());
    // Where it cannot be written, or would be no world, it goes on.
    f.prompts.saves << f.path("no-such-folder/kept.toml") << f.path("kept.txt");
    QTest::mouseClick(f.world_window().findChild<QPushButton*>("drive_keep"), Qt::LeftButton);
    QVERIFY(f.drive().tour() == tour);
    QVERIFY(f.session.is_live());
    QVERIFY(!QFile::exists(f.path("kept.txt")));
}

void DriveTest::a_world_that_is_gone_loses_nothing() {
    DriveFixture f;
    f.drive().hold(0.3, 0.0);
    f.periods(20);
    QVERIFY(QFile::remove(f.path("room.toml")));
    f.periods(20);
    QTRY_VERIFY(f.caught_up());
    const World before = f.drive().tour()->recorded();
    f.drive().keep(f.path("kept.toml"));
    const World kept = read_world(f.path("kept.toml").toStdString());
    QCOMPARE(kept.walls.size(), before.walls.size());
    QCOMPARE(kept.doors.size(), before.doors.size());
    QCOMPARE(kept.tour.commands.size(), before.tour.commands.size());
    const QByteArray text = Fixture::read(f.path("kept.toml"));
    QVERIFY(text.contains("# A room with a door."));
    QVERIFY(text.contains("# all round"));
    QTRY_VERIFY(f.state() == Progress::State::finished);
}

void DriveTest::a_drawing_that_is_elsewhere_loses_nothing() {
    DriveFixture f;
    f.drive().give_up();
    f.write("plan.dxf",
            "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n-1\n20\n-1\n30\n0\n11\n4\n21\n-1\n31\n0\n"
            "0\nENDSEC\n0\nEOF\n");
    f.world_window().drive_through(f.write(
        "drawn.toml", "# Drawn.\nwalls_dxf = \"plan.dxf\"\n[tour]\nway_points = [[1, 0]]\n"));
    f.drive().rest();
    QVERIFY2(f.drive().active(), qPrintable(f.prompts.warnings.join('\n')));
    const std::vector<WallSegment> walls = f.drive().tour()->world().walls;
    f.drive().hold(0.3, 0.0);
    f.periods(20);
    QDir(f.folder.path()).mkdir("elsewhere");
    const QString kept = f.path("elsewhere/kept.toml");
    f.drive().keep(kept);
    const World world = read_world(kept.toStdString());
    QCOMPARE(world.walls.size(), walls.size());
    QVERIFY(world.walls[0].a == walls[0].a && world.walls[0].b == walls[0].b);
    QCOMPARE(world.tour.commands.size(), std::size_t{1});
    QTRY_VERIFY(f.state() == Progress::State::finished);
}

}  // namespace hitos::window
