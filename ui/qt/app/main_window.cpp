// SPDX-License-Identifier: GPL-3.0-or-later
#include "main_window.hpp"

#include <QAbstractButton>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QShortcut>
#include <QTimer>
#include <utility>

#include "actions/configuration_actions.hpp"
#include "actions/file_menus.hpp"
#include "actions/result_actions.hpp"
#include "animation/animation_dialog.hpp"
#include "dialogs/run_until_dialog.hpp"
#include "dialogs/study_dialog.hpp"
#include "inspect/inspection.hpp"
#include "language.hpp"
#include "layouts.hpp"
#include "look/docks.hpp"
#include "look/icons.hpp"
#include "look/parameter_text.hpp"
#include "look/screen_fit.hpp"
#include "look/undo_keys.hpp"
#include "runs/run_keeper.hpp"
#include "runs/runs.hpp"
#include "status_line.hpp"
#include "ui_main_window.h"
#include "views/plots.hpp"
#include "views/view_panels.hpp"
#include "views/view_settings.hpp"
#include "workers/first_look.hpp"
#include "workers/log_counter.hpp"
#include "workers/reference_meter.hpp"
#include "world/world_window.hpp"

namespace hitos::window {
namespace {

/// The files of this computer among what is dragged.
QStringList files_of(const QMimeData& dragged) {
    QStringList files;
    for (const QUrl& url : dragged.urls()) {
        if (url.isLocalFile() && !url.toLocalFile().isEmpty()) files << url.toLocalFile();
    }
    return files;
}

}  // namespace

MainWindow::MainWindow(Session& session, UserFiles& files, Prompts& prompts)
    : ui_(std::make_unique<Ui::MainWindow>()),
      session_(session),
      files_(files),
      prompts_(prompts),
      guard_(session, prompts, this) {
    ui_->setupUi(this);
    setWindowIcon(icon(Glyph::application));
    make_parts();
    set_up_view_buttons();
    connect_configuration();
    connect_run();
    connect_views();
    connect_runs();
    connect_help();
    show_configuration();
    restore_state();
    ui_->scan_view->setFocus();
}

MainWindow::~MainWindow() = default;

ScanView& MainWindow::scan_view() const {
    return *ui_->scan_view;
}

GridView& MainWindow::grid_view() const {
    return *ui_->grid_view;
}

void MainWindow::make_parts() {
    configuration_ = new ConfigurationActions(session_, files_, prompts_, guard_, this);
    view_settings_ = new ViewSettings(files_, ui_->menu_layers, ui_->menu_theme, this);
    results_ = new ResultActions(session_, files_, prompts_, *view_settings_, this);
    meter_ = new ReferenceMeter(session_, this);
    status_ = new StatusLine(ui_->statusbar, session_);
    fill_languages(*ui_->menu_language, files_, *status_);
    counter_ = new LogCounter(session_, this);
    connect(configuration_, &ConfigurationActions::inspected, counter_, &LogCounter::know);
    connect(counter_, &LogCounter::counted, ui_->controls, &RunControls::set_total);
    connect(counter_, &LogCounter::timed, ui_->controls, &RunControls::set_duration);
    connect(counter_, &LogCounter::counted, status_, &StatusLine::set_total);
    connect(counter_, &LogCounter::counted, results_, &ResultActions::set_total);
    connect(counter_, &LogCounter::doubted, status_, &StatusLine::show_doubts);
    connect(counter_, &LogCounter::doubted, ui_->hint, &HintBar::show_doubts);
    first_look_ = new FirstLook(session_, this);
    plots_ = new Plots(session_, *meter_);
    keep_keys_off_tabs(*this);
    DockPlace place{this, nullptr, ui_->menu_view, ui_->menu_theme->menuAction()};
    dock_ = add_dock(place, plots_, tr("Plots"), "plots_dock", QKeySequence("Ctrl+G"));
    place.first = dock_;
    inspection_ = new Inspection(session_, place);
    runs_ = new Runs(session_, files_, prompts_, *view_settings_, place);
    keeper_ = new RunKeeper(session_, this);
    set_up_measuring(place);
    ui_->menu_view->insertSeparator(ui_->menu_theme->menuAction());
    ui_->views->setSizes({500, 500});
    panels_ = new ViewPanels(
        *ui_->views,
        {{{ui_->scan_panel, ui_->scan_panel_title, ui_->scan_view, ui_->scan_frame},
          {ui_->grid_panel, ui_->grid_panel_title, ui_->grid_view, ui_->grid_follow}}},
        ui_->action_alone, ui_->action_stacked);
    layouts_ = new Layouts(
        *this, *ui_->menu_layouts, {ui_->action_presenting, ui_->action_alone, ui_->action_summary},
        files_.settings(), prompts_, {[this] { save_layout(); }, [this] { restore_layout(); }});
    new UndoKeys(this);
    fit_to_screen(*this);
    name_what_runs();
}

void MainWindow::set_up_view_buttons() {
    struct Buttons {
        CanvasView* view;
        QToolButton* fit;
        QToolButton* in;
        QToolButton* out;
        QToolButton* picture;
    };
    for (const Buttons& b : {Buttons{ui_->scan_view, ui_->scan_fit, ui_->scan_zoom_in,
                                     ui_->scan_zoom_out, ui_->scan_picture},
                             Buttons{ui_->grid_view, ui_->grid_fit, ui_->grid_zoom_in,
                                     ui_->grid_zoom_out, ui_->grid_picture}}) {
        b.fit->setIcon(icon(Glyph::fit));
        b.in->setIcon(icon(Glyph::zoom_in));
        b.out->setIcon(icon(Glyph::zoom_out));
        b.picture->setIcon(icon(Glyph::picture));
        connect(b.fit, &QToolButton::clicked, b.view, &CanvasView::fit);
        connect(b.in, &QToolButton::clicked, b.view, [view = b.view] { view->zoom(1.25); });
        connect(b.out, &QToolButton::clicked, b.view, [view = b.view] { view->zoom(0.8); });
        connect(b.picture, &QToolButton::clicked, b.view, &CanvasView::picture_wanted);
    }
    ui_->action_world_frame->setIcon(icon(Glyph::frame));
    ui_->action_follow->setIcon(icon(Glyph::follow));
    ui_->scan_frame->setDefaultAction(ui_->action_world_frame);
    ui_->grid_follow->setDefaultAction(ui_->action_follow);
}

void MainWindow::connect_configuration() {
    connect(ui_->action_select_source, &QAction::triggered, configuration_,
            [this] { configuration_->select_source(); });
    connect(ui_->action_go_on, &QAction::triggered, configuration_, &ConfigurationActions::go_on);
    connect(ui_->action_manual, &QAction::triggered, configuration_,
            &ConfigurationActions::configure);
    new FileMenus(files_, *configuration_, *ui_->menu_recent, *ui_->menu_presets,
                  *ui_->action_save_preset, this);
    connect(ui_->action_save_preset, &QAction::triggered, configuration_,
            &ConfigurationActions::save_preset);
    connect(ui_->action_undo, &QAction::triggered, configuration_, &ConfigurationActions::undo);
    connect(ui_->action_redo, &QAction::triggered, configuration_, &ConfigurationActions::redo);
    const auto enable_history = [this] {
        const auto offer = [](QAction& action, const QString& name, const QString& to,
                              const QString& words) {
            action.setEnabled(!words.isEmpty());
            action.setText(words.isEmpty() ? name : to.arg(QString(words).replace('&', "&&")));
        };
        offer(*ui_->action_undo, tr("Undo"), tr("Undo, back to: %1"), configuration_->undo_words());
        offer(*ui_->action_redo, tr("Redo"), tr("Redo, on to: %1"), configuration_->redo_words());
    };
    connect(configuration_, &ConfigurationActions::history_changed, this, enable_history);
    enable_history();
    connect(ui_->action_load, &QAction::triggered, configuration_, &ConfigurationActions::load);
    connect(ui_->action_save, &QAction::triggered, configuration_, &ConfigurationActions::save);
    connect(ui_->action_set_default, &QAction::triggered, configuration_,
            &ConfigurationActions::set_default);
    connect(ui_->action_reference_map, &QAction::triggered, configuration_,
            &ConfigurationActions::load_reference_map);
    connect(ui_->action_reference_trajectory, &QAction::triggered, configuration_,
            &ConfigurationActions::load_reference_trajectory);
    connect(ui_->action_remove_references, &QAction::triggered, configuration_,
            &ConfigurationActions::remove_references);
    const auto enable_remove = [this] {
        ui_->action_remove_references->setEnabled(configuration_->has_references());
    };
    connect(&session_, &Session::references_changed, this, enable_remove);
    enable_remove();
    connect(ui_->summary, &SummaryBar::group_clicked, configuration_,
            &ConfigurationActions::configure_group);
    connect(configuration_, &ConfigurationActions::notice, status_, &StatusLine::notice);
    ui_->hint->set_session(session_);
    connect(ui_->hint, &HintBar::preset_wanted, configuration_, [this](const std::string& preset) {
        if (guard_.may_discard()) configuration_->use_preset(preset, true);
    });
    connect(&session_, &Session::configuration_changed, this, &MainWindow::show_configuration);
}

void MainWindow::connect_run() {
    ui_->controls->set_up(
        {ui_->action_run, ui_->action_stop, ui_->action_step, ui_->action_best_map,
         ui_->action_odometry, ui_->action_save_map, ui_->action_restart, ui_->action_full_speed,
         ui_->action_previous_event, ui_->action_next_event},
        session_, files_.settings());
    // The space bar runs and stops, unless a button has the focus; an action that is disabled would
    // swallow it.
    ui_->action_run->setShortcut({});
    auto* space = new QShortcut(QKeySequence(Qt::Key_Space), this);
    connect(space, &QShortcut::activated, this, [this] {
        if (auto* button = qobject_cast<QAbstractButton*>(QApplication::focusWidget())) {
            button->click();  // as everywhere
            return;
        }
        (ui_->action_stop->isEnabled() ? ui_->action_stop : ui_->action_run)->trigger();
    });
    connect(ui_->action_run_until, &QAction::triggered, this,
            [this] { RunUntilDialog(session_, files_.settings(), this).exec(); });
    connect(&session_, &Session::failed, this, [this](const QString& reason) {
        prompts_.warn(this, tr("The run has failed"), reason);
    });
    connect(ui_->action_restart, &QAction::triggered, this, [this] {
        if (guard_.may_discard()) session_.restart();
    });
    connect(ui_->action_best_map, &QAction::triggered, results_, &ResultActions::view_best);
    connect(ui_->action_particle_map, &QAction::triggered, results_, &ResultActions::view_particle);
    connect(ui_->action_odometry, &QAction::triggered, results_, &ResultActions::view_odometry);
    connect(ui_->action_save_map, &QAction::triggered, results_, &ResultActions::save_map);
    connect(ui_->action_save_results, &QAction::triggered, results_, &ResultActions::save_results);
    connect(ui_->action_save_figures, &QAction::triggered, results_, &ResultActions::save_figures);
    connect(plots_, &Plots::table_wanted, results_, &ResultActions::save_figures);
    connect(ui_->action_study, &QAction::triggered, this, [this] { open_study(); });
    connect(ui_->action_save_picture, &QAction::triggered, this, [this] {
        if (plots_->hasFocus()) {
            emit plots_->picture_wanted();
        } else {
            emit view_in_use().picture_wanted();
        }
    });
    connect(ui_->action_copy_picture, &QAction::triggered, this, [this] {
        if (plots_->hasFocus()) {
            plots_->copy_picture();
        } else {
            view_in_use().copy_picture();
        }
        status_->notice(tr("The picture is in the clipboard."));
    });
    connect(ui_->action_save_animation, &QAction::triggered, this, [this] {
        save_animation(session_, results_->total(), files_, prompts_, *ui_->scan_view,
                       *ui_->grid_view, this,
                       [this](const QString& words) { status_->notice(words); });
    });
    connect(ui_->action_exit, &QAction::triggered, this, &QWidget::close);
    connect(results_, &ResultActions::notice, status_, &StatusLine::notice);
    connect(results_, &ResultActions::busy, status_, &StatusLine::lasting);
    connect(results_, &ResultActions::written, this, [this](bool good) {
        if (std::exchange(close_when_written_, false) && good) close();
    });
    connect(status_, &StatusLine::skipped_wanted, results_, &ResultActions::list_skipped);
    // The keys of the run go there too.
    connect(results_, &ResultActions::opened, this,
            [this](QWidget* map) { map->addActions(ui_->menu_run->actions()); });
    const auto enable = [this] {
        const bool driven = session_.live_tour() != nullptr;
        // What was driven and not kept has no file that the results could name.
        ui_->action_save_results->setEnabled(session_.progress().steps > 0 && !driven &&
                                             !results_->writing());
        ui_->action_save_figures->setEnabled(session_.progress().steps > 0);
        ui_->action_save_animation->setEnabled(session_.progress().steps > 0);
        ui_->action_particle_map->setEnabled(session_.progress().steps > 0);
        const bool whole = session_.has_source() && !driven && !session_.is_live();
        ui_->action_study->setEnabled(whole);
        ui_->action_run_until->setEnabled(whole);
    };
    connect(&session_, &Session::progress_changed, this, enable);
    connect(results_, &ResultActions::writing_changed, this, enable);
    enable();
}

void MainWindow::offer_start() {
    if (files_.has_init() || !files_.recent().isEmpty()) return;
    ui_->start->offer(*ui_->action_run, *ui_->action_select_source, *ui_->action_drive);
    connect(&session_, &Session::configuration_changed, ui_->start, &QWidget::hide);
    connect(&session_, &Session::progress_changed, ui_->start, [this] {
        if (session_.progress().steps > 0) ui_->start->hide();
    });
}

void MainWindow::connect_views() {
    // While it runs one view after the other, so that a key press waits for one picture and not for
    // two.
    const auto shown = [this] {
        return session_.snapshot() ? session_.snapshot() : first_look_->snapshot();
    };
    const auto show_grid = [this, shown] { ui_->grid_view->set_snapshot(shown()); };
    const auto show_snapshot = [this, shown, show_grid] {
        ui_->scan_view->set_snapshot(shown());
        const bool before = !session_.snapshot() && first_look_->snapshot();
        ui_->scan_panel_title->setText(!before ? tr("Last scan")
                                       : first_look_->is_newest()
                                           ? tr("Newest scan, before the run")
                                           : tr("First scan, before the run"));
        grid_waits_ =
            session_.progress().state == Progress::State::running && ui_->scan_view->isVisible();
        if (!grid_waits_) show_grid();
    };
    connect(&session_, &Session::snapshot_changed, this, show_snapshot);
    connect(first_look_, &FirstLook::changed, this, show_snapshot);
    connect(ui_->scan_view, &CanvasView::painted, this, [this, show_grid] {
        if (std::exchange(grid_waits_, false)) QTimer::singleShot(0, ui_->grid_view, show_grid);
    });
    for (CanvasView* view :
         {static_cast<CanvasView*>(ui_->scan_view), static_cast<CanvasView*>(ui_->grid_view)}) {
        connect(view, &CanvasView::painted, &session_, &Session::note_cost);
        connect(view, &CanvasView::hovered_at, status_, &StatusLine::show_place);
        connect(view, &CanvasView::left, status_, &StatusLine::clear_place);
        connect(view, &CanvasView::picture_wanted, results_,
                [this, view] { results_->save_figure(view->exportable()); });
    }
    connect(inspection_, &Inspection::landmark_chosen, this, &MainWindow::set_highlight);
    inspection_->connect_views(*ui_->scan_view, *ui_->grid_view);
    connect(inspection_, &Inspection::grid_wanted, results_, &ResultActions::view_grid_of);
    connect(inspection_, &Inspection::map_wanted, results_, &ResultActions::save_map_of);
    connect(inspection_, &Inspection::path_wanted, results_, &ResultActions::save_path_of);
    connect(inspection_, &Inspection::picture_wanted, results_, &ResultActions::save_figure);
    connect(inspection_, &Inspection::edits_wanted, configuration_,
            [this](const QString& edits) { configuration_->use_edits(edits.toStdString()); });
    connect(inspection_, &Inspection::drawing_wanted, this, [this] {
        const QString path = prompts_.open_file(
            this, {tr("Drawing to anchor to"),
                   files_.folder_to_open("world"),
                   tr("All of them (*.dxf *.toml *.map *.txt);;Drawings (*.dxf);;"
                      "Worlds (*.toml);;Maps and segments (*.map *.txt)"),
                   {}});
        if (path.isEmpty()) return;
        files_.note_opened("world", path);
        inspection_->open_drawing(path);
    });
    connect(view_settings_, &ViewSettings::layers_changed, inspection_, &Inspection::set_layers);
    inspection_->set_layers(view_settings_->layers());
    connect(&session_, &Session::restarted, this, [this] { set_highlight({}); });
    connect(view_settings_, &ViewSettings::layers_changed, ui_->scan_view, &ScanView::set_layers);
    connect(view_settings_, &ViewSettings::layers_changed, ui_->grid_view, &GridView::set_layers);
    connect(view_settings_, &ViewSettings::theme_changed, this, &MainWindow::restyle);
    ui_->scan_view->set_layers(view_settings_->layers());
    ui_->grid_view->set_layers(view_settings_->layers());
    connect(ui_->action_world_frame, &QAction::toggled, ui_->scan_view,
            [this](bool on) { ui_->scan_view->set_robot_frame(!on); });
    connect(ui_->action_world_frame, &QAction::toggled, ui_->scan_legend, &Legend::set_world_frame);
    ui_->scan_legend->set_world_frame(ui_->action_world_frame->isChecked());
    ui_->scan_legend->set_up(*view_settings_, Legend::Of::scan);
    ui_->grid_legend->set_up(*view_settings_, Legend::Of::grid);
    connect(ui_->action_legend, &QAction::toggled, ui_->scan_legend, &QWidget::setVisible);
    connect(ui_->action_legend, &QAction::toggled, ui_->grid_legend, &QWidget::setVisible);
    connect(ui_->action_summary, &QAction::toggled, ui_->summary, &QWidget::setVisible);
    connect(ui_->action_follow, &QAction::toggled, ui_->grid_view, &CanvasView::set_follow);
    connect(ui_->grid_view, &CanvasView::follow_changed, ui_->action_follow, &QAction::setChecked);
    connect(plots_, &Plots::picture_wanted, results_,
            [this] { results_->save_figure(plots_->exportable()); });
    connect(&session_, &Session::references_changed, ui_->grid_view, [this] {
        ui_->grid_view->set_reference_map(session_.references().map);
        ui_->grid_view->set_reference_path({});
        status_->show_reference_doubts({});
    });
    connect(meter_, &ReferenceMeter::measured, ui_->grid_view,
            [this](const std::shared_ptr<const Measured>& figures) {
                ui_->grid_view->set_reference_path(figures->reference_world);
                status_->show_reference_doubts(figures->doubts);
            });
    show_snapshot();
}

void MainWindow::set_highlight(const PickedLandmark& picked) {
    ui_->scan_view->set_highlight(picked);
    ui_->grid_view->set_highlight(picked);
    inspection_->set_highlight(picked);
}

CanvasView& MainWindow::view_in_use() const {
    if (ui_->scan_view->hasFocus()) return *ui_->scan_view;
    return *ui_->grid_view;
}

void MainWindow::restyle() {
    show_configuration();
    plots_->restyle();
    if (study_ != nullptr) study_->restyle();
    update();
}

void MainWindow::show_configuration() {
    const Configuracion& configuration = session_.configuration();
    ui_->summary->set_configuration(configuration);
    const QString file = QFileInfo(QString::fromStdString(configuration.source.file)).fileName();
    setWindowTitle(file.isEmpty() ? QStringLiteral("Hitos") : file + " – Hitos");
    // The place that was looked at is of another tour.
    if (std::exchange(file_in_views_, configuration.source.file) != configuration.source.file) {
        for (CanvasView* view :
             {static_cast<CanvasView*>(ui_->scan_view), static_cast<CanvasView*>(ui_->grid_view)})
            if (!view->follows()) view->fit();
    }
    name_what_runs();
}

/// Only where there are particles one of them is the best.
void MainWindow::name_what_runs() {
    const bool particles = has_particles(session_.configuration());
    const QString algorithm = algorithm_of(session_.configuration());
    ui_->action_best_map->setText(particles ? tr("View best particle") : tr("View map"));
    ui_->action_best_map->setToolTip(particles ? tr("Grid map of the best particle (B)")
                                               : tr("Grid map by %1 (B)").arg(algorithm));
    ui_->action_save_map->setText(particles ? tr("Save best particle's map") : tr("Save map"));
    ui_->action_particle_map->setVisible(particles);
    view_settings_->set_particles(particles);
}

/// Where the window is small its room is the views'.
void MainWindow::resizeEvent(QResizeEvent* event) {
    constexpr int kLow = 820;
    ui_->summary->set_folded(height() < kLow);
    QMainWindow::resizeEvent(event);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!may_close_now()) {
        event->ignore();
        return;
    }
    if (study_ != nullptr && !study_->may_end()) {
        event->ignore();
        return;
    }
    if (!graphs_may_end() || !guard_.may_leave() || (world_ != nullptr && !world_->may_end())) {
        event->ignore();
        return;
    }
    leave();
    event->accept();
}

