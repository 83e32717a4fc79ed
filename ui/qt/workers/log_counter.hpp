// How many scans the log in use holds, counted beside everything else.
#pragma once

#include <QObject>
#include <QThreadPool>
#include <atomic>
#include <memory>
#include <optional>

#include "app/session.hpp"

namespace hitos::window {

class LogCounter final : public QObject {
    Q_OBJECT

  public:
    LogCounter(Session& session, QObject* parent);
    ~LogCounter() override;

  signals:
    /// Nothing while the count is not known.
    void counted(std::optional<quint64> scans);

  private:
    void begin();

    Session& session_;
    SourceParams source_;
    std::shared_ptr<std::atomic<bool>> stop_;
    QThreadPool pool_;
};

}  // namespace hitos::window
