// SPDX-License-Identifier: GPL-3.0-or-later
// The docks in which a run is looked at in numbers.
#pragma once

#include <QObject>

#include "look/docks.hpp"
#include "views/figure.hpp"
#include "views/landmark_painter.hpp"
#include "views/layers.hpp"

namespace hitos::window {

class AssociationInspector;
class GridView;
class JointCovariance;
class LandmarkTable;
class LoopTable;
class ParticleTable;
class ScanView;
class Session;

/// Docks of tables. What is hidden asks for nothing and costs nothing.
class Inspection final : public QObject {
    Q_OBJECT

  public:
    Inspection(Session& session, const DockPlace& place);

    void connect_views(ScanView& scan, GridView& grid);
    void set_highlight(const hitos::window::PickedLandmark& picked);
    void set_layers(const LayerSet& layers);
    void open_drawing(const QString& path);

  signals:
    void landmark_chosen(hitos::window::PickedLandmark landmark);
    void grid_wanted(int particle);
    void map_wanted(int particle);
    void path_wanted(int particle);
    void edits_wanted(QString edits);
    /// For open_drawing().
    void drawing_wanted();
    void picture_wanted(const hitos::window::Exportable& figure);

  private:
    Session& session_;
    LandmarkTable* landmarks_;
    ParticleTable* particles_;
    AssociationInspector* associations_;
    JointCovariance* joint_;
    LoopTable* loops_;
};

}  // namespace hitos::window
