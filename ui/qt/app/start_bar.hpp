// SPDX-License-Identifier: GPL-3.0-or-later
// What a first start offers.
#pragma once

#include <QFrame>

class QAction;
class QHBoxLayout;

namespace hitos::window {

/// Three ways to begin, each with a line that says what comes of it. Goes when one is taken, or by
/// its button.
class StartBar final : public QFrame {
    Q_OBJECT

  public:
    explicit StartBar(QWidget* parent = nullptr);

    /// Shows it: run the tour that is open, open another, draw a world.
    void offer(QAction& run, QAction& open, QAction& draw);

  private:
    void add(const QString& title, const QString& what, QAction& action, const char* name);

    QHBoxLayout* row_;
};

}  // namespace hitos::window
