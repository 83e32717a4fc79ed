// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_drive.hpp"

#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/geometry.hpp"
#include "hitos/simulation/drive/driver.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "look/user_files.hpp"
#include "look/words_of.hpp"

namespace hitos::window {
namespace {

/// Of tour time in one go: where the machine falls behind, the rest of the delay is let be.
constexpr double kMostAtOnceS = 0.5;
/// Heads for its goal: turning on would change next to nothing [rad].
constexpr double kHeadsForIt = 0.005;
/// A tour shorter than this is no loss [s].
constexpr double kWorthKeepingS = 5.0;

/// The text with this tour, as it reads at the path. Where the drawing of its walls is gone, or
/// another one by now, a new text that has the walls itself.
WorldText with_tour(WorldText text, const World& driven, const std::filesystem::path& path) {
    try {
        text.set(driven);
        WorldText there = text.moved_to(path);
        if (same_world(there.world(), driven)) return there;
    } catch (const Error&) {  // as it says
    }
    WorldText anew;
    anew.set(driven);
    return anew;
}

}  // namespace

LiveDrive::LiveDrive(Session& session, QObject* parent) : QObject(parent), session_(session) {
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &LiveDrive::tick);
    connect(&session, &Session::configuration_changed, this, [this] {
        if (!tour_ || session_.live_tour() == tour_) return;
        rescue();
        give_up();
    });
}

LiveDrive::~LiveDrive() {
    if (tour_) rescue();
    give_up();
}

void LiveDrive::begin(const Configuracion& configuration) {
    std::shared_ptr<SimulatedTour> tour =
        SimulatedTour::live(open_world(configuration.source, configuration.run.seed));
    WorldText text = WorldText::read(configuration.source.file);
    session_.set_live(configuration, tour);  // gives up an earlier tour
    tour_ = std::move(tour);
    text_ = std::move(text);
    goal_.reset();
    ahead_ = left_ = 0.0;
    turns_first_ = false;
    barred_ = 0;
    go_on();
    emit changed();
}

void LiveDrive::set_pace(int times) {
    pace_ = std::clamp(times, 1, kFastest);
}

void LiveDrive::hold(double ahead, double left) {
    ahead_ = std::clamp(ahead, -1.0, 1.0);
    left_ = std::clamp(left, -1.0, 1.0);
    if (ahead_ != 0.0 || left_ != 0.0) goal_.reset();
}

void LiveDrive::set_goal(std::optional<Point2> goal) {
    goal_ = goal;
    turns_first_ = false;
    barred_ = 0;
    emit moved();
}

void LiveDrive::disturb(const Disturbance& disturbance) {
    if (!tour_) return;
    tour_->disturb(disturbance);
    emit moved();
}

void LiveDrive::rest() {
    timer_.stop();
}

void LiveDrive::go_on() {
    if (!tour_) return;
    constexpr int kTickMs = 10;
    due_s_ = 0.0;
    clock_.start();
    timer_.start(kTickMs);
}

void LiveDrive::tick() {
    constexpr double kNano = 1e-9;
    due_s_ += static_cast<double>(clock_.nsecsElapsed()) * kNano * pace_;
    clock_.start();
    due_s_ = std::min(due_s_, kMostAtOnceS);
    const double period_s = 1.0 / tour_->world().robot.control_rate_hz;
    for (; timer_.isActive() && due_s_ >= period_s; due_s_ -= period_s) drive_period();
}

/// Of the robot. On its way to a goal it turns as it drives; where a wall does not let it, it turns
/// on the spot before.
Twist LiveDrive::wanted_now() {
    const RobotParams& robot = tour_->world().robot;
    if (!goal_) return {ahead_ * robot.max_speed, 0.0, left_ * robot.max_turn_rate};
    const Pose pose = tour_->pose_now();
    Twist wanted = towards(pose, *goal_, robot);
    if (wanted == Twist{}) goal_.reset();
    if (!goal_ || !turns_first_) return wanted;
    const double bearing = std::atan2(goal_->y - pose.y, goal_->x - pose.x);
    if (std::abs(wrap_angle(bearing - pose.theta)) > kHeadsForIt) wanted.v = 0.0;
    return wanted;
}

void LiveDrive::drive_period() {
    if (!tour_) return;
    const Twist wanted = wanted_now();
    const std::uint64_t scans = tour_->scans();
    try {
        tour_->drive_on(wanted.v, wanted.w);
    } catch (const std::exception& error) {  // as long as a tour may be, or no memory
        rest();
        emit failed(words_of(error));
        return;
    }
    note_walls(wanted);
    if (tour_->scans() != scans) session_.follow();
    emit moved();
}

/// What is asked to drive and stands still has a wall before it.
void LiveDrive::note_walls(const Twist& wanted) {
    const bool stands = wanted.v != 0.0 && tour_->twist_now() == Twist{};
    const bool turned = !goal_ || std::exchange(turns_first_, turns_first_ || stands);
    barred_ = !stands || !turned ? 0 : wanted.v > 0.0 ? 1 : -1;
    if (!stands && wanted.v != 0.0) turns_first_ = false;
}

void LiveDrive::write(const QString& path) const {
    with_tour(text_, tour_->recorded(), path.toStdString()).save(path.toStdString());
}

void LiveDrive::keep(const QString& path) {
    if (!tour_) return;
    write(path);
    rest();
    const std::shared_ptr<SimulatedTour> kept = std::exchange(tour_, nullptr);
    try {
        map(path);
    } catch (...) {  // the tour is not over before there is a file that is run in its place
        tour_ = kept;
        throw;
    }
    kept->end();
    emit changed();
}

/// The run goes along the file from now on, which says what was changed of it and its noise.
void LiveDrive::map(const QString& path) {
    Configuracion configuration = session_.configuration();
    configuration.source.file = path.toStdString();
    configuration.source.world_set.clear();
    configuration.source.tour_seed = 0;
    configuration.source.map.clear();  // it begins a tour of its own
    session_.set_configuration(configuration);
    session_.run();
}

void LiveDrive::give_up() {
    if (!tour_) return;
    rest();
    tour_->end();
    tour_ = nullptr;
    emit changed();
}

void LiveDrive::leave() {
    if (!tour_) return;
    const bool worth = is_worth_keeping();
    const QString path = rescue();
    if (worth && path.isEmpty()) return;  // why is told; it goes on until it can be kept
    give_up();
    if (!path.isEmpty()) map(path);
}

bool LiveDrive::is_worth_keeping() const {
    return tour_->duration_s() >= kWorthKeepingS;
}

/// Whoever loads something else in the middle of a tour still finds it.
QString LiveDrive::rescue() {
    rest();
    if (!is_worth_keeping()) return {};
    const QString name = QFileInfo(QString::fromStdString(tour_->world().name)).completeBaseName();
    QString path = new_file_of_data(QStringLiteral("driven"), name, QStringLiteral("toml"));
    try {
        write(path);
        emit rescued(path);
        return path;
    } catch (const std::exception& error) {
        emit failed(words_of(error));
        return {};
    }
}

}  // namespace hitos::window
