// SPDX-License-Identifier: GPL-3.0-or-later
// Use case 8.2.2.11 from the window: the study of a parameter.

#include <qcustomplot.h>

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSpinBox>

#include "dialogs/configuration_dialog.hpp"
#include "dialogs/export_dialog.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/study/study_values.hpp"
#include "look/written_number.hpp"
#include "study_fixture.hpp"
#include "tests.hpp"
#include "views/study_plots.hpp"

namespace hitos::window {
namespace {

/// So many runs that none of these tests, however slow its machine, sees the last of them.
constexpr int kEndless = 10000;

}  // namespace

void StudyTest::a_study_needs_a_source() {
    Fixture f(false);
    QVERIFY(!f.action("action_study")->isEnabled());
}

void StudyTest::its_files_are_those_of_the_command_line() {
    StudyFixture f;
    f.run_study();
    QVERIFY2(f.verdict().contains("4 of 4"), qPrintable(f.verdict()));
    QCOMPARE(f.study.plots().means(), 2);
    compare_folders(f.path("study"), f.command_line_study());
}

void StudyTest::noise_seed_and_threads_are_those_of_the_command_line() {
    StudyFixture f;
    f.study.findChild<QDoubleSpinBox*>("noise")->setValue(0.1);
    f.study.findChild<QSpinBox*>("threads")->setValue(1);
    f.set("seed", "7");
    f.run_study();
    compare_folders(f.path("study"), f.command_line_study({"--odometry-noise", "0.1", "--seed", "7",
                                                           "--threads", "2"}));
}

void StudyTest::without_reference_grids_are_measured_and_shown() {
    StudyFixture f;
    f.set("reference", "");
    f.set("values", "0.02");
    f.study.findChild<QCheckBox*>("pictures")->setChecked(true);
    f.run_study();
    QVERIFY2(f.verdict().contains("2 of 2"), qPrintable(f.verdict()));
    QVERIFY(f.error_at("reference").isEmpty());
    QCOMPARE(f.study.plots().means(), 1);
    QVERIFY2(f.study.plots().quality_title().startsWith("Blur"),
             qPrintable(f.study.plots().quality_title()));
    QVERIFY(!QImage(f.path("study/contact-sheet.png")).isNull());
    QVERIFY(QFile::exists(f.path("study/pictures/dmax-0.02-s1.png")));
    QVERIFY(!QFile::exists(f.path("study/error.dat")));
}

void StudyTest::the_true_path_of_the_session_is_used() {
    StudyFixture f;
    Trajectory truth;
    for (int i = 0; i < 1000; ++i) truth.push_back({0.1 * i, {0.01 * i, 0.0, 0.0}});
    References references;
    references.trajectory = truth;
    f.session.set_references(references);
    f.set("reference", "");
    f.set("values", "0.02");
    f.run_study();
    QVERIFY2(f.study.plots().quality_title().startsWith("Trajectory error"),
             qPrintable(f.verdict()));
}

void StudyTest::other_figures_can_be_looked_at() {
    StudyFixture f;
    Configuracion world = f.session.configuration();
    world.source.file = Fixture::source_file("data/worlds/recinto.toml").toStdString();
    world.source.world_set = "laser.rate=1 tour.laps=1";
    f.session.set_configuration(world);
    f.set("reference", Fixture::source_file("data/maps/recinto.map"));
    f.set("values", "0.02, 0.05");
    f.run_study();
    StudyPlots& plots = f.study.plots();
    auto* figure = plots.findChild<QComboBox*>("study_figure");
    QVERIFY2(figure->isVisibleTo(&plots), qPrintable(f.verdict()));
    QCOMPARE(figure->currentText(), QString("Map error"));
    const auto show = [&](const QString& name) {
        const int place = figure->findText(name);
        QVERIFY2(place >= 0, qPrintable(name));
        figure->setCurrentIndex(place);
        emit figure->activated(place);
        QCOMPARE(figure->currentText(), name);
        QVERIFY(plots.quality_title().startsWith(name));
        QCOMPARE(plots.means(), 2);
        plots.choose(0);
        QVERIFY(plots.words_of_cell(0).contains(name + ": "));
    };
    show("Trajectory error");
    show("True poses in the region of 95 %");
    QVERIFY(plots.quality_title().contains("dashed: 0.95, as it ought to be"));
    // Of another study too, which has it.
    f.study.form().set_assignments({"dmax=0.02,0.05", "p=5,6"});
    f.set("folder", f.path("pairs"));
    f.run_study();
    QVERIFY2(f.verdict().contains("8 of 8"), qPrintable(f.verdict()));
    QCOMPARE(figure->currentText(), QString("True poses in the region of 95 %"));
    QCOMPARE(plots.means(), 4);
}

void StudyTest::expected_and_seen_shares_are_a_plot() {
    StudyFixture f;
    const auto combo = [&f] { return f.study.plots().findChild<QComboBox*>("study_figure"); };
    const QString calibration = "Calibration: expected and seen shares";
    f.run_study();
    QCOMPARE(combo()->findText(calibration), -1);  // of a log the truth is not known
    Configuracion world = f.session.configuration();
    world.source.file = Fixture::source_file("data/worlds/recinto.toml").toStdString();
    world.source.world_set = "laser.rate=1 tour.laps=1";
    f.session.set_configuration(world);
    f.set("reference", Fixture::source_file("data/maps/recinto.map"));
    f.study.form().set_assignments({"p=5,50,100"});
    f.set("folder", f.path("world"));
    f.run_study();
    QVERIFY2(f.verdict().contains("6 of 6"), qPrintable(f.verdict()));
    StudyPlots& plots = f.study.plots();
    const int place = combo()->findText(calibration);
    QVERIFY(place > 0);
    combo()->setCurrentIndex(place);
    emit combo()->activated(place);
    QCOMPARE(combo()->currentText(), calibration);
    const auto shown = [&plots]() -> QCustomPlot& {
        for (auto* plot : plots.findChildren<QCustomPlot*>())
            if (plot->isVisibleTo(&plots)) return *plot;
        qFatal("no plot");
    };
    // What gnuplot's picture has: of each value a block of the shares, region by region.
    const QStringList blocks =
        QString(Fixture::read(f.path("world/calibration.dat"))).split("\n\n\n");
    QCOMPARE(blocks.size(), 3);
    const QList<QCPAxisRect*> panels = shown().axisRects();
    QCOMPARE(panels.size(), 3);
    for (int kind = 0; kind < 3; ++kind) {
        const QList<QCPGraph*> lines = panels[kind]->graphs();
        QCOMPARE(lines.size(), 4);  // the diagonal, and a line of each value
        QCOMPARE(lines[0]->data()->at(0)->key, lines[0]->data()->at(0)->value);
        for (int cell = 0; cell < 3; ++cell) {
            QStringList rows = blocks[cell].split('\n', Qt::SkipEmptyParts);
            rows.removeIf([](const QString& row) { return row.startsWith('#'); });
            QCOMPARE(lines[cell + 1]->dataCount(), rows.size());
            QCOMPARE(lines[cell + 1]->name(), QStringList({"p=5", "p=50", "p=100"})[cell]);
            for (int region = 0; region < rows.size(); ++region) {
                const QStringList told = rows[region].split(' ');
                const QCPGraphData& point = *lines[cell + 1]->data()->at(region);
                QCOMPARE(point.key, told[0].toDouble());
                QCOMPARE(point.value, told[1 + kind].toDouble());
            }
        }
    }
    // A click on a line chooses its value, and so do the arrow keys.
    shown().replot();
    const QCPGraph& line = *panels[0]->graphs()[2];
    const QCPGraphData& point = *line.data()->at(0);
    QTest::mouseClick(&shown(), Qt::LeftButton, Qt::NoModifier,
                      line.coordsToPixels(point.key, point.value).toPoint());
    QCOMPARE(plots.chosen(), std::optional<std::size_t>(1));
    const QString words = plots.words_of_cell(1);
    QVERIFY2(words.contains("\nPoses in the region of 50, 68, 95, 99 %: ") &&
                 words.contains("(0.62 to 7.22 where it is as sure as it may be)"),
             qPrintable(words));
    QTest::keyClick(&plots, Qt::Key_Right);
    QCOMPARE(plots.chosen(), std::optional<std::size_t>(2));
    QVERIFY(panels[0]->graphs()[1]->pen().color().alpha() < 255);
    QCOMPARE(panels[0]->graphs()[3]->pen().color().alpha(), 255);
    const auto keep_picture = [&f](const QString& name) {
        const QString folder = qEnvironmentVariable("HITOS_PICTURES");
        if (folder.isEmpty()) return;
        QApplication::processEvents();
        f.study.grab().save(folder + '/' + name);
    };
    keep_picture("study-calibration.png");
    // Another figure, and back; a study without it shows what it has.
    combo()->setCurrentIndex(0);
    emit combo()->activated(0);
    QVERIFY(shown().axisRects().size() == 2 && plots.quality_title().startsWith("Map error"));
    plots.show_calibration();
    QCOMPARE(shown().axisRects().size(), 3);
    // What is chosen is for the screen alone: in a figure all lines are what they are.
    const auto points_of = [](const QImage& image, const QColor& colour) {
        int count = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y) == colour;
        return count;
    };
    FigureWish wish;
    wish.width_mm = 170.0;
    const QColor faint = shown().axisRects()[0]->graphs()[1]->pen().color();
    QVERIFY(faint.alpha() < 255);
    const Picture picture = plots.exportable().offers.front().picture(wish);
    QImage figure(picture.size.toSize(), QImage::Format_RGB32);
    picture.paint(figure, 1.0);
    QVERIFY(points_of(figure, QColor(faint.rgb())) > 50);
    QVERIFY(shown().axisRects()[0]->graphs()[1]->pen().color().alpha() < 255);
    // Arrow keys go by the values of the study that is shown.
    f.study.form().set_assignments({"p=5,10,20,30,50"});
    f.set("folder", f.path("more"));
    f.run_study();
    plots.show_calibration();
    plots.choose(3);
    QTest::keyClick(&plots, Qt::Key_Right);
    QCOMPARE(plots.chosen(), std::optional<std::size_t>(4));
    f.study.form().set_assignments({"filter.algorithm=graph-slam"});
    f.set("folder", f.path("graph"));
    f.run_study();
    QVERIFY2(f.verdict().contains("2 of 2"), qPrintable(f.verdict()));
    QCOMPARE(shown().axisRects().size(), 2);  // it knows no two landmarks together
    keep_picture("study-calibration-graph.png");
}

