// The translation, and the program from outside.

#include <QLabel>
#include <QProcess>
#include <QToolButton>
#include <QTranslator>
#include <QXmlStreamReader>

#include "app/application.hpp"
#include "dialogs/parameter_text.hpp"
#include "gui_fixture.hpp"
#include "tests.hpp"

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
        known("ParameterGroup", group.title);
    QApplication::installTranslator(&spanish);
    QCOMPARE(title_of(ParameterGroup::motion), QString("Modelo de movimiento"));
    QCOMPARE(label_of(find_parameter("filter.particles")), QString("Partículas"));
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

void WordsTest::the_program_makes_pictures_without_a_display() {
    QTemporaryDir folder;
    const QString path = folder.filePath("window.png");
    const Outcome outcome =
        run_program({"--screenshot", path, "--steps", "20", "--size", "1100x700", "--scale", "2",
                     "--language", "es", "--theme", "dark"});
    QVERIFY2(outcome.code == 0, qPrintable(outcome.errors));
    QCOMPARE(QImage(path).size(), QSize(2200, 1400));
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
