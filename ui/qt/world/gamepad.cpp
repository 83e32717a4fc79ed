// SPDX-License-Identifier: GPL-3.0-or-later
#include "gamepad.hpp"

#include <algorithm>
#include <cmath>

#ifdef HITOS_SDL
#define SDL_MAIN_HANDLED
#include <SDL.h>
#endif

namespace hitos::window {
namespace {

constexpr int kLookAtMs = 20;
constexpr int kLookForMs = 1000;

}  // namespace

#ifdef HITOS_SDL
namespace {

/// 0 within the dead zone of a stick that nobody touches, from there on up to -1 and 1, in steps
/// that its trembling does not pass.
double part_of(Sint16 axis) {
    constexpr double kDead = 0.15;
    constexpr double kSteps = 100.0;
    const double part = std::clamp(axis / double{SDL_JOYSTICK_AXIS_MAX}, -1.0, 1.0);
    const double live = std::max(std::abs(part) - kDead, 0.0) / (1.0 - kDead);
    return std::round(std::copysign(live, part) * kSteps) / kSteps + 0.0;  // no -0
}

/// The cross, where it is pressed, in place of the stick.
double either(bool more, bool less, double stick) {
    return more == less ? stick : more ? 1.0 : -1.0;
}

}  // namespace

/// SDL's pads without its windows, and the one that is open: by the names of its parts where SDL
/// knows them, else by the first two axes and the first hat.
class Gamepad::Device {
  public:
    Device() {
        SDL_SetMainReady();
        SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
        SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
        there_ = SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0;
    }
    ~Device() {
        close();
        if (there_) SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
    }
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    /// Also sees what was plugged in and out.
    void update() const {
        if (!there_) return;
        SDL_JoystickUpdate();
        SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);  // nobody takes them
    }

    bool attached() const { return stick_ != nullptr && SDL_JoystickGetAttached(stick_) != 0; }

    bool open() {
        if (!there_) return false;
        close();
        for (int i = 0; i < SDL_NumJoysticks() && stick_ == nullptr; ++i) {
            if (SDL_IsGameController(i) == SDL_FALSE) continue;
            pad_ = SDL_GameControllerOpen(i);
            stick_ = SDL_GameControllerGetJoystick(pad_);
        }
        for (int i = 0; i < SDL_NumJoysticks() && stick_ == nullptr; ++i) {
            stick_ = SDL_JoystickOpen(i);
            if (stick_ == nullptr || SDL_JoystickNumAxes(stick_) >= 2) continue;
            SDL_JoystickClose(stick_);  // pedals, buttons: nothing to drive with
            stick_ = nullptr;
        }
        return stick_ != nullptr;
    }

    void close() {
        if (pad_ != nullptr) {
            SDL_GameControllerClose(pad_);
        } else if (stick_ != nullptr) {
            SDL_JoystickClose(stick_);
        }
        pad_ = nullptr;
        stick_ = nullptr;
    }

    QString name() const {
        const char* name = SDL_JoystickName(stick_);
        return name == nullptr ? QString() : QString::fromUtf8(name).simplified();
    }

    State state() const { return pad_ != nullptr ? state_of_pad() : state_of_stick(); }

  private:
    State state_of_pad() const {
        const auto pressed = [this](SDL_GameControllerButton button) {
            return SDL_GameControllerGetButton(pad_, button) != 0;
        };
        return {
            either(pressed(SDL_CONTROLLER_BUTTON_DPAD_UP), pressed(SDL_CONTROLLER_BUTTON_DPAD_DOWN),
                   -part_of(SDL_GameControllerGetAxis(pad_, SDL_CONTROLLER_AXIS_LEFTY)) + 0.0),
            either(pressed(SDL_CONTROLLER_BUTTON_DPAD_LEFT),
                   pressed(SDL_CONTROLLER_BUTTON_DPAD_RIGHT),
                   -part_of(SDL_GameControllerGetAxis(pad_, SDL_CONTROLLER_AXIS_LEFTX)) + 0.0),
            pressed(SDL_CONTROLLER_BUTTON_START)};
    }

    State state_of_stick() const {
        const unsigned hat = SDL_JoystickNumHats(stick_) > 0 ? SDL_JoystickGetHat(stick_, 0) : 0U;
        const auto pressed = [hat](unsigned side) { return (hat & side) != 0; };
        return {either(pressed(SDL_HAT_UP), pressed(SDL_HAT_DOWN),
                       -part_of(SDL_JoystickGetAxis(stick_, 1)) + 0.0),
                either(pressed(SDL_HAT_LEFT), pressed(SDL_HAT_RIGHT),
                       -part_of(SDL_JoystickGetAxis(stick_, 0)) + 0.0),
                false};
    }

    bool there_ = false;
    SDL_GameController* pad_ = nullptr;
    SDL_Joystick* stick_ = nullptr;  ///< that of the pad, where there is one
};

#else

/// Of a machine without pads.
class Gamepad::Device {
  public:
    static void update() {}
    static bool attached() { return false; }
    static bool open() { return false; }
    static void close() {}
    static QString name() { return {}; }
    static State state() { return {}; }
};

#endif

Gamepad::Gamepad(QObject* parent) : QObject(parent) {
    connect(&timer_, &QTimer::timeout, this, &Gamepad::poll);
}

Gamepad::~Gamepad() = default;

void Gamepad::listen(bool on) {
    if (on == timer_.isActive()) return;
    timer_.stop();
    last_ = {};
    if (!on) return;
    // What SDL takes to begin nobody pays who drives no robot.
    if (!device_) device_ = std::make_unique<Device>();
    timer_.start(device_->attached() ? kLookAtMs : 0);
}

void Gamepad::poll() {
    if (!device_) return;
    device_->update();
    if (!device_->attached()) find();
    if (device_->attached()) take(device_->state());
}

/// Looking for a pad is rarer than looking at one.
void Gamepad::find() {
    const QString before = name_;
    take({});
    if (device_->open()) {
        name_ = device_->name();
        if (name_.isEmpty()) name_ = tr("without a name");
        timer_.setInterval(kLookAtMs);
    } else {
        name_.clear();
        device_->close();
        timer_.setInterval(kLookForMs);
    }
    if (name_ != before) emit changed();
}

void Gamepad::take(const State& state) {
    const State before = last_;
    last_ = state;
    if (state.ahead != before.ahead || state.left != before.left) {
        emit held(state.ahead, state.left);
    }
    if (state.start && !before.start) emit start_pressed();
}

}  // namespace hitos::window
