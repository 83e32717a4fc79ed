// SPDX-License-Identifier: GPL-3.0-or-later
// Connecting to a running robot, and how it stands with the connection.
#pragma once

#include <QDialog>
#include <vector>

#include "look/prompts.hpp"
#include "look/user_files.hpp"
#include "workers/connection.hpp"

class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;

namespace hitos::window {

class TopicList;

/// Stays beside the window for as long as the user wants; closed, the tour comes in all the same.
class ConnectDialog final : public QDialog {
    Q_OBJECT

  public:
    ConnectDialog(Connection& connection, Session& session, UserFiles& files, Prompts& prompts,
                  QWidget* parent);

    /// As a user would type it, and connect; `how` it is read.
    void connect_to(const QString& address, const SourceParams& how);

  private:
    void act();
    bool is_log_in_use(const QString& file) const;
    void begin(const SourceParams& how);
    void browse();
    void suggest_file();
    void refresh();
    void show_received();
    QString state_words() const;
    const char* state_role() const;

    Connection& connection_;
    Session& session_;
    UserFiles& files_;
    Prompts& prompts_;
    std::vector<QWidget*> keep_row_;  ///< where what is received is kept
    QLineEdit* address_;
    QLineEdit* file_;
    QPushButton* browse_;
    QPushButton* act_;
    QPushButton* close_ = nullptr;
    QLabel* state_;
    TopicList* topics_;
    QLabel* came_;
    QLabel* delay_;
    QLabel* losses_;
    QPlainTextEdit* said_;
    QString agreed_;  ///< the file that may be replaced
    QString scans_;   ///< the topics that were chosen
    QString odometry_;
};

}  // namespace hitos::window
