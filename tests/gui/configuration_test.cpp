// SPDX-License-Identifier: GPL-3.0-or-later
// Use cases 8.2.2.2 to 8.2.2.5: loading, saving, editing and keeping configurations.

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QToolButton>
#include <functional>
#include <utility>

#include "actions/command_line.hpp"
#include "dialogs/configuration_dialog.hpp"
#include "gui_fixture.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/files/trajectory_file.hpp"
#include "look/parameter_text.hpp"
#include "tests.hpp"

namespace hitos::window {
namespace {

void set_field(const QDialog& dialog, const char* key, const QString& text) {
    auto* line = dialog.findChild<QLineEdit*>(QString("field_") + key);
    QVERIFY(line != nullptr);
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, text);
}

QString error_at(const QDialog& dialog, const char* key) {
    return dialog.findChild<QLabel*>(QString("error_") + key)->text();
}

void press_ok(const QDialog& dialog) {
    dialog.findChild<QDialogButtonBox*>("buttons")->button(QDialogButtonBox::Ok)->click();
}

}  // namespace

void ConfigurationTest::a_configuration_is_loaded() {
    Fixture f;
    const QString path = f.write("other.cfg", "[filter]\nparticles = 7\n");
    f.prompts.opens = {path};
    f.prompts.confirms = {true};
    f.trigger("action_load");
    QCOMPARE(f.session.configuration().filter.particles, 7);
    QVERIFY(f.prompts.confirmed_texts.front().contains("other.cfg"));
    // The file names no log, so the one in use stays.
    QVERIFY(f.session.configuration().source.file.ends_with("bigloop.log.gz"));
    QCOMPARE(f.window->findChild<QLabel*>("value_filter.particles")->text(), QString("7"));
}

void ConfigurationTest::a_configuration_is_loaded_while_running() {
    Fixture f;
    f.session.set_pace(kUnhurried);
    f.trigger("action_run");
    QTRY_VERIFY(f.steps() > 2);
    f.prompts.opens = {f.write("other.cfg", "[filter]\nparticles = 7\n")};
    f.prompts.confirms = {true};
    f.trigger("action_load");
    QCOMPARE(f.session.configuration().filter.particles, 7);
    QCOMPARE(f.state(), Progress::State::ready);
    QCOMPARE(f.steps(), 0U);
    f.run_steps(2);
    QCOMPARE(f.session.snapshot()->hypotheses.size(), std::size_t{7});
}

void ConfigurationTest::a_configuration_whose_log_is_missing_is_told() {
    Fixture f;
    f.run_steps(3);
    f.prompts.opens = {f.write("lost.cfg", "[source]\nfile = \"/nowhere/tour.log\"\n")};
    f.prompts.confirms = {true};
    f.trigger("action_load");
    QCOMPARE(f.prompts.opens_asked, 2);  // told, then asked for again
    QVERIFY2(f.prompts.warnings.front().contains("/nowhere/tour.log"),
             qPrintable(f.prompts.warnings.front()));
    QCOMPARE(f.steps(), 3U);
}

void ConfigurationTest::loading_can_be_declined_or_cancelled() {
    Fixture f;
    f.run_steps(3);
    f.prompts.opens = {f.write("other.cfg", "[filter]\nparticles = 7\n")};
    f.prompts.confirms = {false};
    f.trigger("action_load");
    QCOMPARE(f.session.configuration().filter.particles, 10);
    f.trigger("action_load");  // cancelled in the file dialog
    QCOMPARE(f.steps(), 3U);
    QVERIFY(f.prompts.warnings.isEmpty());
}

void ConfigurationTest::a_bad_file_is_told_and_asked_for_again() {
    Fixture f;
    f.prompts.opens = {"/nowhere/x.cfg", f.write("bad.cfg", "[filter]\nparticles = 0\n"),
                       f.write("good.cfg", "[filter]\nparticles = 9\n")};
    f.prompts.confirms = {true};
    f.trigger("action_load");
    QCOMPARE(f.prompts.opens_asked, 3);
    QCOMPARE(f.prompts.warnings.size(), 2);
    QVERIFY(f.prompts.warnings[0].contains("/nowhere/x.cfg"));
    QVERIFY2(f.prompts.warnings[1].contains("filter.particles"), qPrintable(f.prompts.warnings[1]));
    QCOMPARE(f.session.configuration().filter.particles, 9);
}

