#include "lesson_guide.hpp"

#include <QAction>
#include <QDockWidget>
#include <QMenu>

#include "actions/configuration_actions.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "language.hpp"
#include "look/docks.hpp"
#include "look/markdown_page.hpp"
#include "look/prompts.hpp"
#include "session/run_guard.hpp"

namespace hitos::window {

LessonGuide::LessonGuide(QMainWindow& window, QMenu& help, QAction* before,
                         ConfigurationActions& configuration, const RunGuard& guard,
                         Prompts& prompts)
    : QObject(&window),
      window_(window),
      configuration_(configuration),
      guard_(guard),
      prompts_(prompts) {
    std::vector<Lesson> all;
    try {
        all = lessons();
    } catch (const Error&) {
        return;  // a page is missing: lessons that are not whole are not offered
    }
    if (all.empty()) return;
    auto* menu = new QMenu(tr("&Lessons"), &help);
    menu->setObjectName("menu_lessons");
    help.insertMenu(before, menu);
    const bool spanish = spoken_language() == "es";
    for (const Lesson& lesson : all) {
        const std::string& title = spanish ? lesson.title_es : lesson.title_en;
        QAction* action = menu->addAction(
            QString("&%1. %2").arg(lesson.number).arg(QString::fromStdString(title)));
        action->setObjectName(QString("action_lesson_%1").arg(lesson.number));
        connect(action, &QAction::triggered, this, [this, lesson] { open(lesson); });
    }
}

void LessonGuide::open(const Lesson& lesson) {
    const std::filesystem::path page = lesson.page(spoken_language().toStdString());
    try {
        input::read_text(page);
    } catch (const Error& error) {
        prompts_.warn(&window_, tr("Lesson %1").arg(lesson.number), words_of(error));
        return;
    }
    if (!guard_.may_discard()) return;
    const QString configuration = QString::fromStdString(lesson.configuration.string());
    if (!configuration_.open(configuration, true)) return;
    show_page(lesson, QString::fromStdString(page.string()));
}

void LessonGuide::show_page(const Lesson& lesson, const QString& path) {
    if (dock_ == nullptr) {
        page_ = new MarkdownPage(&window_);
        page_->setObjectName("lesson_page");
        page_->setOpenExternalLinks(true);
        page_->setTabChangesFocus(true);
        auto* beside = window_.findChild<QDockWidget*>("plots_dock");
        dock_ = make_dock(window_, beside, page_, {}, "lesson_dock");
    }
    const QString title = tr("Lesson %1").arg(lesson.number);
    dock_->setWindowTitle(title);
    page_->setAccessibleName(title);
    page_->setSource(QUrl::fromLocalFile(path));
    dock_->show();
    dock_->raise();
}

}  // namespace hitos::window
