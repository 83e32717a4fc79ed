// SPDX-License-Identifier: GPL-3.0-or-later
// A run that is anchored to a drawing, with mouse and keyboard.

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "gui_fixture.hpp"
#include "hitos/simulation/worlds/world.hpp"
#include "inspect/anchor_dialog.hpp"
#include "inspect/loop_table.hpp"
#include "inspect/wall_view.hpp"
#include "tests.hpp"

namespace hitos::window {
namespace {

/// A finished run of the loop, whose walls stand in a drawing with another frame.
class Anchored : public Fixture {
  public:
    Anchored() {
        Configuracion configuration =
            ArchivoConfiguracion::read(Fixture::source_file("config/recorded.cfg").toStdString());
        configuration.source.file = Fixture::source_file("data/bigloop.log.gz").toStdString();
        configuration.filter.particles = 3;
        session.set_configuration(configuration);
        QByteArray segments;
        for (const WallSegment& wall : world.walls) {
            const Point2 a = transform(drawn, wall.a);
            const Point2 b = transform(drawn, wall.b);
            segments += QString("%1 %2 %3 %4 1\n").arg(a.x).arg(a.y).arg(b.x).arg(b.y).toUtf8();
        }
        prompts.opens << write("plan.txt", segments);
        run_to_end();
        trigger("action_loops_dock");
    }

    template <class Widget>
    Widget& part(const char* name) const {
        auto* found = window->findChild<Widget*>(name);
        if (found == nullptr) qFatal("there is no %s", name);
        return *found;
    }
    void press(const char* name) const {
        QTest::mouseClick(&part<QPushButton>(name), Qt::LeftButton);
    }
    QString state_words() const { return part<QLabel>("anchor_state").text(); }
    std::string edits() const { return session.configuration().registration.edits; }
    bool at_rest() const {
        return state() == Progress::State::finished && shows_everything() &&
               !session.snapshot()->key_scans.empty();
    }
    /// The wall of the drawing that a wall of the scan is, by the truth; none where it sees a
    /// corner or little.
    std::optional<QLineF> drawn_as(const QLineF& seen) const {
        const Pose robot = compose(drawn, session.snapshot()->best_trajectory.back().pose);
        const auto place = [&](const QPointF& at) {
            const Point2 placed = transform(robot, Point2{at.x(), at.y()});
            return QPointF(placed.x, placed.y);
        };
        for (const QLineF& wall : part<WallView>("anchor_drawing").walls().walls) {
            const bool on = distance_to(wall, place(seen.p1())) < 0.1 &&
                            distance_to(wall, place(seen.p2())) < 0.1;
            if (on && seen.length() > 1.0) return seen_from(wall, QPointF(robot.x, robot.y));
        }
        return std::nullopt;
    }
    /// A click beside the wall's middle, on the side that it is seen from.
    void click_drawing(const QLineF& wall) const {
        auto& view = part<WallView>("anchor_drawing");
        const QPointF back(wall.dy() / wall.length(), -wall.dx() / wall.length());
        const QPointF beside = wall.center() + 3.0 / view.camera().pixels_per_m * back;
        QTest::mouseClick(&view, Qt::LeftButton, {}, pixel_in(view, beside));
    }