void ConfigurationTest::a_relative_log_is_found_beside_its_file() {
    Fixture f(false);
    f.write("small.txt", "ODOM 0 0 0\nLASER 0 2 1 0 1 1\n");
    f.prompts.opens = {f.write("tour.cfg", "[source]\nfile = \"small.txt\"\n")};
    f.prompts.confirms = {true};
    f.trigger("action_load");
    QVERIFY(f.session.has_source());
}

void ConfigurationTest::the_configuration_is_saved() {
    Fixture f;
    f.prompts.saves = {f.path("mine.cfg")};
    f.trigger("action_save");
    QCOMPARE(QString::fromUtf8(Fixture::read(f.path("mine.cfg"))),
             QString::fromStdString(ArchivoConfiguracion::to_text(f.session.configuration())));
    QTRY_VERIFY2(f.notice().contains("mine.cfg"), qPrintable(f.notice()));
}

void ConfigurationTest::saving_asks_before_it_overwrites() {
    Fixture f;
    const QString there = f.write("there.cfg", "precious");
    f.prompts.saves = {there, f.path("new.cfg")};
    f.prompts.confirms = {false};
    f.trigger("action_save");
    QCOMPARE(Fixture::read(there), QByteArray("precious"));
    QVERIFY(QFile::exists(f.path("new.cfg")));
    QCOMPARE(f.prompts.saves_asked, 2);
    f.prompts.saves = {there};
    f.prompts.confirms = {true};
    f.trigger("action_save");
    QVERIFY(Fixture::read(there).startsWith("# Configuration of Hitos"));
}

void ConfigurationTest::a_target_that_cannot_be_written_is_told_and_asked_for_again() {
    Fixture f;
    f.prompts.saves = {f.path("no/such/folder/a.cfg"), f.path("good.cfg")};
    f.trigger("action_save");
    QCOMPARE(f.prompts.warnings.size(), 1);
    QVERIFY(f.prompts.warnings.front().contains("no/such/folder"));
    QVERIFY(QFile::exists(f.path("good.cfg")));
}

void ConfigurationTest::saving_can_be_cancelled() {
    Fixture f;
    f.trigger("action_save");
    QCOMPARE(f.prompts.saves_asked, 1);
    QVERIFY(f.prompts.warnings.isEmpty());
}

void ConfigurationTest::values_are_changed_in_the_form() {
    Fixture f;
    f.run_steps(3);
    in_dialog<ConfigurationDialog>([](ConfigurationDialog& dialog) {
        set_field(dialog, "filter.particles", "25");
        const QString told = dialog.findChild<QLabel*>("verdict")->text();
        QVERIFY2(told.contains("Number of particles (M): 10 → 25"), qPrintable(told));
        set_field(dialog, "split_merge.dmax", "0.05");
        auto* detect = dialog.findChild<QComboBox*>("field_features.detect");
        detect->setCurrentIndex(0);
        press_ok(dialog);
    });
    f.trigger("action_manual");
    QCOMPARE(f.session.configuration().filter.particles, 25);
    QCOMPARE(f.session.configuration().extraction.split_merge.dmax_m, 0.05);
    QCOMPARE(f.session.configuration().extraction.detect, Detection::lines);
    QVERIFY(f.prompts.confirmed_texts.isEmpty());  // the form said what changes; undo is there
    QCOMPARE(f.steps(), 0U);                       // it starts from the beginning
}

