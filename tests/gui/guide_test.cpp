// SPDX-License-Identifier: GPL-3.0-or-later
// The user's guide: in the window's language, searched, followed, and opened at what has the
// keyboard.

#include <QAbstractTextDocumentLayout>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPixmap>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBlock>
#include <QToolButton>
#include <QTranslator>
#include <set>

#include "animation/animation_dialog.hpp"
#include "app/help_guide.hpp"
#include "dialogs/configuration_dialog.hpp"
#include "dialogs/export_dialog.hpp"
#include "dialogs/guide_window.hpp"
#include "dialogs/run_until_dialog.hpp"
#include "dialogs/skipped_lines.hpp"
#include "dialogs/source_dialog.hpp"
#include "dialogs/study_dialog.hpp"
#include "gui_fixture.hpp"
#include "inspect/graph_window.hpp"
#include "look/markdown_page.hpp"
#include "runs/runs.hpp"
#include "tests.hpp"
#include "world/import_dialog.hpp"
#include "world/live_drive.hpp"
#include "world/world_form.hpp"
#include "world/world_window.hpp"

namespace hitos::window {
namespace {

/// The guide that the fixture's window has opened.
struct Guide {
    GuideWindow* window;
    MarkdownPage* page;
    QLineEdit* search;
    QLabel* found;
    QListWidget* contents;

    explicit Guide(const QWidget& main) {
        // A dialog may have it for a while.
        QWidget* above = QApplication::activeWindow();
        window = main.findChild<GuideWindow*>();
        if (window == nullptr) window = qobject_cast<GuideWindow*>(above);
        if (window == nullptr) qFatal("no guide");
        page = window->findChild<MarkdownPage*>();
        search = window->findChild<QLineEdit*>("guide_search");
        found = window->findChild<QLabel*>("guide_found");
        contents = window->findChild<QListWidget*>("guide_contents");
    }

    QString file() const { return page->source().toLocalFile(); }
    QString heading() const {
        const int row = page->heading_in_sight();
        return row < 0 ? QString() : page->headings()[row].title;
    }
    QString marked(qsizetype mark) const {
        return page->extraSelections().value(mark).cursor.selectedText();
    }
    bool in_sight(qsizetype mark) const {
        const QRect place = page->cursorRect(page->extraSelections().value(mark).cursor);
        return page->viewport()->rect().contains(place.center());
    }
};

/// Those of the page's pictures, each with whether it could be read and how wide it stands there.
struct PagePicture {
    QString name;
    bool there = false;
    double right = 0.0;  ///< pixels
};
QList<PagePicture> pictures_of(const MarkdownPage& page) {
    QList<PagePicture> found;
    const QTextDocument& document = *page.document();
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        for (auto part = block.begin(); !part.atEnd(); ++part) {
            const QTextImageFormat format = part.fragment().charFormat().toImageFormat();
            if (!format.isValid()) continue;
            const auto picture =
                document.resource(QTextDocument::ImageResource, format.name()).value<QPixmap>();
            found << PagePicture{format.name(), !picture.isNull(),
                                 document.documentLayout()->blockBoundingRect(block).left() +
                                     block.layout()->lineAt(0).naturalTextRect().right()};
        }
    }
    return found;
}

}  // namespace

/// A screen has the keyboard in the window that was used last.
void GuideTest::init() {
    QTRY_VERIFY(QApplication::activePopupWidget() == nullptr);
}

void GuideTest::it_opens_in_the_windows_language_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("title");
    QTest::addColumn<QString>("measuring");
    QTest::addRow("en") << "en"
                        << "/docs/user-guide.md"
                        << "User's guide to the window"
                        << "Measuring";
    QTest::addRow("es") << "es"
                        << "/docs/es/user-guide.md"
                        << "Guía de la ventana para el usuario"
                        << "Medir";
}

