// SPDX-License-Identifier: GPL-3.0-or-later
// What is gone and what is new where a second tour was found in the map of the first.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "free_view.hpp"
#include "registration_impl.hpp"

namespace hitos {
namespace {

constexpr double kCell = 0.1;   // [m]
constexpr double kView = 10.0;  // [m] from where a scan says something of a point
constexpr int kFewestKeys = 2;  // that see a point: what only one sees was somebody passing by
constexpr int kFewestThrough = 3;
constexpr int kSeldom = 5;
constexpr std::size_t kFewestCells = 5;  // of a place
constexpr int kNextTo = 3;               // cells from one to the next of a place

using Cell = std::pair<int, int>;

/// What the scans of one tour saw, cell by cell, and how far each looked.
struct Side {
    struct Seen {
        Point2 at;
        std::size_t last_key = 0;
        int keys = 0;
    };
    std::map<Cell, Seen> cells;
    std::vector<Point2> places;  // of the keys
    std::vector<FreeView> views;
};

Side side_of(const KeyGraph& graph, std::size_t begin, std::size_t end) {
    Side side;
    std::vector<Point2> points;
    for (std::size_t k = begin; k < end; ++k) {
        const Pose& pose = graph.poses[k].pose;
        const std::span<const SurfacePoint> scan = graph.scans[k].points();
        side.places.push_back({pose.x, pose.y});
        side.views.emplace_back(scan, pose);
        points.clear();
        place(scan, pose, points);
        for (const Point2& point : points) {
            if (std::hypot(point.x - pose.x, point.y - pose.y) > kView) continue;
            const Cell cell{static_cast<int>(std::floor(point.y / kCell)),
                            static_cast<int>(std::floor(point.x / kCell))};
            Side::Seen& seen = side.cells.try_emplace(cell, Side::Seen{point}).first->second;
            if (seen.keys > 0 && seen.last_key == k) continue;
            seen.last_key = k;
            ++seen.keys;
        }
    }
    return side;
}

/// Whether the scans of a tour looked past a point, and next to none of them saw anything there: by
/// an edge a scan sees near and far in one direction, and what lies in between is not told apart.
bool looked_past(const Side& side, const Point2& point) {
    int through = 0;
    int there = 0;
    for (std::size_t i = 0; i < side.views.size(); ++i) {
        const Point2& from = side.places[i];
        if (std::hypot(point.x - from.x, point.y - from.y) > kView) continue;
        const FreeView::Said said = side.views[i].of(point);
        if (said == FreeView::Said::there) ++there;
        if (said == FreeView::Said::through) ++through;
    }
    return through >= kFewestThrough && there * kSeldom < through;
}

/// Takes a cell out, with those beside it, and those beside them.
void take_place(std::map<Cell, Point2>& left, std::vector<Point2>& points) {
    std::vector<Cell> open{left.begin()->first};
    points.push_back(left.begin()->second);
    left.erase(left.begin());
    while (!open.empty()) {
        const Cell cell = open.back();
        open.pop_back();
        for (int row = -kNextTo; row <= kNextTo; ++row) {
            for (int column = -kNextTo; column <= kNextTo; ++column) {
                const Cell other{cell.first + row, cell.second + column};
                const auto found = left.find(other);
                if (found == left.end()) continue;
                open.push_back(other);
                points.push_back(found->second);
                left.erase(found);
            }
        }
    }
}

/// What one side saw and the other looked past.
void note_changes(const Side& seen_by, const Side& not_by, bool gone,
                  std::vector<ChangedPlace>& changes) {
    std::map<Cell, Point2> left;
    for (const auto& [cell, seen] : seen_by.cells) {
        if (seen.keys >= kFewestKeys && looked_past(not_by, seen.at)) left.emplace(cell, seen.at);
    }
    while (!left.empty()) {
        ChangedPlace place{gone, {}};
        take_place(left, place.points);
        if (place.points.size() >= kFewestCells) changes.push_back(std::move(place));
    }
}

}  // namespace

std::vector<ChangedPlace> Registration::Impl::changes() const {
    std::vector<ChangedPlace> changes;
    if (figures_.later_tours.empty() || !figures_.later_tours.back().found) return changes;
    const auto begin = std::ranges::lower_bound(graph_.poses, figures_.later_tours.back().begin, {},
                                                &KeyPose::scan);
    const auto first = static_cast<std::size_t>(begin - graph_.poses.begin());
    const Side before = side_of(graph_, 0, first);
    const Side since = side_of(graph_, first, graph_.size());
    note_changes(before, since, true, changes);
    note_changes(since, before, false, changes);
    return changes;
}

}  // namespace hitos
