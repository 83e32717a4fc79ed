// SPDX-License-Identifier: GPL-3.0-or-later
// What the libraries say, in the language of the window.
#pragma once

#include <QString>
#include <exception>
#include <vector>

#include "hitos/base/message.hpp"
#include "hitos/capture/tour_finding.hpp"

namespace hitos {
struct Advice;
}

namespace hitos::window {

/// In the context "Errors"; what has no translation is said in English. Any thread may ask.
QString words_of(const Message& message);
QString words_of(const std::exception& error);
/// Without the preset to try.
QString words_of(const Advice& advice);
/// “Label” value, of each.
QString words_of(const std::vector<SourceSetting>& settings);
/// What was found, and what to do.
QString words_of(const TourFinding& finding);
/// A line of its own among several, which findings begin as parts of a sentence do: "• What …".
QString set_apart(const QString& note);

/// "1 scan", "2 scans": of the words for one and for several ("%1 scans").
QString counted_words(quint64 count, const QString& one, const QString& several);

/// "1.234 m", as tables show a length [m].
QString metre_words(double metres);
/// "12.34°", as they show an angle [rad].
QString degree_words(double radians);

}  // namespace hitos::window
