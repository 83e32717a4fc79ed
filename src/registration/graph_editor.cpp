#include "graph_editor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hitos/base/error.hpp"

namespace hitos {
namespace {

constexpr double kBeside = 5.0;  // [m] of way, as wide as what is searched for

/// Whether a loop that is found at a key may be the one of that scan: other changes move what is
/// found by some scans, as many as the last metres had.
bool is_beside(const KeyGraph& graph, std::size_t key, std::uint64_t scan) {
    const std::uint64_t now = graph.poses[key].scan;
    const auto back = std::ranges::upper_bound(graph.scans, graph.scans[key].travelled_m - kBeside,
                                               {}, &KeyScan::travelled_m);
    const std::uint64_t beside =
        now - graph.poses[static_cast<std::size_t>(back - graph.scans.begin())].scan;
    return (now > scan ? now - scan : scan - now) <= beside;
}

/// The first scan that a change makes otherwise.
std::uint64_t first_touched(const KeyGraph& graph, const GraphEdit& edit) {
    std::uint64_t first = edit.scan.scan;
    if (edit.kind == GraphEdit::Kind::close) first = std::min(first, edit.earlier.scan);
    if (edit.kind != GraphEdit::Kind::refuse) return first;
    for (std::size_t key = 0; key < graph.size() && graph.poses[key].scan < first; ++key) {
        if (is_beside(graph, key, edit.scan.scan)) return graph.poses[key].scan;
    }
    return first;
}

}  // namespace

GraphEditor::GraphEditor(std::vector<GraphEdit> edits)
    : edits_(std::move(edits)), met_(edits_.size(), false) {}

void GraphEditor::replace(std::vector<GraphEdit> edits) {
    std::vector<bool> met;
    for (const GraphEdit& edit : edits) {
        const auto former = std::ranges::find(edits_, edit);
        met.push_back(former != edits_.end() &&
                      met_[static_cast<std::size_t>(former - edits_.begin())]);
    }
    edits_ = std::move(edits);
    met_ = std::move(met);
}

void GraphEditor::check(std::uint64_t number, const Scan& scan) const {
    constexpr double kSameStamp = 1e-3;  // [s]
    for (std::size_t i = 0; i < edits_.size(); ++i) {
        for (const EditedScan& named : {edits_[i].scan, edits_[i].earlier}) {
            if (named.scan != number || !named.stamp_s) continue;
            if (std::abs(*named.stamp_s - scan.stamp_s()) <= kSameStamp) continue;
            throw ConfigError(kGraphEditsKey,
                              HITOS_TEXT("Errors",
                                         "change %1 is of another tour, or of this one read "
                                         "otherwise: scan %2 had the stamp %3 when it was made, "
                                         "and has %4"),
                              i + 1, number + 1, *named.stamp_s, scan.stamp_s());
        }
    }
}

bool GraphEditor::needs_key(std::uint64_t scan) const {
    return std::ranges::any_of(edits_, [&](const GraphEdit& edit) {
        return edit.has_pose() &&
               (edit.scan.scan == scan || (edit.of_two() && edit.earlier.scan == scan));
    });
}

bool GraphEditor::slipped(std::uint64_t scan) {
    bool slipped = false;
    for (std::size_t i = 0; i < edits_.size(); ++i) {
        if (edits_[i].kind != GraphEdit::Kind::slip || edits_[i].scan.scan != scan) continue;
        slipped = met_[i] = true;
    }
    return slipped;
}

std::vector<GraphEdit> GraphEditor::of_newest(const KeyGraph& graph) {
    std::vector<GraphEdit> found;
    for (std::size_t i = 0; i < edits_.size(); ++i) {
        if (!edits_[i].has_pose() || edits_[i].scan.scan != graph.poses.back().scan) continue;
        met_[i] = true;
        found.push_back(edits_[i]);
    }
    return found;
}

bool GraphEditor::names(const GraphEdit& edit, const KeyGraph& graph, const LoopFound& loop) {
    if (edit.kind != GraphEdit::Kind::refuse ||
        !is_beside(graph, graph.size() - 1, edit.scan.scan)) {
        return false;
    }
    const auto earlier =
        std::ranges::upper_bound(graph.poses, edit.earlier.scan, {}, &KeyPose::scan);
    if (earlier == graph.poses.begin()) return false;
    const auto key = static_cast<std::size_t>(earlier - graph.poses.begin()) - 1;
    return std::abs(graph.scans[loop.key].travelled_m - graph.scans[key].travelled_m) <= kBeside;
}

bool GraphEditor::refuses(const KeyGraph& graph, const LoopFound& loop) {
    constexpr double kMemory = 12.0;  // [m] of way without a find, as that of the search
    const double way_m = graph.scans.back().travelled_m;
    const double earlier_way_m = graph.scans[loop.key].travelled_m;
    bool refused = false;
    for (std::size_t i = 0; i < edits_.size(); ++i) {
        if (names(edits_[i], graph, loop)) refused = met_[i] = true;
    }
    if (refused) {
        refused_.push_back({way_m, earlier_way_m});
        return true;
    }
    for (Refused& last : refused_) {
        const double since = way_m - last.way_m;
        if (since > kMemory || std::abs(earlier_way_m - last.earlier_way_m) > since + kBeside)
            continue;
        last = {way_m, earlier_way_m};
        return true;
    }
    return false;
}

std::uint64_t untouched_scans(const KeyGraph& graph, std::span<const GraphEdit> before,
                              std::span<const GraphEdit> after) {
    std::uint64_t first = std::numeric_limits<std::uint64_t>::max();
    const auto note = [&](std::span<const GraphEdit> edits, std::span<const GraphEdit> others) {
        for (const GraphEdit& edit : edits) {
            if (std::ranges::find(others, edit) == others.end())
                first = std::min(first, first_touched(graph, edit));
        }
    };
    note(before, after);
    note(after, before);
    return first;
}

std::vector<std::uint64_t> GraphEditor::unmet() const {
    std::vector<std::uint64_t> unmet;
    for (std::size_t i = 0; i < met_.size(); ++i) {
        if (!met_[i]) unmet.push_back(i);
    }
    return unmet;
}

}  // namespace hitos
