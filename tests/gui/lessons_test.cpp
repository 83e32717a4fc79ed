// SPDX-License-Identifier: GPL-3.0-or-later
// Lessons: the menu, their worlds and their pages.

#include <QDockWidget>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSet>
#include <QTextBrowser>
#include <QToolButton>
#include <QTranslator>

#include "gui_fixture.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "tests.hpp"
#include "views/plots.hpp"
#include "world/world_window.hpp"

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
    QCOMPARE(all.size(), 10U);
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
    QVERIFY(f.window->findChild<QDockWidget*>("lesson_dock")->windowTitle().contains("10"));
}

void LessonsTest::a_page_does_what_it_says_and_leads_to_the_next() {
    Fixture f(false);
    f.trigger("action_lesson_1");
    QTRY_VERIFY(!page(f).isEmpty());
    auto* browser = f.window->findChild<QTextBrowser*>("lesson_page");
    auto* dock = f.window->findChild<QDockWidget*>("lesson_dock");
    QVERIFY2(dock->windowTitle().contains("What odometry does"), qPrintable(dock->windowTitle()));
    const QString html = browser->toHtml();
    for (const char* link : {"do:action_plots_dock", "do:action_run", "do:action_odometry",
                             "do:action_best_map", "do:action_runs_dock", "do:action_manual"}) {
        QVERIFY2(html.contains(QString("href=\"%1\"").arg(link)), link);
    }
    QVERIFY(!html.contains("lesson:0") && !html.contains("lesson:1\""));
    // A link does it; one that cannot be done now does nothing.
    emit browser->anchorClicked(QUrl("do:action_odometry"));
    emit browser->anchorClicked(QUrl("do:no_such_action"));
    emit browser->anchorClicked(QUrl("do:action_run"));
    QTRY_VERIFY(f.state() == Progress::State::finished);
    emit browser->anchorClicked(QUrl("do:action_plots_dock"));
    QVERIFY(f.window->plots().isVisible());
    emit browser->anchorClicked(QUrl("lesson:2"));
    QTRY_VERIFY(page(f).contains("One wall"));
    QVERIFY(browser->toHtml().contains("lesson:1") && browser->toHtml().contains("lesson:3"));
}

namespace {

/// "View → Plots" of every entry of a menu, and of those in it.
void collect(const QMenu& menu, const QString& path, QSet<QString>& all) {
    for (const QAction* action : menu.actions()) {
        const QString words = QString(action->text()).remove('&').remove(QChar(0x2026));
        const QString entry = path + QStringLiteral(" → ") + words;
        all << entry << entry.section(QStringLiteral(" → "), 1);
        if (action->menu() != nullptr) collect(*action->menu(), entry, all);
    }
}

}  // namespace

void LessonsTest::pages_name_menus_that_are_there() {
    for (const bool spanish : {false, true}) {
        QTranslator translator;
        QVERIFY(translator.load(":/i18n/hitos_es.qm"));
        if (spanish) QApplication::installTranslator(&translator);
        QSet<QString> all;
        {
            Fixture f(false);
            for (const QAction* action : f.window->menuBar()->actions())
                collect(*action->menu(), QString(action->text()).remove('&'), all);
            // The workshop's button has a menu of its own.
            for (const auto* button : f.window->open_world_window().findChildren<QToolButton*>()) {
                if (button->menu() != nullptr)
                    collect(*button->menu(), button->text().remove('&'), all);
            }
        }
        QStringList files{
            Fixture::source_file(spanish ? "docs/es/user-guide.md" : "docs/user-guide.md")};
        for (const Lesson& lesson : lessons())
            files << QString::fromStdString(lesson.page(spanish ? "es" : "en").string());
        static const QRegularExpression path("\\*([^*.;\\n]+ → [^*.;]+)\\*");
        QStringList wrong;
        for (const QString& file : files) {
            const QString text = QString::fromUtf8(Fixture::read(file)).simplified();
            for (auto found = path.globalMatch(text); found.hasNext();) {
                const QString named = found.next().captured(1).remove(QChar(0x2026)).trimmed();
                if (!all.contains(named)) wrong << QFileInfo(file).filePath() + ": " + named;
            }
        }
        if (spanish) QApplication::removeTranslator(&translator);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
    }
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
                 QString("Lección 4: El cierre de un bucle"));
    }
    QApplication::removeTranslator(&spanish);
}

}  // namespace hitos::window
