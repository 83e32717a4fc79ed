// SPDX-License-Identifier: GPL-3.0-or-later
// Every window fits the screen that it opens on.

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QInputDialog>
#include <QLabel>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QTextBrowser>
#include <QTranslator>
#include <QVBoxLayout>

#include "actions/configuration_actions.hpp"
#include "animation/animation_dialog.hpp"
#include "dialogs/configuration_dialog.hpp"
#include "dialogs/connect_dialog.hpp"
#include "dialogs/export_dialog.hpp"
#include "dialogs/run_until_dialog.hpp"
#include "dialogs/source_dialog.hpp"
#include "dialogs/study_dialog.hpp"
#include "gui_fixture.hpp"
#include "inspect/graph_window.hpp"
#include "look/screen_fit.hpp"
#include "runs/compare_window.hpp"
#include "runs/runs.hpp"
#include "spoken.hpp"
#include "tests.hpp"
#include "world/world_form.hpp"
#include "world/world_window.hpp"

namespace hitos::window {
namespace {

/// What a desktop leaves of a screen for a window, in points; that of 1920 x 1080 pixels at scale 2
/// has 960 x 540.
const QList<QSize> kScreens{{1024, 700}, {1280, 660}, {1366, 708}, {960, 500}};

bool scrolls(const QWidget* widget) {
    for (; widget != nullptr && !widget->isWindow(); widget = widget->parentWidget()) {
        if (qobject_cast<const QAbstractScrollArea*>(widget) != nullptr) return true;
    }
    return false;
}

/// Qt puts docks that lie behind others outside the window.
bool lies_behind(const QWidget* widget) {
    for (; widget != nullptr && !widget->isWindow(); widget = widget->parentWidget()) {
        const auto* dock = qobject_cast<const QDockWidget*>(widget);
        if (dock != nullptr && dock->geometry().right() < 0) return true;
    }
    return false;
}

/// Those of `part` are whole and inside the window.
void check_buttons(const QWidget& part, const QString& where) {
    QWidget& window = *part.window();
    for (const auto* button : part.findChildren<QAbstractButton*>()) {
        if (!button->isVisible() || button->window() != &window || scrolls(button) ||
            lies_behind(button)) {
            continue;
        }
        const QRect place(button->mapTo(&window, QPoint()), button->size());
        QVERIFY2(window.rect().contains(place),
                 qPrintable(where + ": outside: " + button->objectName() + button->text()));
        if (button->text().isEmpty()) continue;
        QVERIFY2(button->width() >= button->sizeHint().width(),
                 qPrintable(where + ": cut: " + button->objectName() + button->text()));
    }
}

/// At that size, or larger only as far as `screen` allows, its buttons are whole and inside.
void check_at(QWidget& window, const QSize& size, const QSize& screen, const QString& name) {
    QCoreApplication::processEvents();  // what was shown or hidden before changes the least size
    window.resize(size);
    QCoreApplication::processEvents();
    const QString where = QString("%1 on %2 x %3: %4 x %5")
                              .arg(name)
                              .arg(screen.width())
                              .arg(screen.height())
                              .arg(window.width())
                              .arg(window.height());
    QVERIFY2(window.width() <= screen.width() && window.height() <= screen.height(),
             qPrintable(where));
    check_buttons(window, where);
}

/// On every screen the window is no larger, and its buttons are whole and inside: at its own size,
/// and as large as the screen.
void check_fits(QWidget& window, const QString& name) {
    const QSize own = window.size();
    for (const QSize& screen : kScreens) {
        check_at(window, own.boundedTo(screen), screen, name);
        check_at(window, screen, screen, name);
    }
    window.resize(own);
}

/// Whatever is longer than its place scrolls down, never to the side.
void check_scrolls_down(const QWidget& dialog, const QString& name) {
    for (const auto* area : dialog.findChildren<QScrollArea*>()) {
        if (!area->isVisible()) continue;
        QVERIFY2(area->horizontalScrollBar()->maximum() == 0, qPrintable(name));
    }
}

/// At its own size first, as it opens on a great screen.
void check_dialog(QWidget& dialog, const QSize& own, const QString& name) {
    dialog.resize(own);
    dialog.show();
    check_fits(dialog, name);
    dialog.resize(dialog.minimumSizeHint().width(), 400);
    QCoreApplication::processEvents();
    check_scrolls_down(dialog, name);
    dialog.close();
}

}  // namespace

void FitTest::every_window_fits_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<bool>("dark");
    for (const char* language : {"en", "es"}) {
        for (const bool dark : {false, true}) {
            QTest::addRow("%s, %s", language, dark ? "dark" : "light") << language << dark;
        }
    }
}

