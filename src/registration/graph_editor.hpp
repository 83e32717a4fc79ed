// SPDX-License-Identifier: GPL-3.0-or-later
// Changes by hand, as a tour comes to them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hitos/capture/scan.hpp"
#include "hitos/registration/graph_edit.hpp"
#include "hitos/registration/registration.hpp"
#include "key_graph.hpp"
#include "loop_closer.hpp"

namespace hitos {

class GraphEditor {
  public:
    explicit GraphEditor(std::vector<GraphEdit> edits);

    /// What has been met stays met where it is among the new ones.
    void replace(std::vector<GraphEdit> edits);
    const std::vector<GraphEdit>& edits() const { return edits_; }
    /// Throws ConfigError where a change names the scan with another stamp.
    void check(std::uint64_t number, const Scan& scan) const;
    /// Throws ConfigError where a change names a scan that a tour of so many has not.
    void check_end(std::uint64_t scans) const;
    /// Throws ConfigError where a change names a scan of a map that is held, whose tour ended
    /// before `begin`, and made it a key: it would be another map. `forced` are the keys that are
    /// none but by changes, in their order.
    void check_held(const KeyGraph& graph, std::uint64_t begin,
                    std::span<const std::uint64_t> forced) const;
    /// Whether a change needs the scan as a key.
    bool needs_key(std::uint64_t scan) const;
    /// Whether the step to the scan has slipped.
    bool slipped(std::uint64_t scan);
    /// The changes of the graph's newest key that put edges into it; where nobody knows where it
    /// lies in the map (not `placed`) no anchors.
    std::vector<GraphEdit> of_newest(const KeyGraph& graph, bool placed);
    /// Whether a loop, of the graph's newest key, is refused: what the refusal names. What is found
    /// after it and says the same of where the robot is, is refused with it.
    std::optional<NamedLoop> refuses(const KeyGraph& graph, const LoopFound& loop);
    std::vector<std::uint64_t> unmet() const;
    /// By the loops that were refused in that graph, of so many scans.
    std::vector<CoveredRefusal> covered(const KeyGraph& graph, std::span<const LoopRecord> refused,
                                        std::uint64_t scans) const;
    std::optional<ChangesByHand> counts() const;

  private:
    /// Of a refused stretch the last place: the way driven to it, and how it would have moved the
    /// robot in the world.
    struct Refused {
        NamedLoop by;
        double way_m;
        Pose move;
    };

    static bool names(const GraphEdit& edit, const KeyGraph& graph, const LoopFound& loop);

    std::vector<GraphEdit> edits_;
    std::vector<bool> met_;
    std::vector<Refused> refused_;
};

}  // namespace hitos
