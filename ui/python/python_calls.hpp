// SPDX-License-Identifier: GPL-3.0-or-later
// Crossing to Python and back: who holds the interpreter's lock, and what becomes of exceptions.
#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <utility>

#include "bindings.hpp"
#include "ending.hpp"
#include "hitos/base/error.hpp"

namespace hitos::python {

/// What a Python function raised, on its way through C++ that knows nothing of Python. It may be
/// thrown again, and end on any thread.
class PythonFailure : public Error {
  public:
    /// With the lock held.
    explicit PythonFailure(const py::error_already_set& raised);
    /// Raises it again, with the lock held.
    void restore() const;

  private:
    std::shared_ptr<PyObject> value_;
    std::shared_ptr<PyObject> trace_;  // null where it has none
};

/// Calls `work` with the lock held, from any thread. What Python raises there is thrown as
/// PythonFailure.
template <class What>
auto with_python(const What& work) {
    const LockHeld lock;
    try {
        return work();
    } catch (const py::error_already_set& raised) {
        throw PythonFailure(raised);
    }
}

/// Calls `work` without the lock.
template <class What>
auto without_python(const What& work) {
    const Work under_way;
    const LockReleased released;
    return work();
}

/// Lets go of the lock while the object ends: its threads may be waiting for it.
template <class T>
std::shared_ptr<T> ended_without_python(std::unique_ptr<T> object) {
    return std::shared_ptr<T>(object.release(), [](T* ended) {
        if (PyGILState_Check() != 0) {
            const LockReleased released;
            delete ended;
        } else {
            delete ended;
        }
    });
}

/// How often signals are looked for while C++ works.
inline constexpr std::chrono::milliseconds kPoll{20};

/// Waits for what another thread does, within Work that began before it; Ctrl+C calls `stop` and is
/// raised when the work has ended.
template <class Result, class Stop>
Result wait_for(std::future<Result> future, const Stop& stop) {
    while (without_python([&] { return future.wait_for(kPoll); }) != std::future_status::ready) {
        if (!interrupted()) continue;
        const py::error_already_set raised;
        stop();
        without_python([&] { future.wait(); });
        throw py::error_already_set(raised);
    }
    return without_python([&] { return future.get(); });
}

}  // namespace hitos::python
