// The configuration at a glance in five groups [T 9.2.6.1].
#pragma once

#include <QWidget>

#include "hitos/services/configuration/configuracion.hpp"

class QGridLayout;
class QLabel;

namespace hitos::window {

class SummaryBar final : public QWidget {
    Q_OBJECT

  public:
    explicit SummaryBar(QWidget* parent = nullptr);

    /// Shows the values; what differs from its default is marked.
    void set_configuration(const Configuracion& configuration);

  signals:
    /// The user clicked a group.
    void group_clicked(ParameterGroup group);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace hitos::window
