// SPDX-License-Identifier: GPL-3.0-or-later
// The window's icons, drawn rather than stored: they follow the theme and every pixel ratio.
#pragma once

#include <QIcon>

namespace hitos::window {

enum class Glyph {
    application,
    run,
    stop,
    step,
    best_map,
    odometry,
    save_map,
    restart,
    open,
    settings,
    picture,
    fit,
    follow,
    frame,
    plots,
    zoom_in,
    zoom_out,
    full_speed,
    distance,
    angle,
    information,
    question,
    warning,
    file,
    new_folder,
    up,
    back,
    forward,
    tiles,
    lines,
    computer,
    clear
};

QIcon icon(Glyph glyph);

}  // namespace hitos::window
