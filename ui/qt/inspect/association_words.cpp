// SPDX-License-Identifier: GPL-3.0-or-later
#include "association_words.hpp"

#include <QCoreApplication>
#include <algorithm>

#include "views/landmark_painter.hpp"

namespace hitos::window {
namespace {

QString words(const char* text) {
    return QCoreApplication::translate("Associations", text);
}

}  // namespace

QString outcome_words(const Association& association, const LandmarkMap& map, std::uint64_t scans) {
    const int landmark = association.landmark + 1;
    const auto place = static_cast<std::size_t>(std::max(association.landmark, 0));
    const bool named = landmark > 0 && place < map.size() && map[place].identity >= 0;
    const QString called =
        named ? name_of(map[place], association.landmark) : QString::number(landmark);
    switch (association.outcome) {
        case Association::Outcome::matched:
            return landmark > 0
                       ? words(QT_TRANSLATE_NOOP("Associations", "Matched with %1")).arg(called)
                       : words(QT_TRANSLATE_NOOP("Associations", "Matched, on probation"));
        case Association::Outcome::created:
            if (taken_in(association, map, scans))
                return words(QT_TRANSLATE_NOOP("Associations", "New, then merged"));
            return landmark > 0 ? words(QT_TRANSLATE_NOOP("Associations", "New: %1")).arg(called)
                                : words(QT_TRANSLATE_NOOP("Associations", "New, on probation"));
        default:
            return words(QT_TRANSLATE_NOOP("Associations", "Ignored"));
    }
}

QString reason_words(Association::Reason reason) {
    using Reason = Association::Reason;
    switch (reason) {
        case Reason::fits:
            return words(QT_TRANSLATE_NOOP(
                "Associations", "This landmark fits, and no other one is nearly as plausible."));
        case Reason::stretches:
            return words(QT_TRANSLATE_NOOP(
                "Associations",
                "All landmarks that fit are stretches of one wall; the best one takes it."));
        case Reason::together:
            return words(QT_TRANSLATE_NOOP(
                "Associations",
                "Of all pairings of this scan that go together, the best has this one."));
        case Reason::twin:
            return words(QT_TRANSLATE_NOOP(
                "Associations",
                "It shows the landmark that an earlier feature of this scan has made."));
        case Reason::known:
            return words(
                QT_TRANSLATE_NOOP("Associations", "The sensor said which landmark it is."));
        case Reason::drawn:
            return words(QT_TRANSLATE_NOOP(
                "Associations", "Several are plausible; one was drawn by their likelihoods."));
        case Reason::fits_none:
            return words(QT_TRANSLATE_NOOP("Associations", "No landmark fits."));
        case Reason::ambiguous:
            return words(QT_TRANSLATE_NOOP(
                "Associations", "Several landmarks are plausible: it could be any of them."));
        case Reason::taken:
            return words(QT_TRANSLATE_NOOP(
                "Associations", "Another feature of the scan fits its landmark better."));
        case Reason::left_over:
            return words(QT_TRANSLATE_NOOP(
                "Associations",
                "Landmarks fit it, but together the other features fit them better."));
        case Reason::between_gates:
            return words(QT_TRANSLATE_NOOP(
                "Associations",
                "No landmark fits, but the nearest is not far enough for it to be a new one."));
        case Reason::between_keys:
            return words(QT_TRANSLATE_NOOP("Associations",
                                           "No landmark fits, and only key scans make new ones."));
        case Reason::gone:
            return words(QT_TRANSLATE_NOOP("Associations",
                                           "Its landmark was taken out of the map at this scan."));
    }
    return {};
}

QString standing_words(Standing standing) {
    switch (standing) {
        case Standing::candidate:
            return words(QT_TRANSLATE_NOOP("Associations", "fits"));
        case Standing::outside:
            return words(QT_TRANSLATE_NOOP("Associations", "does not fit"));
        case Standing::elsewhere:
            return words(QT_TRANSLATE_NOOP("Associations", "was seen elsewhere"));
        default:
            return words(QT_TRANSLATE_NOOP("Associations", "too far, passed over"));
    }
}

}  // namespace hitos::window
