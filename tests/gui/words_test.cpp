// The translation, and the program from outside.

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QFrame>
#include <QLabel>
#include <QProcess>
#include <QToolButton>
#include <QTranslator>
#include <QXmlStreamReader>

#include "actions/command_line.hpp"
#include "app/application.hpp"
#include "app/screenshot.hpp"
#include "dialogs/configuration_dialog.hpp"
#include "dialogs/run_until_dialog.hpp"
#include "gui_fixture.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "look/parameter_text.hpp"
#include "tests.hpp"
#include "views/plots.hpp"

namespace hitos::window {
namespace {

constexpr const char* kTranslation = "ui/qt/translations/hitos_es.ts";

struct Outcome {
    int code = -1;
    QString errors;
};

Outcome run_program(const QStringList& arguments) {
    QProcess program;
    program.start(QString(HITOS_BIN_DIR) + "/hitos", arguments);
    if (!program.waitForFinished(120000)) return {};
    return {program.exitCode(), QString::fromUtf8(program.readAllStandardError())};
}

}  // namespace

void WordsTest::nothing_is_left_untranslated() {
    QFile file(Fixture::source_file(kTranslation));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    int messages = 0;
    QString source;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String("source")) source = xml.readElementText();
        if (xml.name() != QLatin1String("translation")) continue;
        ++messages;
        QVERIFY2(xml.attributes().value("type").isEmpty(), qPrintable(source));
        const QString words = xml.readElementText();
        QVERIFY2(!words.isEmpty(), qPrintable(source));
        for (const char* place : {"%1", "%2", "%3", "%4", "%5"})
            QVERIFY2(source.contains(place) == words.contains(place), qPrintable(source));
    }
    QVERIFY(!xml.hasError());
    QVERIFY(messages > 250);
}

void WordsTest::every_parameter_has_spanish_words() {
    QTranslator spanish;
    QVERIFY(spanish.load(":/i18n/hitos_es.qm"));
    // As the tables mark them; a text that the translation does not know comes back empty. Names
    // and symbols may be the same in both languages.
    const auto known = [&](const char* context, std::string_view text) {
        const std::string source(text);
        QVERIFY2(!spanish.translate(context, source.c_str()).isEmpty(), source.c_str());
    };
    for (const ConfigParameter& parameter : parameters()) {
        known("Parameter", parameter.description);
        known("ParameterLabel", parameter.label);
        for (const ParameterChoice& choice : parameter.choices)
            known("ParameterChoice", choice.label);
        QVERIFY(spanish.translate("Parameter", std::string(parameter.description).c_str()) !=
                to_qt(parameter.description));
    }
    for (const ParameterGroupFacts& group : parameter_groups())
        if (group.title_key.empty()) known("ParameterGroup", group.title);
    QApplication::installTranslator(&spanish);
    QCOMPARE(title_of(ParameterGroup::motion, {}), QString("Modelo de movimiento"));
    QCOMPARE(label_of(find_parameter("filter.particles")), QString("Partículas"));
    QCOMPARE(unit_of(find_parameter("motion.sigma_x")), QString("m o m²"));
    QCOMPARE(unit_of(find_parameter("motion.sigma_theta")), QString("rad o rad²"));
    QApplication::removeTranslator(&spanish);
}

void WordsTest::the_window_speaks_spanish() {
    QTranslator spanish;
    QVERIFY(spanish.load(":/i18n/hitos_es.qm"));
    QApplication::installTranslator(&spanish);
    {
        Fixture f;
        const QList<QPair<const char*, QString>> buttons{
            {"button_run", "Ejecutar"},
            {"button_stop", "Detener"},
            {"button_step", "Ejecutar 1 paso"},
            {"button_best_map", "Ver mejor partícula"},
            {"button_odometry", "Ver odometría"},
            {"button_save_map", "Guardar mapa mejor partícula"},
            {"button_restart", "Reiniciar"}};
        for (const auto& [name, words] : buttons)
            QCOMPARE(f.window->findChild<QToolButton*>(name)->text(), words);
        QCOMPARE(f.action("action_select_source")->text(), QString("Seleccionar origen…"));
        QCOMPARE(f.window->findChild<QLabel*>("value_motion.model")->text(),
                 QString("Diferencial con odometría"));
    }
    QApplication::removeTranslator(&spanish);
}

void WordsTest::headings_name_what_runs() {
    Fixture f;
    const auto title = [&](ParameterGroup group) -> QString {
        for (auto* card : f.window->findChildren<QFrame*>()) {
            if (card->property("group") == QVariant(static_cast<int>(group))) {
                return card->accessibleName();
            }
        }
        return {};
    };
    QCOMPARE(title(ParameterGroup::particle_filter), QString("FastSLAM 1.0"));
    QCOMPARE(title(ParameterGroup::split_merge), QString("Split and Merge"));
    QCOMPARE(f.action("action_best_map")->text(), QString("View best particle"));
    Configuracion configuration = Fixture::tour(10);
    configuration.filter.algorithm = "ekf-slam";
    configuration.extraction.method = "ransac";
    f.session.set_configuration(configuration);
    QCOMPARE(title(ParameterGroup::particle_filter), QString("EKF-SLAM"));
    QCOMPARE(title(ParameterGroup::split_merge), QString("RANSAC"));
    QCOMPARE(f.window->findChild<QToolButton*>("button_best_map")->text(), QString("View map"));
    QCOMPARE(f.window->findChild<QToolButton*>("button_save_map")->text(), QString("Save map"));
    f.run_steps(20);
    f.trigger("action_best_map");
    const QString map = f.window->result_actions().best_window()->windowTitle();
    QVERIFY2(map.startsWith("Grid map by EKF-SLAM"), qPrintable(map));
    // In the form at once, with what is chosen there.
    ConfigurationDialog dialog(configuration, f.window.get());
    const auto box = [&](ParameterGroup group) {
        auto* frame = dialog.findChild<QWidget*>(QString("group_%1").arg(static_cast<int>(group)));
        return frame->findChild<QLabel*>()->text();
    };
    QCOMPARE(box(ParameterGroup::particle_filter), QString("EKF-SLAM"));
    dialog.findChild<QComboBox*>("field_filter.algorithm")->setCurrentIndex(0);
    QCOMPARE(box(ParameterGroup::particle_filter), QString("FastSLAM 1.0"));
    QCOMPARE(box(ParameterGroup::split_merge), QString("RANSAC"));
}

