// SPDX-License-Identifier: GPL-3.0-or-later
#include "theme.hpp"

#include <QApplication>
#include <QPalette>
#include <QStyle>
#include <QStyleHints>
#include <QWidget>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "own_style.hpp"

namespace hitos::window {
namespace {

Colours make_light() {
    Colours c;
    c.window = "#f3f5f8";
    c.card = "#ffffff";
    c.border = "#d9dee6";
    c.text = "#1d2530";
    c.muted = "#5d6878";
    c.accent = "#1f5fd6";
    c.on_accent = "#ffffff";
    c.danger = "#c0271d";
    c.good = "#13795b";
    c.canvas = "#fcfdfe";
    c.grid_line = "#e8ecf1";
    c.scan = "#44505f";
    c.robot = "#b3261e";
    c.particle = "#e08a00";
    c.observed = "#0b8f62";
    c.landmark = "#2563c9";
    c.created = "#0b8f62";
    c.ignored = "#98a2b0";
    c.association = "#7a3fc9";
    c.highlight = "#d4237a";
    c.path = "#cf2e22";
    c.start = "#14935c";
    c.end = "#2563c9";
    c.odometry = "#a16a00";
    c.reference = "#0883a0";
    c.chip = QColor(255, 255, 255, 224);
    return c;
}

Colours make_dark() {
    Colours c;
    c.dark = true;
    c.window = "#14181e";
    c.card = "#1c222b";
    c.border = "#323a47";
    c.text = "#e6eaf0";
    c.muted = "#9aa6b6";
    c.accent = "#5b98f5";
    c.on_accent = "#0c1420";
    c.danger = "#ff8077";
    c.good = "#4fd0a0";
    c.canvas = "#11151a";
    c.grid_line = "#1f262f";
    c.scan = "#c3ccd8";
    c.robot = "#ff7a70";
    c.particle = "#ffb547";
    c.observed = "#45d69c";
    c.landmark = "#6aa5ff";
    c.created = "#45d69c";
    c.ignored = "#6c7787";
    c.association = "#b58cff";
    c.highlight = "#ff6fb5";
    c.path = "#e5382b";
    c.start = "#19b370";
    c.end = "#3f83f0";
    c.odometry = "#d39a2c";
    c.reference = "#1aa7c4";
    c.chip = QColor(28, 34, 43, 224);
    return c;
}

Colours& current() {
    static Colours colours = make_light();  // one application, one look
    return colours;
}

bool system_is_dark(const QPalette& palette) {
    return palette.color(QPalette::WindowText).lightness() >
           palette.color(QPalette::Window).lightness();
}

/// Of what is disabled.
QColor faint_of(const Colours& c) {
    QColor faint = c.muted;
    faint.setAlpha(130);
    return faint;
}

QPalette palette_of(const Colours& c) {
    QPalette palette;
    palette.setColor(QPalette::Window, c.window);
    palette.setColor(QPalette::WindowText, c.text);
    palette.setColor(QPalette::Base, c.card);
    palette.setColor(QPalette::AlternateBase, c.window);
    palette.setColor(QPalette::Text, c.text);
    palette.setColor(QPalette::PlaceholderText, c.muted);
    palette.setColor(QPalette::Button, c.card);
    palette.setColor(QPalette::ButtonText, c.text);
    palette.setColor(QPalette::ToolTipBase, c.card);
    palette.setColor(QPalette::ToolTipText, c.text);
    palette.setColor(QPalette::Highlight, c.accent);
    palette.setColor(QPalette::HighlightedText, c.on_accent);
    palette.setColor(QPalette::Link, c.accent);
    palette.setColor(QPalette::BrightText, c.danger);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, faint_of(c));
    return palette;
}

QString style_sheet(const Colours& c) {
    QString sheet = QStringLiteral(R"(
QMainWindow::separator { background: %window; width: 6px; height: 6px; }
QToolTip { background: %card; color: %text; border: 1px solid %border; padding: 4px; }
QFrame[role="card"] { background: %card; border: 1px solid %border; border-radius: 8px; }
QFrame[role="card"]:focus { border-color: %accent; }
QLabel[role="title"] { font-weight: 600; }
QLabel[role="muted"] { color: %muted; }
QLabel[role="error"] { color: %danger; }
QLabel[role="good"] { color: %good; }
QLabel[role="warning"] { color: %warning; }
QLabel[role="changed"] { color: %accent; font-weight: 600; }
QLabel:disabled, QLabel[role="muted"]:disabled, QLabel[role="changed"]:disabled { color: %faint; }
QToolButton[role="run"], QPushButton, QDialogButtonBox QPushButton {
  background: %card; border: 1px solid %border; border-radius: 6px; padding: 6px 10px; }
QToolButton[role="run"]:hover, QPushButton:hover { border-color: %accent; }
QToolButton[role="run"]:pressed, QPushButton:pressed { background: %border; }
QToolButton[role="run"]:focus, QPushButton:focus {
  border: 2px solid %accent; padding: 5px 9px; }
QToolButton[role="run"]:disabled, QPushButton:disabled { color: %muted; background: %window; }
QToolButton[primary="true"]:enabled, QPushButton:default:enabled {
  background: %accent; color: %onaccent; border-color: %accent; }
QToolButton[primary="true"]:enabled:focus, QPushButton:default:enabled:focus {
  border: 2px solid %text; padding: 5px 9px; }
QToolButton[role="view"] { border: 1px solid transparent; border-radius: 5px; padding: 3px 6px; }
QToolButton[role="view"]:hover { border-color: %border; background: %window; }
QToolButton[role="view"]:checked { background: %window; border-color: %border; color: %accent; }
QToolButton[role="chip"] { border: none; border-radius: 4px; padding: 1px 4px; color: %muted; }
QToolButton[role="chip"]::menu-indicator { image: none; }
QToolButton[role="chip"]:checked { color: %text; }
QToolButton[role="chip"]:hover { background: %window; }
QToolButton[role="view"]:focus { border-color: %accent; }
QProgressBar { border: none; background: %border; border-radius: 3px; max-height: 6px; }
QProgressBar::chunk { background: %accent; border-radius: 3px; }
QSplitter::handle { background: transparent; }
QStatusBar { background: %window; }
QStatusBar::item { border: none; }
QLineEdit[state="wrong"]:enabled, QComboBox[state="wrong"]:enabled,
QAbstractSpinBox[state="wrong"]:enabled {
  border: 1px solid %danger; border-radius: 3px; }
QMessageBox QLabel#qt_msgbox_informativelabel, QInputDialog QLabel { min-width: 280px; }
QDockWidget::title { padding: 6px 8px; text-align: left; font-weight: 600; }
)");
    sheet.replace("%window", c.window.name());
    sheet.replace("%card", c.card.name());
    sheet.replace("%border", c.border.name());
    sheet.replace("%text", c.text.name());
    sheet.replace("%muted", c.muted.name());
    const QColor faint = faint_of(c);
    sheet.replace("%faint", QString("rgba(%1, %2, %3, %4)")
                                .arg(faint.red())
                                .arg(faint.green())
                                .arg(faint.blue())
                                .arg(faint.alpha()));
    sheet.replace("%accent", c.accent.name());
    sheet.replace("%onaccent", c.on_accent.name());
    sheet.replace("%danger", c.danger.name());
    sheet.replace("%good", c.good.name());
    sheet.replace("%warning", c.odometry.name());
    return sheet;
}

}  // namespace

