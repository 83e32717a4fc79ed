// SPDX-License-Identifier: GPL-3.0-or-later
// A robot driven by a gamepad: one of SDL's own, so that no hardware is needed.

#include "world/gamepad.hpp"

#include "tests.hpp"

#ifdef HITOS_SDL

#define SDL_MAIN_HANDLED
#include <SDL.h>

#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "drive_fixture.hpp"
#include "hitos/simulation/worlds/world.hpp"

namespace hitos::window {
namespace {

constexpr Sint16 kFull = SDL_JOYSTICK_AXIS_MAX;

/// Plugged in as long as it lives.
class VirtualPad {
  public:
    explicit VirtualPad(bool known = true) {
        SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER);
        device_ =
            known ? SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER,
                                              SDL_CONTROLLER_AXIS_MAX, SDL_CONTROLLER_BUTTON_MAX, 0)
                  : SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_UNKNOWN, 2, 4, 1);
        stick_ = SDL_JoystickOpen(device_);
        if (stick_ == nullptr) qFatal("no virtual joystick: %s", SDL_GetError());
    }
    ~VirtualPad() {
        SDL_JoystickDetachVirtual(device_);
        SDL_JoystickClose(stick_);
        SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
    }
    VirtualPad(const VirtualPad&) = delete;
    VirtualPad& operator=(const VirtualPad&) = delete;

    /// Ahead and to the left, -1 … 1 of the way that the stick has.
    void push(double ahead, double left) {
        SDL_JoystickSetVirtualAxis(stick_, 0, static_cast<Sint16>(-left * kFull));
        SDL_JoystickSetVirtualAxis(stick_, 1, static_cast<Sint16>(-ahead * kFull));
    }
    void press(int button, bool down) {
        SDL_JoystickSetVirtualButton(stick_, button, down ? 1 : 0);
    }
    void press_hat(int side) { SDL_JoystickSetVirtualHat(stick_, 0, static_cast<Uint8>(side)); }

  private:
    int device_ = -1;
    SDL_Joystick* stick_ = nullptr;
};

struct PadFixture : DriveFixture {
    Gamepad& gamepad() { return *world_window().findChild<Gamepad*>(); }
    QLabel& label() { return *world_window().findChild<QLabel*>("drive_gamepad"); }
    /// What the robot does a while after the pad was looked at.
    Twist twist() {
        gamepad().poll();
        periods(15);
        return drive().tour()->twist_now();
    }
    double fastest() { return drive().tour()->world().robot.max_speed; }
    double quickest() { return drive().tour()->world().robot.max_turn_rate; }
};

bool about(double found, double wanted) {
    return std::abs(found - wanted) < 1e-9;
}

}  // namespace

/// Another pad would be the first one.
void GamepadTest::init() {
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER);
    const int there = SDL_NumJoysticks();
    SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
    if (there > 0) QSKIP("a gamepad is plugged into this machine");
}

void GamepadTest::its_stick_drives_the_robot() {
    PadFixture f;
    f.gamepad().poll();
    QVERIFY(f.label().isHidden());
    VirtualPad pad;
    QTRY_VERIFY(!f.gamepad().name().isEmpty());  // it is found without being looked for
    QVERIFY(f.label().isVisible());
    QVERIFY(f.label().toolTip().contains(f.gamepad().name()));
    QCOMPARE(f.twist(), Twist{});
    pad.push(1.0, 0.0);
    QVERIFY(about(f.twist().v, f.fastest()));
    QCOMPARE(f.twist().w, 0.0);
    pad.push(0.14, -0.14);  // a stick that nobody touches
    QCOMPARE(f.twist(), Twist{});
    pad.push(-0.575, 0.0);  // in the middle of what is left
    QVERIFY(about(f.twist().v, -0.5 * f.fastest()));
    pad.push(0.0, 0.3);
    QVERIFY(f.twist().w > 0.0 && f.twist().w < 0.3 * f.quickest());
    pad.push(0.0, 0.0);
    pad.press(SDL_CONTROLLER_BUTTON_DPAD_RIGHT, true);
    QVERIFY(about(f.twist().w, -f.quickest()));
    pad.press(SDL_CONTROLLER_BUTTON_DPAD_RIGHT, false);
    QCOMPARE(f.twist(), Twist{});
    // It ends the way to a goal.
    f.drive().set_goal(Point2{3.0, 1.5});
    pad.push(0.0, 1.0);
    f.gamepad().poll();
    QVERIFY(!f.drive().goal());
}

