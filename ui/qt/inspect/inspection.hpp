// The docks in which a run is looked at in numbers.
#pragma once

#include <QObject>

#include "app/docks.hpp"
#include "views/landmark_painter.hpp"
#include "views/layers.hpp"

namespace hitos::window {

class AssociationInspector;
class GridView;
class JointCovariance;
class LandmarkTable;
class ParticleTable;
class ResultActions;
class ScanView;
class Session;

/// Docks of tables. What is hidden asks for nothing and costs nothing.
class Inspection final : public QObject {
    Q_OBJECT

  public:
    Inspection(Session& session, const DockPlace& place);

    void connect_views(ScanView& scan, GridView& grid);
    void connect_results(ResultActions& results);
    void set_highlight(const hitos::window::PickedLandmark& picked);
    void set_layers(const LayerSet& layers);

  signals:
    void landmark_chosen(hitos::window::PickedLandmark landmark);

  private:
    Session& session_;
    LandmarkTable* landmarks_;
    ParticleTable* particles_;
    AssociationInspector* associations_;
    JointCovariance* joint_;
};

}  // namespace hitos::window