/// With what the ready tour changes of the defaults.
void FitTest::chips_are_whole_and_their_values_last_data() {
    add_languages();
}

void FitTest::chips_are_whole_and_their_values_last() {
    QFETCH(const QString, language);
    const Spoken spoken(language);
    Fixture f;
    const auto narrowest = [&](QSize size) {
        f.window->resize(size);
        QCoreApplication::processEvents();
        double share = 1.0;
        for (const QLabel* values : f.window->findChildren<QLabel*>("marked")) {
            if (!values->isVisible()) continue;
            const int room = std::min(values->sizeHint().width(), 50);
            share = std::min(share, static_cast<double>(values->width()) / std::max(1, room));
        }
        return share;
    };
    QVERIFY(narrowest({1366, 708}) >= 1.0);
    // English words are short enough for all of it.
    for (const QLabel* values : f.window->findChildren<QLabel*>("marked")) {
        if (language != "en") break;
        for (const QLabel* label : values->parentWidget()->findChildren<QLabel*>())
            QVERIFY2(label->isHidden() || label->width() >= label->sizeHint().width(),
                     qPrintable(QString("%1: %2 of %3")
                                    .arg(label->text())
                                    .arg(label->width())
                                    .arg(label->sizeHint().width())));
    }
    f.trigger("action_landmarks_dock");
    const double beside = narrowest({1366, 708});
    QVERIFY2(beside >= 1.0, qPrintable(QString::number(beside)));
    for (const char* title : {"scan_panel_title", "grid_panel_title"}) {
        const auto* label = f.window->findChild<QLabel*>(title);
        QVERIFY2(label->width() >= label->sizeHint().width(), title);
    }
    // What is recorded has more that differs; then titles are cut, and still not alike.
    f.window->configuration_actions().use_preset("recorded", true);
    QCoreApplication::processEvents();
    QStringList titles;  // as they are shown
    for (const QLabel* values : f.window->findChildren<QLabel*>("marked")) {
        for (const QLabel* label : values->parentWidget()->findChildren<QLabel*>()) {
            if (label->property("role") != "title") continue;
            titles << label->fontMetrics().elidedText(label->text(), Qt::ElideRight,
                                                      label->width());
        }
    }
    QCOMPARE(titles.size(), 5);
    titles.removeDuplicates();
    QVERIFY2(titles.size() == 5, qPrintable(titles.join(", ")));
}

/// By the names that the menus have for them.
void FitTest::every_key_is_listed() {
    Fixture f;
    f.trigger("action_keys");
    const QString listed =
        f.window->findChild<QDialog*>("keys")->findChild<QTextBrowser*>()->toPlainText();
    const QStringList words = listed.split(QRegularExpression("[^\\w+]"));
    int keys = 0;
    for (const QAction* action : f.window->findChildren<QAction*>()) {
        for (const QKeySequence& key : action->shortcuts()) {
            const QString name = key.toString(QKeySequence::NativeText);
            if (name.startsWith("Alt+")) continue;  // of layers, which have numbers
            QVERIFY2(words.contains(name), qPrintable(name));
            ++keys;
        }
    }
    QVERIFY(keys > 40);
}

void FitTest::in_a_low_window_the_groups_are_chips() {
    Fixture f;
    f.window->resize(1366, 860);
    QCoreApplication::processEvents();
    QVERIFY(f.window->findChild<QLabel*>("value_filter.particles") != nullptr);
    f.window->resize(1366, 708);
    QCoreApplication::processEvents();
    QVERIFY(f.window->findChild<QLabel*>("value_filter.particles") == nullptr);
    QList<QLabel*> marked = f.window->findChildren<QLabel*>("marked");
    QCOMPARE(marked.size(), 5);
    QVERIFY2(marked[0]->text().contains("bigloop.log.gz"), qPrintable(marked[0]->text()));
    QWidget* chip = marked[2]->parentWidget();
    QVERIFY2(chip->toolTip().contains("Particles: 10"), qPrintable(chip->toolTip()));
    const auto opened = [&] { return f.window->findChild<QFrame*>("opened_card"); };
    QTest::mouseClick(chip, Qt::LeftButton);
    QVERIFY(opened() != nullptr && opened()->isVisible());
    QCOMPARE(opened()->findChild<QLabel*>("value_filter.particles")->text(), QString("10"));
    QTest::keyClick(opened(), Qt::Key_Escape);
    QTRY_VERIFY(opened() == nullptr);
    QTest::keyClick(chip, Qt::Key_Return);
    QTRY_VERIFY(opened() != nullptr);
    in_dialog<ConfigurationDialog>([](ConfigurationDialog& form) { form.reject(); });
    QTest::keyClick(opened(), Qt::Key_Return);
    QTRY_VERIFY(opened() == nullptr);
}