void GuideTest::it_opens_in_the_windows_language() {
    QFETCH(QString, language);
    QFETCH(QString, file);
    QTranslator words;
    QVERIFY(words.load(":/i18n/hitos_es.qm"));
    if (language == "es") QApplication::installTranslator(&words);
    {
        Fixture f(false);
        f.trigger("action_guide");
        const Guide guide(*f.window);
        QVERIFY(guide.window->isVisible());
        QVERIFY2(guide.file().endsWith(file), qPrintable(guide.file()));
        QTEST(guide.page->headings().front().title, "title");
        QCOMPARE(guide.heading(), guide.page->headings().front().title);
        QVERIFY(!guide.page->toPlainText().contains("##"));
        const QList<PagePicture> pictures = pictures_of(*guide.page);
        QVERIFY(pictures.size() > 20);
        int english = 0;
        for (const PagePicture& picture : pictures) {
            QVERIFY2(picture.there, qPrintable(picture.name));
            english += picture.name.contains("/es/") ? 0 : 1;
        }
        // Each guide shows the other language once.
        QCOMPARE(language == "en" ? pictures.size() - english : english, 1);
        // The anchors are those of the English guide.
        f.trigger("action_measurements_dock");
        f.window->findChild<QWidget*>("measurement_table")->setFocus();
        f.window->activateWindow();
        QTRY_VERIFY(f.window->isActiveWindow());
        f.trigger("action_explain");
        QTEST(guide.heading(), "measuring");
        QTest::keyClick(guide.page, Qt::Key_Escape);
        QVERIFY(!guide.window->isVisible());
        // From the menu it begins at the beginning.
        f.trigger("action_guide");
        QTEST(guide.heading(), "title");
        QCOMPARE(f.window->findChildren<GuideWindow*>().size(), 1);
        QCOMPARE(f.prompts.warnings, QStringList());
    }
    QApplication::removeTranslator(&words);
}

void GuideTest::the_spanish_guide_has_pictures_of_its_own() {
    const QDir pictures(Fixture::source_file("docs/pictures"));
    static const QRegularExpression named(R"(pictures/(es/[\w-]+\.png))");
    const QString guide =
        QString::fromUtf8(Fixture::read(Fixture::source_file("docs/es/user-guide.md")));
    int found = 0;
    for (const QRegularExpressionMatch& match : named.globalMatch(guide)) {
        const QString name = match.captured(1);
        const QImage spanish(pictures.filePath(name));
        const QImage english(pictures.filePath(name.section('/', 1)));
        QVERIFY2(!spanish.isNull() && !english.isNull(), qPrintable(name));
        QVERIFY2(spanish != english, qPrintable(name));
        ++found;
    }
    QVERIFY(found > 25);
}

void GuideTest::what_is_searched_is_found_and_marked() {
    Fixture f(false);
    f.trigger("action_guide");
    const Guide guide(*f.window);
    guide.window->activateWindow();
    QTRY_VERIFY(guide.window->isActiveWindow());
    QTest::keyClick(guide.page, Qt::Key_F, Qt::ControlModifier);
    QCOMPARE(QApplication::focusWidget(), guide.search);
    QTest::keyClicks(guide.search, "MAHALANÓBIS");  // neither case nor accents matter
    QCOMPARE(guide.found->text(), QString("1 of 1"));
    QCOMPARE(guide.marked(0), QString("Mahalanobis"));
    QVERIFY(guide.in_sight(0));
    QCOMPARE(guide.heading(), QString("Looking at a run in numbers"));
    guide.search->selectAll();
    QTest::keyClicks(guide.search, "covariance");
    const qsizetype hits = guide.page->extraSelections().size();
    QVERIFY(hits > 3);
    // It goes on from where it was, round the page, to and fro.
    int now = guide.found->text().section(' ', 0, 0).toInt();
    QVERIFY2(now > 1, qPrintable(guide.found->text()));
    for (qsizetype i = 0; i < hits; ++i) {
        QTest::keyClick(guide.search, Qt::Key_Return);
        now = now % static_cast<int>(hits) + 1;
        QCOMPARE(guide.found->text(), QString("%1 of %2").arg(now).arg(hits));
        QVERIFY(guide.in_sight(now - 1));
        QCOMPARE(guide.marked(now - 1).toLower(), QString("covariance"));
    }
    QTest::keyClick(guide.search, Qt::Key_Return, Qt::ShiftModifier);
    QCOMPARE(guide.found->text(), QString("%1 of %2").arg(now - 1).arg(hits));
    // What is new is searched from what is in sight.
    guide.search->clear();
    guide.contents->setCurrentItem(
        guide.contents->findItems("Parameters", Qt::MatchExactly).value(0));
    QCOMPARE(guide.heading(), QString("Parameters"));
    QTest::keyClicks(guide.search, "the ");
    QVERIFY(guide.in_sight(guide.found->text().section(' ', 0, 0).toInt() - 1));
    QCOMPARE(guide.heading(), QString("Parameters"));
    guide.search->selectAll();
    QTest::keyClicks(guide.search, "xyzzy");
    QCOMPARE(guide.found->text(), QString("not found"));
    QCOMPARE(guide.page->extraSelections().size(), 0);
    QTest::keyClick(guide.search, Qt::Key_Return);
    guide.search->clear();
    QCOMPARE(guide.found->text(), QString());
    QVERIFY(guide.window->isVisible());
    QTest::keyClick(guide.search, Qt::Key_Escape);
    QVERIFY(!guide.window->isVisible());
}

