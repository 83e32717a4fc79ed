// SPDX-License-Identifier: GPL-3.0-or-later
// The language of the window, and the menu to choose it.
#pragma once

#include <QString>

class QMenu;

namespace hitos::window {

class StatusLine;
class UserFiles;

/// "en" or "es", as the window speaks.
QString spoken_language();

/// What the user chose in the menu: "en", "es", or empty, which is the system's.
QString saved_language(UserFiles& files);

/// The choice counts from the next start on, and the status line says so.
void fill_languages(QMenu& menu, UserFiles& files, StatusLine& status);

}  // namespace hitos::window
