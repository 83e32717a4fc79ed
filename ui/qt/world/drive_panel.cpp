// SPDX-License-Identifier: GPL-3.0-or-later
#include "drive_panel.hpp"

#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <array>
#include <cmath>
#include <utility>

#include "disturb_bar.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/services/evaluation/nees.hpp"
#include "look/named.hpp"
#include "look/steady_label.hpp"
#include "look/words_of.hpp"
#include "world_view.hpp"

namespace hitos::window {
namespace {

constexpr std::array kPaces = {1, 2, 5, LiveDrive::kFastest};

}  // namespace

DrivePanel::DrivePanel(Session& session, UserFiles& files, Prompts& prompts, WorldView& view,
                       QWidget* parent)
    : QWidget(parent),
      session_(session),
      files_(files),
      prompts_(prompts),
      view_(view),
      drive_(session, this),
      logs_(this),
      gamepad_(this) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    make_tools();
    disturb_ = new DisturbBar(this);
    column->addWidget(disturb_);
    figures_ = named(new QLabel(this), "drive_figures");
    column->addWidget(keep_lines(*figures_, 2));
    connect_drive();
    show_state();
}

/// A tour that ends with the window is still rescued; those who would hear of it are going too.
DrivePanel::~DrivePanel() {
    drive_.disconnect();
}

void DrivePanel::make_tools() {
    auto* row = new QHBoxLayout;
    row->setContentsMargins(0, 0, 0, 0);
    rest_ = named(new QToolButton(this), "drive_rest");
    rest_->setText(tr("Hold the clock"));
    rest_->setToolTip(tr("The world stands still until you let the clock go on"));
    rest_->setCheckable(true);
    row->addWidget(rest_);
    pace_ = named(new QComboBox(this), "drive_pace");
    pace_->setAccessibleName(tr("Pace"));
    for (const int times : kPaces) {
        pace_->addItem(times == 1 ? tr("real pace") : tr("%1 times as fast").arg(times), times);
    }
    row->addWidget(pace_);
    pad_ = named(new QLabel(this), "drive_gamepad");
    pad_->hide();
    row->addWidget(pad_);
    row->addStretch(1);
    log_ = named(new QPushButton(tr("Save a log…"), this), "drive_log");
    log_->setAutoDefault(false);
    log_->setToolTip(
        tr("Writes what has been driven so far as a log, and the true path beside it; the tour "
           "goes on"));
    row->addWidget(log_);
    keep_ = named(new QPushButton(tr("End and keep the tour…"), this), "drive_keep");
    keep_->setAutoDefault(false);
    keep_->setToolTip(
        tr("Writes a world file that repeats the tour to the last bit, and maps it to its end"));
    row->addWidget(keep_);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
    connect(rest_, &QToolButton::toggled, this, [this](bool on) {
        on ? drive_.rest() : drive_.go_on();
        view_.setFocus();
    });
    connect(pace_, &QComboBox::activated, this, [this] {
        drive_.set_pace(pace_->currentData().toInt());
        view_.setFocus();
    });
    connect(log_, &QPushButton::clicked, this, &DrivePanel::save_log);
    connect(keep_, &QPushButton::clicked, this, &DrivePanel::keep);
}

void DrivePanel::connect_drive() {
    connect(&drive_, &LiveDrive::changed, this, &DrivePanel::show_state);
    connect(&drive_, &LiveDrive::moved, this, [this] {
        view_.set_goal(drive_.goal());
        view_.refresh();
        figures_->setText(figures());
    });
    connect(&drive_, &LiveDrive::failed, this, [this](const QString& reason) {
        show_rest();
        prompts_.warn(this, tr("The tour stands still"), reason);
    });
    connect(&drive_, &LiveDrive::rescued, this, [this](const QString& path) {
        emit notice(tr("The driven tour was kept as %1").arg(path));
    });
    connect(&logs_, &LogSaver::changed, this,
            [this] { log_->setEnabled(drive_.active() && !logs_.busy()); });
    connect(&logs_, &LogSaver::saved, this, [this](const QString& path) {
        emit notice(tr("The log is written: %1, and the true path beside it").arg(path));
    });
    connect(&logs_, &LogSaver::failed, this, [this](const QString& reason) {
        prompts_.warn(this, tr("The log was not written"), reason);
    });
    connect(&session_, &Session::snapshot_changed, this, [this] {
        view_.set_snapshot(drive_.active() ? session_.snapshot() : nullptr);
        figures_->setText(figures());
    });
    connect(&view_, &WorldView::held, this,
            [this](double ahead, double left) { hold(Holder::keys, ahead, left); });
    connect(&gamepad_, &Gamepad::held, this,
            [this](double ahead, double left) { hold(Holder::gamepad, ahead, left); });
    connect(&gamepad_, &Gamepad::start_pressed, rest_, &QToolButton::toggle);
    connect(&gamepad_, &Gamepad::changed, this, &DrivePanel::show_gamepad);
    connect(&view_, &WorldView::goal_chosen, &drive_, [this](const QPointF& world) {
        drive_.set_goal(Point2{world.x(), world.y()});
    });
    connect(disturb_, &DisturbBar::wanted, this, [this](const Disturbance& disturbance) {
        try {
            drive_.disturb(disturbance);
        } catch (const std::exception& error) {
            prompts_.warn(this, tr("That cannot happen here"), words_of(error));
        }
        view_.setFocus();
    });
}

