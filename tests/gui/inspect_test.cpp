// SPDX-License-Identifier: GPL-3.0-or-later
// Looking at a run in numbers: the tables of landmarks and particles.

#include <QDockWidget>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <algorithm>

#include "gui_fixture.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/services/files/trajectory_file.hpp"
#include "inspect/association_inspector.hpp"
#include "inspect/association_words.hpp"
#include "inspect/landmark_table.hpp"
#include "inspect/particle_table.hpp"
#include "tests.hpp"

namespace hitos::window {
namespace {

QAbstractItemModel& rows_of(const FiguresTable& table) {
    return *table.model();
}

QString cell(const FiguresTable& table, int row, int column) {
    return rows_of(table).index(row, column).data().toString();
}

/// As a click on the row does.
void click_row(const FiguresTable& table, int row) {
    const QRect box = table.visualRect(rows_of(table).index(row, 0));
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, box.center());
}

QImage picture_of(QWidget& widget) {
    return widget.grab().toImage();
}

template <class Result, class Task>
Result ask(const Fixture& f, Task task) {
    return f.session.worker()->with_run(std::move(task)).get();
}

FiguresTable& table_of(const Fixture& f, const char* name) {
    auto* table = f.window->findChild<FiguresTable*>(name);
    if (table == nullptr) qFatal("no table %s", name);
    return *table;
}

/// The middle of a line that the scan shows, in the world.
QPointF middle_of_line(const Snapshot& snapshot, std::size_t line) {
    const DetectedLine& seen = snapshot.observation.lines[line];
    const Point2 a = transform(snapshot.best_pose, snapshot.observation.support[seen.first]);
    const Point2 b =
        transform(snapshot.best_pose, snapshot.observation.support[seen.first + seen.count - 1]);
    return {(a.x + b.x) / 2.0, (a.y + b.y) / 2.0};
}

}  // namespace

void InspectTest::the_landmark_table_has_every_landmark() {
    Fixture f;
    f.run_steps(100);
    const FiguresTable& table = table_of(f, "landmark_table");
    QCOMPARE(rows_of(table).rowCount(), 0);  // hidden, it does nothing
    f.trigger("action_landmarks_dock");
    const LandmarkMap& map = f.session.snapshot()->best_map;
    QCOMPARE(rows_of(table).rowCount(), static_cast<int>(map.size()));
    for (int row = 0; row < rows_of(table).rowCount(); ++row) {
        const ICaracteristica& landmark = map[static_cast<std::size_t>(row)];
        QCOMPARE(cell(table, row, LandmarkModel::number).toInt(), row + 1);
        QCOMPARE(cell(table, row, LandmarkModel::seen).toInt(), landmark.observations);
        QVERIFY(landmark.first_seen <= landmark.last_seen);
        QVERIFY(landmark.last_seen < 100);
        const QString first = cell(table, row, LandmarkModel::born);
        QVERIFY2(first.startsWith(QString("%1 (").arg(landmark.first_seen + 1)), qPrintable(first));
    }
    rows_of(table).sort(LandmarkModel::seen, Qt::DescendingOrder);
    for (int row = 1; row < rows_of(table).rowCount(); ++row) {
        QVERIFY(cell(table, row - 1, LandmarkModel::seen).toInt() >=
                cell(table, row, LandmarkModel::seen).toInt());
    }
    f.run_steps(100);
    QCOMPARE(rows_of(table).rowCount(), static_cast<int>(f.session.snapshot()->best_map.size()));
}

void InspectTest::no_number_of_a_table_is_cut() {
    Fixture f;
    f.run_to_end();
    f.trigger("action_landmarks_dock");
    FiguresTable& table = table_of(f, "landmark_table");
    const QAbstractItemModel& rows = rows_of(table);
    for (const auto& [column, order] :
         {std::pair(0, Qt::AscendingOrder), std::pair(2, Qt::DescendingOrder)}) {
        table.sortByColumn(column, order);
        QTest::qWait(50);  // columns are fitted a little later
        for (int row = 0; row < rows.rowCount(); ++row) {
            for (int at = 0; at < rows.columnCount(); ++at) {
                const QModelIndex cell = table.model()->index(row, at);
                QStyleOptionViewItem option;
                option.initFrom(&table);
                const int wanted = table.itemDelegateForIndex(cell)->sizeHint(option, cell).width();
                QVERIFY2(table.columnWidth(at) >= wanted,
                         qPrintable(QString("%1: %2 of %3 pixels")
                                        .arg(cell.data().toString())
                                        .arg(table.columnWidth(at))
                                        .arg(wanted)));
            }
        }
    }
}