void StudyTest::every_parameter_can_be_chosen() {
    StudyFixture f;
    auto* names = f.study.findChild<QComboBox*>("parameter");
    for (const ThesisParameter& thesis : thesis_parameters()) {
        const QString name = QString::fromStdString(std::string(thesis.name));
        QVERIFY2(names->findText(name + ' ', Qt::MatchStartsWith) >= 0, qPrintable(name));
    }
    // Any other key, and several together, can be written.
    f.study.form().set_assignments({"sensor=0.04/0.00122,0.01/0.0006"});
    QVERIFY(f.study.findChild<QLabel*>("values_hint")->text().contains('2'));
    f.study.form().set_assignments({"split_merge.dmax+split_merge.min_length=0.02/0.5"});
    QVERIFY(f.study.findChild<QLabel*>("parameter_hint")->text().contains("0.02"));
    f.study.form().set_assignments({"motion.model=odometry"});
    QVERIFY2(f.study.findChild<QLabel*>("parameter_hint")->text().contains("one of odometry, "),
             qPrintable(f.study.findChild<QLabel*>("parameter_hint")->text()));
    f.study.form().set_assignments({"p=10:50:10"});
    QVERIFY(f.study.findChild<QLabel*>("values_hint")->text().contains("10"));
}

void StudyTest::decimal_commas_are_those_of_the_country() {
    const auto p0_error = [](const ConfigurationDialog& form) {
        return form.findChild<QLabel*>("error_association.p0")->text();
    };
    StudyFixture f;
    f.study.form().set_assignments({"p0="});
    const auto read = [&](const QString& written) {
        f.set("values", written);
        return f.study.findChild<QLabel*>("values_hint")->text();
    };
    QVERIFY2(read("2,5, 1,3").startsWith("Values: 4 (2; 5; 1; 3)."), qPrintable(read("2,5, 1,3")));
    QVERIFY(read("0.5 1.3").startsWith("Values: 2 (0.5; 1.3)."));
    {
        const DecimalCommas commas;
        for (const char* list : {"0,5; 1,3", "0,5, 1,3", "0,5 1,3", "0.5,1.3", "0.5; 1,3"}) {
            const QString told = read(list);
            QVERIFY2(told.startsWith("Values: 2 (0.5; 1.3)."), qPrintable(told));
        }
        QVERIFY(read("0,1:0,3:0,1").startsWith("Values: 3 (0.1; 0.2; 0.3)."));
        f.study.form().set_assignments({"p0=1,3"});  // of the command line
        QVERIFY(f.study.findChild<QLabel*>("values_hint")->text().startsWith("Values: 2 (1; 3)."));
        f.study.form().set_assignments({"p="});  // whole numbers have none
        for (const char* list : {"10; 20; 50", "10 20 50", "10, 20, 50"})
            QVERIFY(read(list).startsWith("Values: 3 (10; 20; 50)."));
        for (const char* list : {"0,02; 0,04", "10,20,50"}) {
            const QString told = read(list);
            QVERIFY2(told.contains("a comma is a decimal one here"), qPrintable(told));
            QVERIFY(f.study.findChild<QLabel*>("all_runs")->text().isEmpty());
        }
        f.run_study();
        QVERIFY2(f.error_at("values").contains("whole numbers"), qPrintable(f.error_at("values")));
        auto* noise = f.study.findChild<QDoubleSpinBox*>("noise");
        noise->setFocus();
        noise->selectAll();
        QTest::keyClicks(noise, "0,5");
        QCOMPARE(noise->value(), 0.5);
        in_dialog<ConfigurationDialog>([&](ConfigurationDialog& form) {
            form.findChild<QLineEdit*>("field_association.p0")->setText("0,25");
            form.accept();
            QVERIFY2(!form.isVisible(), qPrintable(p0_error(form)));
        });
        f.trigger("action_manual");
        QCOMPARE(f.session.configuration().filter.association.p0, 0.25);
    }
    in_dialog<ConfigurationDialog>([](ConfigurationDialog& form) {
        form.findChild<QLineEdit*>("field_association.p0")->setText("1,000");  // a thousand?
        form.accept();
        QVERIFY(form.isVisible());
        form.reject();
    });
    f.trigger("action_manual");
    QCOMPARE(f.session.configuration().filter.association.p0, 0.25);
}

