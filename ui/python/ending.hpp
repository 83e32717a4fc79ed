// SPDX-License-Identifier: GPL-3.0-or-later
// The interpreter's lock, let go and taken, and the interpreter's end, at which daemon threads may
// still be at work in here.
#pragma once

#include <optional>

#include "bindings.hpp"

namespace hitos::python {

/// Lets go of the interpreter's lock while it lives. A thread that wants it back after the
/// interpreter's end never gets on: CPython would unwind its stack from under C++, which aborts the
/// process.
class LockReleased {
  public:
    LockReleased();
    ~LockReleased();
    LockReleased(const LockReleased&) = delete;
    LockReleased& operator=(const LockReleased&) = delete;

  private:
    PyThreadState* state_;
};

/// Holds the lock while it lives, on any thread; after the interpreter's end as LockReleased.
class LockHeld {
  public:
    LockHeld();

  private:
    std::optional<py::gil_scoped_acquire> lock_;
};

/// Work that the interpreter's end waits for. Begins and ends with the lock held. Raises SystemExit
/// on a daemon thread once the interpreter is ending, but not within other work: that ends when it
/// asks interrupted().
class Work {
  public:
    Work();
    ~Work();
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;
};

/// Whether a signal's handler has raised something (Ctrl+C), or this is a daemon thread and the
/// interpreter is ending: then SystemExit is raised, with which threads end without a word. To be
/// asked with the lock held.
bool interrupted();

/// Has the interpreter tell when it ends.
void bind_ending();

}  // namespace hitos::python
