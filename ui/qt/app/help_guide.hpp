// SPDX-License-Identifier: GPL-3.0-or-later
// Help while working: the guide, at what it says of the thing in use.
#pragma once

#include <QObject>
#include <QPointer>
#include <span>

class QWidget;

namespace hitos::window {

class GuideWindow;
class Prompts;
class UserFiles;

/// What explains a part of the window: the anchor of a heading of docs/user-guide.md.
struct HelpPlace {
    const char* part;  ///< a widget's name, or its property "help"
    const char* heading;
};
std::span<const HelpPlace> help_places();

/// The heading for the widget or the nearest one that it is part of; empty where there is none.
QString help_for(const QWidget* widget);

/// Opens docs/user-guide.md in the window's language. F1 does it in every window of `main`, at what
/// it says of the widget with the keyboard.
class HelpGuide final : public QObject {
    Q_OBJECT

  public:
    HelpGuide(QWidget& main, UserFiles& files, Prompts& prompts);

    /// At the heading of that anchor of the English guide; empty: at the beginning.
    void open(const QString& heading);
    void explain();
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void belong_to(QWidget& window);
    void give_back();

    QWidget& main_;
    UserFiles& files_;
    Prompts& prompts_;
    QPointer<GuideWindow> window_;
};

}  // namespace hitos::window
