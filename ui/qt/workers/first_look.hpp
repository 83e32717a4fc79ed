// SPDX-License-Identifier: GPL-3.0-or-later
// What the first scan looks like with the parameters in use, before anything runs; of a tour that
// comes in or is driven the newest one that is known.
#pragma once

#include <QObject>
#include <QThreadPool>
#include <atomic>
#include <memory>

#include "session/session.hpp"

namespace hitos::window {

/// Takes the first step of the session's run beside it, in a run of its own, whenever the
/// configuration is another one. The session's run stays at its beginning.
class FirstLook final : public QObject {
    Q_OBJECT

  public:
    FirstLook(Session& session, QObject* parent);
    ~FirstLook() override;

    /// The state after the first scan, as the run will have it, or the newest scan alone; null
    /// while neither is known.
    const std::shared_ptr<const Snapshot>& snapshot() const { return snapshot_; }
    bool is_newest() const { return snapshot_ && snapshot_ == newest_; }

  signals:
    void changed();

  private:
    using Stop = std::shared_ptr<std::atomic<bool>>;
    void begin();
    void note();
    void show(std::shared_ptr<const Snapshot> snapshot, const Stop& of);

    Session& session_;
    SourceParams source_;
    const void* tour_ = nullptr;  ///< that comes in or is driven, to know another one by
    std::shared_ptr<const Snapshot> snapshot_;
    std::shared_ptr<const Snapshot> newest_;
    Stop stop_;
    QThreadPool pool_;
};

}  // namespace hitos::window