/// Who lets go of what another one has taken over meanwhile changes nothing.
void DrivePanel::hold(Holder holder, double ahead, double left) {
    if (ahead == 0.0 && left == 0.0 && holder != holder_) return;
    holder_ = holder;
    drive_.hold(ahead, left);
}

void DrivePanel::show_gamepad() {
    constexpr int kWidest = 220;  // pixels
    const QString words = tr("Gamepad: %1").arg(gamepad_.name());
    pad_->setVisible(!gamepad_.name().isEmpty());
    pad_->setText(pad_->fontMetrics().elidedText(words, Qt::ElideRight, kWidest));
    pad_->setToolTip(
        tr("%1. The left stick or the cross drives the robot, Start holds the clock.").arg(words));
}

void DrivePanel::begin(const Configuracion& configuration) {
    drive_.begin(configuration);
    holder_ = Holder::keys;
    show_rest();
    view_.setFocus();
}

/// Whether the clock stands still, whoever has held it.
void DrivePanel::show_rest() {
    const QSignalBlocker quiet(rest_);
    rest_->setChecked(drive_.active() && drive_.rests());
}

void DrivePanel::rest() {
    rest_->setChecked(drive_.active());
}

void DrivePanel::keep() {
    const bool rested = drive_.rests();
    drive_.rest();
    gamepad_.listen(false);  // a question has the user
    const QString path = save_until_done(
        prompts_, this,
        {tr("Keep the tour as a world"), files_.place_to_save(QStringLiteral("driven.toml")),
         tr("Worlds (*.toml)"), QStringLiteral("toml")},
        [this](const QString& file) {
            check_world_name(file);
            drive_.keep(file);
        });
    if (path.isEmpty()) {
        gamepad_.listen(drive_.active());
        if (!rested) drive_.go_on();
        return;
    }
    files_.note_saved("log", path);
    files_.note_recent(path);
    emit kept(path);
    emit notice(tr("The tour is kept as %1").arg(path));
}

/// The world stands still while the user answers.
void DrivePanel::save_log() {
    const bool rested = drive_.rests();
    drive_.rest();
    gamepad_.listen(false);
    ask_for_log();
    gamepad_.listen(drive_.active());
    if (!rested) drive_.go_on();
    view_.setFocus();
}

void DrivePanel::ask_for_log() {
    Prompts::FileQuestion question{tr("Save a log; the true path goes beside it as NAME.truth.tum"),
                                   files_.place_to_save(QStringLiteral("driven.log")),
                                   log_filters().join(QStringLiteral(";;")), QStringLiteral("log")};
    QString chosen;
    question.chosen = &chosen;
    for (;;) {
        const QString path = ask_where_to_save(prompts_, this, question);
        if (path.isEmpty()) return;
        TourFiles files;
        files.log = path.toStdString();
        files.truth = truth_beside(files.log);
        files.format = format_by_ending(files.log, format_of_filter(chosen));
        question.start = path;
        const QString truth = QString::fromStdString(files.truth.string());
        if (QFileInfo::exists(truth) && !may_overwrite(prompts_, this, truth)) continue;
        files_.note_saved("log", path);
        logs_.save(drive_.tour()->recorded(), std::move(files));
        return;
    }
}

void DrivePanel::show_state() {
    view_.set_tour(drive_.tour());
    disturb_->set_tour(drive_.tour());
    if (!drive_.active()) view_.set_snapshot(nullptr);
    setVisible(drive_.active());
    gamepad_.listen(drive_.active());
    log_->setEnabled(drive_.active() && !logs_.busy());
    figures_->setText(figures());
}

/// Of the robot, and how far the run is off the truth at its newest scan.
QString DrivePanel::figures() const {
    if (!drive_.active()) return {};
    const SimulatedTour& tour = *drive_.tour();
    const Twist twist = tour.twist_now();
    QString words = tr("%1 s, %2 m/s, %3 °/s")
                        .arg(tour.duration_s(), 0, 'f', 1)
                        .arg(twist.v, 0, 'f', 2)
                        .arg(std::round(twist.w * kDegreesPerRadian) + 0.0, 0, 'f', 0);
    if (drive_.barred() != 0) {
        return words + '\n' +
               (drive_.barred() > 0 ? tr("A wall is in the way: the Down key or S backs off, a "
                                         "click on the free side "
                                         "leads away.")
                                    : tr("A wall is behind: the Up key or W drives on."));
    }
    const auto snapshot = session_.snapshot();
    if (!snapshot || snapshot->steps == 0 || snapshot->steps > tour.scans()) {
        return words + '\n' +
               tr("The arrow keys or W, A, S, D drive the robot; a click is where it drives by "
                  "itself. Line and dots are what the filter believes.");
    }
    const Pose truth = tour.true_pose(snapshot->steps - 1);
    const Pose off = between(truth, snapshot->best_pose);
    words += tr("; scan %1: the estimate is off by %2 m and %3°")
                 .arg(snapshot->steps)
                 .arg(std::hypot(off.x, off.y), 0, 'f', 3)
                 .arg(off.theta * kDegreesPerRadian, 0, 'f', 1);
    if (const auto nees = pose_nees(snapshot->mean_pose, snapshot->pose_covariance, truth)) {
        words += tr(", NEES %1 (%2 to %3 where it is as sure as it may be)")
                     .arg(*nees, 0, 'f', 1)
                     .arg(kNeesLow, 0, 'f', 1)
                     .arg(kNeesHigh, 0, 'f', 1);
    }
    return words;
}

}  // namespace hitos::window
