// Lessons: the menu, their worlds and their pages.

#include <QDockWidget>
#include <QMenu>
#include <QTextBrowser>
#include <QTranslator>

#include "gui_fixture.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "tests.hpp"

namespace hitos::window {
namespace {

QByteArray action_of(const Lesson& lesson) {
    return "action_lesson_" + QByteArray::number(lesson.number);
}

/// The text of the page that is shown; empty where none is.
QString page(const Fixture& f) {
    const auto* browser = f.window->findChild<QTextBrowser*>("lesson_page");
    return browser != nullptr && browser->isVisible() ? browser->toPlainText() : QString();
}

}  // namespace

void LessonsTest::every_lesson_opens_with_its_page_beside_it() {
    Fixture f(false);
    const std::vector<Lesson> all = lessons();
    QCOMPARE(all.size(), 8U);
    QVERIFY(page(f).isEmpty());
    for (const Lesson& lesson : all) {
        f.trigger(action_of(lesson));
        QTRY_COMPARE(f.session.configuration().source.file, lesson.world.string());
        const QString title = QString::fromStdString(lesson.title_en);
        QTRY_VERIFY2(page(f).contains(title), qPrintable(title));
        QVERIFY(page(f).contains("The question"));
        QVERIFY2(!page(f).contains("##"), "the page is shown as Markdown, not as text");
        f.run_steps(20);
        QCOMPARE(f.steps(), 20U);
    }
    QCOMPARE(f.prompts.warnings, QStringList());
    QCOMPARE(f.window->findChildren<QTextBrowser*>("lesson_page").size(), 1);
    QVERIFY(f.window->findChild<QDockWidget*>("lesson_dock")->windowTitle().contains('8'));
}

void LessonsTest::a_lesson_does_not_take_a_run_unasked() {
    Fixture f;
    const std::string before = f.session.configuration().source.file;
    f.run_steps(20);
    f.window->run_guard().set_long_run(0);
    f.trigger("action_lesson_1");
    QCOMPARE(f.prompts.confirmed_texts.size(), 1);
    QCOMPARE(f.session.configuration().source.file, before);
    QVERIFY(page(f).isEmpty());
    f.prompts.confirms = {true};
    f.trigger("action_lesson_1");
    QTRY_VERIFY(!page(f).isEmpty());
    QVERIFY(f.session.configuration().source.file != before);
}

void LessonsTest::lessons_speak_spanish() {
    QTranslator spanish;
    QVERIFY(spanish.load(":/i18n/hitos_es.qm"));
    QApplication::installTranslator(&spanish);
    {
        Fixture f(false);
        QCOMPARE(f.window->findChild<QMenu*>("menu_lessons")->title(), QString("&Lecciones"));
        QCOMPARE(f.action("action_lesson_4")->text(), QString("&4. El cierre de un bucle"));
        f.trigger("action_lesson_4");
        QTRY_VERIFY(page(f).contains("La pregunta"));
        QCOMPARE(f.window->findChild<QDockWidget*>("lesson_dock")->windowTitle(),
                 QString("Lección 4"));
    }
    QApplication::removeTranslator(&spanish);
}

}  // namespace hitos::window