    const Pose drawn{100.0, -50.0, 0.7};  // of the world's frame in the drawing
    const World world = read_world(Fixture::source_file("data/worlds/bigloop.toml").toStdString());
};

}  // namespace

void InspectTest::a_scan_is_anchored_to_a_drawing() {
    Anchored f;
    QTRY_VERIFY(f.at_rest());
    const auto before = f.session.snapshot();
    f.press("edit_anchor");
    auto& dialog = f.part<AnchorDialog>("anchor_dialog");
    QVERIFY(dialog.isVisible() && !dialog.isModal());
    QVERIFY(!f.part<QPushButton>("anchor_make").isEnabled());
    f.press("anchor_open");
    auto& drawing = f.part<WallView>("anchor_drawing");
    auto& scan = f.part<WallView>("anchor_scan");
    QCOMPARE(drawing.walls().walls.size(), f.world.walls.size());
    QVERIFY(scan.walls().walls.size() >= 2);
    QVERIFY2(f.state_words().startsWith("Choose a wall of the drawing"),
             qPrintable(f.state_words()));
    // The walls of the scan that are whole walls of the drawing, each direction once.
    std::vector<std::pair<QLineF, QLineF>> pairs;
    for (const QLineF& seen : scan.walls().walls) {
        const auto wall = f.drawn_as(seen);
        if (!wall) continue;
        const bool other = std::ranges::all_of(pairs, [&](const auto& pair) {
            return std::abs(std::sin((pair.first.angle() - seen.angle()) * kPi / 180.0)) > 0.5;
        });
        if (other) pairs.emplace_back(seen, *wall);
    }
    QVERIFY2(pairs.size() >= 2, "the last scan sees two walls that are not parallel");
    for (std::size_t i = 0; i < 2; ++i) {
        f.click_drawing(pairs[i].second);
        QVERIFY(drawing.wall().has_value());
        QVERIFY(QLineF(drawing.wall()->p1(), pairs[i].second.p1()).length() < 1e-6);
        QTest::mouseClick(&scan, Qt::LeftButton, {}, pixel_in(scan, pairs[i].first.center()));
        QVERIFY(scan.wall().has_value() && *scan.wall() == pairs[i].first);
        QVERIFY2(f.state_words().startsWith(i == 0 ? "One anchor moves nothing" : "With this one"),
                 qPrintable(f.state_words()));
        f.press("anchor_make");
        QTRY_VERIFY(f.at_rest());
        QVERIFY(!f.part<QPushButton>("anchor_make").isEnabled());
    }
    QCOMPARE(f.part<QListWidget>("graph_edits").count(), 2);
    QVERIFY2(f.edits().starts_with("wall " + std::to_string(before->steps) + "@"),
             f.edits().c_str());
    QVERIFY2(f.part<QLabel>("anchor_effect").text().contains("moved"),
             qPrintable(f.part<QLabel>("anchor_effect").text()));
    const auto laid = f.session.snapshot()->drawing;
    QVERIFY(laid && laid->firm);
    const Pose truth = inverse(f.drawn);
    QVERIFY2(
        std::abs(wrap_angle(laid->pose.theta - truth.theta)) < 0.05 &&
            QLineF(point_of(transform(laid->pose, Point2{100.0, -50.0})), QPointF()).length() < 1.0,
        qPrintable(QString("%1 %2 %3").arg(laid->pose.x).arg(laid->pose.y).arg(laid->pose.theta)));
    QVERIFY(!drawing.walls().dots.empty());  // the scan, laid over it
    GridView& grid = f.window->grid_view();
    QVERIFY2(grid.figures().front().layers.has(Layer::reference), "and the drawing over the grid");
    // The next one is measured before it is made, and one from the other side is not taken.
    f.click_drawing(pairs[0].second);
    scan.choose_wall(pairs[0].first);
    emit scan.chosen();
    QVERIFY2(f.state_words().contains("as change 1"), qPrintable(f.state_words()));
    scan.choose_wall(std::nullopt);
    emit scan.chosen();
    auto& seen = f.part<QLineEdit>("anchor_seen");
    const QPointF middle = 0.6 * pairs[0].first.p1() + 0.4 * pairs[0].first.p2();
    seen.setFocus();
    QTest::keyClicks(
        &seen, QString::number(std::atan2(middle.y(), middle.x()) * kDegreesPerRadian, 'f', 2));
    QVERIFY(scan.wall().has_value());
    QVERIFY2(f.state_words().contains("the wall is 0.0"), qPrintable(f.state_words()));
    drawing.setFocus();
    QTest::keyClick(&drawing, Qt::Key_Space);
    QVERIFY2(f.state_words().contains("This is another wall"), qPrintable(f.state_words()));
    // Undone, the map is the one from before.
    f.trigger("action_undo");
    f.trigger("action_undo");
    QTRY_VERIFY(f.at_rest() && f.edits().empty());
    QVERIFY(f.session.snapshot()->best_trajectory == before->best_trajectory);
    QVERIFY(!f.session.snapshot()->drawing);
}

void InspectTest::points_are_anchored_by_their_coordinates() {
    Anchored f;
    QTRY_VERIFY(f.at_rest());
    f.press("edit_anchor");
    f.part<QComboBox>("anchor_kind").setCurrentIndex(1);
    auto& drawn = f.part<QLineEdit>("anchor_drawn");
    auto& seen = f.part<QLineEdit>("anchor_seen");
    drawn.setFocus();
    QTest::keyClicks(&drawn, "4500000.5; -12");
    seen.setFocus();
    QTest::keyClicks(&seen, "1.5");
    QVERIFY(!f.part<QPushButton>("anchor_make").isEnabled());
    QCOMPARE(f.state_words(), "“1.5” cannot be read; expected: " + seen.toolTip());
    QCOMPARE(seen.property("state").toString(), "wrong");
    QTest::keyClicks(&seen, ", -2");
    QVERIFY(f.part<QPushButton>("anchor_make").isEnabled());
    QTest::keyClick(&seen, Qt::Key_Return);
    QTRY_VERIFY(f.at_rest() && !f.edits().empty());
    QVERIFY2(f.edits().ends_with(" 1.5 -2 4500000.5 -12"), f.edits().c_str());
    QVERIFY(f.session.snapshot()->drawing && !f.session.snapshot()->drawing->firm);
    QVERIFY(f.part<QListWidget>("graph_edits").item(0)->text().contains("4500000.50, -12.00"));
    // Corners are met exactly, by mouse and by keyboard.
    f.press("anchor_open");
    auto& drawing = f.part<WallView>("anchor_drawing");
    const QPointF corner = drawing.walls().places.front();
    QTest::mouseClick(&drawing, Qt::LeftButton, {}, pixel_in(drawing, corner) + QPoint(3, 2));
    QVERIFY(drawing.place().has_value());
    QVERIFY(std::ranges::find(drawing.walls().places, *drawing.place()) !=
            drawing.walls().places.end());
    const QPointF clicked = *drawing.place();
    drawing.setFocus();
    for (const auto key : {Qt::Key_Right, Qt::Key_Left, Qt::Key_Up, Qt::Key_Down})
        QTest::keyClick(&drawing, key);
    QVERIFY(std::ranges::find(drawing.walls().places, *drawing.place()) !=
            drawing.walls().places.end());
    QVERIFY(clicked != QPointF());
    // What cannot be read is told.
    f.part<AnchorDialog>("anchor_dialog").open_drawing(f.write("empty.dxf", "0\nEOF\n"));
    QVERIFY2(f.part<QLabel>("anchor_notes").text().contains("empty.dxf"),
             qPrintable(f.part<QLabel>("anchor_notes").text()));
    QVERIFY(drawing.walls().walls.empty());
}

}  // namespace hitos::window
