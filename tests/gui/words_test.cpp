// SPDX-License-Identifier: GPL-3.0-or-later
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
#include <algorithm>
#include <array>
#include <utility>

#include "actions/command_line.hpp"
#include "app/application.hpp"
#include "app/screenshot.hpp"
#include "dialogs/configuration_dialog.hpp"
#include "dialogs/run_until_dialog.hpp"
#include "dialogs/source_dialog.hpp"
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

/// What the thesis prints of its windows, by section. Dots of what asks further are Hitos's.
void WordsTest::the_window_speaks_the_words_of_the_thesis() {
    QTranslator spanish;
    QVERIFY(spanish.load(":/i18n/hitos_es.qm"));
    QApplication::installTranslator(&spanish);
    {
        Fixture f;
        using Words = QList<QPair<const char*, QString>>;
        const Words panel{// [T 9.2.6.3]
                          {"button_run", "Ejecutar"},
                          {"button_stop", "Detener"},
                          {"button_best_map", "Ver mejor partícula"},
                          {"button_step", "Ejecutar 1 paso"},
                          {"button_odometry", "Ver Odometría"},
                          {"button_save_map", "Guardar Mapa Mejor Partícula"},
                          {"button_restart", "Reiniciar"}};
        for (const auto& [name, words] : panel)
            QCOMPARE(f.window->findChild<QToolButton*>(name)->text(), words);
        const Words menus{// [T 9.2.6.4]
                          {"action_select_source", "Seleccionar Origen…"},
                          {"action_exit", "Salir"},
                          {"action_manual", "Configuración Manual…"},
                          {"action_load", "Cargar Configuración…"},
                          {"action_save", "Guardar Configuración…"},
                          {"action_set_default", "Establecer como predeterminada…"}};
        for (const auto& [name, words] : menus) QCOMPARE(f.action(name)->text(), words);
        const std::array<std::pair<ParameterGroup, const char*>, 6> groups{
            {// [T 9.2.6.1, 9.2.6.5]
             {ParameterGroup::source, "Origen de los datos"},
             {ParameterGroup::motion, "Modelo de movimiento"},
             {ParameterGroup::particle_filter, "Filtro de partículas"},
             {ParameterGroup::observation, "Modelo de observación"},
             {ParameterGroup::split_merge, "Algoritmo Split and Merge"},
             {ParameterGroup::resampling, "Remuestreo"}}};
        for (const auto& [group, words] : groups) QCOMPARE(title_of(group, {}), QString(words));
        ConfigurationDialog form(Fixture::tour(10), f.window.get());
        QCOMPARE(form.windowTitle(), QString("Configuración manual"));  // [T 9.2.6.4]
        const Words fields{
            // [T 8.2.2.4]
            {"filter.particles", "Número de partículas (M)"},
            {"features.detect", "Tipo de características"},
            {"association.p0", "Probabilidad de una nueva observación (P0)"},
            {"split_merge.min_points", "Mínimo número de puntos en una recta (Pmin)"},
            {"split_merge.dmax", "Máxima distancia a la recta (Dmax)"},
            {"split_merge.min_length", "Mínima longitud de una recta (Lmin)"},
            {"motion.model", "Modelo del robot"},
            {"resampling.rule", "Tipo de remuestreador"},
            {"resampling.neff_threshold", "Número de partículas efectivas (Neff)"}};
        for (const auto& [key, words] : fields) {
            QCOMPARE(full_label_of(find_parameter(key)), words);
            const QString& wanted = words;
            const auto labels = form.findChildren<QLabel*>();
            QVERIFY2(std::ranges::count_if(labels,
                                           [&wanted](const QLabel* label) {
                                               return label->text().replace('\n', ' ') == wanted;
                                           }) == 1,
                     key);
        }
        const auto offered = [](const char* key) {
            QStringList words;
            const ConfigParameter& parameter = find_parameter(key);
            for (std::size_t i = 0; i < parameter.choices.size(); ++i)
                words << choice_of(parameter, i);
            return words;
        };
        QCOMPARE(offered("features.detect"), QStringList({"Recta", "Punto", "Ambas"}));
        QVERIFY(offered("motion.model").contains("Diferencial con odometría"));
        QVERIFY(offered("motion.model").contains("Diferencial sin odometría"));
        QCOMPARE(offered("resampling.rule"), QStringList({"Sin umbral", "Con umbral Neff"}));
        QVERIFY(offered("association.method").contains("Máxima similitud"));  // [T 3.3.2]
        SourceDialog source({}, f.prompts, {}, f.window.get());
        QCOMPARE(source.windowTitle(), QString("Selección de origen"));
        f.run_steps(3);
        f.trigger("action_best_map");
        QVERIFY(f.window->result_actions().best_window()->windowTitle().startsWith(
            "Mapa de rejilla de la mejor partícula"));  // [T 9.2.6.3]
        f.trigger("action_odometry");
        QVERIFY(f.window->result_actions().odometry_window()->windowTitle().startsWith(
            "Mapa de rejilla basado en odometría"));
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
    QCOMPARE(title(ParameterGroup::particle_filter), QString("Particle filter"));
    QCOMPARE(title(ParameterGroup::split_merge), QString("Split and Merge algorithm"));
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
    QCOMPARE(box(ParameterGroup::particle_filter), QString("Particle filter"));
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