void ConfigurationTest::the_form_shows_first_what_the_cards_show() {
    ConfigurationDialog dialog(Configuracion{}, nullptr);
    dialog.show();
    const auto shown = [&dialog](const char* key) {
        return dialog.findChild<QWidget*>(QString("field_") + key)->isVisible();
    };
    QVERIFY(shown("filter.particles") && shown("motion.sigma_x") && shown("resampling.rule"));
    QVERIFY(!shown("motion.var_along") && !shown("grid.hit") && !shown("landmarks.probation"));
    // Another model has other values.
    auto* model = dialog.findChild<QComboBox*>("field_motion.model");
    model->setCurrentIndex(
        static_cast<int>(find_parameter("motion.model").place_of("proportional").value()));
    QVERIFY(shown("motion.var_along") && !shown("motion.sigma_x"));
    auto* more = dialog.findChild<QToolButton*>(
        QString("more_%1").arg(static_cast<int>(ParameterGroup::grid)));
    const QString words = more->text();
    more->click();
    QVERIFY(shown("grid.hit") && shown("grid.max_range"));
    more->click();
    QVERIFY(!shown("grid.hit"));
    QCOMPARE(more->text(), words);
    // What differs from its default is never out of sight.
    Configuracion changed;
    set_parameter(changed, "grid.hit=0.5");
    ConfigurationDialog other(changed, nullptr);
    other.show();
    QVERIFY(other.findChild<QWidget*>("field_grid.hit")->isVisible());
    QVERIFY(!other.findChild<QWidget*>("field_grid.miss")->isVisible());
}

void ConfigurationTest::the_form_is_searched() {
    Fixture f;
    ConfigurationDialog dialog(f.session.configuration(), nullptr);
    dialog.show();
    auto* search = dialog.findChild<QLineEdit*>("search");
    const auto found = [&dialog, search](const QString& words) {
        search->setText(words);
        QStringList keys;
        for (const auto* field : dialog.findChildren<QWidget*>(QRegularExpression("^field_")))
            if (field->isVisible()) keys << field->objectName().mid(6);
        return keys;
    };
    QCOMPARE(found("grid.max_range"), QStringList{"grid.max_range"});
    QVERIFY(found("RAY drawn length").contains("grid.max_range"));  // of its description
    QVERIFY(found("grid map").contains("grid.hit"));                // the title's is the group
    QVERIFY(found("loops").size() > 1 && !found("loops").contains("filter.particles"));
    QVERIFY(found("nothing-of-the-kind").isEmpty());
    QVERIFY(!search->toolTip().isEmpty());
    // Return goes to what was found, and changes nothing; Escape shows all again.
    search->setText("grid.max_range");
    search->setFocus();
    QTest::keyClick(search, Qt::Key_Return);
    QVERIFY(dialog.isVisible());
    QCOMPARE(dialog.focusWidget()->objectName(), QString("field_grid.max_range"));
    search->setFocus();
    QTest::keyClick(search, Qt::Key_Escape);
    QVERIFY(dialog.isVisible() && search->text().isEmpty());
    QVERIFY(dialog.findChild<QWidget*>("field_filter.particles")->isVisible());
    // A mistake comes into sight, wherever it is.
    search->setText("particles");
    set_field(dialog, "grid.resolution", "wide");
    dialog.accept();
    QVERIFY(dialog.isVisible() && search->text().isEmpty());
    QVERIFY(dialog.findChild<QLabel*>("error_grid.resolution")->isVisible());
}

void ConfigurationTest::every_mistake_is_shown_at_its_field() {
    Fixture f;
    in_dialog<ConfigurationDialog>([](ConfigurationDialog& dialog) {
        set_field(dialog, "filter.particles", "0");
        set_field(dialog, "split_merge.dmax", "wide");
        press_ok(dialog);
        QVERIFY(dialog.isVisible());
        QVERIFY(!error_at(dialog, "filter.particles").isEmpty());
        QVERIFY(!error_at(dialog, "split_merge.dmax").isEmpty());
        QVERIFY(error_at(dialog, "grid.resolution").isEmpty());
        QVERIFY(dialog.findChild<QLabel*>("verdict")->text().contains('2'));
        dialog.reject();
    });
    f.trigger("action_manual");
    QCOMPARE(f.session.configuration().filter.particles, 10);
}

