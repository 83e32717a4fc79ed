// SPDX-License-Identifier: GPL-3.0-or-later
// The world workshop: a place is drawn, and a robot driven through it.
#pragma once

#include <QDialog>

#include "draw_tool.hpp"
#include "look/prompts.hpp"
#include "look/user_files.hpp"
#include "session/run_guard.hpp"
#include "views/layers.hpp"
#include "world_draft.hpp"
#include "world_files.hpp"

class QAction;
class QLabel;
class QMenu;
class QPushButton;

namespace hitos::window {

class CheckLine;
class DrawBar;
class DrivePanel;
class LiveDrive;
class Session;
class WorldView;

/// Shows either of the two: the draft with the tools to draw, or the robot with what drives it.
class WorldWindow final : public QDialog {
    Q_OBJECT

  public:
    WorldWindow(Session& session, UserFiles& files, Prompts& prompts, const RunGuard& guard,
                QWidget* parent);
    ~WorldWindow() override;

    LiveDrive& drive();
    WorldView& view() const { return *view_; }
    WorldDraft& draft() { return draft_; }
    DrawTool& tool() { return tool_; }
    WorldFiles& world_files() { return files_of_worlds_; }
    const CheckLine& check_line() const { return *check_; }
    /// Opens a world file and puts the robot at its start, in place of what the session works on
    /// if the user agrees. Says what is wrong with a world that cannot be driven through.
    void drive_through(const QString& path);
    /// The same with what is drawn.
    void drive_through_drawn();
    /// Whether what was drawn may be given up, if it is not saved.
    bool may_end() { return files_of_worlds_.may_discard(); }

  signals:
    void notice(QString words);
    /// A world file whose own tour is to be run.
    void run_wanted(QString path);

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    QWidget* make_tools();
    void make_actions();
    void connect_draft();
    void show_draft();
    void show_state();
    bool begin_driving(const QString& path);
    void go_on_with(const QString& path);
    void say(const QString& words);

    Session& session_;
    Prompts& prompts_;
    const RunGuard& guard_;
    WorldDraft draft_;
    DrawTool tool_;
    WorldFiles files_of_worlds_;
    QMenu* menu_ = nullptr;
    QAction* undo_ = nullptr;
    QAction* redo_ = nullptr;
    QPushButton* run_ = nullptr;
    QPushButton* drive_ = nullptr;
    WorldView* view_ = nullptr;
    DrawBar* bar_ = nullptr;
    CheckLine* check_ = nullptr;
    DrivePanel* panel_ = nullptr;
    QLabel* said_ = nullptr;
};

}  // namespace hitos::window
