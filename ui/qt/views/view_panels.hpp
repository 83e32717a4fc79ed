// SPDX-License-Identifier: GPL-3.0-or-later
// The two views beside each other, one above the other, or one alone.
#pragma once

#include <QObject>
#include <array>

class QAction;
class QSettings;
class QSplitter;
class QToolButton;
class QWidget;

namespace hitos::window {

class ViewPanels final : public QObject {
    Q_OBJECT

  public:
    /// One of the views: its panel in the splitter, what is double-clicked to have it alone, and
    /// itself; the button beside the title has words where the panel is wide enough for both.
    struct Panel {
        QWidget* panel = nullptr;
        QWidget* title = nullptr;
        QWidget* view = nullptr;
        QToolButton* button = nullptr;
    };
    /// `alone` shows the view with the keyboard, else the last one, alone; `stacked` puts one above
    /// the other. Both are checkable.
    ViewPanels(QSplitter& splitter, const std::array<Panel, 2>& panels, QAction* alone,
               QAction* stacked);

    void save(QSettings& settings) const;
    void restore(const QSettings& settings);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void show_alone(bool alone);
    void stack(bool stacked);

    QSplitter& splitter_;
    std::array<Panel, 2> panels_;
    QAction* alone_;
    QAction* stacked_;
    QWidget* asked_ = nullptr;  ///< whose title was double-clicked
};

}  // namespace hitos::window
