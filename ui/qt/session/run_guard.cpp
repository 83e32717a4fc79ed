// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_guard.hpp"

#include <QCoreApplication>
#include <QDir>
#include <cmath>

#include "incoming_tour.hpp"

namespace hitos::window {
namespace {

QString guard_words(const char* text) {
    return QCoreApplication::translate("RunGuard", text);
}

}  // namespace

bool RunGuard::ends_tour(const Configuracion& next) const {
    const auto& tour = session_.incoming_tour();
    return tour && tour->is_live() && !tour->is_of(next);
}

bool RunGuard::may_begin(const Configuracion& next) const {
    return ends_tour(next) ? may_leave() : may_discard();
}

bool RunGuard::may_leave() const {
    const auto& tour = session_.incoming_tour();
    if (!tour || !tour->is_live()) return may_discard();
    const QString file = QString::fromStdString(tour->source().file().string());
    return prompts_.confirm(
        window_, {guard_words(QT_TRANSLATE_NOOP("RunGuard", "A tour that comes in")),
                  guard_words(QT_TRANSLATE_NOOP("RunGuard", "End the tour here?")),
                  guard_words(QT_TRANSLATE_NOOP("RunGuard",
                                                "What has come so far is in %1 and can be mapped "
                                                "again; what comes from now on is not mapped."))
                      .arg(QDir::toNativeSeparators(file)),
                  guard_words(QT_TRANSLATE_NOOP("RunGuard", "End the tour")), true});
}

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