/// No text of the window that can be seen.
void WordsTest::nothing_speaks_of_particles_that_are_not_there() {
    Fixture f;
    for (const char* dock : {"plots_dock", "landmarks_dock", "associations_dock"})
        f.trigger((std::string("action_") + dock).c_str());
    Configuracion configuration = Fixture::tour(10);
    for (const char* algorithm : {"ekf-slam", "graph-slam"}) {
        configuration.filter.algorithm = algorithm;
        f.session.set_configuration(configuration);
        f.run_steps(30);
        QStringList said;
        for (auto* action : f.window->findChildren<QAction*>()) {
            // The name of the tool, the presets of other algorithms, and lessons about them, stay.
            const QString name = action->objectName();
            if (!action->isVisible() || name == "action_particles_dock") continue;
            if (name.startsWith("action_preset_") || name == "action_save_figures") continue;
            if (name.startsWith("action_lesson_")) continue;
            said << action->text() << action->toolTip();
        }
        for (auto* dock : f.window->findChildren<QDockWidget*>()) {
            dock->raise();
            for (auto* label : dock->findChildren<QLabel*>())
                if (label->isVisible()) said << label->text();
        }
        for (auto* label : f.window->statusBar()->findChildren<QLabel*>())
            if (label->isVisible()) said << label->text();
        QVERIFY(said.size() > 50);
        for (const QString& text : said) {
            for (const char* word : {"article", "Neff", "Split"})
                QVERIFY2(!text.contains(word), qPrintable(text));
        }
        QVERIFY(!f.window->plots().shows(Plots::neff));
        QVERIFY(!f.window->plots().shows(Plots::best_weight));
        in_dialog<RunUntilDialog>([](RunUntilDialog& dialog) {
            QVERIFY(!dialog.findChild<QCheckBox*>("until_neff")->isEnabled());
            QVERIFY(!dialog.findChild<QCheckBox*>("until_best")->isEnabled());
            dialog.reject();
        });
        f.trigger("action_run_until");
    }
    // The table of particles says so itself.
    f.trigger("action_particles_dock");
    QCOMPARE(f.window->findChild<QLabel*>("no_particles")->text(),
             QString("Graph-SLAM has no particles."));
    QVERIFY(!f.window->findChild<QWidget*>("particle_table")->isVisible());
    // With particles all is there again.
    f.session.set_configuration(Fixture::tour(10));
    QVERIFY(f.action("action_particle_map")->isVisible());
    QVERIFY(f.action("layer_particles")->isVisible() && f.action("layer_ancestry")->isVisible());
    QVERIFY(f.window->findChild<QWidget*>("particle_table")->isVisible());
}

void WordsTest::the_program_makes_pictures_without_a_display() {
    QTemporaryDir folder;
    const QString path = folder.filePath("window.png");
    const Outcome outcome =
        run_program({"--screenshot", path, "--steps", "20", "--size", "1100x700", "--scale", "2",
                     "--language", "es", "--theme", "dark"});
    QVERIFY2(outcome.code == 0, qPrintable(outcome.errors));
    QCOMPARE(QImage(path).size(), QSize(2200, 1400));
}

void WordsTest::a_picture_says_of_how_many_scans() {
    for (const char* show : {"landmarks", "particles", "runs"}) {
        Fixture f;
        CommandLine line;
        line.show = show;
        line.steps = 3;
        line.screenshot = f.path("window.png").toStdString();
        take_screenshot(*f.window, f.session, line);
        const QString words = f.window->findChild<QLabel*>("status_scan")->text();
        QVERIFY2(words == "Scan 3 of 1050", qPrintable(words));
    }
}

void WordsTest::the_program_tells_what_is_wrong() {
    QTemporaryDir folder;
    const QString picture = folder.filePath("a.png");
    const Outcome missing = run_program({"/nowhere/tour.log", "--screenshot", picture});
    QCOMPARE(missing.code, 1);
    QVERIFY2(missing.errors.contains("/nowhere/tour.log"), qPrintable(missing.errors));
    const Outcome wrong = run_program({"--set", "filter.particle=5", "--screenshot", picture});
    QCOMPARE(wrong.code, 1);
    QVERIFY2(wrong.errors.contains("filter.particles"), qPrintable(wrong.errors));
    QVERIFY(run_program({"--language", "xx"}).code != 0);
    QCOMPARE(run_program({"--help"}).code, 0);
    QCOMPARE(run_program({"--version"}).code, 0);
}

}  // namespace hitos::window
