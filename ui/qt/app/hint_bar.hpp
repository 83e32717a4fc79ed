// What speaks against the configuration in use, with the one button that mends it.
#pragma once

#include <QFrame>

#include "session.hpp"

class QLabel;
class QPushButton;

namespace hitos::window {

/// Hidden where there is nothing to say. A log that does not suit the configuration is told as soon
/// as it is opened, what only a run shows at its end.
class HintBar final : public QFrame {
    Q_OBJECT

  public:
    explicit HintBar(QWidget* parent = nullptr);
    void set_session(Session& session);

  signals:
    /// The user wants the configuration that the hint names.
    void preset_wanted(std::string preset);

  private:
    void look(const Session& session);
    void show_advice(const std::vector<Advice>& advice);

    QLabel* text_;
    QPushButton* use_;
    std::string preset_;
    QString closed_;  ///< what the user has read
};

}  // namespace hitos::window