void GuideTest::the_contents_go_there_and_follow() {
    Fixture f(false);
    f.trigger("action_guide");
    const Guide guide(*f.window);
    const auto& headings = guide.page->headings();
    QCOMPARE(guide.contents->count(), static_cast<int>(headings.size()));
    QVERIFY(headings.size() > 15);
    for (int row = 1; row < guide.contents->count(); ++row) {
        guide.contents->setCurrentRow(row);
        const QScrollBar& bar = *guide.page->verticalScrollBar();
        if (bar.value() < bar.maximum()) QCOMPARE(guide.heading(), headings[row].title);
        QCOMPARE(guide.contents->currentRow(), row);
        QCOMPARE(guide.contents->item(row)->text().trimmed(), headings[row].title);
    }
    guide.page->verticalScrollBar()->setValue(0);
    QCOMPARE(guide.contents->currentRow(), 0);
}

void GuideTest::links_are_followed_and_back() {
    Fixture f(false);
    f.trigger("action_guide");
    const Guide guide(*f.window);
    const auto* back = guide.window->findChild<QToolButton*>("guide_back");
    const auto* forward = guide.window->findChild<QToolButton*>("guide_forward");
    guide.contents->setCurrentRow(3);
    QCOMPARE(guide.heading(), QString("Data source"));
    const int place = guide.page->verticalScrollBar()->value();
    emit guide.page->anchorClicked(QUrl("formats.md#doubts"));
    QVERIFY(guide.file().endsWith("/docs/formats.md"));
    QVERIFY2(guide.heading().contains("oubt"), qPrintable(guide.heading()));
    QVERIFY(guide.contents->findItems("Data source", Qt::MatchExactly).isEmpty());
    QVERIFY(back->isEnabled() && !forward->isEnabled());
    // A search goes on in the page that one comes to.
    QTest::keyClicks(guide.search, "joystick");
    QCOMPARE(guide.found->text(), QString("not found"));
    guide.window->activateWindow();
    QTRY_VERIFY(guide.window->isActiveWindow());
    QTest::keyClick(guide.page, Qt::Key_Left, Qt::AltModifier);
    QTRY_VERIFY(guide.file().endsWith("/docs/user-guide.md"));
    QCOMPARE(guide.heading(), QString("Data source"));
    QCOMPARE(guide.page->verticalScrollBar()->value(), place);
    QVERIFY2(guide.found->text().startsWith("found: "), qPrintable(guide.found->text()));
    QTest::keyClick(guide.page, Qt::Key_Right, Qt::AltModifier);
    QTRY_VERIFY(guide.file().endsWith("/docs/formats.md"));
    // What leads back to the guide leads to its place there.
    emit guide.page->anchorClicked(QUrl("user-guide.md#measuring"));
    QCOMPARE(guide.heading(), QString("Measuring"));
    // What is not installed leaves the page and says so.
    emit guide.page->anchorClicked(QUrl("nowhere.md"));
    QCOMPARE(guide.heading(), QString("Measuring"));
    QCOMPARE(guide.found->text(), QString("nowhere.md is not installed."));
}

/// Each of the table is a heading of the guide and something in a window.
void GuideTest::every_place_that_explains_is_there() {
    Fixture f;
    f.trigger("action_guide");
    const Guide guide(*f.window);
    std::set<QString> anchors;
    for (const MarkdownPage::Heading& heading : guide.page->headings())
        anchors.insert(heading.anchors.begin(), heading.anchors.end());
    std::set<QString> parts;
    const auto note = [&parts](const QWidget& window) {
        parts.insert(window.objectName());
        parts.insert(window.property("help").toString());
        for (const auto* part : window.findChildren<QWidget*>()) parts.insert(part->objectName());
    };
    f.run_steps(10);
    for (const char* action : {"action_keys", "action_about", "action_compare"}) f.trigger(action);
    f.window->open_study();
    f.window->open_connection();
    f.window->result_actions().view_best();
    f.trigger("action_lesson_1");
    note(ConfigurationDialog(f.session.configuration(), f.window.get()));
    note(SourceDialog(f.session.configuration().source, f.prompts, {}, f.window.get()));
    note(ExportDialog(f.window->grid_view().exportable(), f.files.settings(), f.window.get()));
    note(RunUntilDialog(f.session, f.files.settings(), f.window.get()));
    note(AnimationDialog(10, f.window.get()));
    note(GraphWindow("none.g2o", f.files, f.prompts, f.window.get()));
    note(ImportDialog("hall.png", WallSource::picture, f.window.get()));
    show_skipped_lines(f.window.get(), "tour.log", {});
    note(WorldForm(WorldText::read(Fixture::source_file("data/worlds/bigloop.toml").toStdString()),
                   f.window.get()));
    WorldWindow& world = f.window->open_world_window();
    note(*f.window);
    world.drive_through(Fixture::source_file("data/worlds/bigloop.toml"));
    note(world);
    world.drive().give_up();
    for (const HelpPlace& place : help_places()) {
        QVERIFY2(anchors.contains(place.heading), place.heading);
        QVERIFY2(parts.contains(place.part), place.part);
    }
}