void InspectTest::a_chosen_landmark_is_marked_everywhere() {
    Fixture f;
    f.trigger("action_world_frame");
    f.trigger("action_landmarks_dock");
    f.run_steps(60);
    FiguresTable& table = table_of(f, "landmark_table");
    rows_of(table).sort(LandmarkModel::sigma_1, Qt::DescendingOrder);
    const QImage scan = picture_of(f.window->scan_view());
    const QImage grid = picture_of(f.window->grid_view());
    click_row(table, 1);
    QVERIFY(table.chosen() >= 0);
    QVERIFY(picture_of(f.window->scan_view()) != scan);
    QVERIFY(picture_of(f.window->grid_view()) != grid);
    // And from a view into the table.
    const LineExtent extent = f.session.snapshot()->line_extents.front();
    const QPointF middle((extent.a.x + extent.b.x) / 2.0, (extent.a.y + extent.b.y) / 2.0);
    for (CanvasView* view : {static_cast<CanvasView*>(&f.window->scan_view()),
                             static_cast<CanvasView*>(&f.window->grid_view())}) {
        table.choose(-1);
        QTest::mouseClick(view, Qt::LeftButton, {}, pixel_in(*view, middle));
        QCOMPARE(table.chosen(), extent.landmark);
    }
    // It stays chosen as the map grows and is sorted anew.
    const ICaracteristica before =
        f.session.snapshot()->best_map[static_cast<std::size_t>(table.chosen())];
    f.run_steps(20);
    const LandmarkMap& map = f.session.snapshot()->best_map;
    QCOMPARE(table.chosen(), find_same(map, before));
}

void InspectTest::a_chosen_particle_shows_what_it_believes() {
    Fixture f;
    f.run_steps(40);
    f.trigger("action_particles_dock");
    FiguresTable& table = table_of(f, "particle_table");
    QCOMPARE(rows_of(table).rowCount(), 10);
    QVERIFY(!f.session.snapshot()->particle.has_value());
    const QImage scan = picture_of(f.window->scan_view());
    const QImage grid = picture_of(f.window->grid_view());
    rows_of(table).sort(ParticleModel::number, Qt::DescendingOrder);
    click_row(table, 2);
    QTRY_VERIFY(f.shows_everything() && f.session.snapshot()->particle.has_value());
    const ParticleDetails& shown = *f.session.snapshot()->particle;
    QCOMPARE(shown.number, std::size_t{7});
    QVERIFY(shown.path ==
            ask<Trajectory>(f, [](const Algoritmo& run) { return run.trajectory_of(7); }));
    QVERIFY(map_to_text(shown.map) == map_to_text(ask<LandmarkMap>(f, [](const Algoritmo& run) {
                return run.filter().map(7);
            })));
    QVERIFY(picture_of(f.window->scan_view()) != scan);
    QVERIFY(picture_of(f.window->grid_view()) != grid);
    f.run_steps(1);
    QCOMPARE(f.session.snapshot()->particle->path.size(), std::size_t{41});
    // What nobody sees is not made.
    f.trigger("action_particles_dock");
    QTRY_VERIFY(f.shows_everything() && !f.session.snapshot()->particle.has_value());
}

void InspectTest::a_click_on_the_cloud_chooses_a_particle() {
    Fixture f;
    f.trigger("action_world_frame");
    f.trigger("action_particles_dock");
    f.run_steps(40);
    const FiguresTable& table = table_of(f, "particle_table");
    ScanView& view = f.window->scan_view();
    const Pose pose = f.session.snapshot()->hypotheses[4].pose;
    view.fit();
    for (int i = 0; i < 20; ++i) view.zoom(1.25);
    view.set_follow(true);
    const QPoint pixel = pixel_in(view, {pose.x, pose.y});
    QVERIFY(view.rect().contains(pixel));
    QTest::mouseClick(&view, Qt::LeftButton, {}, pixel);
    QVERIFY(table.chosen() >= 0);
    // Copies of one particle lie upon each other.
    const Pose chosen =
        f.session.snapshot()->hypotheses[static_cast<std::size_t>(table.chosen())].pose;
    QCOMPARE(pixel_in(view, {chosen.x, chosen.y}), pixel);
}