/// Neither how many they are nor how many runs they make.
void StudyTest::values_that_are_none_are_not_counted() {
    StudyFixture f;
    const auto refused = [&](const char* parameter, const QString& written) {
        f.study.form().set_assignments({parameter});
        f.set("values", written);
        const QString hint = f.study.findChild<QLabel*>("values_hint")->text();
        return hint.startsWith("Values with ") &&
               f.study.findChild<QLabel*>("all_runs")->text().isEmpty();
    };
    QVERIFY(refused("p=", "10.000"));
    QVERIFY(refused("dmax=", "0.02-0.05"));
    QVERIFY(refused("sensor=", "0.04/wide"));
    QVERIFY(!refused("p=", "10, 50"));
    QVERIFY(!refused("motion.model=", "odometry"));
    // What is written whole and cannot be run is said at once.
    const auto told = [&](const char* parameter, const QString& written, const QString& words) {
        f.study.form().set_assignments({parameter});
        f.set("values", written);
        return f.study.findChild<QLabel*>("values_hint")->text().contains(words) &&
               f.study.findChild<QLabel*>("all_runs")->text().isEmpty();
    };
    QVERIFY(told("p=", "5, 0", "filter.particles: 0 is out of range"));
    QVERIFY(told("dmax=", "0.02, 99", "99 is out of range"));
    QVERIFY(told("dmax=", "0.02 0.020", "dmax: the value 0.02 is given twice"));
    QVERIFY(told("p=", "5 5", "the value 5 is given twice"));
    const DecimalCommas commas;
    QVERIFY(refused("dmax=", "0,02,0,05"));
    QVERIFY(!refused("dmax=", "0,02; 0,05"));
}

