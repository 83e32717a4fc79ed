// SPDX-License-Identifier: GPL-3.0-or-later
#include "language.hpp"

#include <QActionGroup>
#include <QCoreApplication>
#include <QMenu>
#include <array>
#include <utility>

#include "look/user_files.hpp"
#include "status_line.hpp"

namespace hitos::window {
namespace {

constexpr const char* kLanguageKey = "view/language";

}  // namespace

QString spoken_language() {
    return QCoreApplication::translate("Language", "en",
                                       "the code of the language that the window speaks");
}

QString saved_language(UserFiles& files) {
    return files.settings().value(kLanguageKey).toString();
}

void fill_languages(QMenu& menu, UserFiles& files, StatusLine& status) {
    auto* group = new QActionGroup(&menu);
    const QString now = saved_language(files);
    const std::array<std::pair<const char*, QString>, 3> languages{
        {{"", QCoreApplication::translate("Language", "As the system")},
         {"en", "English"},
         {"es", "Español"}}};
    for (const auto& [word, name] : languages) {
        QAction* action = menu.addAction(name);
        action->setObjectName(QString("language_") + word);
        action->setCheckable(true);
        action->setChecked(now == word);
        group->addAction(action);
        QObject::connect(action, &QAction::triggered, &status,
                         [&files, &status, chosen = QString(word)] {
                             files.settings().setValue(kLanguageKey, chosen);
                             status.notice(QCoreApplication::translate(
                                 "Language", "The language changes when Hitos starts again."));
                         });
    }
}

}  // namespace hitos::window
