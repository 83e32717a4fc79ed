// Use case 8.2.2.11 from the window: the study of a parameter, or two.

#include <qcustomplot.h>

#include <qcustomplot.h>

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QDirIterator>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProcess>
#include <QPushButton>
#include <QSpinBox>
#include <algorithm>
#include <map>

#include "dialogs/configuration_dialog.hpp"
#include "dialogs/export_dialog.hpp"
#include "dialogs/study_dialog.hpp"
#include "gui_fixture.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/study/study_values.hpp"
#include "look/written_number.hpp"
#include "tests.hpp"
#include "views/study_plots.hpp"

namespace hitos::window {
namespace {

/// So many runs that none of these tests, however slow its machine, sees the last of them.
constexpr int kEndless = 10000;

/// A window with its study open: two values of dmax, two runs of each.
struct StudyFixture : Fixture {
    StudyDialog& study;

    explicit StudyFixture(int particles = 5) : Fixture(true, particles), study(open()) {
        set("values", "0.02, 0.05");
        study.form().set_runs(2);
        set("reference", source_file("data/maps/bigloop.map"));
        set("folder", path("study"));
    }

    StudyDialog& open() {
        trigger("action_study");
        if (window->study() == nullptr) qFatal("no study");
        window->study()->form().set_assignments({"dmax="});
        return *window->study();
    }
    void set(const char* field, const QString& text) const {
        study.findChild<QLineEdit*>(field)->setText(text);
    }
    void press(const char* button) const { study.findChild<QPushButton*>(button)->click(); }
    bool enabled(const char* button) const {
        return study.findChild<QPushButton*>(button)->isEnabled();
    }
    QString error_at(const QString& field) const {
        auto* label = study.findChild<QLabel*>("error_" + field);
        return label->isHidden() ? QString() : label->text();
    }
    QString verdict() const { return study.findChild<QLabel*>("verdict")->text(); }
    void run_study() const {
        press("start");
        QTRY_VERIFY(!study.running());
    }

    /// Runs hitos-cli study with the same inputs; gives its folder.
    QString command_line_study(const QStringList& extra = {}) {
        prompts.saves = {path("same.cfg")};
        trigger("action_save");
        QProcess cli;
        cli.start(QString(HITOS_BIN_DIR) + "/hitos-cli",
                  QStringList{"study", QString::fromStdString(session.configuration().source.file),
                              "--config", path("same.cfg"), "--reference",
                              source_file("data/maps/bigloop.map"), "--vary", "dmax=0.02,0.05",
                              "--runs", "2", "--out", path("cli")} +
                      extra);
        if (!cli.waitForFinished(kPatienceMs) || cli.exitCode() != 0)
            qFatal("hitos-cli has failed");
        return path("cli");
    }
};

/// Every file but those that tell the time that the runs took.
QStringList results_in(const QString& folder) {
    QStringList names;
    QDirIterator files(folder, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QString name = QDir(folder).relativeFilePath(files.next());
        if (name != "timing.csv" && !name.startsWith("runs/")) names << name;
    }
    names.sort();
    return names;
}

void compare_folders(const QString& mine, const QString& other, int runs = 4) {
    const QStringList names = results_in(mine);
    QCOMPARE(names, results_in(other));
    QVERIFY2(names.contains("quality.csv") && names.contains("summary.csv") &&
                 names.contains("error.dat") && names.filter("maps/").size() == runs,
             qPrintable(names.join(' ')));
    for (const QString& name : names) {
        QVERIFY2(Fixture::read(mine + '/' + name) == Fixture::read(other + '/' + name),
                 qPrintable(name));
    }
}

/// The mean error of every pair of values, as "dmax=0.02 p=5": of the runs in quality.csv.
std::map<QString, double> mean_errors(const QString& folder) {
    const QStringList lines =
        QString(Fixture::read(folder + "/quality.csv")).split('\n', Qt::SkipEmptyParts);
    const QStringList columns = lines.front().split(',');
    std::map<QString, std::pair<double, int>> sums;
    for (const QString& line : lines.mid(1)) {
        const QStringList row = line.split(',');
        if (row.size() != columns.size()) continue;
        const auto at = [&](const char* column) { return row[columns.indexOf(column)]; };
        auto& [sum, runs] = sums["dmax=" + at("split_merge.dmax") + " p=" + at("filter.particles")];
        sum += at("error_m").toDouble();
        ++runs;
    }
    std::map<QString, double> means;
    for (const auto& [values, sum] : sums) means[values] = sum.first / sum.second;
    return means;
}

/// Two values of dmax and three numbers of particles, two runs of each pair.
struct TwoParameters : StudyFixture {
    TwoParameters() { study.form().set_assignments({"dmax=0.02,0.05", "p=3,4,6"}); }

