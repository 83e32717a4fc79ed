// SPDX-License-Identifier: GPL-3.0-or-later
// What one has at hand while a robot is driven: clock, pace, gamepad, disturbances, figures, logs.
#pragma once

#include <QWidget>

#include "gamepad.hpp"
#include "live_drive.hpp"
#include "log_saver.hpp"
#include "look/prompts.hpp"
#include "look/user_files.hpp"

class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace hitos::window {

class DisturbBar;
class WorldView;

/// Connects the drive with the view in which it is driven.
class DrivePanel final : public QWidget {
    Q_OBJECT

  public:
    DrivePanel(Session& session, UserFiles& files, Prompts& prompts, WorldView& view,
               QWidget* parent);
    ~DrivePanel() override;

    LiveDrive& drive() { return drive_; }
    /// As LiveDrive::begin().
    void begin(const Configuracion& configuration);
    /// The clock stands still until the user lets it go on.
    void rest();

  signals:
    void notice(QString words);
    /// The tour is over and stands in a world file.
    void kept(QString path);

  private:
    enum class Holder { keys, gamepad };
    void make_tools();
    void show_gamepad();
    void hold(Holder holder, double ahead, double left);
    void connect_drive();
    void keep();
    void save_log();
    void ask_for_log();
    void show_state();
    void show_rest();
    QString figures() const;

    Session& session_;
    UserFiles& files_;
    Prompts& prompts_;
    WorldView& view_;
    LiveDrive drive_;
    LogSaver logs_;
    Gamepad gamepad_;
    Holder holder_ = Holder::keys;  ///< whose word was the last
    QComboBox* pace_ = nullptr;
    QToolButton* rest_ = nullptr;
    QLabel* pad_ = nullptr;
    QPushButton* log_ = nullptr;
    QPushButton* keep_ = nullptr;
    DisturbBar* disturb_ = nullptr;
    QLabel* figures_ = nullptr;
};

}  // namespace hitos::window
