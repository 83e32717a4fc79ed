// SPDX-License-Identifier: GPL-3.0-or-later
// No window opens larger than its screen.
#pragma once

#include <QPoint>
#include <string>

class QScrollArea;
class QWidget;

namespace hitos::window {

/// Before a window is shown: shrinks it to the screen it will open on, with room for its frame.
void fit_to_screen(QWidget& window);

/// Puts a window that was placed somewhere else once wholly on the screen that it opens on.
void keep_on_screen(QWidget& window);

/// Of a window over the one that opens it.
constexpr QPoint kBeside(40, 40);

/// Shrinks it likewise, and places it at an offset from its parent, as far as the screen goes.
void place_beside_parent(QWidget& window, QPoint offset);

/// "1360x860", as the command line takes it, whatever the window was before; what is no size
/// changes nothing.
void apply_size(QWidget& window, const std::string& size);

/// The area scrolls down and nowhere else: it is never narrower than what is in it. To be called
/// when all is in it.
void scroll_down_only(QScrollArea& area);

}  // namespace hitos::window
