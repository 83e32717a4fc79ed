// SPDX-License-Identifier: GPL-3.0-or-later
#include "start_bar.hpp"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "look/named.hpp"

namespace hitos::window {

StartBar::StartBar(QWidget* parent) : QFrame(parent), row_(new QHBoxLayout(this)) {
    setProperty("role", "card");
    row_->setContentsMargins(12, 8, 8, 8);
    row_->setSpacing(12);
    hide();
}

void StartBar::offer(QAction& run, QAction& open, QAction& draw) {
    add(tr("Run the ready tour"), tr("A simulated robot with noisy odometry, open below (Space)"),
        run, "start_run");
    add(tr("Open a log of mine…"), tr("Player, CARMEN, ROS bag or MCAP, text (Ctrl+O)"), open,
        "start_open");
    add(tr("Draw a world"), tr("Walls by hand, and a robot driven through them (Ctrl+D)"), draw,
        "start_draw");
    auto* close = named(new QPushButton(tr("Close")), "start_close");
    close->setFocusPolicy(Qt::TabFocus);
    connect(close, &QPushButton::clicked, this, &QWidget::hide);
    row_->addWidget(close, 0, Qt::AlignTop);
    show();
}

void StartBar::add(const QString& title, const QString& what, QAction& action, const char* name) {
    auto* column = new QVBoxLayout;
    column->setSpacing(2);
    auto* button = named(new QPushButton(title), name);
    button->setFocusPolicy(Qt::TabFocus);
    auto* words = new QLabel(what);
    words->setProperty("role", "muted");
    words->setWordWrap(true);
    column->addWidget(button);
    column->addWidget(words);
    row_->addLayout(column, 1);
    connect(button, &QPushButton::clicked, &action, &QAction::trigger);
    connect(&action, &QAction::triggered, this, &QWidget::hide);
}

}  // namespace hitos::window
