// Finds out whether the robot is where it has been before.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "correlation.hpp"
#include "hitos/registration/loop_record.hpp"
#include "hitos/registration/registration_params.hpp"
#include "key_graph.hpp"
#include "scan_matcher.hpp"

namespace hitos {

/// Where the newest key is, seen from an earlier passage.
struct LoopFound {
    Pose pose;
    std::uint32_t key = 0;               ///< of the earlier passage, the nearest one
    std::vector<std::uint32_t> sources;  ///< the earlier keys that were matched
    LoopRecord record;
};

/// Looks for an earlier passage of the newest key. Not one scan but the points of the last metres
/// are correlated with an earlier stretch; the window is as wide as the graph is unsure; and only
/// what three searches in a row say the same of is a loop: a single match is an accident of like
/// places as often as not.
///
/// Where the graph is less sure than any window, after turns that no scan saw, the likeliest place
/// is one of many. Then stretches all over what may be are looked at in turn, each about itself,
/// and what is found is followed: the next search begins where it says that the robot is.
class LoopCloser {
  public:
    LoopCloser(RegistrationParams params, const ScanMatcher& matcher)
        : params_(std::move(params)), matcher_(matcher) {}

    /// The newest key's passage; `reached` is that of the newest key. What is refused on the way is
    /// added to `refused`.
    std::optional<LoopFound> search(const KeyGraph& graph, std::span<const GraphReach> reached,
                                    std::vector<LoopRecord>& refused);
    /// What a loop from a key to an earlier one is worth as its record has the pose: score,
    /// overlap, share seen through.
    void measure(const KeyGraph& graph, std::uint32_t key, std::uint32_t earlier,
                 LoopRecord& record);
    /// Lays the passage of a key on that of an earlier one, from the record's pose on, and measures
    /// it.
    void fit(const KeyGraph& graph, std::uint32_t key, std::uint32_t earlier, LoopRecord& record);
    /// The graph has moved: what was found before is of another frame.
    void forget() { found_.clear(); }

    std::uint64_t searches() const { return searches_; }

  private:
    /// That a search moved the newest key by `move`, in the world.
    struct Found {
        Pose move;
        double travelled_m;
        bool far;  ///< not where the graph would have it
    };
    /// Where to look: which earlier key, and for the newest one's pose.
    struct Place {
        std::uint32_t key;
        Pose centre;
        SearchWindow window;
        bool far;
    };

    std::optional<Place> likeliest(const KeyGraph& graph,
                                   std::span<const GraphReach> reached) const;
    std::optional<Place> followed(const KeyGraph& graph, std::span<const GraphReach> reached) const;
    std::optional<Place> far_off(const KeyGraph& graph, std::span<const GraphReach> reached);
    std::optional<LoopFound> look(const KeyGraph& graph, const std::optional<Place>& at,
                                  std::vector<LoopRecord>& refused);
    static std::vector<std::uint32_t> stretch_about(const KeyGraph& graph, std::uint32_t key);
    void gather_query(const KeyGraph& graph, std::size_t newest);
    double seen_through(const KeyGraph& graph, std::size_t newest, const LoopFound& loop,
                        const PointMap& map) const;
    void measure(const KeyGraph& graph, std::size_t newest, const LoopFound& loop,
                 const PointMap& map, LoopRecord& record) const;
    bool agreed(const Pose& now, const Pose& then, double travelled_m, bool far);

    RegistrationParams params_;
    ScanMatcher matcher_;
    std::deque<Found> found_;
    std::map<std::int64_t, std::uint64_t> looked_at_;  // by stretch of travel, when last
    std::uint64_t far_looks_ = 0;
    std::uint64_t searches_ = 0;
    std::vector<SurfacePoint> query_;  // in the frame of the newest key; gathered when needed
    std::size_t query_keys_ = 0;       // that it is of
};

}  // namespace hitos
