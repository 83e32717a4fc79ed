// SPDX-License-Identifier: GPL-3.0-or-later
#include "ending.hpp"

#include <cxxabi.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace hitos::python {
namespace {

/// How many Work there are.
std::atomic<int> calls_under_way = 0;
/// How many of them this thread has, one within the other.
thread_local int depth = 0;
/// The thread on which the interpreter ends, from its beginning on.
std::atomic<std::thread::id> ending{};

/// What is to run until the interpreter's end may go on working for so long.
constexpr std::chrono::seconds kPatience{10};
constexpr std::chrono::milliseconds kLook{5};

bool is_over() {
#if PY_VERSION_HEX >= 0x030d0000
    const bool finalizing = Py_IsFinalizing() != 0;
#else
    const bool finalizing = _Py_IsFinalizing() != 0;
#endif
    const bool here = ending.load() == std::this_thread::get_id();
    return !here && (finalizing || Py_IsInitialized() == 0);
}

[[noreturn]] void rest_for_ever() {
    for (;;) ::pause();
}

/// `take` takes the interpreter's lock, or nothing more happens on this thread.
template <class Take>
void take_or_rest(const Take& take) {
    if (is_over()) rest_for_ever();
    try {
        take();
    } catch (const abi::__forced_unwind&) {
        rest_for_ever();  // it ended while this thread waited for the lock
    }
}

bool ends_elsewhere() {
    const std::thread::id there = ending.load();
    return there != std::thread::id() && there != std::this_thread::get_id();
}

/// Daemon threads at work in here see it at their next look and end; until then the interpreter
/// waits, since neither they nor the threads that compute for them may outlive it.
void begin_end() {
    ending = std::this_thread::get_id();
    const auto last = std::chrono::steady_clock::now() + kPatience;
    while (calls_under_way > 0 && std::chrono::steady_clock::now() < last) {
        const LockReleased released;
        std::this_thread::sleep_for(kLook);
    }
}

}  // namespace

LockReleased::LockReleased() : state_(PyEval_SaveThread()) {}

LockReleased::~LockReleased() {
    take_or_rest([this] { PyEval_RestoreThread(state_); });
}

LockHeld::LockHeld() {
    take_or_rest([this] { lock_.emplace(); });
}

Work::Work() {
    if (depth == 0 && ends_elsewhere()) {
        PyErr_SetNone(PyExc_SystemExit);
        throw py::error_already_set();
    }
    ++depth;
    ++calls_under_way;
}

Work::~Work() {
    --calls_under_way;
    --depth;
}

bool interrupted() {
    if (ends_elsewhere()) {
        PyErr_SetNone(PyExc_SystemExit);
        return true;
    }
    return PyErr_CheckSignals() != 0;
}

void bind_ending() {
    py::module_::import("atexit").attr("register")(py::cpp_function(&begin_end));
}

}  // namespace hitos::python
