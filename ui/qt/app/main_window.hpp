// SPDX-License-Identifier: GPL-3.0-or-later
// The program's window: puts the parts together and connects them, and nothing else.
#pragma once

#include <QMainWindow>
#include <memory>

#include "look/prompts.hpp"
#include "look/user_files.hpp"
#include "session/run_guard.hpp"
#include "session/session.hpp"

class QDockWidget;

namespace hitos::window {

class CanvasView;
class ConfigurationActions;
class ConnectDialog;
class Connection;
class FirstLook;
class GraphWindow;
class GridView;
class Inspection;
class Layouts;
class LogCounter;
class MeasureTool;
class MeasurementTable;
class Measurements;
struct DockPlace;
struct PickedLandmark;
class Plots;
class ReferenceMeter;
class ResultActions;
class RunKeeper;
class Runs;
class ScanView;
class StatusLine;
class StudyDialog;
class ViewPanels;
class ViewSettings;
class WorldWindow;
namespace Ui {
class MainWindow;
}

class MainWindow final : public QMainWindow {
    Q_OBJECT

  public:
    MainWindow(Session& session, UserFiles& files, Prompts& prompts);
    ~MainWindow() override;

    Session& session() const { return session_; }
    ConfigurationActions& configuration_actions() { return *configuration_; }
    ResultActions& result_actions() { return *results_; }
    RunGuard& run_guard() { return guard_; }
    ScanView& scan_view() const;
    GridView& grid_view() const;
    Runs& runs() const { return *runs_; }
    RunKeeper& run_keeper() const { return *keeper_; }
    /// Tells of runs that windows have left which were ended from outside, and shows them.
    void tell_left_runs();
    Measurements& measurements() const { return *measurements_; }
    /// Adds a file's distances to what is measured, and shows the table.
    void open_distances(const QString& path);
    Plots& plots() const { return *plots_; }
    QDockWidget& plots_dock() const { return *dock_; }
    /// Offers ways to begin to who has neither settings nor recent files.
    void offer_start();
    /// Shows the study of parameters.
    StudyDialog& open_study();
    /// Shows the world to drive a robot through.
    WorldWindow& open_world_window();
    /// Shows how a robot is connected, or can be.
    ConnectDialog& open_connection();
    /// Opens a graph of poses in a window of its own.
    GraphWindow& open_graph(const QString& path);
    /// What closing does: the run pauses, the layout is remembered.
    void leave();
    /// Null until it was opened.
    StudyDialog* study() const { return study_; }

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void make_parts();
    void connect_configuration();
    void connect_run();
    void connect_views();
    void connect_help();
    void set_up_measuring(const DockPlace& place);
    void set_up_view_buttons();
    void connect_runs();
    /// In front, with the keyboard.
    void come_forward();
    void show_configuration();
    void name_what_runs();
    void set_highlight(const PickedLandmark& picked);
    /// The one with the keyboard, else the grid map.
    CanvasView& view_in_use() const;
    bool may_close_now();
    void ask_for_graph();
    bool graphs_may_end() const;
    void restyle();
    void save_state();
    void save_layout();
    void restore_layout();
    void restore_state();
    void show_about();
    void show_keys();

    std::unique_ptr<Ui::MainWindow> ui_;
    Session& session_;
    UserFiles& files_;
    Prompts& prompts_;
    RunGuard guard_;
    ConfigurationActions* configuration_ = nullptr;
    ResultActions* results_ = nullptr;
    Layouts* layouts_ = nullptr;
    ViewPanels* panels_ = nullptr;
    ViewSettings* view_settings_ = nullptr;
    ReferenceMeter* meter_ = nullptr;
    LogCounter* counter_ = nullptr;
    FirstLook* first_look_ = nullptr;
    StatusLine* status_ = nullptr;
    Plots* plots_ = nullptr;
    QDockWidget* dock_ = nullptr;
    Inspection* inspection_ = nullptr;
    Runs* runs_ = nullptr;
    RunKeeper* keeper_ = nullptr;
    MeasureTool* measure_ = nullptr;
    Measurements* measurements_ = nullptr;
    MeasurementTable* measurement_table_ = nullptr;
    StudyDialog* study_ = nullptr;
    Connection* connection_ = nullptr;
    ConnectDialog* connect_ = nullptr;
    WorldWindow* world_ = nullptr;
    std::string file_in_views_;  ///< the log whose tour they show
    bool close_when_written_ = false;
    bool grid_waits_ = false;  ///< for the other view to be painted
};

}  // namespace hitos::window