void GamepadTest::unplugged_it_lets_go() {
    PadFixture f;
    {
        VirtualPad pad;
        f.gamepad().poll();
        pad.push(0.5, 0.5);
        QVERIFY(f.twist() != Twist{});
    }
    QCOMPARE(f.twist(), Twist{});
    QVERIFY(f.gamepad().name().isEmpty());
    QVERIFY(f.label().isHidden());
    VirtualPad pad;
    f.gamepad().poll();
    QVERIFY(f.label().isVisible());
    pad.push(0.0, 1.0);
    QVERIFY(about(f.twist().w, f.quickest()));
    // A tour that begins with the stick held has it too.
    f.world_window().drive_through(f.path("room.toml"));
    f.drive().rest();
    QVERIFY(about(f.twist().w, f.quickest()));
}

void GamepadTest::whoever_moved_last_drives() {
    PadFixture f;
    VirtualPad pad;
    f.gamepad().poll();
    WorldView& view = f.world_window().view();
    QTest::keyPress(&view, Qt::Key_Left);
    QVERIFY(about(f.twist().w, f.quickest()));  // a pad in the middle stops no key
    pad.push(0.0, -1.0);
    QVERIFY(about(f.twist().w, -f.quickest()));
    QTest::keyRelease(&view, Qt::Key_Left);
    QVERIFY(about(f.twist().w, -f.quickest()));
    QTest::keyPress(&view, Qt::Key_Left);
    QVERIFY(about(f.twist().w, f.quickest()));
    pad.push(0.0, 0.0);
    QVERIFY(about(f.twist().w, f.quickest()));
    QTest::keyRelease(&view, Qt::Key_Left);
    QCOMPARE(f.twist(), Twist{});
}

void GamepadTest::a_joystick_that_nobody_knows_drives_too() {
    PadFixture f;
    VirtualPad pad(false);
    f.gamepad().poll();
    pad.push(0.0, 1.0);
    QVERIFY(about(f.twist().w, f.quickest()));
    pad.press_hat(SDL_HAT_RIGHT);
    QVERIFY(about(f.twist().w, -f.quickest()));
    pad.press_hat(SDL_HAT_CENTERED);
    pad.push(0.0, 0.0);
    QCOMPARE(f.twist(), Twist{});
}

void GamepadTest::start_holds_the_clock() {
    PadFixture f;
    f.drive().go_on();
    auto* rest = f.world_window().findChild<QToolButton*>("drive_rest");
    rest->setChecked(false);
    VirtualPad pad;
    f.gamepad().poll();
    for (const bool rests : {true, false}) {
        pad.press(SDL_CONTROLLER_BUTTON_START, true);
        f.gamepad().poll();
        f.gamepad().poll();
        QCOMPARE(rest->isChecked(), rests);
        QCOMPARE(f.drive().rests(), rests);
        pad.press(SDL_CONTROLLER_BUTTON_START, false);
        f.gamepad().poll();
    }
}

void GamepadTest::what_a_stick_drove_is_kept_to_the_last_bit() {
    PadFixture f;
    VirtualPad pad;
    f.gamepad().poll();
    for (int k = 0; k < 80; ++k) {
        pad.push(0.5 + 0.3 * std::sin(0.37 * k), 0.6 * std::sin(0.23 * k));
        f.gamepad().poll();
        f.periods(1);
    }
    QTRY_VERIFY(f.caught_up());
    const auto driven = f.drive().tour();
    const Trajectory path = f.session.snapshot()->best_trajectory;
    f.drive().keep(f.path("kept.toml"));
    QTRY_VERIFY(f.state() == Progress::State::finished && f.shows_everything());
    f.session.seek(path.size());
    QTRY_VERIFY(f.steps() == path.size() && f.shows_everything());
    QVERIFY(f.session.snapshot()->best_trajectory == path);
    const SimulatedTour again(read_world(f.path("kept.toml").toStdString()));
    QVERIFY(again.world().tour.commands.size() > 40);
    QCOMPARE(again.pose_now(), driven->pose_now());
    QCOMPARE(again.twist_now(), driven->twist_now());
    for (std::uint64_t k = 0; k < driven->scans(); ++k) {
        QVERIFY(again.scan(k).points == driven->scan(k).points);
    }
}

}  // namespace hitos::window

#else

#include <QTest>

namespace hitos::window {

void GamepadTest::init() {
    QSKIP("built without SDL 2");
}
void GamepadTest::its_stick_drives_the_robot() {}
void GamepadTest::unplugged_it_lets_go() {}
void GamepadTest::whoever_moved_last_drives() {}
void GamepadTest::a_joystick_that_nobody_knows_drives_too() {}
void GamepadTest::start_holds_the_clock() {}
void GamepadTest::what_a_stick_drove_is_kept_to_the_last_bit() {}

}  // namespace hitos::window

#endif
