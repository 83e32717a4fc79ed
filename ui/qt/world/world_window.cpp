#include "world_window.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "app/screen_fit.hpp"
#include "app/words_of.hpp"
#include "drive_panel.hpp"
#include "hitos/workbench/presets.hpp"
#include "hitos/workbench/shipped_data.hpp"
#include "world_view.hpp"

namespace hitos::window {
namespace {

constexpr QSize kWished(860, 640);

}  // namespace

WorldWindow::WorldWindow(Session& session, UserFiles& files, Prompts& prompts,
                         const RunGuard& guard, QWidget* parent)
    : QDialog(parent, Qt::Window),
      session_(session),
      files_(files),
      prompts_(prompts),
      guard_(guard) {
    setObjectName("world_window");
    setWindowTitle(tr("Drive a robot"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(make_tools());
    view_ = new WorldView(this);
    view_->setObjectName("world_view");
    column->addWidget(view_, 1);
    panel_ = new DrivePanel(session, files, prompts, *view_, this);
    column->addWidget(panel_);
    connect(panel_, &DrivePanel::notice, this, &WorldWindow::notice);
    connect(&drive(), &LiveDrive::changed, this, &WorldWindow::show_state);
    resize(kWished);
    fit_to_screen(*this);
    show_state();
}

LiveDrive& WorldWindow::drive() {
    return panel_->drive();
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
    row->addStretch(1);
    connect(worlds_, &QComboBox::activated, this, &WorldWindow::open_asked);
    return tools;
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
        panel_->begin(configuration);
    } catch (const std::exception& error) {
        prompts_.warn(this, tr("The world cannot be opened"), words_of(error));
    }
}

void WorldWindow::show_state() {
    worlds_->setItemText(0, drive().active() ? QString::fromStdString(drive().tour()->world().name)
                                             : tr("Choose a world…"));
    worlds_->setCurrentIndex(0);
}

/// Who does not see the world does not drive through it.
void WorldWindow::hideEvent(QHideEvent* event) {
    panel_->rest();
    QDialog::hideEvent(event);
}

}  // namespace hitos::window
