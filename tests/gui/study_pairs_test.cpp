// SPDX-License-Identifier: GPL-3.0-or-later
// Studies of two parameters from the window, and the use of what they have found.

#include <qcustomplot.h>

#include <QComboBox>
#include <algorithm>
#include <cstdlib>
#include <map>

#include "dialogs/export_dialog.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "study_fixture.hpp"
#include "tests.hpp"
#include "views/picture.hpp"
#include "views/plot_style.hpp"

namespace hitos::window {
namespace {

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
    // Every cell has its mean's colour, where its values are.
    const auto by_mean = [](const auto& one) { return one.second; };
    const auto ends = std::ranges::minmax_element(means, {}, by_mean);
    const double least = ends.min->second;
    const double greatest = ends.max->second;
    const QRect cells = f.map().axisRect(0)->rect();
    const QImage seen = f.map().grab().toImage();
    cell = 0;
    for (const auto& [values, mean] : means) {
        const auto column = static_cast<int>(cell / 3);
        const auto row = static_cast<int>(cell++ % 3);
        const QPoint corner(cells.left() + column * cells.width() / 2 + 12,
                            cells.bottom() - row * cells.height() / 3 - 12);
        const QColor colour = seen.pixelColor(corner);
        const QColor due = heat_colour((mean - least) / (greatest - least));
        QVERIFY2(std::abs(colour.red() - due.red()) + std::abs(colour.green() - due.green()) +
                         std::abs(colour.blue() - due.blue()) <=
                     6,
                 qPrintable(values + ": " + colour.name() + ", not " + due.name()));
    }
    // So it is saved.
    f.prompts.saves = {f.path("map.png")};
    in_dialog<ExportDialog>([](ExportDialog& dialog) { dialog.accept(); });
    f.press("save");
    const QImage saved(f.path("map.png"));
    for (const double share : {0.0, 1.0}) {
        int inside = 0;
        for (int y = 0; y < saved.height(); ++y)
            for (int x = 0; x < saved.width(); ++x)
                inside += saved.pixelColor(x, y) == heat_colour(share) ? 1 : 0;
        QVERIFY2(inside > saved.width() * saved.height() / 18, qPrintable(QString::number(inside)));
    }
}

/// In the width of a column of a paper: 85 mm, letters of 7 points.
void StudyTest::figures_fit_the_column_of_a_paper() {
    TwoParameters f;
    f.run_study();
    QCustomPlot& map = f.map();
    FigureWish wish;
    constexpr double kMmPerLetterPoint = 25.4 / 72.0;
    wish.mm_per_point =
        7.0 * kMmPerLetterPoint / QFontInfo(f.study.plots().exportable().font).pixelSize();
    const Picture picture = f.study.plots().exportable().offers.front().picture(wish);
    if (const QString folder = qEnvironmentVariable("HITOS_PICTURES"); !folder.isEmpty()) {
        write_picture(picture, folder + "/heat-85.pdf");
        f.study.plots().show_calibration();
        write_picture(f.study.plots().exportable().offers.front().picture(wish),
                      folder + "/calibration-85.pdf");
        f.study.plots().show_quality(*f.study.plots().qualities().front());
        f.study.form().set_assignments({"dmax=0.02,0.05", ""});
        f.run_study();
        write_picture(f.study.plots().exportable().offers.front().picture(wish),
                      folder + "/curves-85.pdf");
        return;
    }
    const auto& scale = *qobject_cast<QCPColorScale*>(map.plotLayout()->element(1, 1));
    const QCPTextElement& title = *title_of(map, 0, 0);
    const int column = qRound(wish.points());
    for (const int width : {column - 100, column - 50, column, column + 50}) {
        map.setViewport(QRect(0, 0, width, qRound(picture.size.height())));
        map.replot();
        QVERIFY(scale.axis()->axisRect()->width() >= scale.barWidth() - 1);
        QVERIFY(scale.outerRect().right() <= map.viewport().right());
        const QRect needed =
            QFontMetrics(title.font())
                .boundingRect(title.rect(), Qt::TextWordWrap | Qt::AlignLeft, title.text());
        QVERIFY2(title.rect().contains(needed), qPrintable(title.text()));
        // And has no more room than that.
        constexpr int kRounding = 2;
        QVERIFY2(title.rect().height() <= needed.height() + kRounding, qPrintable(title.text()));
    }
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
    f.press("open_run");
    QCOMPARE(f.prompts.offered_first, f.prompts.offered.front());
    f.click(0.75, 0.5);
    f.press("open_run");  // one of those is at hand
    QVERIFY2(f.prompts.offered_first.startsWith("dmax=0.05 p=4 seed 1"),
             qPrintable(f.prompts.offered_first));
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

}  // namespace hitos::window
