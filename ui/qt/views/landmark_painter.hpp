// SPDX-License-Identifier: GPL-3.0-or-later
// Landmarks as marks on the plane: corners with ellipses, lines with bands.
#pragma once

#include <QStringList>
#include <optional>

#include "canvas_paint.hpp"
#include "hitos/services/files/line_extents.hpp"

namespace hitos::window {

/// A map with the stretches of its lines, all in one frame.
struct MarkedMap {
    LandmarkMap map;
    std::vector<LineExtent> extents;
};
/// The same in frame a.
MarkedMap transform(const Pose& pose_a_b, const LandmarkMap& map_b,
                    const std::vector<LineExtent>& extents_b);

struct LandmarkStyle {
    bool uncertainty = true;
    bool endless = false;  ///< lines as what they are, not only where they were seen
    bool numbers = false;
    int highlighted = -1;  ///< index in the map
    QColor colour = {};    ///< of all; that of landmarks where it is none
};

/// The landmark of the world's frame that the user points at, if any.
struct PickedLandmark {
    std::optional<ICaracteristica> landmark;
};

/// Draws landmarks that are in the view's frame.
void draw_landmarks(QPainter& painter, const Scene& scene, const MarkedMap& marked,
                    const LandmarkStyle& style);
/// Draws one of them, strongly.
void draw_highlight(QPainter& painter, const Scene& scene, const MarkedMap& marked, int index,
                    bool uncertainty);

/// The landmark nearest to a point of the map's frame, no further than `tolerance_m`; corners win
/// over lines. -1 where there is none.
int landmark_at(const MarkedMap& marked, const Point2& point, double tolerance_m);

/// The landmark of the map that `wanted` became; -1 where none is near.
int find_same(const LandmarkMap& map, const std::optional<ICaracteristica>& wanted);

/// Whether what a feature of the last of so many scans has made is, after a correction at this
/// scan, one with a landmark that was there before.
bool taken_in(const Association& association, const LandmarkMap& map, std::uint64_t scans);

/// What a landmark is called: by its identity where it has one, else by its place in the map.
QString name_of(const ICaracteristica& landmark, int index);

/// What to know about a landmark: kind and number, values with deviations, observations. `world`
/// is in the world's frame.
QStringList describe(const ICaracteristica& world, int index);

}  // namespace hitos::window
