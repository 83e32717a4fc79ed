// The world workshop: a world, the robot in it, and what is done to both.
#pragma once

#include <QDialog>

#include "actions/prompts.hpp"
#include "actions/run_guard.hpp"
#include "actions/user_files.hpp"
#include "live_drive.hpp"

class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace hitos::window {

class DisturbBar;
class WorldView;

class WorldWindow final : public QDialog {
    Q_OBJECT

  public:
    WorldWindow(Session& session, UserFiles& files, Prompts& prompts, const RunGuard& guard,
                QWidget* parent);

    LiveDrive& drive() { return drive_; }
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
    void connect_drive();
    void open_asked();
    void keep();
    void show_state();
    QString figures() const;

    Session& session_;
    UserFiles& files_;
    Prompts& prompts_;
    const RunGuard& guard_;
    LiveDrive drive_;
    QComboBox* worlds_ = nullptr;
    QComboBox* pace_ = nullptr;
    QToolButton* rest_ = nullptr;
    QPushButton* keep_ = nullptr;
    WorldView* view_ = nullptr;
    DisturbBar* disturb_ = nullptr;
    QLabel* figures_ = nullptr;
};

}  // namespace hitos::window
