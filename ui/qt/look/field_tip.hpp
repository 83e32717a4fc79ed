// SPDX-License-Identifier: GPL-3.0-or-later
// What is told at a field while somebody writes in it.
#pragma once

#include <QString>

class QWidget;

namespace hitos::window {

/// Beside the field, where it covers no other input of the window.
void show_field_tip(QWidget& field, const QString& words);
void hide_field_tip();

}  // namespace hitos::window
