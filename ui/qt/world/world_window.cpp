// SPDX-License-Identifier: GPL-3.0-or-later
#include "world_window.hpp"

#include <QDir>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

#include "check_line.hpp"
#include "dialogs/export_dialog.hpp"
#include "draw_bar.hpp"
#include "drive_panel.hpp"
#include "hitos/capture/tour_reader.hpp"
#include "hitos/workbench/presets.hpp"
#include "look/named.hpp"
#include "look/screen_fit.hpp"
#include "look/steady_label.hpp"
#include "look/undo_keys.hpp"
#include "look/words_of.hpp"
#include "session/session.hpp"
#include "world_form.hpp"
#include "world_view.hpp"

namespace hitos::window {
namespace {

constexpr QSize kWorldSize(960, 700);
constexpr int kLines = 3;  // of what the check says

}  // namespace

WorldWindow::WorldWindow(Session& session, UserFiles& files, Prompts& prompts,
                         const RunGuard& guard, QWidget* parent)
    : QDialog(parent, Qt::Window),
      session_(session),
      prompts_(prompts),
      guard_(guard),
      draft_(this),
      tool_(draft_, this),
      files_of_worlds_(draft_, files, prompts, this) {
    setObjectName("world_window");
    auto* column = new QVBoxLayout(this);
    column->addWidget(make_tools());
    view_ = named(new WorldView(this), "world_view");
    view_->set_tool(tool_);
    connect(view_, &CanvasView::picture_wanted, this, [this, &files] {
        const QString path = export_figure(files, prompts_, this, view_->exportable());
        if (!path.isEmpty()) say(tr("Image saved: %1").arg(QDir::toNativeSeparators(path)));
    });
    bar_ = new DrawBar(draft_, tool_, *view_, this);
    column->addWidget(bar_);
    column->addWidget(view_, 1);
    auto* words = new QHBoxLayout;
    check_ = new CheckLine(this);
    words->addWidget(keep_lines(*check_, kLines), 2);
    said_ = named(new QLabel(this), "world_notice");
    said_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    words->addWidget(keep_lines(*said_, kLines), 1);
    panel_ = new DrivePanel(session, files, prompts, *view_, this);
    column->addWidget(panel_);
    column->addLayout(words);
    make_actions();
    connect_draft();
    connect(panel_, &DrivePanel::notice, this, &WorldWindow::say);
    connect(panel_, &DrivePanel::kept, this, &WorldWindow::go_on_with);
    connect(&drive(), &LiveDrive::changed, this, &WorldWindow::show_state);
    resize(kWorldSize);
    place_beside_parent(*this, kBeside);
    show_draft();
    show_state();
}

/// Before the draft and the tool that they refer to.
WorldWindow::~WorldWindow() {
    delete panel_;
    delete bar_;
}

/// Escape ends what is begun, wherever the keyboard is; it does not close the window.
void WorldWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape) {
        QDialog::keyPressEvent(event);
        return;
    }
    if (!drive().active()) tool_.escape();
    view_->setFocus();
}

LiveDrive& WorldWindow::drive() {
    return panel_->drive();
}

QWidget* WorldWindow::make_tools() {
    auto* tools = new QWidget(this);
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, 0, 0);
    const auto add_button = [&](const QString& text, const char* name) {
        auto* button = named(new QToolButton(tools), name);
        button->setText(text);
        row->addWidget(button);
        return button;
    };
    QToolButton* worlds = add_button(tr("World"), "world_menu_button");
    worlds->setPopupMode(QToolButton::InstantPopup);
    menu_ = named(new QMenu(worlds), "world_menu");
    files_of_worlds_.fill(*menu_);
    menu_->addSeparator();
    QAction* values = menu_->addAction(tr("&Robot, laser, odometry…"), this, [this] {
        WorldForm form(draft_.text(), this);
        if (form.exec() == QDialog::Accepted) {
            draft_.change([&](WorldText& text) { text = form.text(); });
        }
    });
    values->setObjectName("world_values");
    worlds->setMenu(menu_);
    undo_ = new QAction(tr("Undo"), this);
    redo_ = new QAction(tr("Redo"), this);
    add_button({}, "world_undo_button")->setDefaultAction(undo_);
    add_button({}, "world_redo_button")->setDefaultAction(redo_);
    row->addStretch(1);
    run_ = named(new QPushButton(tr("Run its tour"), tools), "world_run");
    run_->setToolTip(
        tr("Maps the tour along the way points, or the one that was driven, in the main window"));
    row->addWidget(run_);
    drive_ = named(new QPushButton(tools), "world_drive");
    row->addWidget(drive_);
    // Return belongs to the drawing.
    for (QPushButton* button : {run_, drive_}) button->setAutoDefault(false);
    return tools;
}

