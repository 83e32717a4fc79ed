// SPDX-License-Identifier: GPL-3.0-or-later
// Changes by hand of a graph from a file.
#include <fmt/format.h>

#include <algorithm>

#include "hitos/base/error.hpp"
#include "hitos/registration/odometry_step.hpp"
#include "hitos/slam/planar_graph.hpp"

namespace hitos {
namespace {

using EditKind = GraphEdit::Kind;

class PlanarEditor {
  public:
    PlanarEditor(PlanarGraph& graph, const PlacedEdits& edits) : graph_(graph), edits_(edits) {
        for (std::uint32_t i = 0; i < graph.vertices.size(); ++i) {
            if (graph.vertices[i].kind == PlanarVertex::Kind::pose) poses_.push_back(i);
        }
        std::ranges::sort(poses_, {}, [&](std::uint32_t i) { return id(i); });
    }

    /// The change of that number, from 1.
    void make(std::size_t number) {
        number_ = number;
        const GraphEdit& edit = edits_.edits[number - 1];
        const std::uint32_t pose = pose_of(edit.scan.scan);
        switch (edit.kind) {
            case EditKind::refuse:
                refuse(pose, pose_of(edit.earlier.scan));
                break;
            case EditKind::close:
                hold(PlanarEdge::Kind::step, pose_of(edit.earlier.scan), pose, edit);
                break;
            case EditKind::fix:
                if (graph_.vertices[pose].fixed) {
                    fail(message(HITOS_TEXT("Errors", "pose %1 is fixed by the graph already"),
                                 edit.scan.scan));
                }
                hold(PlanarEdge::Kind::pose_prior, pose, pose, edit);
                break;
            case EditKind::slip:
                slip(pose);
                break;
            case EditKind::wall:
            case EditKind::point:
                fail(marked(HITOS_TEXT("Errors",
                                       "a graph from a file has no scans that see a wall or point "
                                       "of a drawing; \"fix\" holds a pose at a known place")));
        }
    }

  private:
    [[noreturn]] void fail(const Message& why) const { throw wrong_edit(edits_, number_, why); }

    std::uint64_t id(std::uint32_t vertex) const { return graph_.vertices[vertex].id; }

    /// Among poses_, the first whose id is not lower.
    auto place_of(std::uint64_t wanted) const {
        return std::ranges::lower_bound(poses_, wanted, {}, [&](std::uint32_t i) { return id(i); });
    }

    std::uint32_t pose_of(std::uint64_t wanted) const {
        const auto found = place_of(wanted);
        if (found == poses_.end() || id(*found) != wanted) {
            fail(message(HITOS_TEXT("Errors", "the graph has no pose with the id %1"), wanted));
        }
        return *found;
    }

    static bool joins(const PlanarEdge& edge, std::uint32_t a, std::uint32_t b) {
        return edge.kind == PlanarEdge::Kind::step &&
               std::minmax(edge.from, edge.to) == std::minmax(a, b);
    }

    void refuse(std::uint32_t a, std::uint32_t b) {
        if (std::erase_if(graph_.edges,
                          [&](const PlanarEdge& edge) { return joins(edge, a, b); }) == 0) {
            no_edge(a, b);
        }
    }

    [[noreturn]] void no_edge(std::uint32_t a, std::uint32_t b) const {
        fail(message(HITOS_TEXT("Errors", "the graph has no edge between the poses %1 and %2"),
                     id(a), id(b)));
    }

    void hold(PlanarEdge::Kind kind, std::uint32_t from, std::uint32_t to, const GraphEdit& edit) {
        PlanarEdge& edge = graph_.edges.emplace_back();
        edge.kind = kind;
        edge.by_hand = true;
        edge.from = from;
        edge.to = to;
        edge.z << edit.pose.x, edit.pose.y, edit.pose.theta;
        edge.information.diagonal() = sigmas_by_hand(edit.kind).cwiseAbs2().cwiseInverse();
    }

    void slip(std::uint32_t pose) {
        const auto place = place_of(id(pose));
        if (place == poses_.begin()) {
            fail(message(HITOS_TEXT("Errors", "pose %1 has the lowest id: no step leads to it"),
                         id(pose)));
        }
        const std::uint32_t before = *(place - 1);
        bool met = false;
        for (PlanarEdge& edge : graph_.edges) {
            if (!joins(edge, before, pose)) continue;
            edge.information = step_information(slip_variances(), 0.0);
            met = true;
        }
        if (!met) no_edge(before, pose);
    }

    PlanarGraph& graph_;
    const PlacedEdits& edits_;
    std::vector<std::uint32_t> poses_;  // by their ids
    std::size_t number_ = 0;
};

}  // namespace

void edit(PlanarGraph& graph, const PlacedEdits& edits) {
    PlanarEditor editor(graph, edits);
    for (std::size_t number = 1; number <= edits.edits.size(); ++number) editor.make(number);
}

std::string vertex_text_of(std::span<const GraphEdit> edits) {
    std::string text;
    for (const GraphEdit& edit : edits) {
        text += fmt::format("{} {}", word_of(edit.kind), edit.scan.scan);
        if (edit.of_two()) text += fmt::format(" {}", edit.earlier.scan);
        if (edit.has_pose()) {
            text += fmt::format(" {} {} {}", edit.pose.x, edit.pose.y, edit.pose.theta);
        }
        if (!edit.comment.empty()) text += "  # " + edit.comment;
        text += '\n';
    }
    return text;
}

}  // namespace hitos
