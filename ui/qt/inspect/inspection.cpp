// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspection.hpp"

#include <QAction>
#include <QDockWidget>

#include "association_inspector.hpp"
#include "joint_covariance.hpp"
#include "landmark_table.hpp"
#include "loop_table.hpp"
#include "loop_view.hpp"
#include "particle_table.hpp"
#include "views/grid_view.hpp"
#include "views/scan_view.hpp"

namespace hitos::window {

Inspection::Inspection(Session& session, const DockPlace& place)
    : QObject(place.window),
      session_(session),
      landmarks_(new LandmarkTable(session, place.window)),
      particles_(new ParticleTable(session, place.window)),
      associations_(new AssociationInspector(session, place.window)),
      joint_(new JointCovariance(session, place.window)),
      loops_(new LoopTable(session, place.window)) {
    add_dock(place, landmarks_, tr("Landmarks"), "landmarks_dock", QKeySequence("Ctrl+Shift+L"));
    add_dock(place, particles_, tr("Particles"), "particles_dock", QKeySequence("Ctrl+Shift+P"));
    add_dock(place, associations_, tr("Associations"), "associations_dock",
             QKeySequence("Ctrl+Shift+A"));
    add_dock(place, joint_, tr("Joint covariance"), "joint_dock", QKeySequence("Ctrl+Shift+J"));
    auto* loops_dock =
        add_dock(place, loops_, tr("Loops"), "loops_dock", QKeySequence("Ctrl+Shift+O"));
    const auto take_keys = [this](bool shown) {
        if (shown) loops_->take_keys();
    };
    connect(loops_dock->toggleViewAction(), &QAction::triggered, loops_, take_keys,
            Qt::QueuedConnection);  // once it is in sight
    connect(landmarks_, &LandmarkTable::landmark_chosen, this, &Inspection::landmark_chosen);
    connect(associations_, &AssociationInspector::landmark_chosen, this,
            &Inspection::landmark_chosen);
    connect(particles_, &ParticleTable::grid_wanted, this, &Inspection::grid_wanted);
    connect(particles_, &ParticleTable::map_wanted, this, &Inspection::map_wanted);
    connect(particles_, &ParticleTable::path_wanted, this, &Inspection::path_wanted);
    connect(joint_, &JointCovariance::picture_wanted, this,
            [this] { emit picture_wanted(joint_->exportable()); });
    connect(loops_, &LoopTable::edits_wanted, this, &Inspection::edits_wanted);
    connect(loops_, &LoopTable::drawing_wanted, this, &Inspection::drawing_wanted);
    connect(loops_, &LoopTable::picture_wanted, this,
            [this] { emit picture_wanted(loops_->view().exportable()); });
}

void Inspection::open_drawing(const QString& path) {
    loops_->open_drawing(path);
}

void Inspection::connect_views(ScanView& scan, GridView& grid) {
    connect(&scan, &ScanView::landmark_clicked, this, &Inspection::landmark_chosen);
    connect(&grid, &GridView::landmark_clicked, this, &Inspection::landmark_chosen);
    connect(&scan, &ScanView::particle_clicked, particles_, [this](int particle) {
        if (particles_->isVisible()) particles_->choose(static_cast<std::size_t>(particle));
    });
    connect(&scan, &ScanView::feature_clicked, associations_, [this](int feature) {
        if (associations_->isVisible()) associations_->choose(feature);
    });
    connect(associations_, &AssociationInspector::feature_chosen, &scan, &ScanView::set_feature);
    connect(loops_, &LoopTable::loop_shown, &grid, &GridView::set_loop);
    connect(loops_, &LoopTable::drawing_read, &grid, &GridView::set_drawing);
    connect(&grid, &GridView::loop_clicked, loops_, [this](const auto& loop) {
        if (loops_->isVisible() && !loops_->takes_places()) loops_->choose(loop);
    });
    connect(&grid, &GridView::place_clicked, loops_, &LoopTable::take_place);
}

void Inspection::set_highlight(const PickedLandmark& picked) {
    landmarks_->set_highlight(picked);
}

void Inspection::set_layers(const LayerSet& layers) {
    SnapshotParts parts = session_.parts();
    parts.ancestry = layers.has(Layer::ancestry);
    session_.want(parts);
}

}  // namespace hitos::window
