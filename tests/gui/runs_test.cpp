// SPDX-License-Identifier: GPL-3.0-or-later
// Runs stay, and two of them can be compared.

#include "runs/runs.hpp"

#include <qcustomplot.h>

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QDialogButtonBox>
#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "actions/command_line.hpp"
#include "dialogs/export_dialog.hpp"
#include "dialogs/source_dialog.hpp"
#include "gui_fixture.hpp"
#include "look/theme.hpp"
#include "look/words_of.hpp"
#include "runs_fixture.hpp"
#include "tests.hpp"
#include "views/canvas_paint.hpp"

namespace hitos::window {
namespace {

void run_two_logs(RunsFixture& f) {
    f.run_steps(40);
    Configuracion other = f.session.configuration();
    other.source.file = Fixture::source_file("data/bigloop-noisy.log.gz").toStdString();
    f.session.set_configuration(other);
    f.run_steps(40);
}

}  // namespace

void RunsTest::runs_that_are_left_stay_in_the_list() {
    RunsFixture f;
    run_thrice(f);
    QCOMPARE(f.rows(), 3);
    QCOMPARE(f.cell(0, RunsModel::scans), "40");
    QCOMPARE(f.cell(1, RunsModel::scans), "80");
    QCOMPARE(f.cell(0, RunsModel::different), "");
    QVERIFY2(f.cell(1, RunsModel::different).endsWith(" 10"), qPrintable(f.cell(1, 2)));
    QVERIFY2(f.cell(2, RunsModel::different).endsWith(" 20"), qPrintable(f.cell(2, 2)));
    const KeptRun& first = *f.list().runs()[1].run;
    QCOMPARE(first.path.size(), std::size_t{80});
    QCOMPARE(f.cell(1, RunsModel::landmarks), QString::number(first.map.size()));
    QVERIFY(first.seconds > 0.0);
    // A new start is another run; the same one again is not.
    f.trigger("action_restart");
    QCOMPARE(f.rows(), 4);
    f.run_steps(40);
    f.trigger("action_restart");
    QCOMPARE(f.rows(), 4);
    f.run_steps(1);
    f.trigger("action_restart");
    QCOMPARE(f.rows(), 4);  // of one scan there is nothing to see
}

void RunsTest::what_is_kept_is_the_run_to_the_last_bit() {
    RunsFixture f;
    f.run_steps(90);
    const auto snapshot = f.session.snapshot();
    f.change(11);
    const KeptRun& kept = *f.list().runs().back().run;
    QCOMPARE(kept.configuration.filter.particles, 10);
    QVERIFY(kept.path == snapshot->best_trajectory);
    QVERIFY(kept.odometry == snapshot->odometry_trajectory);
    QCOMPARE(kept.map.size(), snapshot->best_map.size());
    QVERIFY(kept.grid.tiles == snapshot->step_grid.tiles);
}

void RunsTest::a_finished_run_is_another_than_one_at_its_last_scan() {
    RunsFixture f;
    f.run_to_end();
    f.trigger("action_restart");
    f.session.seek(1050);
    QTRY_VERIFY(f.state() == Progress::State::paused && f.shows_everything());
    QCOMPARE(f.steps(), quint64{1050});
    f.trigger("action_restart");
    const std::vector<ListedRun> runs = f.list().runs();
    QCOMPARE(runs.size(), std::size_t{3});
    QVERIFY(runs[1].run->finished && !runs[2].run->finished);
    QCOMPARE(runs[1].run->scans, runs[2].run->scans);
}

void RunsTest::a_finished_run_stays_so_when_one_looks_back() {
    RunsFixture f;
    f.run_to_end();
    const std::shared_ptr<const Snapshot> end = f.session.snapshot();
    f.session.seek(180);
    QTRY_VERIFY(f.steps() == 180U && f.shows_everything());
    f.trigger("action_restart");
    const KeptRun& kept = *f.list().runs().back().run;
    QVERIFY(kept.finished);
    QCOMPARE(kept.scans, end->steps);
    QVERIFY(kept.path == end->best_trajectory && kept.grid.tiles == end->step_grid.tiles);
    // The next one of the same log is another run.
    f.run_steps(20);
    f.change(11);
    QVERIFY(!f.list().runs().back().run->finished);
    QCOMPARE(f.list().runs().back().run->scans, 20U);
}

void RunsTest::runs_of_two_logs_are_told_apart() {
    RunsFixture f;
    run_two_logs(f);
    f.trigger("action_compare");
    CompareWindow& comparison = f.comparison();
    comparison.choose(1, {1, false});
    const QString said = comparison.findChild<QLabel*>("compare_verdict")->text();
    QVERIFY2(said.contains("bigloop.log.gz") && said.contains("bigloop-noisy.log.gz"),
             qPrintable(said));
}

void RunsTest::errors_are_measured_by_the_references() {
    RunsFixture f;
    run_thrice(f);
    QCOMPARE(f.cell(1, RunsModel::path_error), "–");
    References references;
    references.trajectory = f.list().runs()[1].run->path;
    references.map = f.list().runs()[1].run->map;
    f.session.set_references(references);
    QCOMPARE(f.cell(1, RunsModel::path_error), "0.000 m");
    QCOMPARE(f.cell(1, RunsModel::map_error), "0.000 m");
    QVERIFY(f.cell(2, RunsModel::path_error) != "–");
    QVERIFY(f.cell(2, RunsModel::path_error) != "0.000 m");
    f.session.set_references({});
    for (const int row : {1, 2}) {
        QCOMPARE(f.cell(row, RunsModel::path_error), "–");
        QCOMPARE(f.cell(row, RunsModel::map_error), "–");
    }
}

void RunsTest::errors_stay_while_another_log_is_there() {
    RunsFixture f;
    f.trigger("action_runs_dock");
    f.run_steps(40);
    const Configuracion first = f.session.configuration();
    References references;
    references.trajectory = f.session.snapshot()->odometry_trajectory;
    f.session.set_references(references);
    Configuracion other = first;
    other.source.file = Fixture::source_file("data/bigloop-noisy.log.gz").toStdString();
    f.session.set_configuration(other);
    const QString measured = f.cell(1, RunsModel::path_error);
    QVERIFY2(measured.endsWith(" m"), qPrintable(measured));
    const auto compared_with = [&f] { return f.list().reference_of(*f.list().runs()[1].run); };
    QVERIFY(compared_with() != nullptr);  // as Compare asks
    QVERIFY(*compared_with() == *references.trajectory);
    f.session.set_configuration(first);  // and back, where nothing is loaded now
    QCOMPARE(f.cell(1, RunsModel::path_error), measured);
    QVERIFY(compared_with() != nullptr);
    // Other references measure it anew, and none take that away.
    f.session.set_references(references);
    QCOMPARE(f.cell(1, RunsModel::path_error), measured);
    f.session.set_references({});
    QCOMPARE(f.cell(1, RunsModel::path_error), "–");
    QVERIFY(compared_with() == nullptr);
}

void RunsTest::paths_of_chosen_runs_are_in_the_grid_map() {
    RunsFixture f;
    run_thrice(f);
    const QImage before = seen(f.window->grid_view());
    f.panel().table().choose_rows({1, 2});
    QCOMPARE(f.panel().chosen().size(), std::size_t{2});
    const QImage with_both = seen(f.window->grid_view());
    QVERIFY(with_both != before);
    f.panel().table().choose_rows({1});
    QVERIFY(seen(f.window->grid_view()) != with_both);
    f.trigger("action_runs_dock");  // hidden, it draws nothing
    const QImage hidden = seen(f.window->grid_view());
    f.panel().table().choose_rows({});
    QCOMPARE(seen(f.window->grid_view()), hidden);
}

void RunsTest::a_run_can_be_removed_and_its_configuration_used() {
    RunsFixture f;
    run_thrice(f);
    QVERIFY(!f.enabled("runs_remove"));
    QVERIFY(!f.enabled("runs_use"));
    f.panel().table().choose_rows({2});
    QVERIFY(f.enabled("runs_use"));
    f.press("runs_use");
    QCOMPARE(f.session.configuration().filter.particles, 20);
    QCOMPARE(f.rows(), 4);  // the one that was left is kept too
    f.panel().table().choose_rows({1, 3});
    f.press("runs_remove");
    QCOMPARE(f.rows(), 2);
    QCOMPARE(f.list().runs().back().run->configuration.filter.particles, 20);
    f.panel().table().choose_rows({0});
    QVERIFY(!f.enabled("runs_remove"));  // that of the window stays
}

void RunsTest::two_runs_are_side_by_side_under_one_camera() {
    RunsFixture f;
    run_thrice(f);
    CompareWindow& comparison = compare_first_two(f);
    GridView& left = comparison.view(0);
    GridView& right = comparison.view(1);
    QVERIFY(left.isVisible() && right.isVisible());
    QTRY_COMPARE(left.camera().centre, right.camera().centre);
    const double before = right.camera().pixels_per_m;
    left.zoom(2.0);
    QCOMPARE(left.camera().pixels_per_m, 2.0 * before);
    QCOMPARE(right.camera().pixels_per_m, 2.0 * before);
    QTest::keyClick(&right, Qt::Key_A);
    QCOMPARE(left.camera().centre, right.camera().centre);
    right.fit();
    QCOMPARE(left.camera().pixels_per_m, before);
    QVERIFY2(comparison.findChild<QLabel*>("compare_verdict")->text().contains("20"),
             qPrintable(comparison.findChild<QLabel*>("compare_verdict")->text()));
    QVERIFY(seen(left) != seen(right));
}

void RunsTest::two_runs_lie_over_each_other_or_blink() {
    RunsFixture f;
    run_thrice(f);
    CompareWindow& comparison = compare_first_two(f);
    comparison.set_mode(CompareWindow::Mode::overlaid);
    QVERIFY(!comparison.view(1).isVisible());
    // The one view has the whole width.
    QTRY_VERIFY(comparison.view(0).width() > 3 * comparison.width() / 4);
    const QImage overlaid = seen(comparison.view(0));
    comparison.set_mode(CompareWindow::Mode::blinking);
    const QImage first = seen(comparison.view(0));
    QVERIFY(first != overlaid);
    QTRY_VERIFY(seen(comparison.view(0)) != first);
    QTRY_VERIFY(seen(comparison.view(0)) == first);
    comparison.set_mode(CompareWindow::Mode::side_by_side);
    QVERIFY(comparison.view(1).isVisible());
}

void RunsTest::a_run_is_compared_with_its_odometry() {
    RunsFixture f;
    f.run_steps(150);
    f.trigger("action_compare");
    CompareWindow& comparison = f.comparison();
    QTRY_VERIFY(!comparison.building());
    QTRY_VERIFY(!comparison.view(1).tiles().empty());
    QVERIFY(comparison.view(0).tiles().tiles != comparison.view(1).tiles().tiles);
    // The picture of this run follows it.
    const QImage before = seen(comparison.view(0));
    f.run_steps(150);
    QVERIFY(seen(comparison.view(0)) != before);
}

void RunsTest::figures_are_hidden_at_first_and_need_a_reference() {
    RunsFixture f;
    run_thrice(f);
    CompareWindow& comparison = compare_first_two(f);
    auto* strip = comparison.findChild<ErrorStrip*>("compare_figures");
    QVERIFY(!strip->isVisible());
    const QImage plain = seen(comparison.view(0));
    figures_button(comparison)->click();
    QVERIFY(strip->isVisible());
    // Nothing to plot: words alone, of what is missing and what helps.
    QVERIFY(!strip->findChild<QCustomPlot*>()->isVisible());
    for (const char* side : {"figures_0", "figures_1"}) {
        const QString said = strip->findChild<QLabel*>(side)->text();
        QVERIFY2(said.contains("bigloop.log.gz") && said.contains("Load reference trajectory"),
                 qPrintable(said));
    }
    f.session.set_references(moved_path_of_the_first(f));
    QVERIFY(strip->findChild<QCustomPlot*>()->isVisible());
    QCOMPARE(strip->curve(1).size(), std::size_t{80});
    f.session.set_references({});
    QVERIFY(!strip->findChild<QCustomPlot*>()->isVisible());
    QVERIFY(strip->curve(1).empty());
    // A window that opens later remembers it.
    comparison.close();
    QTRY_VERIFY(f.window->runs().comparison() == nullptr);
    CompareWindow& next = compare_first_two(f);
    QVERIFY(next.findChild<ErrorStrip*>("compare_figures")->isVisible());
    figures_button(next)->click();
    QVERIFY(!next.findChild<ErrorStrip*>("compare_figures")->isVisible());
    QTRY_COMPARE(seen(next.view(0)), plain);
}

void RunsTest::figures_are_those_of_the_services() {
    RunsFixture f;
    run_thrice(f);
    const References references = moved_path_of_the_first(f);
    f.session.set_references(references);
    const Trajectory reference = references.trajectory.value();
    const Trajectory path = f.list().runs()[2].run->path;
    const auto whole = trajectory_error(path, reference);
    const auto relative = relative_error(path, reference, PairSpacing{});
    QVERIFY(whole && relative && whole->rmse_m > 0.001);
    CompareWindow& comparison = compare_first_two(f);
    comparison.show_figures(true);
    auto* strip = comparison.findChild<ErrorStrip*>("compare_figures");
    const QString said = strip->findChild<QLabel*>("figures_1")->text();
    for (const QString& figure :
         {metre_words(whole->rmse_m), metre_words(whole->mean_m), metre_words(whole->maximum_m),
          degree_words(whole->heading_rmse_rad.value()), metre_words(relative->translation_m.rmse),
          degree_words(relative->rotation_rad.rmse), QString("80")}) {
        QVERIFY2(said.contains(figure), qPrintable(said + " lacks " + figure));
    }
    const auto expect = [&](const std::vector<PathError>& errors, bool by_way) {
        const std::vector<QPointF> curve = strip->curve(1);
        QCOMPARE(curve.size(), errors.size());
        for (std::size_t i = 0; i < curve.size(); ++i) {
            QCOMPARE(curve[i].x(),
                     by_way ? errors[i].way_m : errors[i].time_s - path.front().time_s);
            QCOMPARE(curve[i].y(), errors[i].error_m);
        }
    };
    expect(path_errors(path, reference, whole->pose_reference_estimate), false);
    strip->findChild<QComboBox*>("figures_along")->setCurrentIndex(1);
    expect(path_errors(path, reference, whole->pose_reference_estimate), true);
    strip->findChild<QCheckBox*>("figures_aligned")->click();
    expect(path_errors(path, reference), true);
    // The left one is the reference, wherever that lies.
    for (const QPointF& point : strip->curve(0)) QVERIFY(point.y() < 1e-6);
}

void RunsTest::the_errors_of_more_than_two_lie_over_each_other() {
    RunsFixture f;
    run_thrice(f);
    f.session.set_references(moved_path_of_the_first(f));
    const std::vector<ListedRun> runs = f.list().runs();
    f.panel().table().choose_rows({0, 1, 2});
    f.press("runs_compare");
    CompareWindow& comparison = f.comparison();
    comparison.show_figures(true);
    auto* strip = comparison.findChild<ErrorStrip*>("compare_figures");
    for (std::size_t place = 0; place < 3; ++place) {
        const std::vector<QPointF> curve = strip->curve(place);
        const auto wanted =
            path_figures(runs[place].run->path, {}, *f.session.references().trajectory, true);
        QCOMPARE(curve.size(), wanted.errors.size());
        QCOMPARE(curve.back().y(), wanted.errors.back().error_m);
        const auto* words = strip->findChild<QLabel*>(QString("figures_%1").arg(place));
        QVERIFY(words->text().startsWith(name_of(runs[place])));
    }
    // The reference, which is in another frame, is laid where the errors are reckoned: as far from
    // the path, pose by pose.
    for (const bool aligned : {true, false}) {
        const Trajectory& path = runs[0].run->path;
        const Trajectory& reference = *f.session.references().trajectory;
        const auto laid = path_figures(path, {}, reference, aligned);
        QCOMPARE(laid.reference.size(), reference.size());
        for (const PathError& error : laid.errors) {
            const Pose& pose = path[error.pose].pose;
            const QPointF away = laid.reference[error.pose] - QPointF(pose.x, pose.y);
            QVERIFY(std::abs(std::hypot(away.x(), away.y()) - error.error_m) < 1e-9);
        }
    }
    // Laid over, the third one's path is there as well, until that run is removed.
    comparison.show_figures(false);  // whose scale of colours is that of all
    comparison.set_mode(CompareWindow::Mode::overlaid);
    const QImage all = seen(comparison.view(0));
    // Chosen as a side it leaves the others its place, and none is there twice.
    comparison.choose(1, {runs[2].number, false});
    comparison.choose(1, {runs[1].number, false});
    QCOMPARE(seen(comparison.view(0)), all);
    f.list().remove(runs[2].number);
    QVERIFY(strip->findChild<QLabel*>("figures_2") == nullptr);
    QTRY_VERIFY(!comparison.building());
    QVERIFY(seen(comparison.view(0)) != all);
    // Another choice of two has no third.
    comparison.show_figures(true);
    comparison.compare({runs[0], runs[1]});
    QVERIFY(strip->curve(0).size() == 40 && strip->curve(1).size() == 80);
    // Where a side's run goes, nothing is compared with itself.
    comparison.compare({runs[1], runs[0]});
    f.list().remove(runs[1].number);
    QCOMPARE(comparison.findChild<QComboBox*>("compare_left")->currentData().toPoint(),
             QPoint(0, 1));
}

void RunsTest::paths_have_the_colours_of_their_errors() {
    RunsFixture f;
    run_thrice(f);
    f.session.set_references(moved_path_of_the_first(f));
    CompareWindow& comparison = compare_first_two(f);
    comparison.show_figures(true);
    // The left one is nowhere off; the greatest error is the right one's. Where it has just that
    // there may be a mark.
    const std::vector<QColor> least{heat_colour(0.0)};
    std::vector<QColor> most;
    for (int i = 0; i <= 20; ++i) most.push_back(heat_colour(0.75 + 0.25 * i / 20.0));
    const auto has = [](const QImage& image, const std::vector<QColor>& wanted) {
        for (int y = image.height() / 4; y < image.height(); ++y) {  // below the legend
            for (int x = 0; x < image.width(); ++x) {
                const QRgb there = image.pixel(x, y);
                for (const QColor& colour : wanted) {
                    const int away = std::abs(qRed(there) - colour.red()) +
                                     std::abs(qGreen(there) - colour.green()) +
                                     std::abs(qBlue(there) - colour.blue());
                    if (away < 12) return true;
                }
            }
        }
        return false;
    };
    QTRY_VERIFY(has(seen(comparison.view(0)), least));
    QVERIFY(!has(seen(comparison.view(0)), most));
    QTRY_VERIFY(has(seen(comparison.view(1)), most));
    comparison.set_mode(CompareWindow::Mode::overlaid);
    QTRY_VERIFY(has(seen(comparison.view(0)), most));
    comparison.show_figures(false);
    QTRY_VERIFY(!has(seen(comparison.view(0)), most));
    comparison.show_figures(true);
    comparison.set_mode(CompareWindow::Mode::blinking);
    QTRY_VERIFY(has(seen(comparison.view(0)), most));
    QTRY_VERIFY(!has(seen(comparison.view(0)), most));
}

void RunsTest::a_run_of_another_log_has_no_figures() {
    RunsFixture f;
    run_two_logs(f);
    References references;
    references.trajectory = f.session.snapshot()->odometry_trajectory;
    f.session.set_references(references);
    f.trigger("action_compare");
    CompareWindow& comparison = f.comparison();
    comparison.choose(0, {0, false});
    comparison.choose(1, {1, false});
    comparison.show_figures(true);
    auto* strip = comparison.findChild<ErrorStrip*>("compare_figures");
    QCOMPARE(strip->curve(0).size(), std::size_t{40});
    QVERIFY(strip->curve(1).empty());
    const QString said = strip->findChild<QLabel*>("figures_1")->text();
    QVERIFY2(said.contains("bigloop.log.gz"), qPrintable(said));
    // What is shown follows the run.
    f.run_steps(20);
    QTRY_COMPARE(strip->findChild<QLabel*>("figures_0")->text().count("40"), 1);
    references.trajectory = f.session.snapshot()->odometry_trajectory;
    f.session.set_references(references);
    QCOMPARE(strip->curve(0).size(), std::size_t{60});
    // A reference of another time tells nothing.
    for (StampedPose& stamped : *references.trajectory) stamped.time_s += 1e6;
    f.session.set_references(references);
    QVERIFY(strip->curve(0).empty());
    QVERIFY(strip->findChild<QLabel*>("figures_0")->text().contains("bigloop-noisy.log.gz"));
}

void RunsTest::the_plot_of_the_errors_is_saved() {
    RunsFixture f;
    run_thrice(f);
    f.session.set_references(moved_path_of_the_first(f));
    CompareWindow& comparison = compare_first_two(f);
    comparison.show_figures(true);
    const auto* strip = comparison.findChild<ErrorStrip*>("compare_figures");
    in_dialog<ExportDialog>([](ExportDialog& dialog) { dialog.accept(); });
    f.prompts.saves = {f.path("errors.pdf")};
    strip->findChild<QPushButton*>()->click();
    QVERIFY(Fixture::read(f.path("errors.pdf")).startsWith("%PDF"));
    QVERIFY2(f.prompts.starts.back().contains("path-errors"), qPrintable(f.prompts.starts.back()));
    // A right click copies it.
    QApplication::clipboard()->clear();
    auto* plot = strip->findChild<QCustomPlot*>();
    const QPoint middle = plot->rect().center();
    QContextMenuEvent click(QContextMenuEvent::Mouse, middle, plot->mapToGlobal(middle));
    QApplication::sendEvent(plot, &click);
    auto* menu = strip->findChild<QMenu*>();
    QVERIFY(menu != nullptr && menu->actions().size() == 2);
    menu->actions().front()->trigger();
    menu->close();
    QVERIFY(QApplication::clipboard()->image().width() > plot->width());
    // And the views still are saved.
    in_dialog<ExportDialog>([](ExportDialog& dialog) { dialog.accept(); });
    f.prompts.saves = {f.path("view.png")};
    emit comparison.view(1).picture_wanted();
    QVERIFY(!QImage(f.path("view.png")).isNull());
}

void RunsTest::a_folder_of_results_is_opened() {
    RunsFixture f;
    f.run_steps(120);
    const LandmarkMap map = f.session.snapshot()->best_map;
    f.save_results("results");
    const QString folder = f.path("results");
    f.change(25);
    f.run_steps(20);
    for (const ListedRun& listed : f.list().runs()) f.list().remove(listed.number);
    f.prompts.folders = {folder};
    f.trigger("action_open_results");
    QCOMPARE(f.prompts.warnings, QStringList());
    QVERIFY(f.panel().isVisible());
    QCOMPARE(f.rows(), 2);
    QCOMPARE(f.cell(1, RunsModel::scans), "120");
    QCOMPARE(f.cell(1, RunsModel::landmarks), QString::number(map.size()));
    QVERIFY(f.cell(1, RunsModel::different).endsWith(" 10"));
    // Its grid is made from the log.
    CompareWindow& comparison = f.comparison();
    QTRY_VERIFY(!comparison.building() && !comparison.view(0).tiles().empty());
    // Dropped, or named on the command line, it is opened too.
    f.window->configuration_actions().open(folder);
    QCOMPARE(f.rows(), 2);
    CommandLine line;
    line.open = folder.toStdString();
    QCOMPARE(starting_configuration(line, f.files).filter.particles, 10);
}

void RunsTest::a_map_is_gone_on_with() {
    RunsFixture f(false);
    Configuracion mapped =
        ArchivoConfiguracion::read(Fixture::source_file("config/recorded.cfg").toStdString());
    mapped.source.file = Fixture::source_file("data/bigloop.log.gz").toStdString();
    mapped.filter.particles = 3;
    mapped.registration.edits = "slip 50";
    f.session.set_configuration(mapped);
    f.run_to_end();
    f.save_results("mapped");
    // With the run's parameters, whatever the window has now.
    f.session.set_configuration(
        ArchivoConfiguracion::read(Fixture::source_file("config/thesis.cfg").toStdString()));
    f.prompts.folders = {f.path("mapped")};
    in_dialog<SourceDialog>([](SourceDialog& dialog) {
        dialog.set_path(Fixture::source_file("data/bigloop.log.gz"));
        const auto& fields = dialog.findChildren<QLineEdit*>();
        const auto start = std::ranges::find_if(
            fields, [](const QLineEdit* line) { return line->objectName().contains("start"); });
        QVERIFY(start != fields.end() && (*start)->isVisible());
        QTest::keyClicks(*start, "0,0,0");
        QTRY_COMPARE(QString::fromStdString(dialog.source().start), QString("0,0,0"));
        auto* ok = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        QTRY_VERIFY_WITH_TIMEOUT(ok->isEnabled(), 20000);
        const QString verdict = dialog.findChild<QLabel*>("verdict")->text();
        QVERIFY2(verdict.contains("the tour that the map of"), qPrintable(verdict));
        ok->click();
    });
    f.trigger("action_go_on");
    QCOMPARE(f.prompts.warnings, QStringList());
    const Configuracion& now = f.session.configuration();
    QCOMPARE(QString::fromStdString(now.source.map), f.path("mapped"));
    QCOMPARE(QString::fromStdString(now.source.start), QString("0,0,0"));
    QCOMPARE(now.filter.particles, 3);
    f.run_to_end();
    QCOMPARE(f.steps(), 2 * 1050);
    const RegistrationFigures told =
        f.session.worker()
            ->with_run([](const Algoritmo& run) { return run.registration()->figures(); })
            .get();
    QCOMPARE(told.later_tours.size(), 1U);
    QVERIFY(told.later_tours.front().found.has_value());
    const QString found = QString("at scan %1").arg(*told.later_tours.front().found + 1);
    const auto* state = f.window->findChild<QLabel*>("status_state");
    QTRY_VERIFY2(
        state->toolTip().contains("Found in the map after") && state->toolTip().contains(found),
        qPrintable(state->toolTip()));
    Configuracion held = now;
    held.source.hold = true;
    f.session.set_configuration(held);
    f.window->configuration_actions().use_edits("slip 12");
    QCOMPARE(f.prompts.warnings.size(), 1);
    QVERIFY2(f.prompts.warnings.takeFirst().contains("\"slip 12\" is of the map of"),
             "the map stays as it is");
    QVERIFY(f.session.configuration().registration.edits.starts_with("slip 50"));

    // The command line has the same.
    CommandLine line;
    line.open = mapped.source.file;
    line.values.map = f.path("mapped").toStdString();
    line.values.localise = true;
    const Configuracion localised = starting_configuration(line, f.files);
    QVERIFY(localised.source.hold);
    QCOMPARE(localised.filter.particles, 3);
    QCOMPARE(localised.source.map, line.values.map);
    QVERIFY(localised.registration.edits.starts_with("slip 50"));
    // A folder of nothing is none.
    f.prompts.folders = {f.path("user")};
    f.trigger("action_go_on");
    QCOMPARE(f.prompts.warnings.size(), 1);
    // Nor is one that was changed by hand.
    QFile settings(f.path("mapped/config.cfg"));
    QVERIFY(settings.open(QIODevice::Append));
    settings.write("# mine\n");
    settings.close();
    f.prompts.folders = {f.path("mapped")};
    f.trigger("action_go_on");
    QCOMPARE(f.prompts.warnings.size(), 2);
    QVERIFY(f.prompts.warnings.back().contains("is not the file that summary.json beside it"));
}

void RunsTest::a_folder_without_results_is_told() {
    RunsFixture f;
    f.prompts.folders = {f.path("user")};
    f.trigger("action_open_results");
    QCOMPARE(f.prompts.warnings.size(), 1);
    QVERIFY2(f.prompts.warnings[0].contains("summary.json"), qPrintable(f.prompts.warnings[0]));
    QCOMPARE(f.rows(), 1);
    QVERIFY(f.window->runs().comparison() == nullptr);
}

void RunsTest::results_without_their_log_are_shown_without_grid() {
    RunsFixture f;
    f.run_steps(60);
    f.save_results("results");
    const QString folder = f.path("results");
    QByteArray text = Fixture::read(folder + "/config.cfg");
    text.replace("bigloop.log.gz", "lost.log.gz");
    f.write("results/config.cfg", text);
    // The summary knows the file as it was, unless it is an older one.
    QJsonObject summary = QJsonDocument::fromJson(Fixture::read(folder + "/summary.json")).object();
    f.change(25);
    f.prompts.folders = {folder, folder};
    f.trigger("action_open_results");
    QCOMPARE(f.prompts.warnings.size(), 1);
    QVERIFY2(f.prompts.warnings.takeFirst().contains("config.cfg"), "names the file");
    summary.remove("files");
    summary.remove("rest_xxh3_128");
    f.write("results/summary.json", QJsonDocument(summary).toJson());
    f.trigger("action_open_results");
    QCOMPARE(f.prompts.warnings, QStringList());
    CompareWindow& comparison = f.comparison();
    QTRY_VERIFY(!comparison.building());
    QVERIFY(comparison.view(0).tiles().empty());
    const QString said = comparison.findChild<QLabel*>("compare_verdict")->text();
    QVERIFY2(said.contains("lost.log.gz"), qPrintable(said));
    const QImage picture = seen(comparison.view(0));
    comparison.choose(0, {0, false});
    QVERIFY(seen(comparison.view(0)) != picture);
}

}  // namespace hitos::window