void ConfigurationTest::values_that_are_impossible_together_are_refused() {
    Fixture f;
    in_dialog<ConfigurationDialog>([](ConfigurationDialog& dialog) {
        set_field(dialog, "grid.hit", "0");
        set_field(dialog, "grid.miss", "0");
        press_ok(dialog);
        QVERIFY(!error_at(dialog, "grid.hit").isEmpty());
        dialog.reject();
    });
    f.trigger("action_manual");
    QCOMPARE(f.session.configuration().grid.log_odds_hit, 0.85);
}

void ConfigurationTest::the_form_can_be_cancelled_or_declined() {
    Fixture f;
    f.run_steps(3);
    in_dialog<ConfigurationDialog>([](ConfigurationDialog& dialog) {
        set_field(dialog, "filter.particles", "25");
        dialog.reject();
    });
    f.trigger("action_manual");
    QCOMPARE(f.session.configuration().filter.particles, 10);
    // A long run is not lost without a question; where that is declined the form comes again.
    f.window->run_guard().set_long_run(0.0);
    in_dialog<ConfigurationDialog>([](ConfigurationDialog& dialog) {
        set_field(dialog, "filter.particles", "25");
        in_dialog<ConfigurationDialog>([](ConfigurationDialog& again) {
            QCOMPARE(again.findChild<QLineEdit*>("field_filter.particles")->text(), QString("25"));
            again.reject();
        });
        press_ok(dialog);
    });
    f.trigger("action_manual");
    QCOMPARE(f.prompts.confirmed_texts.size(), 1);
    QCOMPARE(f.session.configuration().filter.particles, 10);
    QCOMPARE(f.steps(), 3U);
}

void ConfigurationTest::the_form_opens_while_the_run_goes_on() {
    Fixture f;
    f.session.set_pace(kUnhurried);
    f.trigger("action_run");
    QTRY_VERIFY(f.steps() > 2);
    in_dialog<ConfigurationDialog>([&f](ConfigurationDialog& dialog) {
        const quint64 there = f.steps();
        QTRY_VERIFY(f.steps() > there || f.state() == Progress::State::finished);
        set_field(dialog, "filter.particles", "25");
        press_ok(dialog);
    });
    f.trigger("action_manual");
    QCOMPARE(f.session.configuration().filter.particles, 25);
    QCOMPARE(f.state(), Progress::State::ready);
}

void ConfigurationTest::what_the_models_do_not_use_is_grey() {
    Fixture f;
    ConfigurationDialog dialog(f.session.configuration(), nullptr);
    auto* rule = dialog.findChild<QComboBox*>("field_resampling.rule");
    auto* threshold = dialog.findChild<QWidget*>("field_resampling.neff_threshold");
    for (int i = 0; i < rule->count(); ++i) {
        rule->setCurrentIndex(i);
        emit rule->activated(i);
        QCOMPARE(threshold->isEnabled(), static_cast<ResamplingRule>(i) == ResamplingRule::neff);
    }
    const auto enabled = [&](const char* key) {
        return dialog.findChild<QWidget*>(QString("field_") + key)->isEnabled();
    };
    const auto choose = [&](const char* key, int place) {
        auto* choice = dialog.findChild<QComboBox*>(QString("field_") + key);
        choice->setCurrentIndex(place);
        emit choice->activated(place);
    };
    QVERIFY(enabled("filter.particles") && !enabled("association.new_probability"));
    choose("filter.algorithm", 1);
    QVERIFY(!enabled("filter.particles") && enabled("association.new_probability"));
    QVERIFY(!enabled("resampling.neff_threshold") && enabled("association.gate_probability"));
    QVERIFY(enabled("split_merge.dmax") && !enabled("ransac.threshold"));
    choose("features.method", 1);
    QVERIFY(!enabled("split_merge.dmax") && enabled("ransac.threshold"));
    QVERIFY(enabled("observation.var_rho") && !enabled("observation.point_sigma"));
    choose("observation.covariance", static_cast<int>(ObservationCovariance::points));
    QVERIFY(!enabled("observation.var_rho") && enabled("observation.point_sigma"));
}

