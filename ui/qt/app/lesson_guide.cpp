// SPDX-License-Identifier: GPL-3.0-or-later
#include "lesson_guide.hpp"

#include <QAction>
#include <QCursor>
#include <QDesktopServices>
#include <QDockWidget>
#include <QHash>
#include <QMenu>
#include <QRegularExpression>
#include <QToolTip>
#include <algorithm>
#include <cstdlib>

#include "actions/configuration_actions.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "language.hpp"
#include "look/docks.hpp"
#include "look/markdown_page.hpp"
#include "look/named.hpp"
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
    try {
        lessons_ = lessons();
    } catch (const Error&) {
        return;  // a page is missing: lessons that are not whole are not offered
    }
    if (lessons_.empty()) return;
    auto* menu = named(new QMenu(tr("&Lessons"), &help), "menu_lessons");
    help.insertMenu(before, menu);
    for (const Lesson& lesson : lessons_) {
        QString number = QString::number(lesson.number);
        number.insert(number.size() - 1, '&');  // of 10 the second digit: 1 is the first lesson's
        QAction* action = menu->addAction(number + ". " + title_of(lesson));
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
    if (!guard_.may_leave()) return;
    const QString configuration = QString::fromStdString(lesson.configuration.string());
    if (!configuration_.open(configuration, true)) return;
    show_page(lesson, QString::fromStdString(page.string()));
}

void LessonGuide::show_page(const Lesson& lesson, const QString& path) {
    if (dock_ == nullptr) {
        page_ = named(new MarkdownPage(&window_), "lesson_page");
        page_->setOpenLinks(false);
        page_->setTabChangesFocus(true);
        connect(page_, &QTextBrowser::anchorClicked, this, &LessonGuide::follow);
        auto* beside = window_.findChild<QDockWidget*>("plots_dock");
        dock_ = make_dock(window_, beside, page_, {}, "lesson_dock");
    }
    const QString title = tr("Lesson %1: %2").arg(lesson.number).arg(title_of(lesson));
    page_->set_rewriting(
        [this, number = lesson.number](const QString& page) { return with_links(page, number); });
    dock_->setWindowTitle(title);
    page_->setAccessibleName(title);
    page_->setSource(QUrl::fromLocalFile(path));
    dock_->show();
    dock_->raise();
}

QString LessonGuide::title_of(const Lesson& lesson) const {
    const bool spanish = spoken_language() == "es";
    return QString::fromStdString(spanish ? lesson.title_es : lesson.title_en);
}

/// Words set apart that are those of an action ("*View → Plots*", "**Run**") become links to it.
QString LessonGuide::with_links(const QString& page, int number) const {
    QHash<QString, QString> actions;
    for (const QAction* action : window_.findChildren<QAction*>()) {
        const QString words = QString(action->text()).remove('&').remove(QChar(0x2026));
        if (!action->objectName().isEmpty() && action->menu() == nullptr)
            actions.insert(words, action->objectName());
    }
    static const QRegularExpression apart(R"((\*{1,2})(?=\S)([^*\n]+)(?<=\S)\1)");
    QString text;
    bool code = false;
    for (const QString& line : page.split('\n')) {
        if (line.startsWith("```")) code = !code;
        qsizetype from = 0;
        for (auto found = apart.globalMatch(code ? QString() : line); found.hasNext();) {
            const QRegularExpressionMatch match = found.next();
            const QString words = match.captured(2).section(QChar(0x2192), -1).trimmed();
            const QString action = actions.value(QString(words).remove(QChar(0x2026)));
            if (action.isEmpty()) continue;
            text += line.mid(from, match.capturedStart() - from) +
                    QString("[%1](do:%2)").arg(match.captured(), action);
            from = match.capturedEnd();
        }
        text += line.mid(from) + '\n';
    }
    QStringList neighbours;
    for (const Lesson& lesson : lessons_) {
        if (std::abs(lesson.number - number) != 1) continue;
        const QString sign = lesson.number < number ? tr("Before: %1") : tr("Next: %1");
        neighbours << QString("[%1](lesson:%2)").arg(sign.arg(title_of(lesson))).arg(lesson.number);
    }
    return text + "\n---\n\n" + neighbours.join(QStringLiteral(" · ")) + '\n';
}

void LessonGuide::follow(const QUrl& link) {
    if (link.scheme() == "do") {
        auto* action = window_.findChild<QAction*>(link.path());
        if (action != nullptr && action->isEnabled()) {
            action->trigger();
        } else {
            QToolTip::showText(QCursor::pos(), tr("Not possible at this moment"), page_);
        }
    } else if (link.scheme() == "lesson") {
        const auto found = std::ranges::find(lessons_, link.path().toInt(), &Lesson::number);
        if (found != lessons_.end()) open(*found);
    } else if (link.isLocalFile() || link.isRelative()) {
        page_->setSource(page_->source().resolved(link));
    } else {
        QDesktopServices::openUrl(link);
    }
}

}  // namespace hitos::window