void StudyTest::bad_values_are_told_at_their_fields_data() {
    QTest::addColumn<QString>("assignment");
    QTest::addColumn<QString>("field");
    QTest::addColumn<QString>("words");
    QTest::newRow("none") << "dmax="
                          << "values"
                          << "";
    QTest::newRow("no number") << "dmax=wide"
                               << "values"
                               << "wide";
    QTest::newRow("out of range") << "p=5,0"
                                  << "values"
                                  << "filter.particles";
    QTest::newRow("no way there") << "dmax=0.01:0.05:-0.01"
                                  << "values"
                                  << "step";
    QTest::newRow("a part is missing") << "sensor=0.04"
                                       << "values"
                                       << "components";
    QTest::newRow("given twice") << "dmax=0.02,0.020"
                                 << "values"
                                 << "twice";
    QTest::newRow("without effect") << "motion.var_along=0.1"
                                    << "values"
                                    << "no effect";
    QTest::newRow("unknown") << "dmux=1"
                             << "parameter"
                             << "dmux";
}

void StudyTest::bad_values_are_told_at_their_fields() {
    QFETCH(const QString, assignment);
    QFETCH(const QString, field);
    QFETCH(const QString, words);
    StudyFixture f;
    f.study.form().set_assignments({assignment.toStdString()});
    f.run_study();
    QVERIFY2(!f.error_at(field).isEmpty(), qPrintable(f.verdict()));
    QVERIFY2(f.error_at(field).contains(words), qPrintable(f.error_at(field)));
    QVERIFY(!QFile::exists(f.path("study")));
    QVERIFY(f.enabled("start"));
    // What is being mended is no longer told to be wrong.
    f.study.form().set_assignments({"dmax=0.03"});
    QVERIFY(f.error_at(field).isEmpty());
}

