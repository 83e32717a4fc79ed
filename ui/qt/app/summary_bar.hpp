// SPDX-License-Identifier: GPL-3.0-or-later
// The configuration at a glance in five groups [T 9.2.6.1]: cards, or where there is little height
// one line of chips.
#pragma once

#include <QWidget>

#include "hitos/services/configuration/configuracion.hpp"

class QFrame;

namespace hitos::window {

class SummaryBar final : public QWidget {
    Q_OBJECT

  public:
    explicit SummaryBar(QWidget* parent = nullptr);

    /// Shows the values; what differs from its default is marked.
    void set_configuration(const Configuracion& configuration);
    /// A chip has the group's name and what differs from the default, or the log; a click opens
    /// its card.
    void set_folded(bool folded);

  signals:
    /// The user clicked a group's card.
    void group_clicked(ParameterGroup group);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void rebuild();
    QFrame* make_frame(ParameterGroup group, QWidget* parent);
    void open_card(QWidget& chip);

    Configuracion configuration_;
    bool folded_ = false;
    QObject* pressed_ = nullptr;  ///< a group's frame, to be compared only
};

}  // namespace hitos::window