void MainWindow::leave() {
    session_.pause();
    save_state();
}

void MainWindow::save_state() {
    layouts_->end_presenting();
    files_.settings().setValue("window/geometry", saveGeometry());
    save_layout();
}

void MainWindow::save_layout() {
    QSettings& settings = files_.settings();
    settings.setValue("window/state", save_docks(*this));
    panels_->save(settings);
    settings.setValue("window/world_frame", ui_->action_world_frame->isChecked());
    settings.setValue("window/summary", ui_->action_summary->isChecked());
    settings.setValue("window/legend", ui_->action_legend->isChecked());
}

void MainWindow::restore_state() {
    const QSettings& settings = files_.settings();
    if (restoreGeometry(settings.value("window/geometry").toByteArray())) keep_on_screen(*this);
    restore_layout();
}

void MainWindow::restore_layout() {
    const QSettings& settings = files_.settings();
    restore_docks(*this, settings.value("window/state").toByteArray());
    panels_->restore(settings);
    ui_->action_world_frame->setChecked(settings.value("window/world_frame", false).toBool());
    ui_->action_summary->setChecked(settings.value("window/summary", true).toBool());
    ui_->action_legend->setChecked(settings.value("window/legend", true).toBool());
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!files_of(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QStringList paths = files_of(*event->mimeData());
    if (paths.isEmpty()) return;
    event->acceptProposedAction();
    // Not at once: where it came from waits for the end of the drop, and a question may follow.
    QTimer::singleShot(0, configuration_, [this, paths] { configuration_->open_all(paths); });
}

}  // namespace hitos::window