void StudyTest::all_mistakes_are_told_at_once() {
    StudyFixture f;
    f.set("seed", "first");
    f.set("reference", "/nowhere/true.map");
    f.set("folder", "");
    f.press("start");
    QVERIFY(!f.study.running());
    QVERIFY(!f.error_at("seed").isEmpty());
    QVERIFY2(f.error_at("reference").contains("/nowhere/true.map"),
             qPrintable(f.error_at("reference")));
    QVERIFY(!f.error_at("folder").isEmpty());
    QVERIFY(f.error_at("values").isEmpty());
    f.prompts.opens = {Fixture::source_file("data/maps/bigloop.map")};
    f.press("reference_browse");
    f.prompts.folders = {f.path("study")};
    f.press("folder_browse");
    f.set("seed", "1");
    QVERIFY(f.error_at("reference").isEmpty() && f.error_at("folder").isEmpty());
    f.run_study();
    QVERIFY2(f.verdict().contains("4 of 4"), qPrintable(f.verdict()));
}

void StudyTest::a_folder_that_cannot_be_written_is_told() {
    StudyFixture f;
    f.write("file", "no folder");
    f.set("folder", f.path("file/study"));
    f.run_study();
    QVERIFY2(f.error_at("folder").contains("file/study"), qPrintable(f.verdict()));
    QVERIFY(f.enabled("start"));
}

void StudyTest::a_log_that_has_gone_is_told() {
    StudyFixture f;
    const QString path = f.write("small.txt", "ODOM 0 0 0\nLASER 0 2 1 0 1 1\n");
    QVERIFY(f.window->configuration_actions().open(path));
    QFile::remove(path);
    f.run_study();
    QVERIFY2(f.verdict().contains("small.txt"), qPrintable(f.verdict()));
}

void StudyTest::runs_that_fail_are_told_and_the_others_go_on() {
    StudyFixture f;
    const QString good = QString::fromStdString(f.session.configuration().source.file);
    const QString bad = f.write("letter.txt", "Dear reader,\nthis is no log.\n");
    f.study.form().set_assignments({("source.file=" + good + ',' + bad).toStdString()});
    f.run_study();
    QVERIFY2(f.verdict().contains("letter.txt"), qPrintable(f.verdict()));
    QVERIFY2(f.verdict().contains("2 of 4"), qPrintable(f.verdict()));
    QCOMPARE(f.study.plots().means(), 1);
}

