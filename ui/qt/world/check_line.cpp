// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_line.hpp"

#include <QStringList>
#include <cmath>

#include "hitos/simulation/drive/world_check.hpp"
#include "look/theme.hpp"
#include "look/words_of.hpp"
#include "session/background.hpp"

namespace hitos::window {
namespace {

/// Whether its tour is driven in a moment: steps by walls, boxes by boxes.
bool is_quick(const World& world) {
    constexpr double kMost = 2e8;
    constexpr double kMostBoxes = 200.0;
    const TourParams& tour = world.tour;
    double seconds = tour.rest_s;
    for (const DriveCommand& command : tour.commands) seconds += command.duration_s;
    Point2 before{tour.start.x, tour.start.y};
    double way = 0.0;
    for (const WayPoint& point : tour.way_points) {
        way += std::hypot(point.at.x - before.x, point.at.y - before.y);
        before = point.at;
    }
    seconds += way * tour.laps / world.robot.max_speed;
    const auto boxes = static_cast<double>(tour.events.size());
    const double walls = static_cast<double>(world.walls.size()) + 4.0 * boxes;
    return boxes <= kMostBoxes && seconds * world.robot.control_rate_hz * walls <= kMost;
}

}  // namespace

CheckLine::CheckLine(QWidget* parent) : QLabel(parent) {
    setObjectName("world_check");
    setTextInteractionFlags(Qt::TextSelectableByMouse);
    constexpr int kPauseMs = 150;
    pause_.setSingleShot(true);
    pause_.setInterval(kPauseMs);
    pool_.setMaxThreadCount(1);
    connect(&pause_, &QTimer::timeout, this, &CheckLine::begin);
}

CheckLine::~CheckLine() {
    pool_.waitForDone();
}

void CheckLine::check(const World& world) {
    world_ = world;
    ++asked_;
    setEnabled(false);  // what it says is about what was before
    pause_.start();
}

void CheckLine::begin() {
    if (busy_) return;  // it begins anew when the one under way is done
    busy_ = true;
    pool_.start([this, world = world_, number = asked_] {
        begin_background_work();
        QStringList words;
        bool good = false;
        try {
            World checked = world;
            const bool quick = is_quick(world);
            if (!quick) checked.tour.way_points.clear();
            if (!quick) checked.tour.commands.clear();
            const WorldCheck check = check_world(checked);
            good = check.good();
            for (const Message& sentence : sentences_of(check, checked)) {
                words << words_of(sentence);
            }
            if (!quick) words.last() = tr("tour: too long to be driven while it is drawn");
        } catch (const std::exception& error) {
            words << words_of(error);
        }
        QMetaObject::invokeMethod(this, [this, number, words, good] {
            show_result(number, words.join(QStringLiteral(" · ")), good);
        });
    });
}

void CheckLine::show_result(std::uint64_t number, const QString& words, bool good) {
    busy_ = false;
    if (number != asked_) {
        if (!pause_.isActive()) begin();
        return;
    }
    shown_ = number;
    setEnabled(true);
    setText(world_.walls.empty() ? tr("Nothing is drawn yet.") : words);
    set_look(*this, "role", good || world_.walls.empty() ? "muted" : "warning");
}

}  // namespace hitos::window
