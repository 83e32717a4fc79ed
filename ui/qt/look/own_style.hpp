// SPDX-License-Identifier: GPL-3.0-or-later
// Qt's Fusion with Hitos's own icons in questions and file dialogs.
#pragma once

#include <QProxyStyle>

namespace hitos::window {

class OwnStyle final : public QProxyStyle {
    Q_OBJECT

  public:
    OwnStyle();

    QIcon standardIcon(StandardPixmap which, const QStyleOption* option,
                       const QWidget* widget) const override;
    QPixmap standardPixmap(StandardPixmap which, const QStyleOption* option,
                           const QWidget* widget) const override;
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* answer) const override;
};

}  // namespace hitos::window