void ConfigurationTest::the_cards_show_what_is_used() {
    Fixture f;
    const auto shown = [&](const char* key) {
        return f.window->findChild<QLabel*>(QString("value_") + key) != nullptr;
    };
    QVERIFY(shown("split_merge.dmax") && !shown("ransac.threshold"));
    QVERIFY(shown("motion.sigma_x") && !shown("motion.var_along"));
    QVERIFY(shown("filter.particles") && !shown("association.new_probability"));
    Configuracion configuration = f.session.configuration();
    for (const char* assignment :
         {"features.method=ransac", "motion.model=proportional", "filter.algorithm=ekf-slam"})
        set_parameter(configuration, assignment);
    f.session.set_configuration(configuration);
    QVERIFY(!shown("split_merge.dmax") && shown("ransac.threshold"));
    QVERIFY(!shown("motion.sigma_x") && shown("motion.var_along"));
    QVERIFY(!shown("filter.particles") && shown("association.new_probability"));
    QVERIFY(shown("run.seed") && shown("association.ambiguity") && !shown("grid.hit"));
}

void ConfigurationTest::the_form_has_every_parameter() {
    Fixture f;
    ConfigurationDialog dialog(f.session.configuration(), nullptr);
    // What is read has a dialog of its own.
    const QStringList elsewhere{"source.file", "source.format", "source.scan_topic",
                                "source.odom_topic"};
    for (const ConfigParameter& parameter : parameters()) {
        if (elsewhere.contains(to_qt(parameter.key))) continue;
        const QString name = "field_" + QString::fromStdString(std::string(parameter.key));
        auto* editor = dialog.findChild<QWidget*>(name);
        QVERIFY2(editor != nullptr, qPrintable(name));
        QVERIFY(!editor->toolTip().isEmpty());
    }
}

void ConfigurationTest::what_findings_advise_is_in_the_form() {
    Fixture f;
    in_dialog<ConfigurationDialog>([](ConfigurationDialog& dialog) {
        set_field(dialog, "source.laser_pose", "0.1,0,90");
        set_field(dialog, "source.scan_delay", "0.25");
        QVERIFY(!dialog.findChild<QLineEdit*>("field_source.world_set")->isEnabled());  // no world
        press_ok(dialog);
    });
    f.trigger("action_manual");
    QCOMPARE(f.session.configuration().source.read.laser_pose, std::string("0.1,0,90"));
    QCOMPARE(f.session.configuration().source.read.scan_delay_s, 0.25);
    QVERIFY(f.session.configuration().source.file.ends_with("bigloop.log.gz"));
}

void ConfigurationTest::the_default_is_written_and_read_at_start() {
    Fixture f;
    f.prompts.confirms = {true};
    f.trigger("action_set_default");
    QVERIFY(f.files.has_init());
    QVERIFY(f.prompts.confirmed_texts.front().contains("init.cfg"));
    const Configuracion at_start = starting_configuration(CommandLine{}, f.files);
    QCOMPARE(ArchivoConfiguracion::to_text(at_start),
             ArchivoConfiguracion::to_text(f.session.configuration()));
}

void ConfigurationTest::the_default_is_not_written_without_consent() {
    Fixture f;
    f.trigger("action_set_default");
    QVERIFY(!f.files.has_init());
}

void ConfigurationTest::a_default_that_cannot_be_written_is_told() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("file");
    QFile blocked(file);
    QVERIFY(blocked.open(QIODevice::WriteOnly));
    UserFiles files(file + "/user");
    ScriptedPrompts prompts;
    Session session;
    const RunGuard guard(session, prompts, nullptr);
    ConfigurationActions actions(session, files, prompts, guard, nullptr);
    prompts.confirms = {true};
    actions.set_default();
    QCOMPARE(prompts.warnings.size(), 1);
    QVERIFY2(prompts.warnings.front().contains("init.cfg"), qPrintable(prompts.warnings.front()));
}

void ConfigurationTest::references_are_loaded() {
    Fixture f;
    f.prompts.opens = {"/nowhere/a.map", Fixture::source_file("data/maps/bigloop.map")};
    f.trigger("action_reference_map");
    QCOMPARE(f.prompts.warnings.size(), 1);
    QCOMPARE(f.session.references().map->size(), 16U);
}

