// SPDX-License-Identifier: GPL-3.0-or-later
// Files of drawn worlds: new ones, what can be made one, and where they are saved.
#pragma once

#include <QObject>
#include <string>

#include "look/prompts.hpp"
#include "look/user_files.hpp"

class QMenu;
class QWidget;

namespace hitos::window {

class WorldDraft;

class WorldFiles final : public QObject {
    Q_OBJECT

  public:
    WorldFiles(WorldDraft& draft, UserFiles& files, Prompts& prompts, QWidget* window);

    /// New, open, the worlds that come with Hitos, save.
    void fill(QMenu& menu);

    /// These ask where something would be lost; false where the user would rather not.
    bool start_new();
    /// A world, or anything that walls can be taken from. Says why where it cannot be.
    bool open(const QString& path);
    bool save();
    bool save_as();
    bool may_discard();

    /// A world file that says what is drawn now: the draft's own, or a copy in the program's data
    /// where something is not saved. Throws hitos::Error.
    QString file_as_drawn();

  signals:
    void notice(QString words);
    /// What is drawn counts now: what was begun is to be ended.
    void asked_for();

  private:
    void ask_to_open();
    bool import(const QString& path);
    bool write(const QString& path);
    bool changed_by_others() const;

    WorldDraft& draft_;
    UserFiles& files_;
    Prompts& prompts_;
    QWidget* window_;
    QString copy_;        ///< of what is not saved
    std::string copied_;  ///< what it says
};

}  // namespace hitos::window
