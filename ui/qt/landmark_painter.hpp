// Landmarks as marks on the plane: corners with ellipses, lines with bands.
#pragma once

#include <QStringList>
#include <optional>

#include "canvas_paint.hpp"
#include "hitos/features/caracteristica.hpp"

namespace hitos::window {

struct LandmarkStyle {
    bool uncertainty = true;
    bool numbers = false;
    int highlighted = -1;  ///< index in the map
};

/// The landmark of the world's frame that the user points at, if any.
struct PickedLandmark {
    std::optional<ICaracteristica> landmark;
};

/// Draws a map whose landmarks are in the view's frame.
void draw_landmarks(QPainter& painter, const Scene& scene, const LandmarkMap& map,
                    const LandmarkStyle& style);

/// The landmark nearest to a point of the map's frame, no further than `tolerance_m`; corners win
/// over lines. -1 where there is none.
int landmark_at(const LandmarkMap& map, const Point2& point, double tolerance_m);

/// The landmark of the map that `wanted` became; -1 where none is near.
int find_same(const LandmarkMap& map, const std::optional<ICaracteristica>& wanted);

/// What to know about a landmark: kind and number, values with deviations, observations. `world`
/// is in the world's frame.
QStringList describe(const ICaracteristica& world, int index);

}  // namespace hitos::window
