// SPDX-License-Identifier: GPL-3.0-or-later
// Finds out whether the robot is where it has been before.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "correlation.hpp"
#include "graph_ways.hpp"
#include "hitos/registration/loop_record.hpp"
#include "hitos/registration/registration_params.hpp"
#include "key_graph.hpp"
#include "loop_limits.hpp"
#include "scan_matcher.hpp"

namespace hitos {

/// Where the newest key is, seen from an earlier passage.
struct LoopFound {
    Pose pose;
    std::uint32_t key = 0;               ///< of the earlier passage, the nearest one
    std::vector<std::uint32_t> sources;  ///< the earlier keys that were matched
    LoopRecord record;
};

/// The keys since the robot may have been carried.
struct CarriedPiece {
    std::size_t first = 0;  ///< key of it
    std::size_t query = 0;  ///< the first key whose scan can be trusted to lie as its neighbours do
    std::uint64_t scan = 0;   ///< the first of it
    double broken_m = 0.0;    ///< way driven when the last break was told
    bool other_tour = false;  ///< it is a second tour: no way leads to it
    /// Where about its first key is, in the frame of the first tour, as somebody says.
    std::optional<Pose> start = {};
};

/// Looks for an earlier passage of the newest key. Not one scan but the points of the last metres
/// are correlated with an earlier stretch; the window is as wide as the graph is unsure; and only
/// what three searches in a row say the same of is a loop: a single match is an accident of like
/// places as often as not.
///
/// Where the graph is less sure than any window, after turns that no scan saw, the likeliest place
/// is one of many. Then stretches all over what may be are looked at in turn, each about itself,
/// and what is found is followed: the next search begins where it says that the robot is.
///
/// Where the robot may have been carried the graph says nothing: the piece since is looked for in
/// all that was before, at every heading, and found only where no other place is nearly as like.
class LoopCloser {
  public:
    LoopCloser(RegistrationParams params, const ScanMatcher& matcher)
        : params_(std::move(params)), matcher_(matcher) {}

    /// The newest key's passage; `ways` are those from it. What is refused on the way is added to
    /// `refused`.
    std::optional<LoopFound> search(const KeyGraph& graph, GraphWays& ways,
                                    std::vector<LoopRecord>& refused);
    /// Where the newest key's piece lies among what was before it.
    std::optional<LoopFound> search_piece(const KeyGraph& graph, const CarriedPiece& piece,
                                          std::vector<LoopRecord>& refused);
    /// What a loop from a key to an earlier one is worth as its record has the pose: score,
    /// overlap, share seen through.
    void measure(const KeyGraph& graph, std::uint32_t key, std::uint32_t earlier,
                 LoopRecord& record);
    /// Lays the passage of a key on that of an earlier one, from the record's pose on, and measures
    /// it.
    void fit(const KeyGraph& graph, std::uint32_t key, std::uint32_t earlier, LoopRecord& record);
    /// The graph has moved: what was found before is of another frame.
    void forget() {
        found_.clear();
        before_.reset();
        sureness_.reset();
    }

    /// Frees what a search for a piece has drawn, and the next one draws the same again.
    void rest() { before_.reset(); }

    std::uint64_t searches() const { return searches_; }

  private:
    /// That a search moved the newest key by `move`, in the world.
    struct Found {
        Pose move;
        double travelled_m;
        bool far;               ///< not where the graph would have it
        bool single = true;     ///< no other place was nearly as like
        std::size_t piece{};    ///< of a piece: its first key
        double likeness = 0.0;  ///< of a piece
    };
    /// Where to look: which earlier key, and for the newest one's pose.
    struct Place {
        std::uint32_t key;
        Pose centre;
        SearchWindow window;
        bool far;
        double most_seen_through = kMostSeenThrough;
        std::vector<std::uint32_t> sources = {};  ///< empty: the stretch about the key
    };
    static constexpr double kStretch = 5.0;  // [m] of travel, of the query and about the old key
    static constexpr double kMemory = 12.0;  // [m] of travel, of what was found
    static constexpr std::size_t kQueryKeys = 16;
    static constexpr std::size_t kFewestPoints = 40;  // of a query
    static constexpr SearchWindow kAboutFound{1.0, 0.1};
    static constexpr double kSpan = 1.5;  // [m] of travel from the first that agrees to the last
    // Where the graph expects no loop so many more finds must agree, and over that much travel.
    static constexpr int kMoreOfFar = 2;
    static constexpr double kFarSpan = 4.0;  // [m]