void InspectTest::any_particles_map_path_and_grid_are_opened() {
    Fixture f;
    f.trigger("action_particles_dock");
    f.run_steps(40);
    const auto press = [&](const char* name) {
        auto* button = f.window->findChild<QPushButton*>(name);
        QVERIFY(button->isEnabled());
        button->click();
    };
    QVERIFY(!f.window->findChild<QPushButton*>("particle_grid")->isEnabled());
    click_row(table_of(f, "particle_table"), 3);
    f.prompts.saves = {f.path("three.map"), f.path("three.tum")};
    press("particle_map");
    press("particle_path");
    const auto map = ask<LandmarkMap>(f, [](const Algoritmo& run) { return run.filter().map(3); });
    QCOMPARE(Fixture::read(f.path("three.map")).toStdString(), map_to_text(map));
    const auto path = ask<Trajectory>(f, [](const Algoritmo& run) { return run.trajectory_of(3); });
    QCOMPARE(Fixture::read(f.path("three.tum")).toStdString(), trajectory_to_text(path));
    press("particle_grid");
    MapWindow* grid = f.window->result_actions().particle_window();
    QVERIFY(grid != nullptr);
    QTRY_VERIFY(!grid->builder().state().running && !grid->builder().state().path.empty());
    QVERIFY(grid->builder().state().path == path);
}

void InspectTest::a_row_that_is_deselected_stays_the_particles() {
    Fixture f;
    f.trigger("action_particles_dock");
    f.run_steps(20);
    const FiguresTable& table = table_of(f, "particle_table");
    click_row(table, 3);
    const QRect row = table.visualRect(table.currentIndex());
    QTest::mouseClick(table.viewport(), Qt::LeftButton, Qt::ControlModifier, row.center());
    QCOMPARE(table.chosen(), -1);
    f.prompts.saves = {f.path("three.map")};
    f.window->findChild<QPushButton*>("particle_map")->click();
    const auto map = ask<LandmarkMap>(f, [](const Algoritmo& run) { return run.filter().map(3); });
    QCOMPARE(Fixture::read(f.path("three.map")).toStdString(), map_to_text(map));
}

void InspectTest::a_table_that_shrinks_chooses_nothing_else() {
    Fixture f;
    f.trigger("action_landmarks_dock");
    f.run_steps(900);
    const FiguresTable& table = table_of(f, "landmark_table");
    const int last = rows_of(table).rowCount() - 1;
    click_row(table, last);
    QCOMPARE(table.chosen(), last);
    QStringList told;
    QObject::connect(&table, &FiguresTable::row_chosen, &table,
                     [&told](int row) { told << QString::number(row); });
    f.session.seek(3);
    QTRY_VERIFY(f.state() == Progress::State::paused && f.shows_everything());
    QVERIFY(rows_of(table).rowCount() < last);
    QVERIFY2(told.isEmpty(), qPrintable(told.join(' ')));
    QCOMPARE(table.chosen(), -1);
}

void InspectTest::the_ancestry_of_the_particles_is_a_layer() {
    Fixture f;
    f.trigger("action_world_frame");
    f.run_steps(60);
    QVERIFY(f.session.snapshot()->ancestry.empty());
    const QImage scan = picture_of(f.window->scan_view());
    const QImage grid = picture_of(f.window->grid_view());
    f.trigger("layer_ancestry");
    QTRY_VERIFY(f.shows_everything() && !f.session.snapshot()->ancestry.empty());
    QVERIFY(picture_of(f.window->scan_view()) != scan);
    QVERIFY(picture_of(f.window->grid_view()) != grid);
    std::uint32_t particles = 0;
    for (const HistoryBranch& branch : f.session.snapshot()->ancestry) {
        const bool newest = std::ranges::any_of(
            f.session.snapshot()->hypotheses,
            [&](const WeightedPose& particle) { return particle.pose == branch.poses.back(); });
        if (newest) particles += branch.particles;
    }
    QCOMPARE(particles, 10U);
    f.trigger("layer_ancestry");
    QTRY_VERIFY(f.shows_everything() && f.session.snapshot()->ancestry.empty());
}

