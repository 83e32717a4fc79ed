// SPDX-License-Identifier: GPL-3.0-or-later
// Measuring in the views, and the distances files that come of it.

#include <QDockWidget>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <cmath>

#include "gui_fixture.hpp"
#include "hitos/services/evaluation/hand_measurement.hpp"
#include "look/figures_table.hpp"
#include "measure/measurement_table.hpp"
#include "tests.hpp"

namespace hitos::window {
namespace {

FiguresTable& measured(const Fixture& f) {
    return *f.window->findChild<FiguresTable*>("measurement_table");
}

const std::vector<MeasuredRow>& rows(const Fixture& f) {
    return f.window->findChild<Measurements*>()->rows();
}

QString words_in(const Fixture& f, int row, int column) {
    return measured(f).model()->index(row, column).data().toString();
}

bool write_into(const Fixture& f, int row, int column, const QString& words) {
    QAbstractItemModel& model = *measured(f).model();
    return model.setData(model.index(row, column), words, Qt::EditRole);
}

void press(const Fixture& f, const char* name) {
    QTest::mouseClick(f.window->findChild<QPushButton*>(name), Qt::LeftButton);
}

QPoint pixel_at(const CanvasView& view, double x, double y) {
    return view.camera().to_screen(view.size()).map(QPointF(x, y)).toPoint();
}

void click_at(CanvasView& view, double x, double y, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseClick(&view, Qt::LeftButton, keys, pixel_at(view, x, y));
}

/// In the middle of where the wall of the map was seen.
void click_wall(const Fixture& f, CanvasView& view, const Recta& wanted) {
    const Snapshot& snapshot = *f.session.snapshot();
    for (const LineExtent& extent : snapshot.line_extents) {
        const ICaracteristica& line = snapshot.best_map[static_cast<std::size_t>(extent.landmark)];
        const LineDifference apart = difference(std::get<Recta>(line.value), wanted);
        if (apart.rho > 0.3 || apart.theta > 0.1) continue;
        click_at(view, (extent.a.x + extent.b.x) / 2.0, (extent.a.y + extent.b.y) / 2.0);
        return;
    }
    QFAIL("no such wall");
}

// The corridor in which the ready tour begins is 3 m wide.
const Recta kSouth{1.0, -kPi / 2.0};
const Recta kNorth{2.0, kPi / 2.0};

void measure_corridor(const Fixture& f, CanvasView& view) {
    click_wall(f, view, kSouth);
    click_wall(f, view, kNorth);
}

/// What the command line makes of a file's distances in the map as it is now.
std::vector<MeasuredDistance> as_the_command_line(const Fixture& f, const QString& path) {
    return measure_distances(f.session.snapshot()->best_map, read_distances(path.toStdString()));
}

}  // namespace

void MeasureTest::two_walls_are_measured_as_the_command_line_does() {
    Fixture f;
    f.run_steps(200);
    GridView& grid = f.window->grid_view();
    const QImage before = grid.grab().toImage();
    QTest::keyClick(f.window.get(), Qt::Key_M);
    QVERIFY(f.action("action_measure")->isChecked());
    QVERIFY(measured(f).isVisible());
    measure_corridor(f, grid);
    QCOMPARE(rows(f).size(), std::size_t{1});
    QVERIFY(rows(f)[0].measurement.between_walls());
    QVERIFY(std::abs(rows(f)[0].slam.value.value() - 3.0) < 0.2);
    QCOMPARE(words_in(f, 0, MeasurementModel::name), QString("d1"));
    QVERIFY(grid.grab().toImage() != before);
    f.prompts.saves = {f.path("walls.distances")};
    press(f, "measurement_save");
    QVERIFY2(f.prompts.warnings.isEmpty(), qPrintable(f.prompts.warnings.join(' ')));
    // Both follow the run alike.
    for (int i = 0; i < 2; ++i) {
        const auto found = as_the_command_line(f, f.path("walls.distances"));
        QCOMPARE(found.size(), std::size_t{1});
        QVERIFY(std::abs(found[0].slam_m.value() - rows(f)[0].slam.value.value()) < 1e-9);
        f.run_steps(150);
    }
    // The scan view measures too, in either frame.
    for (const bool world : {true, false}) {
        f.action("action_world_frame")->setChecked(world);
        ScanView& scan = f.window->scan_view();
        const Pose pose = f.session.snapshot()->best_pose;
        for (const double y : {-1.0, 1.0}) {
            const Point2 place = world ? transform(pose, Point2{0.5, y}) : Point2{0.5, y};
            click_at(scan, place.x, place.y, Qt::ShiftModifier);
        }
        QCOMPARE(rows(f).back().measurement.places[0].kind, PickedPlace::Kind::point);
        QVERIFY(std::abs(rows(f).back().slam.value.value() - 2.0) < 0.2);
        const Point2 picked = transform(inverse(pose), rows(f).back().measurement.places[1].at);
        QVERIFY(std::hypot(picked.x - 0.5, picked.y - 1.0) < 0.1);
    }
    QCOMPARE(rows(f).size(), std::size_t{3});
}

void MeasureTest::truth_is_the_reference_maps_or_written() {
    Fixture f;
    f.run_steps(200);
    f.trigger("action_measure");
    measure_corridor(f, f.window->grid_view());
    QVERIFY(!rows(f)[0].truth);
    QCOMPARE(words_in(f, 0, MeasurementModel::percent), QString("–"));
    f.prompts.opens = {Fixture::source_file("data/maps/bigloop.map")};
    f.trigger("action_reference_map");
    QVERIFY(std::abs(rows(f)[0].truth.value() - 3.0) < 1e-9);
    QCOMPARE(words_in(f, 0, MeasurementModel::truth), QString("3.000 m"));
    QVERIFY(f.window->findChild<QLabel*>("measurement_means")->text().contains("%"));
    QVERIFY(!write_into(f, 0, MeasurementModel::truth, "2,500"));  // metres, or kilometres?
    {
        const DecimalCommas commas;
        QVERIFY(write_into(f, 0, MeasurementModel::truth, "2,5"));
    }
    QCOMPARE(rows(f)[0].truth.value(), 2.5);
    const double slam = rows(f)[0].slam.value.value();
    QVERIFY(std::abs(rows(f)[0].error_percent().value() - 100.0 * (slam - 2.5) / 2.5) < 1e-9);
    QVERIFY(!write_into(f, 0, MeasurementModel::truth, "far"));
    QTRY_VERIFY2(f.notice().contains("far"), qPrintable(f.notice()));
    QVERIFY(!write_into(f, 0, MeasurementModel::name, "two words"));
    QVERIFY(write_into(f, 0, MeasurementModel::name, "corridor"));
    f.prompts.saves = {f.path("true.distances")};
    press(f, "measurement_save");
    const auto written = read_distances(f.path("true.distances").toStdString());
    QCOMPARE(written[0].name, std::string("corridor"));
    QVERIFY(std::abs(written[0].true_m() - 2.5) < 1e-9);
    // Nothing written: the reference map's again.
    QVERIFY(write_into(f, 0, MeasurementModel::truth, ""));
    QVERIFY(std::abs(rows(f)[0].truth.value() - 3.0) < 1e-9);
}

void MeasureTest::what_is_written_stays_while_the_run_goes_on() {
    Fixture f;
    f.run_steps(200);
    f.trigger("action_measure");
    measure_corridor(f, f.window->grid_view());
    FiguresTable& table = measured(f);
    table.edit(table.model()->index(0, MeasurementModel::name));
    QTRY_VERIFY(table.findChild<QLineEdit*>() != nullptr);
    QTest::keyClicks(table.findChild<QLineEdit*>(), "hall");
    f.run_steps(20);
    QCOMPARE(table.findChild<QLineEdit*>()->text(), QString("hall"));
    QTest::keyClick(table.findChild<QLineEdit*>(), Qt::Key_Return);
    QTRY_COMPARE(rows(f)[0].measurement.name, std::string("hall"));
}

void MeasureTest::angles_and_places_are_measured_with_keys_too() {
    Fixture f;
    f.run_steps(200);
    GridView& grid = f.window->grid_view();
    grid.setFocus();
    QTest::keyClick(f.window.get(), Qt::Key_M, Qt::ShiftModifier);
    QVERIFY(f.action("action_measure_angle")->isChecked());
    measure_corridor(f, grid);  // parallel walls have an angle where it is asked for
    QCOMPARE(rows(f)[0].measurement.quantity, Quantity::angle);
    QVERIFY(rows(f)[0].slam.value.value() < 0.05);
    click_at(grid, 1.0, 0.0, Qt::ShiftModifier);
    click_at(grid, 0.0, 0.0, Qt::ShiftModifier);
    QCOMPARE(rows(f).size(), std::size_t{1});
    click_at(grid, 0.0, 1.0, Qt::ShiftModifier);
    QVERIFY(std::abs(rows(f)[1].slam.value.value() - kPi / 2.0) < 0.2);
    // No file holds those.
    QVERIFY(!f.window->findChild<QPushButton*>("measurement_save")->isEnabled());
    // With the keyboard alone: two places in the middle, the view moved between them.
    QTest::keyClick(f.window.get(), Qt::Key_M);
    QVERIFY(!f.action("action_measure_angle")->isChecked());
    QTest::keyClick(&grid, Qt::Key_Return, Qt::ShiftModifier);
    const double pixels_per_m = grid.camera().pixels_per_m;
    QTest::keyClick(&grid, Qt::Key_D);
    QTest::keyClick(&grid, Qt::Key_Return, Qt::ShiftModifier);
    QCOMPARE(rows(f).size(), std::size_t{3});
    QVERIFY(std::abs(rows(f)[2].slam.value.value() - 48.0 / pixels_per_m) < 1e-6);
    // Escape drops what was begun, then ends.
    QTest::keyClick(&grid, Qt::Key_Return);
    QTest::keyClick(&grid, Qt::Key_Escape);
    QVERIFY(f.action("action_measure")->isChecked());
    QTest::keyClick(&grid, Qt::Key_Escape);
    QVERIFY(!f.action("action_measure")->isChecked());
    click_at(grid, 1.0, 0.0);
    click_at(grid, 2.0, 0.0);
    QCOMPARE(rows(f).size(), std::size_t{3});
    measured(f).choose(1);
    press(f, "measurement_remove");
    QCOMPARE(rows(f).size(), std::size_t{2});
    f.prompts.confirms = {false, true};
    press(f, "measurement_clear");
    QCOMPARE(rows(f).size(), std::size_t{2});
    press(f, "measurement_clear");
    QVERIFY(rows(f).empty());
}

void MeasureTest::distances_files_are_opened() {
    Fixture f;
    f.run_steps(200);
    f.trigger("action_measurements_dock");
    const QString good = f.write("good.distances", "corridor 2 -1 2 2\nnowhere 200 200 203 200\n");
    f.prompts.opens = {good, f.write("bad.distances", "corridor 2 -1\n")};
    press(f, "measurement_open");
    QCOMPARE(rows(f).size(), std::size_t{2});
    const auto found = as_the_command_line(f, good);
    QCOMPARE(rows(f)[0].slam.value.value(), found[0].slam_m.value());
    QCOMPARE(rows(f)[0].truth.value(), 3.0);
    QCOMPARE(words_in(f, 1, MeasurementModel::slam), QString("–"));
    press(f, "measurement_open");
    QCOMPARE(f.prompts.warnings.size(), 1);
    QVERIFY2(f.prompts.warnings[0].contains("found 3 fields"), qPrintable(f.prompts.warnings[0]));
    QCOMPARE(rows(f).size(), std::size_t{2});
    // What was read is written again as it was.
    f.prompts.saves = {f.path("again.distances")};
    press(f, "measurement_save");
    QVERIFY(read_distances(f.path("again.distances").toStdString()) ==
            read_distances(good.toStdString()));
}

void MeasureTest::measurements_go_with_their_log() {
    Fixture f;
    f.run_steps(200);
    f.trigger("action_measure");
    measure_corridor(f, f.window->grid_view());
    f.trigger("action_restart");
    QCOMPARE(rows(f).size(), std::size_t{1});
    QVERIFY(!rows(f)[0].slam.value);
    const Configuracion here = f.session.configuration();
    Configuracion other = here;
    other.source.file = Fixture::source_file("data/bigloop-noisy.log.gz").toStdString();
    // A name is being written: it belongs to no row of the other log.
    FiguresTable& table = measured(f);
    const QString before = QString::fromStdString(rows(f)[0].measurement.name);
    table.setCurrentIndex(table.model()->index(0, MeasurementModel::name));
    table.edit(table.model()->index(0, MeasurementModel::name));
    QTRY_VERIFY(table.findChild<QLineEdit*>() != nullptr);
    QTest::keyClicks(table.findChild<QLineEdit*>(), "hall");
    f.session.set_configuration(other);
    QVERIFY(rows(f).empty());
    // What was begun on a log ends with it.
    f.run_steps(200);
    click_wall(f, f.window->grid_view(), kSouth);
    f.session.set_configuration(here);
    QCOMPARE(rows(f).size(), std::size_t{1});
    QCOMPARE(QString::fromStdString(rows(f)[0].measurement.name), before);
    f.run_steps(200);
    click_wall(f, f.window->grid_view(), kNorth);
    QCOMPARE(rows(f).size(), std::size_t{1});
    f.trigger("action_restart");
    f.run_steps(200);
    QVERIFY(rows(f)[0].slam.value);
}

void MeasureTest::maps_in_windows_of_their_own_are_measured() {
    Fixture f;
    f.run_steps(200);
    f.trigger("action_best_map");
    MapWindow* map = f.window->result_actions().best_window();
    QTRY_VERIFY(!map->builder().state().running && !map->view().tiles().empty());
    QTest::keyClick(map, Qt::Key_M);
    QVERIFY(f.action("action_measure")->isChecked());
    measure_corridor(f, map->view());
    QVERIFY(rows(f).at(0).measurement.between_walls());
    // Escape ends measuring, and does not close the window.
    QTest::keyClick(&map->view(), Qt::Key_Escape);
    QVERIFY(!f.action("action_measure")->isChecked());
    QVERIFY(map->isVisible());
}

}  // namespace hitos::window
