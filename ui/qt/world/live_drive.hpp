// SPDX-License-Identifier: GPL-3.0-or-later
// A robot that the user drives through a world while the run maps it.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "hitos/simulation/drive/simulated_tour.hpp"
#include "hitos/simulation/text/world_text.hpp"
#include "session/session.hpp"

namespace hitos::window {

/// The clock of a driven tour: asks the robot, a control period after the other, for what the user
/// wants of it by then, at real pace or faster, and lets the session follow. Where the machine
/// cannot keep the pace the tour is slower, never another one.
class LiveDrive final : public QObject {
    Q_OBJECT

  public:
    static constexpr int kFastest = 10;  ///< times as fast as a clock

    explicit LiveDrive(Session& session, QObject* parent);
    ~LiveDrive() override;

    /// Puts the robot at the start of the world of the configuration's source and begins a run of
    /// what it will see. Throws hitos::Error, and leaves what was there.
    void begin(const Configuracion& configuration);
    /// The tour that is driven; null where there is none.
    const std::shared_ptr<SimulatedTour>& tour() const { return tour_; }
    bool active() const { return tour_ != nullptr; }

    void set_pace(int times);
    /// What is held down: parts -1 … 1 of the greatest speed ahead and turn rate to the left. It
    /// ends the way to a goal.
    void hold(double ahead, double left);
    /// Drives there [m, world frame]; nothing: nowhere.
    void set_goal(std::optional<Point2> goal);
    const std::optional<Point2>& goal() const { return goal_; }
    /// A wall keeps it from driving ahead (1) or back (-1), as it is asked to, and turning first
    /// would not help on the way to its goal. 0: none does.
    int barred() const { return barred_; }
    /// Happens now. Throws hitos::ConfigError where it cannot.
    void disturb(const Disturbance& disturbance);

    /// The clock stands still until the next go_on().
    void rest();
    void go_on();
    bool rests() const { return !timer_.isActive(); }
    /// One control period, whatever the clock says.
    void drive_period();

    /// Ends the tour and gives the world that repeats it to the last bit: it stands in place of the
    /// tour in the world's text as it was at begin(), whose comments stay, whatever has become of
    /// its file. Where the drawing of its walls is not found from the path, the walls stand in a
    /// new text. Throws hitos::FileError where it cannot be written, and the tour goes on.
    void keep(const QString& path);

    /// Ends the tour; one that was worth it is kept in the program's data and mapped there, and
    /// rescued() says where. Where it cannot be written it goes on, and failed() says why.
    void leave();
    /// Ends the tour; nothing of it stays.
    void give_up();

  signals:
    /// The robot, or something else in the world, has moved.
    void moved();
    /// A tour has begun or is over.
    void changed();
    /// The tour was given up before it was kept; there it lies.
    void rescued(QString path);
    void failed(QString reason);

  private:
    void tick();
    Twist wanted_now();
    void note_walls(const Twist& wanted);
    void write(const QString& path) const;
    bool is_worth_keeping() const;
    QString rescue();
    void map(const QString& path);

    Session& session_;
    std::shared_ptr<SimulatedTour> tour_;
    WorldText text_;  ///< of the world as it was when the tour began
    QTimer timer_;
    QElapsedTimer clock_;
    double due_s_ = 0.0;  ///< tour time that the clock asks for and nobody has driven yet
    int pace_ = 1;
    double ahead_ = 0.0;
    double left_ = 0.0;
    std::optional<Point2> goal_;
    bool turns_first_ = false;  ///< on the way to the goal, because a wall was in the way
    int barred_ = 0;
};

}  // namespace hitos::window
