// The Help menu.

#include <QDesktopServices>
#include <QMessageBox>
#include <QUrl>

#include "hitos/services/run/results.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "icons.hpp"
#include "main_window.hpp"
#include "ui_main_window.h"

namespace hitos::window {
namespace {

/// A window that the user closes when it pleases; the run goes on meanwhile.
void show_text(QWidget* parent, const char* name, const QString& title, const QString& text) {
    auto* box = new QMessageBox(QMessageBox::NoIcon, title, text, QMessageBox::Close, parent);
    box->setObjectName(name);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setTextFormat(Qt::RichText);
    box->setIconPixmap(icon(Glyph::application).pixmap(64, 64));
    box->setModal(false);
    box->show();
}

}  // namespace

void MainWindow::connect_help() {
    connect(ui_->action_about, &QAction::triggered, this, &MainWindow::show_about);
    connect(ui_->action_keys, &QAction::triggered, this, &MainWindow::show_keys);
    connect(ui_->action_guide, &QAction::triggered, this, &MainWindow::show_guide);
}

void MainWindow::show_about() {
    show_text(
        this, "about", tr("About Hitos"),
        "<h3>Hitos " + QString::fromStdString(version()) + "</h3><p>" +
            tr("A workbench for landmark SLAM on recorded laser tours: FastSLAM step by step, "
               "with every parameter at hand.") +
            "</p><p>" + tr("Free software under the GNU GPL, version 3 or later.") + "</p>");
}

void MainWindow::show_keys() {
    const QList<QPair<QString, QString>> keys{
        {tr("Space"), tr("run or stop")},
        {tr("Right arrow"), tr("one step")},
        {"Ctrl+U", tr("run until something happens")},
        {tr("Ctrl+Space"), tr("as fast as possible, or at the pace chosen")},
        {"Ctrl+R", tr("restart")},
        {"B, O", tr("map of the best particle, of the odometry")},
        {"Ctrl+Shift+S", tr("save the best particle's map")},
        {"Ctrl+P", tr("save the view in use as an image")},
        {"Ctrl+O, Ctrl+M", tr("data source, parameters")},
        {"Ctrl+L, Ctrl+S", tr("load, save the configuration")},
        {"Ctrl+Z, Ctrl+Shift+Z", tr("undo, redo a change of the configuration")},
        {"Ctrl+H", tr("configuration at a glance")},
        {"Ctrl+G", tr("plots")},
        {"Ctrl+E", tr("study of one parameter")},
        {"Ctrl+T, Ctrl+F", tr("world frame, follow the robot")},
        {"Alt+1 … Alt+9", tr("layers")},
        {"+, −, F, WASD", tr("zoom, fit and move the view in use")}};
    QString table = "<table cellspacing='6'>";
    const qsizetype rows = (keys.size() + 1) / 2;  // two columns, for small screens
    for (qsizetype row = 0; row < rows; ++row) {
        table += "<tr>";
        for (const auto& [key, meaning] : {keys.value(row), keys.value(row + rows)})
            table += "<td><b>" + key + "</b>&nbsp;</td><td>" + meaning + "&nbsp;&nbsp;</td>";
        table += "</tr>";
    }
    show_text(this, "keys", tr("Keyboard"), table + "</table>");
}

void MainWindow::show_guide() {
    const QString guide = QString::fromStdString(shipped_file("docs/user-guide.md").string());
    if (guide.isEmpty()) {
        prompts_.warn(this, tr("User's guide"), tr("docs/user-guide.md is not installed."));
        return;
    }
    QDesktopServices::openUrl(QUrl::fromLocalFile(guide));
}

}  // namespace hitos::window
