// SPDX-License-Identifier: GPL-3.0-or-later
// What the libraries tell, in the language of the window.

#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTranslator>
#include <QXmlStreamReader>
#include <functional>

#include "dialogs/configuration_dialog.hpp"
#include "dialogs/source_dialog.hpp"
#include "gui_fixture.hpp"
#include "hitos/services/study/study.hpp"
#include "hitos/simulation/worlds/odometry_noise.hpp"
#include "look/words_of.hpp"
#include "tests.hpp"

namespace hitos::window {
namespace {

/// The program speaks Spanish as long as one of these lives.
class Spanish {
  public:
    Spanish() {
        if (!words_.load(":/i18n/hitos_es.qm")) qFatal("no Spanish words");
        QApplication::installTranslator(&words_);
    }
    ~Spanish() { QApplication::removeTranslator(&words_); }
    Spanish(const Spanish&) = delete;
    Spanish& operator=(const Spanish&) = delete;
    const QTranslator& words() const { return words_; }

  private:
    QTranslator words_;
};

/// Words that stand in nearly every English message and in no Spanish one.
QString english_in(const QString& text) {
    static const QRegularExpression words(
        R"(\b(the|is|are|of|and|or|to|with|found|expected|choose|cannot|lines?|file|log|first)\b)",
        QRegularExpression::UseUnicodePropertiesOption);
    const QRegularExpressionMatch match = words.match(text);
    return match.hasMatch() ? text : QString();
}

#define VERIFY_SPANISH(text, wanted)                       \
    do {                                                   \
        const QString& said = (text);                      \
        QVERIFY2(said.contains(wanted), qPrintable(said)); \
        QCOMPARE(english_in(said), QString());             \
    } while (false)

QString warning_about(Fixture& f, const QString& path) {
    if (f.prompts.warnings.isEmpty()) return "no warning";
    return f.prompts.warnings.last().replace(path, "…");
}

QString verdict_on(Fixture& f, const QString& path) {
    QString verdict;
    in_dialog<SourceDialog>([&verdict, path](SourceDialog& dialog) {
        const auto* label = dialog.findChild<QLabel*>("verdict");
        dialog.set_path(path);
        QTRY_VERIFY(!label->text().startsWith("Leyendo"));
        verdict = label->text();
        dialog.reject();
    });
    f.trigger("action_select_source");
    return verdict.replace(path, "…");
}

QSet<QString> places_of(const QString& text) {
    static const QRegularExpression place("%[1-9]");
    QSet<QString> places;
    for (const QRegularExpressionMatch& match : place.globalMatch(text)) places << match.captured();
    return places;
}

}  // namespace

void WordsTest::every_message_of_the_libraries_is_translated() {
    const Spanish spanish;
    QFile file(Fixture::source_file("ui/qt/translations/hitos_es.ts"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    QString context;
    int messages = 0;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String("name")) context = xml.readElementText();
        if (xml.name() != QLatin1String("source") || context != "Errors") continue;
        const QString source = xml.readElementText();
        const QString words = spanish.words().translate("Errors", source.toUtf8());
        QVERIFY2(!words.isEmpty() && words != source, qPrintable(source));
        QCOMPARE(places_of(words), places_of(source));
        QVERIFY2(english_in(words).isEmpty(), qPrintable(words));
        ++messages;
    }
    QVERIFY(messages > 200);
}

void WordsTest::a_refused_log_is_told_in_spanish() {
    const Spanish spanish;
    Fixture f(false);
    const QString letter = f.write("carta.log", "Querido lector,\nesto no es nada.\n");
    QVERIFY(!f.window->configuration_actions().open(letter));
    VERIFY_SPANISH(warning_about(f, letter), "ninguna línea es de un formato que Hitos lea");
    VERIFY_SPANISH(verdict_on(f, letter), "carmen, mrclam, rosbag, mcap, db3 o rosbag2");
    VERIFY_SPANISH(verdict_on(f, f.write("vacio.log", "")), "está vacío");
    VERIFY_SPANISH(verdict_on(f, "/nowhere/x.log"), "no existe");
    VERIFY_SPANISH(verdict_on(f, f.folder.path()), "es una carpeta");
}

void WordsTest::choices_are_told_in_spanish() {
    const Spanish spanish;
    const auto told = [](const std::function<void()>& wrong) {
        try {
            wrong();
        } catch (const std::exception& error) {
            return words_of(error);
        }
        return QString();
    };
    Study study;
    study.configuration.filter.motion.model = "proportional";
    study.parameters = {parse_study_parameter("motion.sigma_x=0.004,0.008")};
    VERIFY_SPANISH(told([&] { plan_study(study); }), "odometry o no-odometry");
    study.parameters = {parse_study_parameter("filter.particles=5,10"), study.parameters.front()};
    VERIFY_SPANISH(told([&] { plan_study(study); }), "odometry o no-odometry");
    VERIFY_SPANISH(told([] { parse_noise_kind("pink", "--odometry-noise-kind"); }), " o ");
}

void WordsTest::a_bad_configuration_is_told_in_spanish() {
    const Spanish spanish;
    Fixture f;
    const auto load = [&f](const QString& path) {
        f.prompts.opens = {path};
        f.trigger("action_load");
        return warning_about(f, path);
    };
    const QString bad = load(f.write("bad.cfg",
                                     "[filter]\nparticles = 0\nalgoritmo = \"x\"\n"
                                     "[split_merge]\ndmax = true\ndmx = 1\n[nada]\n"));
    VERIFY_SPANISH(bad, "filter.particles: 0 está fuera del rango; se permite: enteros de 1 a ");
    VERIFY_SPANISH(bad, "línea 3: filter.algoritmo: no existe ese parámetro; ");
    VERIFY_SPANISH(bad, "se encontró un valor lógico; se esperaba un número, de 1e-06 a 10 m");
    VERIFY_SPANISH(bad, "[nada]: no existe ese grupo");
    VERIFY_SPANISH(bad, "¿quería decir split_merge.dmax?");
    VERIFY_SPANISH(load("/nowhere/x.cfg"), "no existe ese archivo");
    in_dialog<ConfigurationDialog>([](ConfigurationDialog& dialog) {
        for (const char* key : {"field_grid.hit", "field_grid.miss"})
            dialog.findChild<QLineEdit*>(key)->setText("0");
        dialog.findChild<QDialogButtonBox*>("buttons")->button(QDialogButtonBox::Ok)->click();
        VERIFY_SPANISH(dialog.findChild<QLabel*>("error_grid.hit")->text(), "no se dibuja nada");
        dialog.reject();
    });
    f.trigger("action_manual");
}

void WordsTest::damaged_lines_are_told_in_spanish() {
    const Spanish spanish;
    Fixture f(false);
    const QString path = f.write("small.txt",
                                 "ODOM 0 0 0\nLASER 0 2 1 0 1 1\nLASER roto\nODOM 1 0.1 0\n"
                                 "LASER 1 2 1 0 1 1.1\nLASER 2 1 1\n%\nODOM 2 0 0 0 0\n");
    VERIFY_SPANISH(verdict_on(f, path), "se encontró \"roto\", se esperaba un número");
    QVERIFY(f.window->configuration_actions().open(path));
    f.run_to_end();
    auto* label = f.window->findChild<QLabel*>("status_skipped");
    QTRY_VERIFY(label->isVisible());
    emit label->linkActivated("skipped");
    QTRY_VERIFY(f.window->findChild<QDialog*>("skipped_lines") != nullptr);
    const QString text =
        f.window->findChild<QDialog*>("skipped_lines")->findChild<QPlainTextEdit*>()->toPlainText();
    VERIFY_SPANISH(text, "línea 3: ");
    VERIFY_SPANISH(text, "se encontró el final de la línea, se esperaba un valor");
    VERIFY_SPANISH(text, "no es una línea del formato normalized");
    VERIFY_SPANISH(text, "tras las velocidades, se esperaba el final de la línea");
}

void WordsTest::a_run_that_fails_is_told_in_spanish() {
    const Spanish spanish;
    Fixture f(false);
    const QString path = f.write("vacio.txt", "ODOM 0 0 0\nLASER roto\nODOM 1 0 0\n");
    QVERIFY(f.window->configuration_actions().open(path));
    f.trigger("action_run");
    QTRY_COMPARE(f.prompts.warnings.size(), 1);
    const QString warning = warning_about(f, path);
    VERIFY_SPANISH(warning, "no se encontró ningún barrido legible");
    VERIFY_SPANISH(warning, "la primera: línea 2: time: se encontró \"roto\"");
    VERIFY_SPANISH(warning, "; se esperaba al menos un barrido");
}

void WordsTest::what_cannot_be_written_is_told_in_spanish() {
    const Spanish spanish;
    Fixture f;
    f.run_steps(20);
    const QString nowhere = f.path("falta/mapa.txt");
    f.prompts.saves = {nowhere};
    f.trigger("action_save_map");
    VERIFY_SPANISH(
        warning_about(f, nowhere),
        "no se puede escribir: no existe el archivo o la carpeta; cree antes la carpeta");
}

}  // namespace hitos::window
