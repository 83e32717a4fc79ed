// SPDX-License-Identifier: GPL-3.0-or-later
// The Help menu.

#include <QDialog>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QKeySequence>
#include <QLabel>
#include <QStringList>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <algorithm>

#include "help_guide.hpp"
#include "hitos/services/results/results.hpp"
#include "lesson_guide.hpp"
#include "look/icons.hpp"
#include "look/named.hpp"
#include "look/screen_fit.hpp"
#include "main_window.hpp"
#include "ui_main_window.h"

namespace hitos::window {
namespace {

/// A window that the user closes when it pleases; the run goes on meanwhile. What is longer than
/// the screen scrolls.
void show_text(QWidget* parent, const char* name, const QString& title, const QString& html) {
    auto* dialog = named(new QDialog(parent), name);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    auto* column = new QVBoxLayout(dialog);
    auto* row = new QHBoxLayout;
    column->addLayout(row);
    auto* picture = new QLabel;
    picture->setPixmap(icon(Glyph::application).pixmap(64, 64));
    row->addWidget(picture, 0, Qt::AlignTop);
    auto* text = new QTextBrowser;
    text->setFrameShape(QFrame::NoFrame);
    text->setHtml(html);
    constexpr double kWidest = 640.0;
    QTextDocument& document = *text->document();
    document.setTextWidth(std::min(document.idealWidth(), kWidest));
    row->addWidget(text);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
    column->addWidget(buttons);
    constexpr QSize kAround(140, 80);  // picture, margins and button
    dialog->resize(document.size().toSize() + kAround);
    fit_to_screen(*dialog);
    dialog->show();
}

/// Keys with commas between, by the names that menus have for them.
QString as_in_menus(const QString& keys) {
    QStringList names;
    for (const QString& key : keys.split(", ")) {
        const QString name = QKeySequence::fromString(key, QKeySequence::PortableText)
                                 .toString(QKeySequence::NativeText);
        names << (name.isEmpty() ? key : name);
    }
    return names.join(", ");
}

}  // namespace

void MainWindow::connect_help() {
    connect(ui_->action_about, &QAction::triggered, this, &MainWindow::show_about);
    connect(ui_->action_keys, &QAction::triggered, this, &MainWindow::show_keys);
    auto* guide = new HelpGuide(*this, files_, prompts_);
    connect(ui_->action_guide, &QAction::triggered, guide, [guide] { guide->open({}); });
    connect(ui_->action_explain, &QAction::triggered, guide, &HelpGuide::explain);
    new LessonGuide(*this, *ui_->menu_help, ui_->action_keys, *configuration_, guard_, prompts_);
}

void MainWindow::show_about() {
    show_text(
        this, "about", tr("About Hitos"),
        "<h3>Hitos " + QString::fromStdString(version()) + "</h3><p>" +
            tr("A workbench for landmark SLAM on recorded laser tours: FastSLAM, EKF-SLAM and "
               "graph-SLAM step by step, "
               "with every parameter at hand.") +
            "</p><p>" + tr("Free software under the GNU GPL, version 3 or later.") + "</p>");
}

void MainWindow::show_keys() {
    const QList<QPair<QString, QString>> keys{
        {"Space", tr("run or stop")},
        {"Right", tr("one step")},
        {"Ctrl+Left, Ctrl+Right", tr("to the event before, to the next (time line)")},
        {"Ctrl+U", tr("run until something happens")},
        {"Ctrl+Space", tr("as fast as possible, or at the pace chosen")},
        {"Ctrl+R", tr("restart")},
        {"B, P, O", tr("map as estimated, of one particle, as by the odometry")},
        {"Ctrl+Shift+S, Ctrl+Shift+R", tr("save the map, all results")},
        {"Ctrl+P, Ctrl+C", tr("save the view in use as an image, copy it")},
        {"Ctrl+O, Ctrl+M", tr("data source, parameters")},
        {"Ctrl+Shift+N", tr("map what a running robot sees")},
        {"Ctrl+D", tr("draw a world, drive a robot through it")},
        {"Ctrl+L, Ctrl+S", tr("load, save the configuration")},
        {"Ctrl+Z, Ctrl+Shift+Z", tr("undo, redo a change of the configuration")},
        {"Ctrl+H", tr("configuration at a glance")},
        {"F11, Shift+F11", tr("one view alone, one above the other")},
        {"Ctrl+F11", tr("presenter mode, for a classroom")},
        {"Ctrl+G", tr("plots")},
        {"Ctrl+Shift+L, Ctrl+Shift+P", tr("tables of landmarks and particles")},
        {"Ctrl+Shift+A, Ctrl+Shift+J", tr("why features were associated, joint covariance")},
        {"Ctrl+Shift+O", tr("loops: closed, refused, changed by hand")},
        {"M, Shift+M", tr("measure a distance, an angle")},
        {"Ctrl+Shift+M", tr("what was measured")},
        {"Ctrl+K, Ctrl+Shift+K", tr("compare runs, the list of runs")},
        {"Ctrl+E", tr("study of parameters")},
        {"Ctrl+T, Ctrl+F", tr("world frame, follow the robot")},
        {"Alt+1 … Alt+9", tr("layers")},
        {"+, −, F, WASD", tr("zoom, fit and move the view in use")},
        {"F1, Shift+F1", tr("explain what has the keyboard, list the keys")},
        {"Ctrl+Q", tr("quit")}};
    QString table = "<table cellspacing='6'>";
    for (const auto& [key, meaning] : keys)
        table +=
            "<tr><td><b>" + as_in_menus(key) + "</b>&nbsp;&nbsp;</td><td>" + meaning + "</td></tr>";
    show_text(this, "keys", tr("Keyboard"), table + "</table>");
}

}  // namespace hitos::window