void StudyTest::a_stopped_study_goes_on_where_it_was() {
    // Where this thread sees the first runs only after the last ones have ended, runs that last
    // longer are tried.
    for (int particles = 1000;; particles *= 2) {
        StudyFixture f(particles);
        f.study.findChild<QSpinBox*>("threads")->setValue(1);
        f.press("start");
        QVERIFY(f.study.running());
        QVERIFY(!f.enabled("start"));
        QVERIFY(!f.study.findChild<QWidget*>("form")->isEnabled());
        QTRY_VERIFY(f.study.plots().means() > 0);
        if (f.study.running()) f.press("stop");
        QTRY_VERIFY(!f.study.running());
        if (f.verdict().contains("4 of 4")) continue;
        QVERIFY2(f.verdict().contains("Stopped"), qPrintable(f.verdict()));
        QVERIFY(!QFile::exists(f.path("study/quality.csv")));
        f.run_study();
        QVERIFY(f.prompts.confirmed_texts.isEmpty());  // it is this window's own folder
        compare_folders(f.path("study"), f.command_line_study());
        return;
    }
}

void StudyTest::another_studys_folder_is_asked_about() {
    StudyFixture f;
    QDir().mkpath(f.path("study"));
    f.write("study/quality.csv", "precious");
    f.prompts.confirms = {false};
    f.press("start");
    QVERIFY(!f.study.running());
    QCOMPARE(Fixture::read(f.path("study/quality.csv")), QByteArray("precious"));
    f.prompts.confirms = {true};
    f.run_study();  // without a plan it is of no study, but somebody's own
    QVERIFY2(f.error_at("folder").contains("quality.csv"), qPrintable(f.error_at("folder")));
    QCOMPARE(Fixture::read(f.path("study/quality.csv")), QByteArray("precious"));
    f.write("study/study.json", "{}");
    f.prompts.confirms = {true};
    f.run_study();
    QVERIFY(f.prompts.confirmed_texts.back().contains("study"));
    QVERIFY(Fixture::read(f.path("study/quality.csv")) != QByteArray("precious"));
}

void StudyTest::closing_while_it_runs_asks() {
    StudyFixture f;
    f.study.form().set_runs(kEndless);
    f.press("start");
    QVERIFY(f.study.running());
    f.prompts.confirms = {false, false};
    f.press("close");
    QVERIFY(f.study.isVisible() && f.study.running());
    QVERIFY(!f.window->close());
    QVERIFY(f.window->isVisible() && f.study.running());
    QTest::keyClick(&f.study, Qt::Key_Escape);  // declined: the list is at its end
    QVERIFY(f.study.isVisible());
    f.prompts.confirms = {true};
    f.press("close");
    QVERIFY(!f.study.isVisible());
    QTRY_VERIFY(!f.study.running());
}

void StudyTest::the_main_window_ends_a_running_study() {
    StudyFixture f;
    f.study.form().set_runs(kEndless);
    f.press("start");
    f.prompts.confirms = {true};
    QVERIFY(f.window->close());
    f.window.reset();  // waits for no more than the steps under way
    QVERIFY(!QFile::exists(f.path("study/quality.csv")));
}

void StudyTest::the_configuration_may_change_meanwhile() {
    StudyFixture f;
    f.press("start");
    f.session.set_configuration(Fixture::tour(6));
    QTRY_VERIFY(!f.study.running());
    f.session.set_configuration(Fixture::tour(5));
    compare_folders(f.path("study"), f.command_line_study());
}