void FitTest::the_views_keep_their_height_data() {
    QTest::addColumn<QSize>("screen");
    QTest::addColumn<int>("least");
    QTest::addColumn<QString>("language");
    struct Screen {
        const char* name;
        QSize size;  // of the window, in points
        int least;
    };
    for (const Screen& screen : {Screen{"1024x768", {1024, 708}, 300},
                                 {"1366x768", {1366, 708}, 380},
                                 {"1920x1080", {1920, 1020}, 380},
                                 {"2560x1440 at 2", {1280, 660}, 380}}) {
        for (const char* language : {"en", "es"}) {
            QTest::addRow("%s, %s", screen.name, language)
                << screen.size << screen.least << language;
        }
    }
}

void FitTest::the_views_keep_their_height() {
    QFETCH(QSize, screen);
    QFETCH(int, least);
    QFETCH(QString, language);
    QTranslator words;
    QVERIFY(words.load(":/i18n/hitos_es.qm"));
    if (language == "es") QApplication::installTranslator(&words);
    {
        Fixture f;
        f.run_steps(30);
        const auto check = [&](const QString& panel) {
            QCoreApplication::processEvents();
            f.window->resize(screen);
            QCoreApplication::processEvents();
            for (const QWidget* view : {static_cast<QWidget*>(&f.window->scan_view()),
                                        static_cast<QWidget*>(&f.window->grid_view())}) {
                const QString told = QString("%1: %2 x %3 with %4, %5")
                                         .arg(view->objectName())
                                         .arg(view->width())
                                         .arg(view->height())
                                         .arg(panel, language);
                qInfo("%s", qPrintable(told));
                QVERIFY2(view->height() >= least, qPrintable(told));
            }
            QCOMPARE(f.window->size(), screen);
        };
        check("no panel");
        for (auto* dock : f.window->findChildren<QDockWidget*>()) {
            dock->show();
            dock->raise();
            check(dock->objectName());
            dock->hide();
        }
    }
    QApplication::removeTranslator(&words);
}

void FitTest::every_window_fits() {
    QFETCH(QString, language);
    QFETCH(bool, dark);
    QTranslator words;
    QVERIFY(words.load(":/i18n/hitos_es.qm"));
    if (language == "es") QApplication::installTranslator(&words);
    apply_theme(*qApp, dark ? Theme::dark : Theme::light);
    {
        Fixture f;
        f.window->resize(1600, 1000);
        f.run_steps(30);
        check_fits(*f.window, "main window");
        QVERIFY(f.window->configuration_actions().open(
            Fixture::source_file("data/logs/carmen-flaser.log.gz")));  // with its hint
        f.window->plots_dock().show();
        for (const QSize& screen : kScreens) {
            check_at(*f.window, screen, screen, "with the plots and a hint");
            // On the lowest one the cards have to make room for them.
            f.action("action_summary")->setChecked(screen.height() >= 600);
            for (auto* dock : f.window->findChildren<QDockWidget*>()) {
                dock->show();
                dock->raise();
                check_at(*f.window, screen, screen, "with " + dock->objectName());
            }
            for (auto* dock : f.window->findChildren<QDockWidget*>()) dock->hide();
            f.action("action_summary")->setChecked(true);
        }
        ConfigurationDialog form(f.session.configuration(), f.window.get());
        check_dialog(form, {980, 790}, "form");
        WorldForm world(
            WorldText::read(Fixture::source_file("data/worlds/bigloop.toml").toStdString()),
            f.window.get());
        check_dialog(world, world.size(), "world form");
        SourceDialog source(f.session.configuration().source, f.prompts, {}, f.window.get());
        check_dialog(source, {720, 480}, "source");
        source.findChild<QCheckBox*>("how")->setChecked(true);
        check_dialog(source, {720, 480}, "source with how it is read");
        ExportDialog picture(f.window->grid_view().exportable(), f.files.settings(),
                             f.window.get());
        check_dialog(picture, picture.sizeHint(), "picture");
        ConnectDialog& connection = f.window->open_connection();
        check_dialog(connection, {640, 560}, "connection");
        connection.hide();
        RunUntilDialog until(f.session, f.files.settings(), f.window.get());
        check_dialog(until, until.sizeHint(), "run until");
        AnimationDialog animation(30, f.window.get());
        check_dialog(animation, animation.sizeHint(), "animation");
        GraphWindow& graph = f.window->open_graph(f.write("a.g2o",
                                                          "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\n"
                                                          "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n"));
        QTRY_VERIFY(graph.shown() && !graph.busy());
        check_dialog(graph, {1180, 700}, "graph");
        StudyDialog& study = f.window->open_study();
        for (const char* second : {"", "p=5,10"}) {
            study.form().set_assignments({"dmax=0.01,0.02", second});
            check_dialog(study, {1120, 720}, "study");
        }
        f.trigger("action_odometry");
        check_dialog(*f.window->result_actions().odometry_window(), {820, 680}, "map");
        f.trigger("action_compare");
        check_dialog(*f.window->runs().comparison(), {1100, 680}, "compare");
        f.run_steps(30);
        References references;
        references.trajectory = f.session.snapshot()->odometry_trajectory;
        f.session.set_references(references);
        f.trigger("action_compare");
        f.window->runs().comparison()->show_figures(true);
        check_dialog(*f.window->runs().comparison(), {1100, 680}, "compare with figures");
        f.trigger("action_guide");
        auto* guide = f.window->findChild<QDialog*>("guide_window");
        check_dialog(*guide, guide->size(), "guide");
        f.trigger("action_keys");
        f.trigger("action_about");
        for (const char* name : {"keys", "about"}) {
            auto* box = f.window->findChild<QDialog*>(name);
            QVERIFY(box != nullptr);
            check_fits(*box, name);
        }
    }
    apply_theme(*qApp, Theme::light);
    QApplication::removeTranslator(&words);
}