void WorldWindow::make_actions() {
    undo_->setObjectName("world_undo");
    undo_->setShortcut(QKeySequence::Undo);
    new UndoKeys(this);
    redo_->setObjectName("world_redo");
    redo_->setShortcuts(
        {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    addActions({undo_, redo_});
    connect(undo_, &QAction::triggered, this, [this] {
        // A point that was just drawn goes first.
        tool_.pending().empty() ? draft_.undo() : tool_.drop_last_point();
    });
    connect(redo_, &QAction::triggered, &draft_, &WorldDraft::redo);
    connect(run_, &QPushButton::clicked, this, [this] {
        try {
            emit run_wanted(files_of_worlds_.file_as_drawn());
        } catch (const std::exception& error) {
            tell_not_written(prompts_, this, words_of(error));
        }
    });
    connect(drive_, &QPushButton::clicked, this,
            [this] { drive().active() ? drive().leave() : drive_through_drawn(); });
}

void WorldWindow::connect_draft() {
    connect(&files_of_worlds_, &WorldFiles::notice, this, &WorldWindow::say);
    connect(&files_of_worlds_, &WorldFiles::asked_for, &tool_, &DrawTool::finish);
    connect(&draft_, &WorldDraft::opened, this, [this] {
        view_->set_world(std::make_shared<const World>(draft_.world()));
        view_->fit();
    });
    connect(&draft_, &WorldDraft::changed, this, &WorldWindow::show_draft);
    connect(&tool_, &DrawTool::pending_changed, this, &WorldWindow::show_state);
    connect(&draft_, &WorldDraft::refused, this, [this](const QString& reason) {
        prompts_.warn(this, tr("That cannot be drawn"), reason);
    });
}

void WorldWindow::show_draft() {
    say({});  // it was about what was before
    view_->set_world(std::make_shared<const World>(draft_.world()));
    check_->check(draft_.world());
    show_state();
}

void WorldWindow::show_state() {
    const bool drives = drive().active();
    tool_.set_active(!drives);
    bar_->setVisible(!drives);
    setProperty("help", drives ? QVariant("driving") : QVariant());
    check_->setVisible(!drives);
    for (QAction* action : menu_->actions()) action->setEnabled(!drives);
    undo_->setEnabled(!drives && (draft_.can_undo() || !tool_.pending().empty()));
    redo_->setEnabled(!drives && draft_.can_redo());
    const TourParams& tour = draft_.world().tour;
    const bool has_tour = !tour.way_points.empty() || !tour.commands.empty();
    run_->setEnabled(!drives && !draft_.world().walls.empty() && has_tour);
    drive_->setText(drives ? tr("Back to drawing") : tr("Drive a robot"));
    drive_->setToolTip(drives ? tr("Ends the tour; of five seconds or more a copy is kept")
                              : tr("Puts the robot at the start, to be driven by hand"));
    drive_->setEnabled(drives || !draft_.world().walls.empty());
    setWindowTitle(tr("%1 – World workshop")
                       .arg(draft_.name() + (draft_.modified() ? QStringLiteral("*") : QString())));
}

void WorldWindow::drive_through(const QString& path) {
    // What cannot be driven through leaves what was there, a driven tour too.
    if (!files_of_worlds_.may_discard()) return;
    try {
        WorldText text = WorldText::read(path.toStdString());
        if (begin_driving(path)) draft_.open(std::move(text), path);
    } catch (const std::exception& error) {
        prompts_.warn(this, tr("The world cannot be opened"), words_of(error));
    }
}

void WorldWindow::drive_through_drawn() {
    try {
        begin_driving(files_of_worlds_.file_as_drawn());
    } catch (const std::exception& error) {
        prompts_.warn(this, tr("The world cannot be driven through"), words_of(error));
    }
}

bool WorldWindow::begin_driving(const QString& path) {
    if (!guard_.may_leave()) return false;
    try {
        Configuracion configuration = session_.configuration();
        // What suits a log suits no world, and nothing was chosen for worlds yet.
        if (!is_world_file(configuration.source.file)) {
            configuration = suited_configuration(path.toStdString());
        }
        configuration.source = {};
        configuration.source.file = path.toStdString();
        say({});  // it was about an earlier tour
        panel_->begin(configuration);
        return true;
    } catch (const std::exception& error) {
        prompts_.warn(this, tr("The world cannot be driven through"), words_of(error));
        return false;
    }
}

/// What was driven is part of the world from now on, and can be undone.
void WorldWindow::go_on_with(const QString& path) {
    try {
        draft_.go_on_as(WorldText::read(path.toStdString()), path);
    } catch (const std::exception& error) {  // somebody has taken it away already
        prompts_.warn(this, tr("The world cannot be opened"), words_of(error));
    }
}

/// Here, and in the main window.
void WorldWindow::say(const QString& words) {
    said_->setText(words);
    said_->setToolTip(words);
    if (!words.isEmpty()) emit notice(words);
}

/// Whoever works on a world sees that one.
void WorldWindow::showEvent(QShowEvent* event) {
    const std::string& source = session_.configuration().source.file;
    if (draft_.untouched() && is_world_file(source)) {
        try {
            draft_.open(WorldText::read(source), QString::fromStdString(source));
        } catch (const std::exception&) {  // it is told where it is run
        }
    }
    QDialog::showEvent(event);
    view_->setFocus();
}

/// Who does not see the world does not drive through it.
void WorldWindow::hideEvent(QHideEvent* event) {
    panel_->rest();
    QDialog::hideEvent(event);
}

}  // namespace hitos::window