void StudyTest::its_plot_is_saved() {
    StudyFixture f;
    QVERIFY(!f.enabled("save"));
    const auto save = [&f] {
        in_dialog<ExportDialog>([](ExportDialog& dialog) { dialog.accept(); });
        f.press("save");
    };
    f.run_study();
    f.prompts.saves = {f.path("plot.png")};
    save();
    QVERIFY(!QImage(f.path("plot.png")).isNull());
    f.prompts.saves = {f.path("plot.pdf")};
    save();
    QVERIFY(Fixture::read(f.path("plot.pdf")).startsWith("%PDF"));
    // A right click copies it.
    QApplication::clipboard()->clear();
    auto* plots = f.study.findChild<StudyPlots*>();
    auto* plot = plots->findChild<QCustomPlot*>();
    const QPoint middle = plot->rect().center();
    QContextMenuEvent click(QContextMenuEvent::Mouse, middle, plot->mapToGlobal(middle));
    QApplication::sendEvent(plot, &click);
    auto* menu = plots->findChild<QMenu*>();
    QVERIFY(menu != nullptr);
    menu->actions().front()->trigger();
    menu->close();
    QVERIFY(QApplication::clipboard()->image().width() > plot->width());
    // Overwriting declined, a kind that is none, a folder that is not there, given up.
    f.prompts.saves = {f.path("plot.png"), f.path("plot.bmp"), f.path("no/folder/plot.pdf")};
    f.prompts.confirms = {false};
    f.prompts.saves_asked = 0;
    save();
    QCOMPARE(f.prompts.saves_asked, 4);
    QCOMPARE(f.prompts.warnings.size(), 2);
    QVERIFY(!QFile::exists(f.path("plot.bmp")));
}

void StudyTest::its_words_are_remembered() {
    StudyFixture f;
    f.run_study();
    StudyDialog next(f.session, f.files, f.prompts, nullptr);
    QCOMPARE(next.findChild<QLineEdit*>("values")->text(), QString("0.02,0.05"));
    QCOMPARE(next.findChild<QSpinBox*>("runs")->value(), 2);
    QVERIFY(next.findChild<QComboBox*>("parameter")->currentText().startsWith("dmax "));
    QCOMPARE(next.findChild<QComboBox*>("parameter_2")->currentIndex(), 0);
    f.study.form().set_assignments({"dmax=0.02,0.05", "p=3,4"});
    f.run_study();
    StudyDialog last(f.session, f.files, f.prompts, nullptr);
    QVERIFY(last.findChild<QComboBox*>("parameter_2")->currentText().startsWith("p "));
    QCOMPARE(last.findChild<QLineEdit*>("values_2")->text(), QString("3,4"));
}

void StudyTest::a_reference_belongs_to_its_log() {
    StudyFixture f;
    const QString map = Fixture::source_file("data/maps/bigloop.map");
    f.set("reference", QDir::current().relativeFilePath(map));
    f.set("values", "0.02");
    f.run_study();
    const auto offered = [](const StudyDialog& study) {
        return study.findChild<QLineEdit*>("reference")->text();
    };
    const auto of_another_session = [&] {
        const StudyDialog next(f.session, f.files, f.prompts, nullptr);
        return offered(next);
    };
    QCOMPARE(of_another_session(), map);
    const Configuracion log = f.session.configuration();
    Configuracion other = log;
    other.source.file = Fixture::source_file("data/worlds/recinto.toml").toStdString();
    f.session.set_configuration(other);
    QCOMPARE(offered(f.study), QString());
    QCOMPARE(of_another_session(), QString());
    f.session.set_configuration(log);
    QCOMPARE(offered(f.study), map);
    // One that is written stays while the log is the same.
    f.set("reference", "another.map");
    Configuracion seed = log;
    seed.run.seed = 7;
    f.session.set_configuration(seed);
    QCOMPARE(offered(f.study), QString("another.map"));
}

void StudyTest::a_run_of_it_is_opened() {
    StudyFixture f;
    QVERIFY(!f.enabled("open_run"));
    f.run_study();
    f.prompts.numbers = {3};  // of two values with two seeds
    f.press("open_run");
    QCOMPARE(f.prompts.offered.size(), 4);
    QVERIFY2(f.prompts.offered[3].startsWith("dmax=0.05 seed 2: "),
             qPrintable(f.prompts.offered[3]));
    QCOMPARE(f.session.configuration().run.seed, 2U);
    QCOMPARE(find_parameter("split_merge.dmax").text(f.session.configuration()), "0.05");
    QTRY_VERIFY(f.state() == Progress::State::finished && f.shows_everything());
    // It is that run, to the last bit.
    f.prompts.saves = {f.path("again.txt")};
    f.trigger("action_save_map");
    QCOMPARE(Fixture::read(f.path("again.txt")),
             Fixture::read(f.path("study/maps/dmax-0.05-s2.map")));
    f.press("open_run");  // given up
    QCOMPARE(f.session.configuration().run.seed, 2U);
}

}  // namespace hitos::window