void GuideTest::f1_explains_what_has_the_keyboard() {
    Fixture f;
    f.run_steps(10);
    const auto explained = [&](QWidget* widget) -> QString {
        widget->window()->show();
        widget->window()->activateWindow();
        widget->setFocus();
        if (!QTest::qWaitFor([&] { return QApplication::focusWidget() == widget; }, kPatienceMs)) {
            return "no keyboard in " + widget->objectName();
        }
        QTest::keyClick(widget, Qt::Key_F1);
        return Guide(*f.window).heading();
    };
    QCOMPARE(explained(f.window->findChild<QWidget*>("scan_view")), QString("The window"));
    QCOMPARE(explained(f.window->findChild<QWidget*>("time_line")), QString("The window"));
    f.trigger("action_plots_dock");
    QCOMPARE(explained(f.window->findChild<QWidget*>("plots")), QString("Plots"));
    f.trigger("action_landmarks_dock");
    QCOMPARE(explained(f.window->findChild<QWidget*>("landmark_table")),
             QString("Looking at a run in numbers"));
    f.trigger("action_runs_dock");
    QCOMPARE(explained(f.window->findChild<QWidget*>("runs_table")), QString("Comparing runs"));
    f.trigger("action_measurements_dock");
    QCOMPARE(explained(f.window->findChild<QWidget*>("measurement_table")), QString("Measuring"));
    QCOMPARE(explained(f.window->open_study().findChild<QWidget*>("values")), QString("Studies"));
    WorldWindow& world = f.window->open_world_window();
    QCOMPARE(explained(world.findChild<QWidget*>("world_view")), QString("Drawing a world"));
    world.drive_through(Fixture::source_file("data/worlds/bigloop.toml"));
    QCOMPARE(explained(world.findChild<QWidget*>("world_view")), QString("Driving a robot"));
    world.drive().give_up();
    QCOMPARE(explained(Guide(*f.window).search), QString("Help"));
    QCOMPARE(f.prompts.warnings, QStringList());
}

/// One that waits for its answer blocks other windows, but not the guide.
void GuideTest::in_a_dialog_it_can_be_read() {
    Fixture f;
    f.trigger("action_guide");
    const QPointer<GuideWindow> window = Guide(*f.window).window;
    in_dialog<ConfigurationDialog>([&](ConfigurationDialog& form) {
        auto* search = form.findChild<QLineEdit*>("search");
        form.activateWindow();
        search->setFocus();
        QTRY_COMPARE(QApplication::focusWidget(), search);
        QTest::keyClick(search, Qt::Key_F1);
        const Guide guide(*f.window);
        QCOMPARE(guide.window, window.data());
        QCOMPARE(guide.heading(), QString("Parameters"));
        QCOMPARE(window->parentWidget(), &form);
        QTRY_VERIFY(window->isActiveWindow());
        QTest::keyClicks(guide.search, "preset");
        QVERIFY(guide.found->text().startsWith("1 of") || guide.found->text().contains(" of "));
        form.reject();
    });
    f.trigger("action_manual");
    QVERIFY2(!window.isNull(), "the guide outlives the dialog");
    QVERIFY(window->isVisible());
    QCOMPARE(window->parentWidget(), f.window.get());
}

void GuideTest::nothing_is_wider_than_the_page() {
    Fixture f(false);
    f.trigger("action_guide");
    const Guide guide(*f.window);
    for (const QSize& size : {QSize(1300, 700), QSize(760, 500), QSize(1000, 600)}) {
        guide.window->resize(size);
        QCoreApplication::processEvents();
        QCOMPARE(guide.page->horizontalScrollBar()->maximum(), 0);
        const int room = guide.page->viewport()->width();
        double widest = 0.0;
        for (const PagePicture& picture : pictures_of(*guide.page)) {
            QVERIFY2(picture.right <= room, qPrintable(picture.name));
            widest = std::max(widest, picture.right);
        }
        QVERIFY2(widest > 0.8 * room, "they take the room that there is");
    }
}

void GuideTest::its_place_is_remembered() {
    Fixture f(false);
    f.trigger("action_guide");
    Guide(*f.window).window->resize(701, 455);
    f.window = std::make_unique<MainWindow>(f.session, f.files, f.prompts);
    f.window->show();
    f.trigger("action_guide");
    QCOMPARE(Guide(*f.window).window->size(), QSize(701, 455));
}

}  // namespace hitos::window