void FitTest::what_opens_is_no_larger_than_its_screen() {
    QWidget window;
    window.resize(5000, 4000);
    fit_to_screen(window);
    const QSize screen = window.screen()->availableGeometry().size();
    QVERIFY(window.width() < screen.width() && window.height() < screen.height());
    QWidget small;
    small.resize(100, 80);
    fit_to_screen(small);
    QCOMPARE(small.size(), QSize(100, 80));
}

/// A window is moved with its frame, which lies round it.
void FitTest::what_opens_lies_on_its_screen_with_its_frame() {
    constexpr int kTitle = 36;
    constexpr int kBorder = 8;
    Fixture f;
    const QRect screen = f.window->screen()->availableGeometry();
    const auto on_screen = [&](const QWidget& window) {
        const QRect with_frame(window.pos(), window.size() + QSize(2 * kBorder, kTitle + kBorder));
        QVERIFY2(screen.contains(with_frame), qPrintable(QString("%1 at %2, %3, %4 x %5")
                                                             .arg(window.objectName())
                                                             .arg(window.x())
                                                             .arg(window.y())
                                                             .arg(window.width())
                                                             .arg(window.height())));
    };
    f.trigger("action_study");
    on_screen(*f.window->study());
    on_screen(f.window->open_world_window());
    for (const QSize& size : {QSize(400, 300), QSize(5000, 4000)}) {
        QWidget other(f.window.get(), Qt::Window);
        other.resize(size);
        place_beside_parent(other, QPoint(2000, 2000));
        on_screen(other);
    }
}

void FitTest::what_scrolls_down_is_wide_enough_for_new_words() {
    QScrollArea area;
    auto* content = new QWidget;
    auto* button = new QPushButton("a");
    (new QVBoxLayout(content))->addWidget(button);
    area.setWidget(content);
    area.setWidgetResizable(true);
    scroll_down_only(area);
    area.show();
    const int before = area.minimumWidth();
    button->setText("much longer words than there were before");
    QTRY_VERIFY(area.minimumWidth() > before);
    QVERIFY(area.minimumWidth() > button->minimumSizeHint().width());
}

/// The bar of a box has the program's name beside its title, and buttons.
void FitTest::the_title_of_a_box_has_room() {
    Fixture f;
    QtPrompts prompts;
    const QString title = "The reference trajectory is in doubt for many reasons";
    const auto wide = [&title](QDialog& box) {
        const int words = box.fontMetrics().horizontalAdvance(title + " - Hitos");
        QVERIFY2(box.width() >= words + 100, qPrintable(QString::number(box.width() - words)));
        box.reject();
    };
    in_dialog<QMessageBox>(wide);
    prompts.warn(f.window.get(), title, "No.");
    in_dialog<QMessageBox>(wide);
    QVERIFY(!prompts.confirm(f.window.get(), {title, "Go on?", "It is lost.", "Yes", true}));
    in_dialog<QInputDialog>(wide);
    QVERIFY(!prompts.choice(f.window.get(), title, "Which?", {"a", "b"}, 1));
    in_dialog<QInputDialog>(wide);
    QVERIFY(!prompts.text(f.window.get(), title, "Which?"));
    in_dialog<QInputDialog>([](QInputDialog& box) { box.accept(); });
    QCOMPARE(prompts.choice(f.window.get(), title, "Which?", {"a", "b"}, 1), std::optional(1));
}

