// From a worker to the window: calls that wait in the event loop of the window's thread.
#pragma once

#include <QObject>
#include <functional>
#include <utility>

namespace hitos::window {

/// Lives in the thread that is to do the work; any thread may give it something to do. What is not
/// done when it is destroyed is dropped.
class ThreadCall final : public QObject {
    Q_OBJECT

  public:
    explicit ThreadCall(QObject* parent = nullptr);
    void operator()(std::function<void()> task) { emit called(std::move(task)); }

  signals:
    void called(std::function<void()> task);
};

}  // namespace hitos::window