    /// How sure the graph was of all keys, seen from one: the greatest variances.
    struct Sureness {
        std::size_t key;
        std::size_t part_begin;  // of it
        double variance_m2 = 0.0;
        double variance_rad2 = 0.0;
    };

    static std::optional<Place> likeliest(const KeyGraph& graph, GraphWays& ways);
    std::optional<Place> followed(const KeyGraph& graph, GraphWays& ways) const;
    std::optional<Place> far_off(const KeyGraph& graph, GraphWays& ways);
    bool sure_of_all(const KeyGraph& graph) const;
    /// All keys before a piece; copies share it.
    struct Before {
        std::size_t piece;              // its first key
        std::vector<Point2> positions;  // of the keys
        CorrelationMap picture;
        SquareLattice squares;
    };
    /// What is looked for: the last metres, of so many keys.
    struct Query {
        double way_m;
        std::size_t most_keys;
        std::size_t first_key;
    };

    static bool same_place(const Pose& a, const Pose& b);
    static std::optional<Place> place_about(const KeyGraph& graph, const CarriedPiece& piece,
                                            const Pose& at);
    std::optional<LoopFound> single_place(const KeyGraph& graph, const CarriedPiece& piece,
                                          std::vector<LoopRecord>& refused);
    std::optional<LoopFound> followed_piece(const KeyGraph& graph, const CarriedPiece& piece,
                                            std::vector<LoopRecord>& refused);
    std::optional<double> agreed_on_piece(const KeyGraph& graph, const LoopFound& loop,
                                          std::size_t piece, bool said);
    static double piece_seen_through(const KeyGraph& graph, const CarriedPiece& piece,
                                     const Pose& pose);
    const Before& all_before(const KeyGraph& graph, const CarriedPiece& piece);
    static std::size_t gather(const KeyGraph& graph, std::size_t newest, const Query& how,
                              std::vector<SurfacePoint>& points);
    static LoopRecord record_of(const KeyGraph& graph, const LoopFound& loop);
    std::optional<LoopFound> look(const KeyGraph& graph, const std::optional<Place>& at,
                                  std::vector<LoopRecord>& refused);
    static std::vector<std::uint32_t> stretch_about(const KeyGraph& graph, std::uint32_t key);
    void gather_query(const KeyGraph& graph, std::size_t newest);
    double seen_through(const KeyGraph& graph, std::size_t newest, const LoopFound& loop,
                        const PointMap& map) const;
    void measure(const KeyGraph& graph, std::size_t newest, const LoopFound& loop,
                 const PointMap& map, LoopRecord& record) const;
    static bool says(const Found& found, const Pose& now, const Pose& then, double travelled_m);
    bool agreed(const Pose& now, const Pose& then, double travelled_m, bool far);

    RegistrationParams params_;
    ScanMatcher matcher_;
    std::deque<Found> found_;
    std::deque<Found> sought_;                         // of a piece
    std::map<std::int64_t, std::uint64_t> looked_at_;  // by stretch of travel, when last
    std::uint64_t far_looks_ = 0;
    std::optional<Sureness> sureness_;  // of the last time that all were looked at
    std::shared_ptr<const Before> before_;
    int idle_looks_ = 0;                // at everything, since something was found
    double looked_everywhere_m_ = 0.0;  // the way when it was last looked at
    std::uint64_t searches_ = 0;
    std::vector<SurfacePoint> query_;  // in the frame of the newest key; gathered when needed
    std::size_t query_keys_ = 0;       // that it is of
};

}  // namespace hitos