Theme theme_from(const QString& word) {
    if (word == "light") return Theme::light;
    if (word == "dark") return Theme::dark;
    return Theme::system;
}

QString to_word(Theme theme) {
    switch (theme) {
        case Theme::light:
            return "light";
        case Theme::dark:
            return "dark";
        case Theme::system:
            break;
    }
    return "system";
}

const Colours& colours() {
    return current();
}

const Colours& light_colours() {
    static const Colours light = make_light();
    return light;
}

QColor heat_colour(double share) {
    constexpr std::array<std::array<double, 3>, 5> kStops{
        {{252, 244, 196}, {248, 190, 104}, {226, 112, 76}, {150, 44, 104}, {48, 16, 84}}};
    const double place = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
    const double part = place - static_cast<double>(below);
    const auto mixed = [&](std::size_t channel) {
        return static_cast<int>(std::lround(
            std::lerp(kStops.at(below).at(channel), kStops.at(below + 1).at(channel), part)));
    };
    return {mixed(0), mixed(1), mixed(2)};
}

void apply_theme(QApplication& application, Theme theme) {
    static const bool system_dark = system_is_dark(QApplication::palette());
    const bool dark = theme == Theme::dark || (theme == Theme::system && system_dark);
    current() = dark ? make_dark() : make_light();
    QApplication::setStyle(new OwnStyle);
    QApplication::setPalette(palette_of(current()));
    application.setStyleSheet(style_sheet(current()));
}

void set_look(QWidget& widget, const char* property, const char* value) {
    widget.setProperty(property, value);
    widget.style()->unpolish(&widget);
    widget.style()->polish(&widget);
}

}  // namespace hitos::window
