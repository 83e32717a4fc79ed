// SPDX-License-Identifier: GPL-3.0-or-later
// What program and tests do alike before a window can be made.
#pragma once

#include <QString>

class QApplication;

namespace hitos::window {

/// The names that the program goes by, and what it carries with it.
void prepare_application();

/// Translations ("en", "es"; empty: the system's language), and numbers with a point.
void speak(QApplication& application, const QString& language);

}  // namespace hitos::window
