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
    const auto& tour = session_.incoming_tour();
    const bool once = tour && tour->source().problem() && session_.progress().steps > 0;
    const double seconds = session_.computed_seconds();
    if (!once && seconds <= long_run_s_) return true;
    const QString why =
        once ? guard_words(QT_TRANSLATE_NOOP(
                   "RunGuard",
                   "Its log does not hold all of it any more, so it cannot be mapped again."))
             : guard_words(QT_TRANSLATE_NOOP("RunGuard", "It has computed for %1 s."))
                   .arg(std::ceil(seconds));
    return prompts_.confirm(
        window_,
        {once ? guard_words(QT_TRANSLATE_NOOP("RunGuard", "A map that is here alone"))
              : guard_words(QT_TRANSLATE_NOOP("RunGuard", "A long run")),
         guard_words(QT_TRANSLATE_NOOP("RunGuard", "Discard this run?")),
         why + ' ' +
             guard_words(QT_TRANSLATE_NOOP(
                 "RunGuard", "Its results can be kept first with File → Save all results.")),
         guard_words(QT_TRANSLATE_NOOP("RunGuard", "Discard")), true});
}

}  // namespace hitos::window
