// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of the libraries that a window shows in its user's language.
#pragma once

/// Expands to the text. It marks the text for the translators where it stands: lupdate reads the
/// mark (ui/qt/CMakeLists.txt says how), the window translates the text in that context, and the
/// libraries need no Qt.
#define HITOS_TEXT(context, text) text
