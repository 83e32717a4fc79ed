// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_guard.hpp"

#include <QCoreApplication>
#include <cmath>

namespace hitos::window {
namespace {

QString guard_words(const char* text) {
    return QCoreApplication::translate("RunGuard", text);
}

}  // namespace

bool RunGuard::may_discard() const {
    const double seconds = session_.computed_seconds();
    if (seconds <= long_run_s_) return true;
    return prompts_.confirm(
        window_,
        {guard_words(QT_TRANSLATE_NOOP("RunGuard", "A long run")),
         guard_words(QT_TRANSLATE_NOOP("RunGuard", "Discard this run?")),
         guard_words(QT_TRANSLATE_NOOP("RunGuard",
                                       "It has computed for %1 s. Its results can be kept first "
                                       "with File → Save all results."))
             .arg(std::ceil(seconds)),
         guard_words(QT_TRANSLATE_NOOP("RunGuard", "Discard")), true});
}

}  // namespace hitos::window
