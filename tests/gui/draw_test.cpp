// SPDX-License-Identifier: GPL-3.0-or-later
// Worlds drawn and changed with mouse and keys.

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>

#include "gui_fixture.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/simulation/worlds/world.hpp"
#include "hitos/simulation/worlds/world_key.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "look/parameter_text.hpp"
#include "spoken.hpp"
#include "tests.hpp"
#include "world/check_line.hpp"
#include "world/import_dialog.hpp"
#include "world/live_drive.hpp"
#include "world/world_form.hpp"
#include "world/world_view.hpp"
#include "world/world_window.hpp"

namespace hitos::window {
namespace {

/// The world window, empty, and hands that draw in it.
struct DrawFixture : Fixture {
    DrawFixture() : Fixture(false) {
        trigger("action_drive");
        world().resize(1000, 700);
        // Without a screen it takes its time with some versions of Qt.
        if (!QTest::qWaitFor([this] { return world().isActiveWindow(); }, kPatienceMs))
            qFatal("the window does not become active");
        view().setFocus();
    }
    ~DrawFixture() { world().drive().give_up(); }

    /// Opened by the constructor: to open it once more would move the keyboard.
    WorldWindow& world() { return *window->findChild<WorldWindow*>(); }
    WorldView& view() { return world().view(); }
    const WorldText& text() { return world().draft().text(); }
    QPoint pixel(double x, double y) {
        return view().camera().to_screen(view().size()).map(QPointF(x, y)).toPoint();
    }
    void press(const char* button) {
        auto* found = world().findChild<QAbstractButton*>(button);
        if (found == nullptr) qFatal("no button %s", button);
        QTest::mouseClick(found, Qt::LeftButton);
    }
    void move(double x, double y) {
        QTest::mouseMove(&view(), pixel(x, y));
        // Without a screen a move is heard of by nobody.
        QMouseEvent event(QEvent::MouseMove, pixel(x, y), view().mapToGlobal(pixel(x, y)),
                          Qt::NoButton, Qt::NoButton, Qt::NoModifier);
        QApplication::sendEvent(&view(), &event);
    }
    void click(double x, double y) { QTest::mouseClick(&view(), Qt::LeftButton, {}, pixel(x, y)); }
    void double_click(double x, double y) {
        click(x, y);
        QTest::mouseDClick(&view(), Qt::LeftButton, {}, pixel(x, y));
    }
    void drag(double x, double y, double to_x, double to_y) {
        QTest::mousePress(&view(), Qt::LeftButton, {}, pixel(x, y));
        for (const double share : {0.3, 0.7, 1.0}) {
            const QPoint at = pixel(x + share * (to_x - x), y + share * (to_y - y));
            QMouseEvent event(QEvent::MouseMove, at, view().mapToGlobal(at), Qt::NoButton,
                              Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(&view(), &event);
        }
        QTest::mouseRelease(&view(), Qt::LeftButton, {}, pixel(to_x, to_y));
    }
    void key(int key, Qt::KeyboardModifiers with = {}) {
        QTest::keyClick(&view(), Qt::Key(key), with);
    }
    /// What is typed goes where the keyboard is.
    void type(const QString& keys) {
        for (const QChar c : keys) {
            QWidget* there = world().focusWidget();
            if (c == '\t')
                QTest::keyClick(there, Qt::Key_Tab);
            else if (c == '\n')
                QTest::keyClick(there, Qt::Key_Return);
            else
                QTest::keyClick(there, c.toLatin1());
        }
    }
    void act(const char* name) {
        auto* found = world().findChild<QAction*>(name);
        if (found == nullptr) qFatal("no action %s", name);
        found->trigger();
    }
    void picture(const char* name) {
        QVERIFY(!verdict().isEmpty());
        QVERIFY(keep_picture(world(), name));
    }
    QString verdict() {
        const CheckLine& line = world().check_line();
        if (!QTest::qWaitFor([&line] { return line.up_to_date(); }, kPatienceMs)) return {};
        return line.text();
    }
    QString said() { return world().findChild<QLabel*>("world_notice")->text(); }
    bool no_warnings() {
        if (!prompts.warnings.isEmpty()) qWarning("%s", qPrintable(prompts.warnings.join('\n')));
        return prompts.warnings.isEmpty();
    }
    void draw_room() {
        press("draw_room");
        click(-1.0, -1.0);
        click(9.0, 6.0);
    }
};

bool are(const Polyline& line, const Polyline& wanted) {
    return line == wanted;
}

}  // namespace

/// The guide's walk from an empty window to a saved map ("Drawing a world"), step by step.
void DrawTest::from_an_empty_window_to_a_saved_map_data() {
    add_languages();
}

void DrawTest::from_an_empty_window_to_a_saved_map() {
    QFETCH(const QString, language);
    const Spoken spoken(language);
    DrawFixture f;
    QVERIFY(f.text().text().empty());
    QCOMPARE(f.verdict(), spoken.said("Nothing is drawn yet.").front());
    QVERIFY(!f.world().findChild<QPushButton*>("world_drive")->isEnabled());
    f.draw_room();
    QVERIFY(are(f.text().walls().at(0), {{-1, -1}, {9, -1}, {9, 6}, {-1, 6}, {-1, -1}}));
    f.press("draw_wall");  // a block in the middle, typed
    f.click(2.0, 1.5);
    f.move(4.0, 1.5);
    f.type("4\t0\n");
    f.move(6.0, 2.7);
    f.picture("draw-wall.png");
    f.type("2\t90\n");
    f.type("4\t180\n");
    f.click(2.0, 1.5);
    QCOMPARE(f.text().walls().size(), std::size_t{2});
    QVERIFY(are(f.text().walls()[1], {{2, 1.5}, {6, 1.5}, {6, 3.5}, {2, 3.5}, {2, 1.5}}));
    f.press("draw_box");
    f.click(8.0, 5.0);
    f.press("draw_start");
    f.click(0.5, 0.2);
    f.click(3.0, 0.2);
    QVERIFY(f.text().world().tour.start == (Pose{0.5, 0.2, 0.0}));
    QVERIFY2(f.verdict().contains(spoken.said("start: free").front()), qPrintable(f.verdict()));
    QVERIFY(f.verdict().contains(spoken.said("room: closed").front()));
    f.picture("draw.png");
    f.press("world_drive");
    QVERIFY(f.no_warnings());
    LiveDrive& drive = f.world().drive();
    QVERIFY(drive.active());
    drive.rest();  // the test is the clock
    QVERIFY(!f.world().findChild<QWidget*>("draw_wall")->isVisible());
    // Once round, by keys and clicks.
    QTest::keyPress(&f.view(), Qt::Key_Up);
    for (int k = 0; k < 60; ++k) drive.drive_period();
    QTest::keyRelease(&f.view(), Qt::Key_Up);
    QVERIFY(drive.tour()->pose_now().x > 2.0);
    for (const QPointF corner : {QPointF(7.5, 0.2), QPointF(7.3, 4.2), QPointF(0.4, 4.8),
                                 QPointF(0.5, 0.4), QPointF(4.0, 0.2)}) {
        f.click(corner.x(), corner.y());
        QVERIFY(drive.goal());
        for (int k = 0; k < 900 && drive.goal(); ++k) drive.drive_period();
        QVERIFY(!drive.goal());
    }
    QTRY_VERIFY(f.steps() == drive.tour()->scans() && f.shows_everything());
    f.picture("draw-driven.png");
    f.prompts.saves << f.path("drawn.toml");
    f.press("drive_keep");
    QVERIFY(f.no_warnings());
    QTRY_VERIFY(f.state() == Progress::State::finished && f.shows_everything());
    f.prompts.saves << f.path("drawn.map");
    f.trigger("action_save_map");
    QVERIFY(f.no_warnings());
    const LandmarkMap map = read_map(f.path("drawn.map").toStdString());
    int walls = 0;
    for (const ICaracteristica& landmark : map)
        walls += std::holds_alternative<Recta>(landmark.value);
    QVERIFY2(walls >= 8, qPrintable(QString::number(walls)));  // of the room and of the block
    // The drawing and the way stand in one world file, which the command line reads.
    const World kept = read_world(f.path("drawn.toml").toStdString());
    QCOMPARE(kept.walls.size(), std::size_t{8});
    QVERIFY(!kept.tour.commands.empty());
    QCOMPARE(kept.tour.events.size(), std::size_t{1});
    QVERIFY(same_world(kept, f.text().world()));
}

void DrawTest::what_is_drawn_is_saved_and_read_the_same() {
    DrawFixture f;
    f.draw_room();
    f.press("draw_door");
    f.click(9.0, 1.0);
    f.click(9.0, 2.0);
    f.press("draw_person");
    f.click(1.0, 1.0);
    f.click(4.0, 1.0);
    f.double_click(4.0, 3.0);
    f.press("draw_way_point");
    f.click(3.0, 2.0);
    f.click(7.0, 4.0);
    f.press("draw_wall");
    f.click(6.0, 6.0);
    f.double_click(6.0, 5.0);
    QVERIFY(f.no_warnings());
    const World& drawn = f.text().world();
    QCOMPARE(drawn.doors.size(), std::size_t{1});
    QVERIFY(are(f.text().walls()[0], {{9, 2}, {9, 6}, {-1, 6}, {-1, -1}, {9, -1}, {9, 1}}));
    QVERIFY(are(drawn.walkers.at(0).way, {{1, 1}, {4, 1}, {4, 3}}));
    QCOMPARE(drawn.tour.way_points.size(), std::size_t{2});
    QVERIFY2(f.verdict().contains("tour: hits no wall"), qPrintable(f.verdict()));
    QVERIFY(f.world().windowTitle().contains('*'));
    f.prompts.saves << f.path("room.toml");
    f.act("world_save");
    QVERIFY(same_world(read_world(f.path("room.toml").toStdString()), f.text().world()));
    QVERIFY(f.said().contains("room.toml"));
    QVERIFY(!f.world().windowTitle().contains('*'));
    // Its tour runs in the main window, which has the keyboard, though a late event of the
    // workshop's own may take it back.
    f.press("world_run");
    f.world().activateWindow();
    QTRY_COMPARE(QApplication::activeWindow(), f.window.get());
    QTRY_VERIFY(f.state() == Progress::State::finished && f.shows_everything());
    QVERIFY(QString::fromStdString(f.session.configuration().source.file).endsWith("room.toml"));
}

void DrawTest::shipped_worlds_keep_their_comments() {
    DrawFixture f;
    for (const std::string& name : shipped_worlds()) {
        QVERIFY(f.world().world_files().open(QString::fromStdString(find_world(name).string())));
        const std::string before = f.text().text();
        const QRectF seen(f.view().rect());
        f.press("draw_box");
        QTest::mouseClick(&f.view(), Qt::LeftButton, {}, seen.center().toPoint());
        QVERIFY2(f.text().text() != before, name.c_str());
        f.prompts.saves << f.path(QString::fromStdString(name) + ".toml");
        if (f.text().world().drawing.empty()) {
            f.act("world_save");  // what comes with Hitos is not written over: it asks where
            QVERIFY2(f.no_warnings(), name.c_str());
            const QByteArray after = Fixture::read(f.path(QString::fromStdString(name) + ".toml"));
            for (const QByteArray& line : QByteArray::fromStdString(before).split('\n')) {
                if (line.contains('#')) QVERIFY2(after.contains(line), line.constData());
            }
        }
        f.prompts.saves.clear();
        f.act("world_undo");
        QCOMPARE(f.text().text(), before);
        f.act("world_redo");
        QVERIFY(f.text().text() != before);
        f.act("world_undo");
        f.prompts.confirms = {true};  // a saved box that was undone is a change again
    }
}

void DrawTest::things_are_chosen_moved_and_taken_out() {
    DrawFixture f;
    f.draw_room();
    f.press("draw_door");
    f.click(3.0, -1.0);
    f.click(4.0, -1.0);
    f.key(Qt::Key_Escape);  // back to choosing
    QVERIFY(f.world().findChild<QToolButton*>("draw_select")->isChecked());
    f.click(3.5, -1.0);
    QVERIFY(f.world().tool().chosen());
    QCOMPARE(f.world().tool().chosen()->kind, ItemKind::door);
    f.drag(3.5, -1.0, 5.5, -1.0);
    QVERIFY(f.text().world().doors[0].a == (Point2{5, -1}));
    f.key(Qt::Key_Right, Qt::ControlModifier);
    QVERIFY(f.text().world().doors[0].b == (Point2{6.1, -1}));
    f.key(Qt::Key_Delete);
    QVERIFY(f.text().world().doors.empty());
    QVERIFY(f.text().walls()[0].front() == f.text().walls()[0].back());  // the wall is whole again
    // A corner, a piece by its numbers, all of it.
    f.drag(9.0, 6.0, 10.0, 6.5);
    QVERIFY(f.no_warnings());
    const Polyline moved = f.text().walls()[0];
    QVERIFY(std::ranges::find(moved, Point2{10, 6.5}) != moved.end());
    f.click(4.0, -1.0);
    auto* length = f.world().findChild<QLineEdit*>("drawn_number_0");
    QVERIFY(length->isVisible());
    QCOMPARE(length->text(), QString("10"));
    length->setFocus();
    length->selectAll();
    f.type("8\n");
    QVERIFY(f.no_warnings());
    const Polyline shorter = f.text().walls()[0];
    QVERIFY(std::ranges::find(shorter, Point2{7, -1}) != shorter.end() ||
            std::ranges::find(shorter, Point2{1, -1}) != shorter.end());
    f.double_click(4.0, -1.0);
    f.key(Qt::Key_Delete);
    QVERIFY(f.text().walls().empty());
    for (int step = 0; step < 20; ++step) f.act("world_undo");
    QVERIFY(f.text().text().empty());
    f.act("world_redo");
    QCOMPARE(f.text().walls().size(), std::size_t{1});
    // A key that stands twice is heard of by nobody.
    QList<QKeySequence> keys;
    for (const QAction* action : f.world().actions()) keys << action->shortcuts();
    for (const QKeySequence& shortcut : keys) QCOMPARE(keys.count(shortcut), 1);
}

void DrawTest::points_snap_and_what_cannot_be_is_told() {
    DrawFixture f;
    f.draw_room();
    f.press("draw_wall");
    f.click(2.03, 2.02);
    f.click(5.02, 2.06);  // at a right angle
    f.click(5.03, 5.97);  // onto the wall of the room
    f.key(Qt::Key_Escape);
    QVERIFY(are(f.text().walls()[1], {{2, 2}, {5, 2}, {5, 6}}));
    QTest::mouseClick(&f.view(), Qt::LeftButton, Qt::ShiftModifier, f.pixel(7.03, 2.02));
    QVERIFY(!f.world().tool().pending().empty());
    QVERIFY(f.world().tool().pending()[0] != (Point2{7, 2}));  // as it is
    f.act("world_undo");                                       // the point, not the wall before
    QVERIFY(f.world().tool().pending().empty());
    QCOMPARE(f.text().walls().size(), std::size_t{2});
    // Without a grid.
    f.world().findChild<QDoubleSpinBox*>("draw_grid")->setValue(0.0);
    f.press("draw_box");
    f.click(7.037, 2.043);
    const auto& box = f.text().world().tour.events.at(0).values;
    QVERIFY(std::abs(box[0] - 7.037) < 0.02 && box[0] != 7.0);
    // A box of no size.
    f.press("draw_select");
    f.click(box[0] + 0.25, box[1]);
    auto* side = f.world().findChild<QLineEdit*>("drawn_number_2");
    QVERIFY(side->isVisible());
    side->setFocus();
    side->selectAll();
    const std::string before = f.text().text();
    f.type("0\n");
    QCOMPARE(f.prompts.warnings.size(), 1);
    QCOMPARE(f.text().text(), before);
    QCOMPARE(side->text(), QString("0.5"));
}

void DrawTest::drawings_maps_and_pictures_are_opened() {
    DrawFixture f;
    // A picture made of a grid: a room of 4 by 3 m, walls two cells thick.
    QImage picture(110, 90, QImage::Format_Grayscale8);
    picture.fill(254);
    for (int x = 10; x < 92; ++x)
        for (const int y : {10, 11, 70, 71}) picture.setPixel(x, y, qRgb(0, 0, 0));
    for (int y = 10; y < 72; ++y)
        for (const int x : {10, 11, 90, 91}) picture.setPixel(x, y, qRgb(0, 0, 0));
    QVERIFY(picture.save(f.path("room.png")));
    in_dialog<ImportDialog>([](ImportDialog& dialog) {
        auto* pixel = dialog.findChild<QDoubleSpinBox*>("import_pixel");
        pixel->setValue(0.0);
        dialog.accept();
        QTRY_VERIFY(!dialog.findChild<QLabel*>("import_verdict")->text().contains("Looking"));
        QVERIFY(dialog.isVisible());  // no pixel is so small
        pixel->setValue(0.05);
        dialog.accept();
        QTRY_VERIFY(!dialog.isVisible());
    });
    QVERIFY(f.world().world_files().open(f.path("room.png")));
    QVERIFY2(f.said().contains("Walls found: 4") && f.said().contains("tolerance"),
             qPrintable(f.said()));
    QCOMPARE(f.text().world().walls.size(), std::size_t{4});
    QVERIFY(f.world().draft().file().isEmpty());  // it is a new world
    // A map of lines and corners.
    in_dialog<ImportDialog>([](ImportDialog& dialog) {
        QVERIFY(dialog.findChild<QDoubleSpinBox*>("import_pixel") == nullptr);
        dialog.accept();
        QTRY_VERIFY(!dialog.isVisible());
    });
    f.prompts.confirms = {true};
    QVERIFY(f.world().world_files().open(Fixture::source_file("data/maps/bigloop.map")));
    QCOMPARE(f.text().world().walls.size(), std::size_t{8});
    // What is no world leaves what is there.
    const std::string before = f.text().text();
    for (const char* bad : {"walls = 3\n", "walls = [[[0, 0], [0, 0]]]\n", "\xff\xfe"}) {
        f.prompts.confirms = {true};
        QVERIFY(!f.world().world_files().open(f.write("bad.toml", bad)));
        QCOMPARE(f.text().text(), before);
    }
    QCOMPARE(f.prompts.warnings.size(), 3);
    f.prompts.confirms = {true};
    QVERIFY(!f.world().world_files().open(f.path("nothing.dxf")));
    QCOMPARE(f.prompts.warnings.size(), 4);
    QCOMPARE(f.text().text(), before);
}

void DrawTest::nothing_drawn_is_lost_unasked() {
    DrawFixture f;
    f.draw_room();
    f.act("world_new");
    QCOMPARE(f.prompts.confirmed_texts.size(), 1);
    QVERIFY(!f.text().text().empty());
    f.window->close();
    QVERIFY(f.window->isVisible());
    QCOMPARE(f.prompts.confirmed_texts.size(), 2);
    // Where it cannot be written it says why and asks again.
    f.prompts.saves << f.path("no-such-folder/room.toml") << f.path("room.txt")
                    << Fixture::source_file("data/worlds/new.toml") << f.path("room.toml");
    f.act("world_save");
    QCOMPARE(f.prompts.warnings.size(), 3);
    QVERIFY(!QFile::exists(f.path("room.txt")));
    QVERIFY(!QFile::exists(Fixture::source_file("data/worlds/new.toml")));
    QVERIFY(QFile::exists(f.path("room.toml")));
    // Somebody else has written it meanwhile.
    f.write("room.toml", "walls = [[[0, 0], [1, 1]]]\n");
    f.press("draw_box");
    f.click(4.0, 3.0);
    f.act("world_save");
    QCOMPARE(f.prompts.confirmed_texts.size(), 3);
    QCOMPARE(Fixture::read(f.path("room.toml")), QByteArray("walls = [[[0, 0], [1, 1]]]\n"));
    f.prompts.confirms = {true};
    f.act("world_save");
    QVERIFY(same_world(read_world(f.path("room.toml").toStdString()), f.text().world()));
    f.act("world_new");  // everything is in the file
    QCOMPARE(f.prompts.confirmed_texts.size(), 4);
    QVERIFY(f.text().text().empty());
}

void DrawTest::an_unsaved_world_is_driven_through_a_copy() {
    DrawFixture f;
    f.prompts.saves << f.path("room.toml");
    f.draw_room();
    f.act("world_save");
    const QByteArray saved = Fixture::read(f.path("room.toml"));
    f.press("draw_box");
    f.click(4.0, 3.0);
    f.press("draw_wall");
    f.click(1.0, 4.0);
    f.click(2.0, 4.0);
    f.press("world_drive");  // ends the wall first
    QVERIFY(f.no_warnings());
    LiveDrive& drive = f.world().drive();
    QVERIFY(drive.active());
    drive.rest();
    QCOMPARE(Fixture::read(f.path("room.toml")), saved);
    QCOMPARE(drive.tour()->walls_now().size(), std::size_t{4 + 4 + 1});  // with the box
    drive.hold(0.3, 0.0);
    for (int k = 0; k < 60; ++k) drive.drive_period();
    f.press("world_drive");  // back to drawing
    QVERIFY(!drive.active());
    QVERIFY2(f.said().contains("kept as"), qPrintable(f.said()));
    QVERIFY(f.world().findChild<QWidget*>("draw_wall")->isVisible());
    QVERIFY(f.world().draft().modified());
    QCOMPARE(f.text().walls().size(), std::size_t{2});
    QDir(QFileInfo(f.said().section("kept as ", 1)).path()).removeRecursively();
}

void DrawTest::drawings_segments_and_grids_are_opened() {
    DrawFixture f;
    QByteArray drawing("0\nSECTION\n2\nENTITIES\n");
    const Polyline corners = {{0, 0}, {4, 0}, {4, 3}, {0, 3}, {0, 0}};
    for (std::size_t i = 0; i < 4; ++i) {
        drawing += "0\nLINE\n8\n0\n10\n" + QByteArray::number(corners[i].x) + "\n20\n" +
                   QByteArray::number(corners[i].y) + "\n11\n" +
                   QByteArray::number(corners[i + 1].x) + "\n21\n" +
                   QByteArray::number(corners[i + 1].y) + "\n";
    }
    drawing += "0\nENDSEC\n0\nEOF\n";
    f.write("room.dxf", drawing);
    QVERIFY(f.world().world_files().open(f.path("room.dxf")));
    QVERIFY(f.no_warnings());
    QCOMPARE(f.text().world().walls.size(), std::size_t{4});
    f.prompts.confirms = {true, true, true, true, true};
    // Of a drawing that leaves a doubt, unit and layers are asked for.
    drawing.replace("\n4\n", "\n4000\n").replace("\n3\n", "\n3000\n");
    f.write("mm.dxf", drawing);
    in_dialog<ImportDialog>([](ImportDialog& dialog) {
        const auto* verdict = dialog.findChild<QLabel*>("import_verdict");
        QVERIFY2(verdict->text().contains("4000 m x 3000 m"), qPrintable(verdict->text()));
        dialog.findChild<QComboBox*>("import_unit")->setCurrentIndex(1);
        dialog.findChild<QLineEdit*>("import_layer")->setText("roof");
        dialog.accept();
        QTRY_VERIFY(verdict->text().contains("roof"));
        dialog.findChild<QLineEdit*>("import_layer")->clear();
        dialog.accept();
        QTRY_VERIFY(!dialog.isVisible());
    });
    QVERIFY(f.world().world_files().open(f.path("mm.dxf")));
    QVERIFY(f.no_warnings());
    QVERIFY2(f.said().contains("as asked"), qPrintable(f.said()));
    QCOMPARE(f.text().world().walls.front().b, (Point2{4, 0}));
    f.write("segments.txt", "# x1 y1 x2 y2 landmark\n0 0 4 0 1\n4 0 4 3 2\n");
    QVERIFY(f.world().world_files().open(f.path("segments.txt")));
    QVERIFY(f.no_warnings());
    QCOMPARE(f.text().world().walls.size(), std::size_t{2});
    // A world that takes its walls from a drawing is driven through with what is not saved.
    f.write("hall.toml",
            "walls_dxf = \"room.dxf\"  # the hall\ndxf_unit = 1\n[tour]\nstart = [1, 1, 0]\n");
    QVERIFY(f.world().world_files().open(f.path("hall.toml")));
    f.press("draw_box");
    f.click(3.0, 2.0);
    QVERIFY(f.no_warnings());
    f.press("world_drive");
    QVERIFY(f.no_warnings());
    QVERIFY(f.world().drive().active());
    f.world().drive().rest();
    QCOMPARE(f.world().drive().tour()->walls_now().size(), std::size_t{8});
    f.press("world_drive");
    QDir(f.path(".")).mkdir("elsewhere");
    f.prompts.saves << f.path("elsewhere/hall.toml");
    f.act("world_save_as");
    QVERIFY(f.no_warnings());
    QVERIFY(same_world(read_world(f.path("elsewhere/hall.toml").toStdString()), f.text().world()));
    QVERIFY(Fixture::read(f.path("elsewhere/hall.toml")).contains("# the hall"));
    // The drawing goes: what was drawn is saved with its walls all the same.
    QVERIFY(QFile::remove(f.path("room.dxf")));
    f.prompts.saves << f.path("alone.toml");
    f.act("world_save_as");
    QVERIFY(f.no_warnings());
    QCOMPARE(read_world(f.path("alone.toml").toStdString()).walls.size(), std::size_t{4});
    f.press("draw_box");
    f.click(1.0, 2.0);
    QVERIFY(f.no_warnings());
}

void DrawTest::what_was_driven_and_left_is_not_run_in_its_place() {
    DrawFixture f;
    f.draw_room();
    f.prompts.saves << f.path("room.toml");
    f.act("world_save");
    f.press("world_drive");
    LiveDrive& drive = f.world().drive();
    drive.rest();
    for (int k = 0; k < 20; ++k) drive.drive_period();
    QTRY_VERIFY(f.steps() == drive.tour()->scans() && f.shows_everything());
    f.press("world_drive");  // too short to be rescued: there is no file that repeats it
    QVERIFY(!drive.active());
    QVERIFY(!f.action("action_save_results")->isEnabled());
    f.press("draw_way_point");
    f.click(3.0, 0.0);
    f.press("world_run");
    QVERIFY(f.no_warnings());
    QTRY_VERIFY(f.state() == Progress::State::finished && f.shows_everything());
    QVERIFY(f.session.live_tour() == nullptr);
    QVERIFY(f.steps() > 25);  // the tour to the way point
    QVERIFY(f.action("action_save_results")->isEnabled());
    f.act("world_save");
    // A kept tour that is undone is not written over by the drawing that it began with.
    f.press("world_drive");
    drive.rest();
    for (int k = 0; k < 20; ++k) drive.drive_period();
    f.prompts.saves << f.path("kept.toml");
    f.press("drive_keep");
    QTRY_VERIFY(f.state() == Progress::State::finished);
    const QByteArray kept = Fixture::read(f.path("kept.toml"));
    QVERIFY(f.world().windowTitle().startsWith("kept"));
    f.act("world_undo");
    QVERIFY(f.world().windowTitle().startsWith("room"));
    f.press("draw_box");
    f.click(5.0, 4.0);
    f.act("world_save");
    QVERIFY(f.no_warnings());
    QCOMPARE(Fixture::read(f.path("kept.toml")), kept);
    QVERIFY(Fixture::read(f.path("room.toml")).contains("box"));
}

void DrawTest::robot_and_laser_are_set_in_the_form() {
    DrawFixture f;
    f.draw_room();
    in_dialog<WorldForm>([](WorldForm& form) {
        QCOMPARE(static_cast<std::size_t>(form.findChildren<ParameterField*>().size()),
                 world_keys().size());
        for (const WorldKey& key : world_keys())
            QVERIFY2(key.unit.empty() == unit_of(key).isEmpty(), std::string(key.key).c_str());
        auto* rays = form.findChild<QLineEdit*>("field_laser.rays");
        rays->setText("1");
        form.accept();
        QVERIFY(form.isVisible());
        QVERIFY(form.findChild<QLabel*>("error_laser.rays")->isVisible());
        rays->setText("361");
        form.findChild<QLineEdit*>("field_odometry.noise")->setText("0.3");
        form.accept();
    });
    f.act("world_values");
    QCOMPARE(f.text().world().laser.rays, 361);
    QCOMPARE(f.text().world().odometry.noise, 0.3);
    QVERIFY(f.text().text().find("rays = 361") != std::string::npos);
    f.act("world_undo");
    QCOMPARE(f.text().world().laser.rays, 181);
}

void DrawTest::all_that_is_said_can_be_read() {
    DrawFixture f;
    f.draw_room();
    QTRY_VERIFY(f.world().check_line().up_to_date());
    f.world().resize(960, 600);
    QCoreApplication::processEvents();
    const QRect picture = f.view().geometry();
    const QString much = QString("tour: too much to be said in a few lines · ").repeated(20);
    for (const char* name : {"world_check", "world_notice", "draw_hint"}) {
        auto* label = f.world().findChild<QLabel*>(name);
        auto* area = qobject_cast<QScrollArea*>(label->parentWidget()->parentWidget());
        QVERIFY2(area != nullptr, name);
        label->setText(much);
        QTRY_VERIFY(area->verticalScrollBar()->isVisible());
        QVERIFY(label->height() >= label->heightForWidth(label->width()));
        QVERIFY(label->width() <= area->viewport()->width());
        QCOMPARE(area->verticalScrollBar()->maximum(),
                 label->height() - area->viewport()->height());
    }
    QCOMPARE(f.view().geometry(), picture);  // it does not move
}

void DrawTest::distances_are_measured() {
    DrawFixture f;
    f.draw_room();
    const std::string before = f.text().text();
    f.press("draw_measure");
    f.click(-1.0, -1.0);
    f.click(9.0, 6.0);
    QVERIFY((f.world().tool().pending() == std::vector<Point2>{{-1, -1}, {9, 6}}));
    f.click(2.0, 2.0);  // begins anew
    QCOMPARE(f.world().tool().pending().size(), std::size_t{1});
    f.key(Qt::Key_Escape);
    QVERIFY(f.world().tool().pending().empty());
    QCOMPARE(f.text().text(), before);
}

}  // namespace hitos::window
