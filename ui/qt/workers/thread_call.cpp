#include "thread_call.hpp"

namespace hitos::window {

ThreadCall::ThreadCall(QObject* parent) : QObject(parent) {
    connect(
        this, &ThreadCall::called, this, [](const std::function<void()>& task) { task(); },
        Qt::QueuedConnection);
}

}  // namespace hitos::window
