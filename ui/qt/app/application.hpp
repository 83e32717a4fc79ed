// What program and tests do alike before a window can be made.
#pragma once

#include <QString>

class QApplication;

namespace hitos::window {

/// Names, translations ("en", "es"; empty: the system's language) and numbers with a point.
void prepare_application(QApplication& application, const QString& language);

}  // namespace hitos::window
