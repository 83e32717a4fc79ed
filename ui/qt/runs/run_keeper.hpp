// SPDX-License-Identifier: GPL-3.0-or-later
// What a long run has found, kept for the case that the window is ended from outside.
#pragma once

#include <QObject>
#include <QString>
#include <future>
#include <memory>

#include "hitos/base/folder_lock.hpp"
#include "session/session.hpp"

namespace hitos::window {

/// Nobody can be asked and nothing written once the display is gone, the process killed or the
/// power lost. So the results of a run that has computed for longer than a minute are written into
/// the program's data when it ends, but for what reads the log again, and taken away when the user
/// leaves the run or the window. What is left there the next window tells of.
class RunKeeper final : public QObject {
    Q_OBJECT

  public:
    RunKeeper(Session& session, QObject* parent);
    /// In order: nothing is left.
    ~RunKeeper() override;
    /// What counts as long [s].
    void set_long_run(double seconds) { long_run_s_ = seconds; }

    /// The window ends without anybody having been asked: what is kept stays.
    void let_stay();

    /// A folder of results that a window which is no more has left; empty where there is none. It
    /// is given once: from then on it is the user's, in another folder of the program's data.
    static QString take_left();

  private:
    void look();
    void keep();
    void give_up();

    Session& session_;
    double long_run_s_ = 60.0;
    QString place_;  // of this run; empty where it is not kept
    std::shared_ptr<FolderLock> lock_;
    std::shared_future<void> writing_;
};

}  // namespace hitos::window