/// Messages have paths and reasons, which are as long as they are.
void FitTest::what_is_told_is_told_whole() {
    Fixture f;
    QtPrompts prompts;
    const QString path =
        "/home/somebody/measurements/recordings/"
        "a-tour-with-a-name-that-says-all-of-it_2026-11-29_first-floor.mcap: ";
    for (const int sentences : {1, 3, 8}) {
        const QString text =
            path + QString(
                       "the odometry never moves although the scans do; expected a tour; look "
                       "whether the topic is the right one. ")
                       .repeated(sentences);
        const auto whole = [sentences](QMessageBox& box) {
            QApplication::processEvents();
            if (const QString folder = qEnvironmentVariable("HITOS_PICTURES"); !folder.isEmpty())
                box.grab().save(
                    QString("%1/box-%2-%3.png").arg(folder).arg(sentences).arg(box.icon()));
            for (const auto* label : box.findChildren<QLabel*>()) {
                if (label->text().isEmpty()) continue;
                const QString seen = QString("%1: %2 x %3")
                                         .arg(label->text())
                                         .arg(label->width())
                                         .arg(label->height());
                QVERIFY2(label->height() >= label->heightForWidth(label->width()),
                         qPrintable(seen));
                const QRect room(0, 0, label->width(), 10'000);
                const QRect taken = label->fontMetrics().boundingRect(
                    room, static_cast<int>(label->alignment()) | Qt::TextWordWrap, label->text());
                QVERIFY2(taken.width() <= label->width() && taken.height() <= label->height(),
                         qPrintable(seen));
            }
            box.reject();
        };
        in_dialog<QMessageBox>(whole);
        prompts.warn(f.window.get(), "The log cannot be used", text);
        in_dialog<QMessageBox>(whole);
        prompts.confirm(f.window.get(), {"A tour", "End the tour here?", text, "End", true});
        expect_no_awaited_dialog();
    }
}

void FitTest::at_scale_two_it_fits_too() {
    const QTemporaryDir folder;
    const QString picture = folder.filePath("a.png");
    QProcess program;
    program.start(QString(HITOS_BIN_DIR) + "/hitos", {"--screenshot", picture, "--size", "960x540",
                                                      "--scale", "2", "--language", "es"});
    QVERIFY(program.waitForFinished(kPatienceMs));
    QCOMPARE(QImage(picture).size(), QSize(1920, 1080));
}

void FitTest::the_summary_can_be_folded() {
    Fixture f;
    auto* summary = f.window->findChild<QWidget*>("summary");
    QVERIFY(summary->isVisible());
    f.trigger("action_summary");
    QVERIFY(!summary->isVisible());
    f.window->close();
    const MainWindow next(f.session, f.files, f.prompts);
    QVERIFY(!next.findChild<QAction*>("action_summary")->isChecked());
}

void FitTest::a_restored_window_lies_on_the_screen() {
    Fixture f;
    const QRect screen = f.window->screen()->availableGeometry();
    // As another desktop has left it: larger than this one, and beyond its edge.
    for (const QRect& before : {QRect(-300, -200, screen.width() * 2, screen.height() * 2),
                                QRect(screen.width() - 100, screen.height() - 80, 900, 560)}) {
        QWidget other;
        other.setGeometry(before);
        f.files.settings().setValue("window/geometry", other.saveGeometry());
        MainWindow restored(f.session, f.files, f.prompts);
        restored.show();
        QVERIFY(screen.contains(restored.geometry()));
        apply_size(restored, "1030x560");
        QCOMPARE(restored.size(), QSize(1030, 560));
    }
    // A size that is asked for counts, whatever the window was before.
    MainWindow large(f.session, f.files, f.prompts);
    large.showMaximized();
    apply_size(large, "1030x560");
    QVERIFY(!large.isMaximized());
    QTRY_COMPARE(large.size(), QSize(1030, 560));
}

}  // namespace hitos::window
