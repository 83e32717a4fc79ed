// Labels that take the same room whatever they say: a picture above them does not move.
#pragma once

#include <QLabel>

namespace hitos::window {

/// Room for so many lines, and for no more.
inline void keep_lines(QLabel& label, int lines) {
    label.setFixedHeight(label.fontMetrics().lineSpacing() * lines + 2);
    label.setAlignment(Qt::AlignLeft | Qt::AlignTop);
}

}  // namespace hitos::window
