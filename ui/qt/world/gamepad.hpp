// SPDX-License-Identifier: GPL-3.0-or-later
// A gamepad that drives the robot.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>

namespace hitos::window {

/// The first gamepad that the machine has, found when it is plugged in: left stick and cross drive,
/// Start is a key. Built without SDL there is never one.
class Gamepad final : public QObject {
    Q_OBJECT

  public:
    explicit Gamepad(QObject* parent);
    ~Gamepad() override;

    /// Looks for one, and at it, until it is told no longer to.
    void listen(bool on);
    /// Of the pad that is there; empty: none.
    const QString& name() const { return name_; }
    /// Looks now, whatever the clock says.
    void poll();

  signals:
    /// Parts -1 … 1 of the greatest speed ahead and turn rate to the left, when they change; of a
    /// pad that is unplugged, none.
    void held(double ahead, double left);
    void start_pressed();
    /// A pad is there, or no longer.
    void changed();

  private:
    class Device;
    struct State {
        double ahead = 0.0;
        double left = 0.0;
        bool start = false;
    };
    void take(const State& state);
    void find();

    std::unique_ptr<Device> device_;
    QString name_;
    QTimer timer_;
    State last_;
};

}  // namespace hitos::window
