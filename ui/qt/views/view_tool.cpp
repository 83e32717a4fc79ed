// SPDX-License-Identifier: GPL-3.0-or-later
#include "view_tool.hpp"

namespace hitos::window {

ViewTool::~ViewTool() = default;

bool ViewTool::pick_up(const PointedAt& pointed) {
    Q_UNUSED(pointed)
    return false;
}

bool ViewTool::key(int key, Qt::KeyboardModifiers keys) {
    Q_UNUSED(key)
    Q_UNUSED(keys)
    return false;
}

void ViewTool::drag(const PointedAt& pointed) {
    Q_UNUSED(pointed)
}

}  // namespace hitos::window
