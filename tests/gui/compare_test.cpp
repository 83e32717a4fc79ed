// SPDX-License-Identifier: GPL-3.0-or-later
// Runs laid over each other: what they differ in, their frames, and legends.

#include <qcustomplot.h>

#include <QCheckBox>
#include <QComboBox>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <algorithm>
#include <cmath>

#include "dialogs/export_dialog.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/files/trajectory_file.hpp"
#include "look/parameter_text.hpp"
#include "look/theme.hpp"
#include "runs_fixture.hpp"
#include "tests.hpp"

namespace hitos::window {

void RunsTest::the_settings_that_differ_are_those_of_the_command_line() {
    RunsFixture f;
    f.trigger("action_runs_dock");
    f.run_steps(40);
    Configuracion other = f.session.configuration();
    other.filter.algorithm = "ekf-slam";
    other.filter.particles = 77;
    f.session.set_configuration(other);
    f.run_steps(40);
    f.panel().table().choose_rows({0, 1});
    f.press("runs_compare");
    const auto listed = f.list().runs();
    const auto found = differences(listed[1].run->configuration, listed[0].run->configuration);
    QVERIFY(found.size() > 1);  // what one of them makes no use of counts too
    f.comparison().choose(0, {listed[1].number, false});
    f.comparison().choose(1, {0, false});
    const QString told = f.comparison().findChild<QLabel*>("compare_verdict")->text();
    for (const ConfigParameter* parameter : found) {
        const bool of_right = parameter->used_by(listed[0].run->configuration);
        const QString label = label_of(*parameter);
        QVERIFY2(told.contains(label + ' '), qPrintable(label + ": " + told));
        if (!of_right) QVERIFY2(told.contains("(the left one alone)"), qPrintable(told));
    }
}

void RunsTest::runs_of_different_frames_are_laid_on_each_other() {
    RunsFixture f;
    f.trigger("action_runs_dock");
    f.run_steps(80);
    f.save_results("moved");
    const std::string file = f.path("moved/trajectory.tum").toStdString();
    Trajectory right = read_trajectory(file);
    for (StampedPose& stamped : right) stamped.pose = compose({4.0, -2.0, 1.0}, stamped.pose);
    write_trajectory(right, file);
    // As of a release that did not say what its files were.
    QJsonObject summary =
        QJsonDocument::fromJson(Fixture::read(f.path("moved/summary.json"))).object();
    summary.remove("files");
    summary.remove("rest_xxh3_128");
    f.write("moved/summary.json", QJsonDocument(summary).toJson());
    f.change(20);
    f.run_steps(80);
    f.prompts.folders = {f.path("moved")};
    f.trigger("action_open_results");
    QVERIFY2(f.prompts.warnings.isEmpty(), qPrintable(f.prompts.warnings.join(" ")));
    const std::vector<ListedRun> listed = f.list().runs();
    int number = -1;
    for (const ListedRun& one : listed) {
        if (std::abs(one.run->path.front().pose.x - right.front().pose.x) < 1e-6)
            number = one.number;
    }
    QVERIFY(number > 0);
    const Trajectory left = listed.front().run->path;
    CompareWindow& comparison = f.comparison();
    comparison.choose(0, {0, false});
    comparison.choose(1, {number, false});
    const auto mean_distance = [&] {
        const std::vector<QPointF>& other = comparison.view(0).traces().back().path;
        double sum = 0.0;
        for (std::size_t i = 0; i < left.size(); ++i)
            sum += std::hypot(other[i].x() - left[i].pose.x, other[i].y() - left[i].pose.y);
        return sum / static_cast<double>(left.size());
    };
    comparison.set_mode(CompareWindow::Mode::overlaid);
    QCOMPARE(comparison.view(0).traces().size(), 2U);
    const QPointF first = comparison.view(0).traces().back().path.front();
    QVERIFY(std::hypot(first.x() - left.front().pose.x, first.y() - left.front().pose.y) < 1e-9);
    References references;
    references.trajectory = left;
    f.session.set_references(references);
    comparison.show_figures(true);
    // Dashed as in the window, and below the colours of the errors.
    QCOMPARE(comparison.view(0).traces().front().name, QString("Reference"));
    QCOMPARE(comparison.view(0).traces().front().line, Qt::DashLine);
    const double aligned = mean_distance();
    const auto error = trajectory_error(right, left);
    QVERIFY(error.has_value());
    QVERIFY2(std::abs(aligned - error->mean_m) < 1e-4, qPrintable(QString::number(aligned)));
    comparison.findChild<QCheckBox*>("figures_aligned")->click();
    QVERIFY(mean_distance() >= aligned);
    // Beside each other both views show the same places.
    comparison.show_figures(false);
    comparison.set_mode(CompareWindow::Mode::side_by_side);
    comparison.view(1).look_as(comparison.view(0));
    QTRY_VERIFY(!comparison.building());
    // Of another log nothing is laid on anything, and it is told.
    const auto* verdict = comparison.findChild<QLabel*>("compare_verdict");
    QVERIFY(!verdict->text().contains("is not laid"));
    Configuracion other = f.session.configuration();
    other.source.file = Fixture::source_file("data/bigloop-noisy.log.gz").toStdString();
    f.session.set_configuration(other);
    f.run_steps(40);
    comparison.choose(0, {0, false});
    QTRY_VERIFY2(verdict->text().contains("is not laid"), qPrintable(verdict->text()));
}

void RunsTest::legends_cover_nothing() {
    RunsFixture f;
    run_thrice(f);
    f.session.set_references(moved_path_of_the_first(f));
    CompareWindow& comparison = compare_first_two(f);
    comparison.show_figures(true);
    comparison.set_mode(CompareWindow::Mode::overlaid);
    auto* plot = comparison.findChild<QCustomPlot*>();
    auto* legend = plot->findChild<QCPLegend*>();
    QTRY_VERIFY(!legend->outerRect().isEmpty() && legend->itemCount() == 2);
    QVERIFY(!legend->outerRect().intersects(plot->axisRects().front()->rect()));
    // Of a figure of the views the legend is below, and can be left out.
    const FigureOffer map = comparison.view(0).figures().front();
    FigureWish wish;
    wish.layers = map.shown;
    const auto picture = [&](const FigureOffer& offer) {
        Picture drawn = offer.picture(wish);
        drawn.scale = 2.0;
        return image_of(drawn);
    };
    const QImage bare = picture(map);
    wish.legend = true;
    const QImage with_legend = picture(map);
    QVERIFY(with_legend.height() > bare.height() + 20);
    const auto above = [&](const QImage& image) {
        return image.copy(0, 0, bare.width(), bare.height() - 4)
            .convertToFormat(QImage::Format_RGB32);
    };
    QCOMPARE(above(with_legend), above(bare));
    // The path is drawn in the runs' colours: the legend does not name it in its own.
    const QImage below = with_legend.copy(0, bare.height(), bare.width(), with_legend.height());
    for (int y = 0; y < below.height(); ++y) {
        for (int x = 0; x < below.width(); ++x)
            QVERIFY(below.pixelColor(x, y) != light_colours().path);
    }
    // Nor does that of the plot have to be.
    const auto* strip = comparison.findChild<ErrorStrip*>("compare_figures");
    in_dialog<ExportDialog>([](ExportDialog& dialog) {
        auto* shown = dialog.findChild<QCheckBox*>("export_legend");
        QVERIFY(shown->isVisible() && shown->isEnabled() && shown->isChecked());
        QVERIFY(!dialog.findChild<QCheckBox*>("export_axes")->isVisible());
        const QImage with = image_of(dialog.picture());
        shown->setChecked(false);
        const QImage without = image_of(dialog.picture());
        QVERIFY(with != without);
        // However narrow it is, its letters have room.
        dialog.findChild<QComboBox*>("export_format")->setCurrentText("PDF");
        const Picture narrow = dialog.picture();
        QVERIFY2(narrow.size.height() >= 150.0, qPrintable(QString::number(narrow.size.height())));
        dialog.reject();
    });
    strip->findChild<QPushButton*>()->click();
    QTRY_COMPARE(legend->itemCount(), 2);
}

}  // namespace hitos::window