/// By the odometry; the run itself has not begun.
void ConfigurationTest::a_reference_is_doubted_before_the_run() {
    Fixture f;
    f.run_steps(1050);
    const Trajectory path = f.session.snapshot()->odometry_trajectory;
    QCOMPARE(path.size(), 1050U);
    f.session.set_configuration(Fixture::tour(7));
    const auto load = [&](const std::function<void(StampedPose&)>& change) {
        Trajectory changed = path;
        for (StampedPose& pose : changed) change(pose);
        write_trajectory(changed, f.path("reference.tum").toStdString());
        f.prompts.opens = {f.path("reference.tum")};
        f.trigger("action_reference_trajectory");
        f.prompts.opens.clear();
        const QStringList warned = std::exchange(f.prompts.warnings, {});
        return warned.isEmpty() ? QString() : warned.front();
    };
    QCOMPARE(load([](StampedPose&) {}), QString());
    const QString large = load([](StampedPose& stamped) {
        stamped.pose.x *= 100.0;
        stamped.pose.y *= 100.0;
    });
    QVERIFY2(large.contains("centimetres"), qPrintable(large));
    const QString late = load([](StampedPose& stamped) { stamped.time_s += 1e6; });
    QVERIFY2(late.contains("not one of this tour"), qPrintable(late));
    QCOMPARE(f.steps(), 0U);
}

void ConfigurationTest::references_go_with_their_log() {
    Fixture f;
    QVERIFY(!f.action("action_remove_references")->isEnabled());
    const auto load = [&f] {
        f.prompts.opens = {Fixture::source_file("data/maps/bigloop.map")};
        f.trigger("action_reference_map");
        QVERIFY(f.session.references().map && !f.session.reference_map_file().isEmpty());
    };
    load();
    f.trigger("action_remove_references");
    QVERIFY(!f.session.references().map && f.session.reference_map_file().isEmpty());
    load();
    f.session.set_configuration(Fixture::tour(7));  // of the same log
    QVERIFY(f.session.references().map.has_value());
    const QString path = f.write("small.txt", "ODOM 0 0 0\nLASER 0 2 1 0 1 1\n");
    QVERIFY(f.window->configuration_actions().open(path));
    QVERIFY(!f.session.references().map && f.session.reference_map_file().isEmpty());
}

void ConfigurationTest::a_form_that_could_not_be_applied_keeps_its_values() {
    Fixture f(false);
    const QByteArray log = "ODOM 0 0 0\nLASER 0 2 1 0 1 1\n";
    QVERIFY(f.window->configuration_actions().open(f.write("small.txt", log)));
    in_dialog<ConfigurationDialog>([&](ConfigurationDialog& dialog) {
        QFile::remove(f.path("small.txt"));
        set_field(dialog, "filter.particles", "25");
        in_dialog<ConfigurationDialog>([&](ConfigurationDialog& again) {
            QCOMPARE(f.prompts.warnings.size(), 1);
            f.write("small.txt", log);
            press_ok(again);
        });
        press_ok(dialog);
    });
    f.trigger("action_manual");
    QCOMPARE(f.session.configuration().filter.particles, 25);
}

void ConfigurationTest::a_mistake_that_becomes_unused_is_forgotten() {
    Fixture f;
    in_dialog<ConfigurationDialog>([](ConfigurationDialog& dialog) {
        auto* particles = dialog.findChild<QLineEdit*>("field_filter.particles");
        set_field(dialog, "filter.particles", "0");
        QVERIFY(!error_at(dialog, "filter.particles").isEmpty());
        auto* algorithm = dialog.findChild<QComboBox*>("field_filter.algorithm");
        algorithm->setCurrentIndex(1);
        QVERIFY(!particles->isEnabled() && error_at(dialog, "filter.particles").isEmpty());
        QCOMPARE(particles->text(), QString("10"));
        press_ok(dialog);
    });
    f.trigger("action_manual");
    QCOMPARE(f.session.configuration().filter.algorithm, std::string("ekf-slam"));
}

}  // namespace hitos::window
