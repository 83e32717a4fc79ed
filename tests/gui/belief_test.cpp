// SPDX-License-Identifier: GPL-3.0-or-later
// How sure the algorithm is: the pose's uncertainty, the joint covariance, the NEES.

#include <QClipboard>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <cmath>

#include "dialogs/export_dialog.hpp"
#include "gui_fixture.hpp"
#include "inspect/joint_covariance.hpp"
#include "tests.hpp"
#include "views/plots.hpp"

namespace hitos::window {
namespace {

Configuracion with_algorithm(const char* algorithm) {
    Configuracion configuration =
        ArchivoConfiguracion::read(Fixture::source_file("config/simulated.cfg").toStdString());
    configuration.source.file = Fixture::source_file("data/bigloop.log.gz").toStdString();
    configuration.filter.particles = 30;
    configuration.filter.algorithm = algorithm;
    return configuration;
}

QImage seen_in(QWidget& widget) {
    return widget.grab().toImage();
}

}  // namespace

void InspectTest::the_joint_covariance_is_a_picture() {
    Fixture f;
    f.session.set_configuration(with_algorithm("ekf-slam"));
    f.run_steps(200);
    QCOMPARE(f.session.snapshot()->joint_covariance.size(), 0);  // nobody looks
    f.trigger("action_joint_dock");
    auto* dock = f.window->findChild<JointCovariance*>();
    QTRY_VERIFY(f.shows_everything() && dock->view().isVisible());
    const auto snapshot = f.session.snapshot();
    const Eigen::MatrixXd& joint = snapshot->joint_covariance;
    QCOMPARE(joint.rows(), 3 + 2 * static_cast<Eigen::Index>(snapshot->best_map.size()));
    // The words of what the cursor is on: the robot's x with the first line's theta.
    const CorrelationView& view = dock->view();
    const auto* words = f.window->findChild<QLabel*>("joint_words");
    QTest::mouseMove(dock, {1, 1});
    QTest::mouseMove(&dock->view(), view.place_of({0, 4}).toPoint());
    const double correlation = joint(0, 4) / std::sqrt(joint(0, 0) * joint(4, 4));
    QVERIFY(std::abs(correlation) > 0.01);
    const QString said = QString("Robot x – Line 1 θ\nCorrelation %1\nCovariance %2 m·rad")
                             .arg(correlation, 0, 'f', 3)
                             .arg(joint(0, 4), 0, 'g', 4);
    QTRY_COMPARE(words->text(), said);
    QVERIFY(view.words({3, 3}).contains("Correlation 1.000"));
    QVERIFY(view.words({2, 2}).endsWith("rad²") && view.words({3, 1}).endsWith(" m²"));
    // Colours: no entry is surer of itself than the diagonal, and the picture is symmetric.
    const QImage picture = seen_in(dock->view());
    const auto colour = [&](const CorrelationView::Entry& entry) {
        return picture.pixelColor((view.place_of(entry) * picture.devicePixelRatio()).toPoint());
    };
    QCOMPARE(colour({3, 3}), colours().robot);
    QCOMPARE(colour({0, 4}), colour({4, 0}));
    f.prompts.saves = {f.path("joint.png"), f.path("joint.svg")};
    QApplication::clipboard()->clear();
    f.window->findChild<QPushButton*>("joint_copy")->click();
    QCOMPARE(QApplication::clipboard()->image().size(), view.size() * 2);
    in_dialog<ExportDialog>([](ExportDialog& dialog) { dialog.accept(); });
    f.window->findChild<QPushButton*>("joint_picture")->click();
    QCOMPARE(QImage(f.path("joint.png")).size(), view.size() * 2);
    in_dialog<ExportDialog>([](ExportDialog& dialog) { dialog.accept(); });
    f.window->findChild<QPushButton*>("joint_picture")->click();
    QVERIFY(Fixture::read(f.path("joint.svg")).contains("<svg"));
    // It follows the run, as long as it can be seen.
    f.run_steps(1);
    QVERIFY(f.session.snapshot()->joint_covariance.size() > 0);
    f.trigger("action_joint_dock");
    QTRY_VERIFY(f.shows_everything() && f.session.snapshot()->joint_covariance.size() == 0);
    // Others have none, and it is said.
    f.session.set_configuration(with_algorithm("fastslam"));
    f.trigger("action_joint_dock");
    f.run_steps(20);
    QVERIFY(!view.isVisible());
    QCOMPARE(words->text(),
             QString("FastSLAM 1.0 keeps no joint covariance of pose and landmarks."));
}

void InspectTest::the_poses_uncertainty_is_drawn() {
    Fixture f;
    f.action("layer_landmarks")->setChecked(false);
    for (const char* algorithm : {"ekf-slam", "fastslam"}) {
        f.session.set_configuration(with_algorithm(algorithm));
        f.run_steps(300);
        const Snapshot& snapshot = *f.session.snapshot();
        QVERIFY(snapshot.pose_covariance.trace() > 0.0);
        for (const bool world : {false, true}) {
            f.action("action_world_frame")->setChecked(world);
            for (CanvasView* view : {static_cast<CanvasView*>(&f.window->scan_view()),
                                     static_cast<CanvasView*>(&f.window->grid_view())}) {
                view->set_follow(true);
                for (int i = 0; i < 20; ++i) view->zoom(1.25);
                f.action("layer_uncertainty")->setChecked(false);
                const QImage without = seen_in(*view);
                f.action("layer_uncertainty")->setChecked(true);
                QVERIFY2(seen_in(*view) != without, algorithm);
                f.action("layer_robot")->setChecked(false);  // it is the robot's
                const QImage none = seen_in(*view);
                f.action("layer_uncertainty")->setChecked(false);
                QVERIFY(seen_in(*view) == none);
                f.action("layer_robot")->setChecked(true);
                view->fit();
            }
        }
    }
}

void InspectTest::the_nees_is_a_plot_where_the_truth_is_known() {
    Fixture f;
    f.trigger("action_plots_dock");
    f.session.set_configuration(with_algorithm("ekf-slam"));
    f.run_steps(200);
    QVERIFY(!f.window->plots().shows(Plots::pose_nees));  // of a log nothing is known
    Configuracion world = with_algorithm("ekf-slam");
    world.source.file = Fixture::source_file("data/worlds/bigloop.toml").toStdString();
    f.session.set_configuration(world);
    f.run_steps(200);
    QTRY_VERIFY(f.window->plots().shows(Plots::pose_nees));
    PositionError truth(*f.session.references().trajectory);
    int told = 0;
    for (const StepFigures& step : f.session.worker()->figures_since(0)) {
        told += nees_of(step, truth).has_value() ? 1 : 0;
    }
    QVERIFY(told > 100 && told < 200);  // at rest in the beginning the pose is certain
    QCOMPARE(f.window->plots().points(Plots::pose_nees), told);
    QVERIFY(f.window->plots().title(Plots::pose_nees).startsWith("NEES of the pose"));
}

}  // namespace hitos::window
