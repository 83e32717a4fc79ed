// SPDX-License-Identifier: GPL-3.0-or-later
// Colours and style of the window, light and dark.
#pragma once

#include <QColor>
#include <QString>
#include <array>

class QApplication;
class QWidget;

namespace hitos::window {

enum class Theme { system, light, dark };

/// "system", "light", "dark"; another word means system.
Theme theme_from(const QString& word);
QString to_word(Theme theme);

/// Every colour of the window in one place.
struct Colours {
    bool dark = false;
    // Surfaces and text.
    QColor window, card, border, text, muted, accent, on_accent, danger, good;
    // Views.
    QColor canvas, grid_line, scan, robot, particle, observed, landmark, created, ignored,
        association, highlight, path, start, end, odometry, reference, chip;
};

/// The colours in use; light until a theme is applied.
const Colours& colours();

/// The light colours, whatever is in use: saved pictures are for paper.
const Colours& light_colours();

/// Of a share from 0 to 1, from light to dark; told apart by the colour-blind and in grey too.
QColor heat_colour(double share);

/// Gives the application style, palette and style sheet. `system` follows the platform's palette as
/// it was when the application started.
void apply_theme(QApplication& application, Theme theme);

/// Sets a property that the style sheet goes by ("role", "state") and lets it take effect.
void set_look(QWidget& widget, const char* property, const char* value);

}  // namespace hitos::window