    QCustomPlot& map() const {
        for (auto* plot : study.plots().findChildren<QCustomPlot*>())
            if (plot->isVisible()) return *plot;
        qFatal("no map");
    }
    void click(double across, double up) const {
        const QRect cells = map().axisRect(0)->rect();
        QTest::mouseClick(&map(), Qt::LeftButton, Qt::NoModifier,
                          QPoint(cells.left() + static_cast<int>(across * cells.width()),
                                 cells.bottom() - static_cast<int>(up * cells.height())));
    }
    QString value_of(const char* key) const {
        return QString::fromStdString(find_parameter(key).text(session.configuration()));
    }
};

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

void StudyTest::two_parameters_are_a_map_of_colours() {
    TwoParameters f;
    QCOMPARE(f.study.findChild<QLabel*>("all_runs")->text(), QString("Runs in all: 12"));
    f.run_study();
    QVERIFY2(f.verdict().contains("12 of 12"), qPrintable(f.verdict()));
    compare_folders(f.path("study"), f.command_line_study({"--vary", "p=3,4,6"}), 12);
    const std::map<QString, double> means = mean_errors(f.path("study"));
    QCOMPARE(means.size(), 6U);
    QCOMPARE(f.study.plots().means(), 6);
    std::size_t cell = 0;
    for (const auto& [values, mean] : means) {  // in the order of the plan
        const QStringList told = f.study.plots().words_of_cell(cell++).split('\n');
        QCOMPARE(told[0], values);
        QCOMPARE(told[1], QString("Runs: 2"));
        const QString words = QString("Map error: %1 ±").arg(mean, 0, 'f', 3);
        QVERIFY2(told[2].startsWith(words), qPrintable(told[2] + ", not " + words));
    }
    const auto ticks = f.map().axisRect(0)->axis(QCPAxis::atBottom)->tickVectorLabels();
    QCOMPARE(ticks, (QVector<QString>{"0.02", "0.05"}));
    // The best and the worst have the ends of the scale.
    f.prompts.saves = {f.path("map.png")};
    in_dialog<ExportDialog>([](ExportDialog& dialog) { dialog.accept(); });
    f.press("save");
    const QImage picture(f.path("map.png"));
    const auto area_of = [&picture](double share) {
        int count = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                count += picture.pixelColor(x, y) == heat_colour(share) ? 1 : 0;
        return count;
    };
    const int cell_inside = picture.width() * picture.height() / 18;
    QVERIFY2(area_of(0.0) > cell_inside, qPrintable(QString::number(area_of(0.0))));
    QVERIFY2(area_of(1.0) > cell_inside, qPrintable(QString::number(area_of(1.0))));
}

void StudyTest::the_scale_of_the_map_darkens() {
    int before = 256;
    for (int percent = 0; percent <= 100; percent += 5) {
        const int grey = qGray(heat_colour(percent / 100.0).rgb());
        QVERIFY2(grey < before, qPrintable(QString::number(percent)));
        before = grey;
    }
    QCOMPARE(heat_colour(-1.0), heat_colour(0.0));
    QCOMPARE(heat_colour(2.0), heat_colour(1.0));
}

void StudyTest::values_are_chosen_and_used() {
    TwoParameters f;
    QVERIFY(!f.enabled("use"));
    f.run_study();
    const Configuracion before = f.session.configuration();
    f.click(0.75, 0.5);
    QVERIFY(f.enabled("use"));
    QVERIFY(f.study.plots().accessibleDescription().startsWith("dmax=0.05 p=4\n"));
    f.press("use");
    QCOMPARE(f.value_of("split_merge.dmax"), QString("0.05"));
    QCOMPARE(f.value_of("filter.particles"), QString("4"));
    QCOMPARE(f.session.configuration().run.seed, before.run.seed);
    QCOMPARE(f.session.configuration().source.file, before.source.file);
    QVERIFY2(f.notice().contains("dmax=0.05 p=4"), qPrintable(f.notice()));
    f.trigger("action_undo");
    QCOMPARE(ArchivoConfiguracion::to_text(f.session.configuration()),
             ArchivoConfiguracion::to_text(before));
    // The arrow keys begin at the best and stay within the map.
    f.study.plots().choose(std::nullopt);
    QVERIFY(!f.enabled("use"));
    const std::map<QString, double> means = mean_errors(f.path("study"));
    const auto best =
        std::ranges::min_element(means, {}, [](const auto& one) { return one.second; });
    const auto key = [&f](Qt::Key pressed) { QTest::keyClick(&f.study.plots(), pressed); };
    key(Qt::Key_Up);
    QVERIFY(f.study.plots().accessibleDescription().startsWith(best->first + '\n'));
    for (int i = 0; i < 3; ++i) key(Qt::Key_Right);
    for (int i = 0; i < 3; ++i) key(Qt::Key_Down);
    QCOMPARE(f.study.plots().chosen(), std::optional<std::size_t>(3));  // dmax=0.05 p=3
    key(Qt::Key_Up);
    key(Qt::Key_Left);
    QCOMPARE(f.study.plots().chosen(), std::optional<std::size_t>(1));
    key(Qt::Key_Return);
    QCOMPARE(f.value_of("filter.particles"), QString("4"));
    f.study.form().set_runs(1);
    f.run_study();  // another one has nothing chosen
    QVERIFY(!f.enabled("use"));
}

void StudyTest::a_value_of_one_parameter_is_used() {
    TwoParameters f;
    f.study.form().set_assignments({"dmax=0.05,0.02,0.1"});
    f.run_study();
    QCOMPARE(f.study.plots().means(), 3);
    const auto key = [&f](Qt::Key pressed) { QTest::keyClick(&f.study.plots(), pressed); };
    for (int i = 0; i < 3; ++i) key(Qt::Key_Left);  // along the axis, not in the order of the list
    QCOMPARE(f.study.plots().chosen(), std::optional<std::size_t>(1));
    key(Qt::Key_Right);
    QCOMPARE(f.study.plots().chosen(), std::optional<std::size_t>(0));
    f.press("use");
    QCOMPARE(f.value_of("split_merge.dmax"), QString("0.05"));
    f.click(0.99, 0.5);  // the greatest is near the right edge
    QCOMPARE(f.study.plots().chosen(), std::optional<std::size_t>(2));
    f.click(0.75, 0.5);  // there is none
    QVERIFY(!f.enabled("use"));
}

void StudyTest::pairs_that_fail_are_told() {
    TwoParameters f;
    const QString good = QString::fromStdString(f.session.configuration().source.file);
    const QString bad = f.write("letter.txt", "Dear reader,\nthis is no log.\n");
    f.study.form().set_assignments({("source.file=" + good + ',' + bad).toStdString(), "p=3,4"});
    f.run_study();
    QVERIFY2(f.verdict().contains("4 of 8"), qPrintable(f.verdict()));
    QCOMPARE(f.study.plots().means(), 2);
    QVERIFY(!f.study.plots().words_of_cell(0).contains("Failed"));
    QVERIFY(f.study.plots().words_of_cell(3).contains("Runs: 0\nFailed: 2"));
}

void StudyTest::the_second_parameter_is_checked_too() {
    TwoParameters f;
    const auto refused = [&f](const char* first, const char* second) {
        f.study.form().set_assignments({first, second});
        f.run_study();
    };
    refused("dmax=0.02", "p=5,0");
    QVERIFY(f.error_at("values").isEmpty());
    QVERIFY2(f.error_at("values_2").contains("filter.particles"),
             qPrintable(f.error_at("values_2")));
    refused("p=0", "dmax=0.02");
    QVERIFY(!f.error_at("values").isEmpty() && f.error_at("values_2").isEmpty());
    refused("dmax=0.02", "split_merge.dmax=0.03");
    QVERIFY2(f.error_at("values_2").contains("both"), qPrintable(f.error_at("values_2")));
    refused("dmax=0.02", "dmux=1");
    QVERIFY(!f.error_at("parameter_2").isEmpty());
    refused("dmax=0.02", "p=");
    QVERIFY(!f.error_at("values_2").isEmpty());
    QVERIFY(!QFile::exists(f.path("study")));
    // None again: its values are not asked for.
    f.study.findChild<QComboBox*>("parameter_2")->setCurrentIndex(0);
    QVERIFY(f.error_at("values_2").isEmpty());
    QVERIFY(f.study.findChild<QLineEdit*>("values_2")->isHidden());
    QCOMPARE(f.study.findChild<QLabel*>("all_runs")->text(), QString("Runs in all: 2"));
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
    struct Comma {
        Comma() { set_decimal_comma(true); }
        ~Comma() { set_decimal_comma(false); }
    };
    StudyFixture f;
    f.study.form().set_assignments({"p0="});
    const auto read = [&](const QString& written) {
        f.set("values", written);
        return f.study.findChild<QLabel*>("values_hint")->text();
    };
    QVERIFY2(read("0,5, 1,3").startsWith("Values: 4 (0; 5; 1; 3)."), qPrintable(read("0,5, 1,3")));
    QVERIFY(read("0.5 1.3").startsWith("Values: 2 (0.5; 1.3)."));
    {
        const Comma comma;
        for (const char* list : {"0,5; 1,3", "0,5, 1,3", "0,5 1,3", "0.5,1.3", "0.5; 1,3"}) {
            const QString told = read(list);
            QVERIFY2(told.startsWith("Values: 2 (0.5; 1.3)."), qPrintable(told));
        }
        QVERIFY(read("0,1:0,3:0,1").startsWith("Values: 3 (0.1; 0.2; 0.3)."));
        f.study.form().set_assignments({"p0=1,3"});  // of the command line
        QVERIFY(f.study.findChild<QLabel*>("values_hint")->text().startsWith("Values: 2 (1; 3)."));
        f.study.form().set_assignments({"p="});  // whole numbers have none
        QVERIFY(read("10,20,50").startsWith("Values: 3 (10; 20; 50)."));
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