void InspectTest::a_clicked_feature_tells_why() {
    Fixture f;
    f.trigger("action_world_frame");
    f.trigger("action_associations_dock");
    f.run_steps(60);
    auto* inspector = f.window->findChild<AssociationInspector*>();
    QTRY_VERIFY(inspector->record() != nullptr);
    const auto snapshot = f.session.snapshot();
    const FiguresTable& features = inspector->features();
    QCOMPARE(rows_of(features).rowCount(), static_cast<int>(snapshot->associations.size()));
    ScanView& view = f.window->scan_view();
    const QImage bare = picture_of(view);
    QTest::mouseClick(&view, Qt::LeftButton, {}, pixel_in(view, middle_of_line(*snapshot, 0)));
    const int chosen = features.chosen();
    QVERIFY(chosen >= 0);
    QVERIFY(picture_of(view) != bare);
    const Association& told = snapshot->associations[static_cast<std::size_t>(chosen)];
    QCOMPARE(told.kind, FeatureKind::line);
    const QString words = f.window->findChild<QLabel*>("association_words")->text();
    QVERIFY2(words.startsWith(outcome_words(told, snapshot->best_map, snapshot->steps)),
             qPrintable(words));
    QVERIFY2(words.contains(reason_words(told.reason)), qPrintable(words));
    QVERIFY2(words.contains("p0"), qPrintable(words));
    // All lines of the map before the scan were compared, the nearest stands first.
    const FiguresTable& candidates = inspector->candidates();
    const RecordedFeature& recorded = inspector->record()->hypotheses.at(
        inspector->record()->best)[static_cast<std::size_t>(chosen)];
    QCOMPARE(rows_of(candidates).rowCount(), static_cast<int>(recorded.compared.size()));
    QVERIFY(recorded.compared.size() > 1);
    QCOMPARE(told.outcome, Association::Outcome::matched);
    QCOMPARE(cell(candidates, 0, CandidateModel::landmark).toInt(), told.landmark + 1);
    QCOMPARE(cell(candidates, 0, CandidateModel::standing), standing_words(Standing::candidate));
    // A candidate is marked in the views.
    const QImage grid = picture_of(f.window->grid_view());
    click_row(candidates, 1);  // the first one was clicked with the feature
    QVERIFY(picture_of(f.window->grid_view()) != grid);
    // Hidden it does nothing.
    f.trigger("action_associations_dock");
    f.run_steps(1);
    QVERIFY(inspector->record() != nullptr);
    QCOMPARE(rows_of(features).rowCount(), static_cast<int>(snapshot->associations.size()));
}

void InspectTest::the_inspector_tells_of_every_algorithm_and_particle() {
    Fixture f;
    f.trigger("action_associations_dock");
    auto* inspector = f.window->findChild<AssociationInspector*>();
    auto* particle = f.window->findChild<QSpinBox*>("association_particle");
    for (const char* algorithm : {"fastslam", "ekf-slam", "graph-slam"}) {
        Configuracion configuration = Fixture::tour(10);
        configuration.filter.algorithm = algorithm;
        f.session.set_configuration(configuration);
        QVERIFY(inspector->record() == nullptr);
        f.run_steps(30);
        QTRY_VERIFY2(inspector->record() != nullptr, algorithm);
        const auto snapshot = f.session.snapshot();
        const AssociationRecord& record = *inspector->record();
        QCOMPARE(record.hypotheses.size(), snapshot->hypotheses.size());
        QCOMPARE(record.hypotheses.at(record.best).size(), snapshot->associations.size());
        QCOMPARE(particle->maximum(), static_cast<int>(snapshot->hypotheses.size()) - 1);
        particle->setValue(particle->maximum());
        inspector->choose(0);
        const RecordedFeature& feature =
            record.hypotheses.at(snapshot->hypotheses.back().from).front();
        QCOMPARE(rows_of(inspector->candidates()).rowCount(),
                 static_cast<int>(feature.compared.size()));
        const QString words = f.window->findChild<QLabel*>("association_words")->text();
        QVERIFY2(
            words.startsWith(outcome_words(feature.decision, snapshot->best_map, snapshot->steps)),
            qPrintable(words));
        particle->setValue(-1);
    }
}

