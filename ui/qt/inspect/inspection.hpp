// The docks in which a run is looked at in numbers.
#pragma once

#include <QKeySequence>
#include <QObject>

#include "views/landmark_painter.hpp"
#include "views/layers.hpp"

class QAction;
class QDockWidget;
class QMainWindow;
class QMenu;

namespace hitos::window {

class AssociationInspector;
class GridView;
class LandmarkTable;
class ParticleTable;
class ResultActions;
class ScanView;
class Session;

/// Tabbed with the first dock, below the views, for tables are wide; hidden at first. What is
/// hidden asks for nothing and costs nothing.
class Inspection final : public QObject {
    Q_OBJECT

  public:
    /// The switches of the docks are put into the menu before `before`.
    Inspection(Session& session, QMainWindow* window, QDockWidget* first, QMenu* menu,
               QAction* before);

    void connect_views(ScanView& scan, GridView& grid);
    void connect_results(ResultActions& results);
    void set_highlight(const hitos::window::PickedLandmark& picked);
    void set_layers(const LayerSet& layers);

  signals:
    void landmark_chosen(hitos::window::PickedLandmark landmark);

  private:
    void add_dock(QWidget* widget, const QString& title, const char* name, const QKeySequence& key);

    Session& session_;
    QMainWindow* window_;
    QMenu* menu_;
    QAction* before_;
    QDockWidget* first_;
    LandmarkTable* landmarks_;
    ParticleTable* particles_;
    AssociationInspector* associations_;
};

}  // namespace hitos::window
