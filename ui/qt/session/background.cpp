// SPDX-License-Identifier: GPL-3.0-or-later
#include "background.hpp"

#include <sys/resource.h>

#include <QCoreApplication>
#include <QCursor>
#include <QEventLoop>
#include <QGuiApplication>
#include <QScopeGuard>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace hitos::window {
namespace {

#if defined(__x86_64__)
/// A thread begins with the registers of the one that starts it, and Qt's painting leaves the upper
/// halves of the vector registers in use. While they are, every SSE instruction waits for them: the
/// filter would need twice its time for as long as the thread lives.
[[gnu::target("avx")]] void clear_upper_halves() {
    _mm256_zeroupper();
}
#endif

}  // namespace

void begin_background_work() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx")) clear_upper_halves();
#endif
    // On Linux a priority is the thread's own, whatever the name of the call says. Where it is
    // refused, the work goes on as it is.
    constexpr int kNiceness = 5;
    constexpr id_t kThisThread = 0;
    setpriority(PRIO_PROCESS, kThisThread, kNiceness);
}

void wait_until(const std::function<bool(std::chrono::milliseconds)>& done) {
    using std::chrono::milliseconds;
    constexpr milliseconds kAtOnce(40);  // as somebody sees it
    constexpr milliseconds kPause(10);
    if (done(kAtOnce)) return;
    QGuiApplication::setOverrideCursor(Qt::WaitCursor);
    const auto restore = qScopeGuard([] { QGuiApplication::restoreOverrideCursor(); });
    do {
        QCoreApplication::processEvents(QEventLoop::ExcludeUserInputEvents);
    } while (!done(kPause));
}

}  // namespace hitos::window
