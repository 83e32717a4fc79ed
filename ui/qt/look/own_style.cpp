// SPDX-License-Identifier: GPL-3.0-or-later
#include "own_style.hpp"

#include <QPainter>
#include <QStyleOption>
#include <optional>

#include "icons.hpp"
#include "theme.hpp"

namespace hitos::window {
namespace {

std::optional<Glyph> own_glyph(QStyle::StandardPixmap which) {
    switch (which) {
        case QStyle::SP_MessageBoxInformation:
            return Glyph::information;
        case QStyle::SP_MessageBoxQuestion:
            return Glyph::question;
        case QStyle::SP_MessageBoxWarning:
        case QStyle::SP_MessageBoxCritical:
            return Glyph::warning;
        case QStyle::SP_DirIcon:
        case QStyle::SP_DirOpenIcon:
        case QStyle::SP_DirClosedIcon:
        case QStyle::SP_DirLinkIcon:
        case QStyle::SP_DirHomeIcon:
            return Glyph::open;
        case QStyle::SP_FileDialogNewFolder:
            return Glyph::new_folder;
        case QStyle::SP_FileIcon:
        case QStyle::SP_FileLinkIcon:
            return Glyph::file;
        case QStyle::SP_FileDialogToParent:
            return Glyph::up;
        case QStyle::SP_FileDialogBack:
        case QStyle::SP_ArrowBack:
            return Glyph::back;
        case QStyle::SP_ArrowForward:
            return Glyph::forward;
        case QStyle::SP_FileDialogListView:
            return Glyph::tiles;
        case QStyle::SP_FileDialogDetailedView:
            return Glyph::lines;
        case QStyle::SP_ComputerIcon:
        case QStyle::SP_DesktopIcon:
        case QStyle::SP_DriveHDIcon:
            return Glyph::computer;
        case QStyle::SP_LineEditClearButton:
            return Glyph::clear;
        default:
            return std::nullopt;
    }
}

}  // namespace

OwnStyle::OwnStyle() : QProxyStyle("Fusion") {}

QIcon OwnStyle::standardIcon(StandardPixmap which, const QStyleOption* option,
                             const QWidget* widget) const {
    const std::optional<Glyph> own = own_glyph(which);
    return own ? icon(*own) : QProxyStyle::standardIcon(which, option, widget);
}

QPixmap OwnStyle::standardPixmap(StandardPixmap which, const QStyleOption* option,
                                 const QWidget* widget) const {
    const std::optional<Glyph> own = own_glyph(which);
    const int size = pixelMetric(PM_SmallIconSize, option, widget);
    return own ? icon(*own).pixmap(size) : QProxyStyle::standardPixmap(which, option, widget);
}

int OwnStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                        QStyleHintReturn* answer) const {
    // Some desktops would put pictures into the buttons of dialogs, and none into Hitos's own.
    if (hint == SH_DialogButtonBox_ButtonsHaveIcons) return 0;
    if (hint == SH_EtchDisabledText)
        return 0;  // which in the dark is brighter than what is enabled
    return QProxyStyle::styleHint(hint, option, widget, answer);
}

void OwnStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                             QPainter* painter, const QWidget* widget) const {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element != PE_IndicatorCheckBox && element != PE_FrameLineEdit) return;
    const bool dark = colours().window.lightness() < colours().text.lightness();
    const State focus = element == PE_FrameLineEdit ? State(State_HasFocus)
                                                    : State_HasFocus | State_KeyboardFocusChange;
    if (!dark || (option->state & focus) == focus) return;
    // Fusion's outline is a darker window: in the dark none that can be seen.
    constexpr double kRadius = 2.0;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setBrush(Qt::NoBrush);
    painter->setPen(colours().muted);
    painter->drawRoundedRect(QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5), kRadius, kRadius);
    painter->restore();
}

}  // namespace hitos::window
