#include "world_window.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <array>
#include <cmath>

#include "app/icons.hpp"
#include "app/screen_fit.hpp"
#include "app/words_of.hpp"
#include "disturb_bar.hpp"
#include "hitos/services/evaluation/nees.hpp"
#include "hitos/workbench/presets.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "world_view.hpp"

namespace hitos::window {
namespace {

constexpr QSize kWished(860, 640);
constexpr double kDegrees = 180.0 / kPi;
constexpr std::array kPaces = {1, 2, 5, LiveDrive::kFastest};

}  // namespace

WorldWindow::WorldWindow(Session& session, UserFiles& files, Prompts& prompts,
                         const RunGuard& guard, QWidget* parent)
    : QDialog(parent, Qt::Window),
      session_(session),
      files_(files),
      prompts_(prompts),
      guard_(guard),
      drive_(session, this) {
    setObjectName("world_window");
    setWindowTitle(tr("Drive a robot"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(make_tools());
    view_ = new WorldView(this);
    view_->setObjectName("world_view");
    column->addWidget(view_, 1);
    disturb_ = new DisturbBar(this);
    column->addWidget(disturb_);
    figures_ = new QLabel(this);
    figures_->setObjectName("drive_figures");
    figures_->setWordWrap(true);
    column->addWidget(figures_);
    connect_drive();
    resize(kWished);
    fit_to_screen(*this);
    show_state();
}

QWidget* WorldWindow::make_tools() {
    auto* tools = new QWidget(this);
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, 0, 0);
    worlds_ = new QComboBox(tools);
    worlds_->setObjectName("drive_world");
    worlds_->setAccessibleName(tr("World"));
    worlds_->addItem(tr("Choose a world…"));
    for (const std::string& name : shipped_worlds()) {
        worlds_->addItem(QString::fromStdString(name));
    }
    worlds_->addItem(tr("Another file…"));
    row->addWidget(worlds_);
    rest_ = new QToolButton(tools);
    rest_->setObjectName("drive_rest");
    rest_->setText(tr("Hold the clock"));
    rest_->setToolTip(tr("The world stands still until you let the clock go on"));
    rest_->setCheckable(true);
    row->addWidget(rest_);
    pace_ = new QComboBox(tools);
    pace_->setObjectName("drive_pace");
    pace_->setAccessibleName(tr("Pace"));
    for (const int times : kPaces) {
        pace_->addItem(times == 1 ? tr("real pace") : tr("%1 times as fast").arg(times), times);
    }
    row->addWidget(pace_);
    row->addStretch(1);
    keep_ = new QPushButton(tr("End and keep the tour…"), tools);
    keep_->setObjectName("drive_keep");
    keep_->setToolTip(
        tr("Writes a world file that repeats the tour to the last bit, and maps it to its end"));
    row->addWidget(keep_);
    for (QPushButton* button : tools->findChildren<QPushButton*>()) button->setAutoDefault(false);
    connect(worlds_, &QComboBox::activated, this, &WorldWindow::open_asked);
    connect(rest_, &QToolButton::toggled, this, [this](bool on) {
        on ? drive_.rest() : drive_.go_on();
        view_->setFocus();
    });
    connect(pace_, &QComboBox::activated, this, [this] {
        drive_.set_pace(pace_->currentData().toInt());
        view_->setFocus();
    });
    connect(keep_, &QPushButton::clicked, this, &WorldWindow::keep);
    return tools;
}

void WorldWindow::connect_drive() {
    connect(&drive_, &LiveDrive::changed, this, &WorldWindow::show_state);
    connect(&drive_, &LiveDrive::moved, this, [this] {
        view_->set_goal(drive_.goal());
        view_->refresh();
        figures_->setText(figures());
    });
    connect(&drive_, &LiveDrive::failed, this, [this](const QString& reason) {
        prompts_.warn(this, tr("The robot cannot be driven on"), reason);
    });
    connect(&drive_, &LiveDrive::rescued, this, [this](const QString& path) {
        emit notice(tr("The driven tour was kept as %1").arg(path));
    });
    connect(&session_, &Session::snapshot_changed, this, [this] {
        view_->set_snapshot(drive_.active() ? session_.snapshot() : nullptr);
        figures_->setText(figures());
    });
    connect(view_, &WorldView::held, &drive_, &LiveDrive::hold);
    connect(view_, &WorldView::goal_chosen, &drive_, [this](const QPointF& world) {
        drive_.set_goal(Point2{world.x(), world.y()});
    });
    connect(disturb_, &DisturbBar::wanted, this, [this](const Disturbance& disturbance) {
        try {
            drive_.disturb(disturbance);
        } catch (const std::exception& error) {
            prompts_.warn(this, tr("That cannot happen here"), words_of(error));
        }
        view_->setFocus();
    });
}

void WorldWindow::open_asked() {
    const int place = worlds_->currentIndex();
    if (place == 0) return;
    QString path;
    if (place == worlds_->count() - 1) {
        path = prompts_.open_file(this, {tr("World to drive through"),
                                         files_.folder_to_open("log"),
                                         tr("Worlds (*.toml);;All files (*)"),
                                         {}});
    } else {
        try {
            path =
                QString::fromStdString(find_world(worlds_->currentText().toStdString()).string());
        } catch (const std::exception& error) {
            prompts_.warn(this, tr("The world cannot be opened"), words_of(error));
        }
    }
    if (!path.isEmpty()) drive_through(path);
    worlds_->setCurrentIndex(0);  // which names what is driven
}

void WorldWindow::drive_through(const QString& path) {
    if (!guard_.may_discard()) return;
    try {
        Configuracion configuration = session_.configuration();
        // What suits a log suits no world, and nothing was chosen for worlds yet.
        if (!is_world_file(configuration.source.file)) {
            configuration = preset_configuration(kWorldPreset);
        }
        configuration.source = {};
        configuration.source.file = path.toStdString();
        drive_.begin(configuration);
        const QSignalBlocker quiet(rest_);
        rest_->setChecked(false);
        view_->setFocus();
    } catch (const std::exception& error) {
        prompts_.warn(this, tr("The world cannot be opened"), words_of(error));
    }
}

void WorldWindow::keep() {
    const bool rested = drive_.rests();
    drive_.rest();
    const QString path = save_until_done(
        prompts_, this,
        {tr("Keep the tour as a world"), files_.last_folder("log") + QStringLiteral("/driven.toml"),
         tr("Worlds (*.toml)"), QStringLiteral("toml")},
        [this](const QString& file) { drive_.keep(file); });
    if (path.isEmpty()) {
        if (!rested) drive_.go_on();
        return;
    }
    files_.note_folder("log", path);
    files_.note_recent(path);
    emit notice(tr("The tour is kept as %1").arg(path));
}

void WorldWindow::show_state() {
    const bool active = drive_.active();
    view_->set_tour(drive_.tour());
    disturb_->set_tour(drive_.tour());
    for (QWidget* widget : {static_cast<QWidget*>(rest_), static_cast<QWidget*>(keep_)}) {
        widget->setEnabled(active);
    }
    if (!active) view_->set_snapshot(nullptr);
    worlds_->setItemText(
        0, active ? QString::fromStdString(drive_.tour()->world().name) : tr("Choose a world…"));
    worlds_->setCurrentIndex(0);
    figures_->setText(figures());
}

/// Of the robot, and how far the run is off the truth at its newest scan.
QString WorldWindow::figures() const {
    if (!drive_.active()) {
        return tr(
            "The arrow keys or W, A, S, D drive the robot; a click is where it drives by "
            "itself. Line and dots are what the filter believes.");
    }
    const SimulatedTour& tour = *drive_.tour();
    const Twist twist = tour.twist_now();
    QString words = tr("%1 s, %2 m/s, %3 °/s")
                        .arg(tour.duration_s(), 0, 'f', 1)
                        .arg(twist.v, 0, 'f', 2)
                        .arg(std::round(twist.w * kDegrees) + 0.0, 0, 'f', 0);
    const auto snapshot = session_.snapshot();
    if (!snapshot || snapshot->steps == 0 || snapshot->steps > tour.scans()) return words;
    const Pose truth = tour.true_pose(snapshot->steps - 1);
    const Pose off = between(truth, snapshot->best_pose);
    words += tr("; scan %1: the estimate is off by %2 m and %3°")
                 .arg(snapshot->steps)
                 .arg(std::hypot(off.x, off.y), 0, 'f', 3)
                 .arg(off.theta * kDegrees, 0, 'f', 1);
    if (const auto nees = pose_nees(snapshot->mean_pose, snapshot->pose_covariance, truth)) {
        words += tr(", NEES %1 (%2 to %3 where it is as sure as it may be)")
                     .arg(*nees, 0, 'f', 1)
                     .arg(kNeesLow, 0, 'f', 1)
                     .arg(kNeesHigh, 0, 'f', 1);
    }
    return words;
}

/// Who does not see the world does not drive through it.
void WorldWindow::hideEvent(QHideEvent* event) {
    rest_->setChecked(drive_.active());
    QDialog::hideEvent(event);
}

}  // namespace hitos::window