void InspectTest::what_a_correction_merges_is_no_new_landmark() {
    LandmarkMap map(2);
    map[0].first_seen = 3;
    map[1].first_seen = 9;
    Association made{FeatureKind::line, 0, Association::Outcome::created,
                     Association::Reason::fits_none, 1};
    QCOMPARE(outcome_words(made, map, 10), QString("New: 2"));
    made.landmark = 0;
    QCOMPARE(outcome_words(made, map, 10), QString("New, then merged"));
    made.outcome = Association::Outcome::matched;
    QCOMPARE(outcome_words(made, map, 10), QString("Matched with 1"));
    // Of a scan that closes a loop, whose landmarks were others when it was weighed.
    Fixture f;
    f.trigger("action_associations_dock");
    auto* inspector = f.window->findChild<AssociationInspector*>();
    Configuracion configuration =
        ArchivoConfiguracion::read(Fixture::source_file("config/recorded.cfg").toStdString());
    configuration.source.file = Fixture::source_file("data/bigloop.log.gz").toStdString();
    configuration.filter.algorithm = "graph-slam";
    f.session.set_configuration(configuration);
    f.run_to_end();
    const auto& loops = f.session.snapshot()->loops;
    const auto loop = std::ranges::find_if(loops, &RunLoop::closed);
    QVERIFY(loop != loops.end());
    const std::uint64_t closing = loop->record.scan + 1;
    for (const std::uint64_t scans : {closing - 1, closing}) {
        f.session.seek(scans);
        QTRY_VERIFY(f.session.progress().steps == scans && f.shows_everything());
        QTRY_VERIFY(inspector->record() != nullptr);
        inspector->choose(0);
        const bool merged = inspector->record()->landmarks > f.session.snapshot()->best_map.size();
        QCOMPARE(merged, scans == closing);
        const QString words = f.window->findChild<QLabel*>("association_words")->text();
        QVERIFY2(words.contains("Landmarks were merged at this scan") == merged, qPrintable(words));
    }
}

/// In the scan it looks like what was matched.
void InspectTest::what_was_merged_is_marked_as_matched() {
    Fixture f;
    f.run_steps(40);
    Snapshot snapshot = *f.session.snapshot();
    const auto with_landmark = std::ranges::find_if(
        snapshot.associations, [](const Association& one) { return one.landmark >= 0; });
    QVERIFY(with_landmark != snapshot.associations.end());
    ScanView view;
    view.resize(500, 400);
    const auto seen_as = [&](Association::Outcome outcome, std::uint64_t first_seen) {
        with_landmark->outcome = outcome;
        auto& landmark = snapshot.best_map[static_cast<std::size_t>(with_landmark->landmark)];
        landmark.first_seen = static_cast<decltype(landmark.first_seen)>(first_seen);
        view.set_snapshot(std::make_shared<const Snapshot>(snapshot));
        return picture_of(view);
    };
    const QImage created = seen_as(Association::Outcome::created, snapshot.steps - 1);
    const QImage merged = seen_as(Association::Outcome::created, 3);
    QVERIFY(merged != created);
    QCOMPARE(merged, seen_as(Association::Outcome::matched, 3));
}

void InspectTest::weighing_again_leaves_the_run_as_it_was() {
    Fixture f;
    f.trigger("action_associations_dock");
    auto* inspector = f.window->findChild<AssociationInspector*>();
    f.run_steps(100000);  // to the end
    QTRY_VERIFY(inspector->record() != nullptr);
    QCOMPARE(f.state(), Progress::State::finished);
    const auto inspected =
        ask<Trajectory>(f, [](const Algoritmo& run) { return run.best_trajectory(); });
    f.trigger("action_associations_dock");
    f.trigger("action_restart");
    f.run_steps(100000);  // to the end
    QVERIFY(inspected ==
            ask<Trajectory>(f, [](const Algoritmo& run) { return run.best_trajectory(); }));
}

}  // namespace hitos::window
