// The world workshop: a world, the robot in it, and what is done to both.
#pragma once

#include <QDialog>

#include "actions/prompts.hpp"
#include "actions/run_guard.hpp"
#include "actions/user_files.hpp"

class QComboBox;

namespace hitos::window {

class DrivePanel;
class LiveDrive;
class Session;
class WorldView;

class WorldWindow final : public QDialog {
    Q_OBJECT

  public:
    WorldWindow(Session& session, UserFiles& files, Prompts& prompts, const RunGuard& guard,
                QWidget* parent);

    LiveDrive& drive();
    WorldView& view() const { return *view_; }
    /// Puts the robot at the start of a world file, in place of what the session works on if the
    /// user agrees. Says what is wrong with a world that cannot be driven through.
    void drive_through(const QString& path);

  signals:
    void notice(QString words);

  protected:
    void hideEvent(QHideEvent* event) override;

  private:
    QWidget* make_tools();
    void open_asked();
    void show_state();

    Session& session_;
    UserFiles& files_;
    Prompts& prompts_;
    const RunGuard& guard_;
    QComboBox* worlds_ = nullptr;
    WorldView* view_ = nullptr;
    DrivePanel* panel_ = nullptr;
};

}  // namespace hitos::window
