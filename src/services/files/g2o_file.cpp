// SPDX-License-Identifier: GPL-3.0-or-later
// After g2o's types slam2d and slam2d_addons: a vertex is its tag, number and estimate, an edge its
// tag, numbers, measurement and the upper triangle of its information, row by row. Lines stand with
// theta before rho, and a vertex ends with the numbers of its end points, -1 where it has none.
#include "hitos/services/files/g2o_file.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/rounding.hpp"
#include "hitos/base/text_input.hpp"

namespace hitos {
namespace {

using G2oWords = std::span<const std::string_view>;
using VertexKind = PlanarVertex::Kind;
using EdgeKind = PlanarEdge::Kind;

constexpr std::string_view kFix = "FIX";
constexpr double kGreatestInformation = 1e18;
constexpr std::array<std::string_view, 4> kPoseColumns{"id", "x", "y", "theta"};
constexpr std::array<std::string_view, 3> kPointColumns{"id", "x", "y"};
constexpr std::array<std::string_view, 5> kLineColumns{"id", "theta", "rho", "p1", "p2"};
constexpr std::array<std::string_view, 11> kStepColumns{"from", "to",  "x",   "y",   "theta", "I11",
                                                        "I12",  "I13", "I22", "I23", "I33"};
constexpr std::array<std::string_view, 7> kSeenPointColumns{"from", "to",  "x",  "y",
                                                            "I11",  "I12", "I22"};
constexpr std::array<std::string_view, 7> kSeenLineColumns{"from", "to",  "theta", "rho",
                                                           "I11",  "I12", "I22"};

struct VertexTag {
    std::string_view name;
    VertexKind kind;
    G2oWords columns;
};
/// In the order of their kinds.
constexpr std::array kVertexTags{VertexTag{"VERTEX_SE2", VertexKind::pose, kPoseColumns},
                                 VertexTag{"VERTEX_XY", VertexKind::point, kPointColumns},
                                 VertexTag{"VERTEX_LINE2D", VertexKind::line, kLineColumns}};

struct EdgeTag {
    std::string_view name;
    EdgeKind kind;
    VertexKind to;     ///< what it ends at; it begins at a pose
    G2oWords columns;  ///< a prior's first is none
};
constexpr std::array kEdgeTags{
    EdgeTag{"EDGE_SE2", EdgeKind::step, VertexKind::pose, kStepColumns},
    EdgeTag{"EDGE_SE2_XY", EdgeKind::point, VertexKind::point, kSeenPointColumns},
    EdgeTag{"EDGE_SE2_LINE2D", EdgeKind::line, VertexKind::line, kSeenLineColumns},
    EdgeTag{"EDGE_PRIOR_SE2", EdgeKind::pose_prior, VertexKind::pose,
            G2oWords(kStepColumns).subspan(1)},
    EdgeTag{"EDGE_PRIOR_SE2_XY", EdgeKind::position_prior, VertexKind::pose,
            G2oWords(kSeenPointColumns).subspan(1)},
    EdgeTag{"EDGE_PRIOR_XY", EdgeKind::point_prior, VertexKind::point,
            G2oWords(kSeenPointColumns).subspan(1)}};

class G2oReader {
  public:
    explicit G2oReader(const std::string& name) : name_(name) {}

    G2oFile read(std::string_view text) {
        text = input::without_mark(text);
        while (const auto line = input::next_line(text)) {
            ++line_;
            const auto words = input::fields(line->substr(0, line->find('#')));
            if (!words.empty()) take(words.front(), std::span(words).subspan(1));
        }
        if (file_.graph.count(VertexKind::pose) == 0) {
            constexpr std::string_view kExpected = "VERTEX_SE2 id x y theta";
            if (file_.unread.empty()) {
                fail(0, message(HITOS_TEXT("Errors",
                                           "no pose in the file; expected a graph of the plane as "
                                           "g2o writes it, with lines \"%1\""),
                                kExpected));
            }
            fail(0, message(HITOS_TEXT("Errors",
                                       "no pose in the file, and lines %1; expected a graph of the "
                                       "plane as g2o writes it, with lines \"%2\""),
                            input::in_quotes(file_.unread.front().tag), kExpected));
        }
        index();
        fix();
        join();
        return std::move(file_);
    }

  private:
    /// A vertex that a line names.
    struct Named {
        std::uint64_t id;
        std::uint64_t line;
        std::uint32_t vertex = 0;
    };

    void take(std::string_view tag, G2oWords words) {
        if (const auto* vertex = std::ranges::find(kVertexTags, tag, &VertexTag::name);
            vertex != kVertexTags.end()) {
            take_vertex(*vertex, words);
        } else if (const auto* edge = std::ranges::find(kEdgeTags, tag, &EdgeTag::name);
                   edge != kEdgeTags.end()) {
            take_edge(*edge, words);
        } else if (tag == kFix) {
            constexpr std::array<std::string_view, 1> kColumns{"id"};
            if (words.empty()) input::require_columns(0, kColumns, place());
            for (const std::string_view word : words) fixed_.push_back({id_of(word, "id"), line_});
        } else {
            pass_over(tag);
        }
    }

    void take_vertex(const VertexTag& tag, G2oWords words) {
        input::require_columns(words.size(), tag.columns, place());
        bound();
        ids_.push_back({id_of(words[0], tag.columns[0]), line_,
                        static_cast<std::uint32_t>(file_.graph.vertices.size())});
        PlanarVertex& vertex = file_.graph.vertices.emplace_back();
        vertex.kind = tag.kind;
        vertex.id = ids_.back().id;
        const std::size_t numbers = tag.kind == VertexKind::pose ? 3 : 2;
        for (std::size_t i = 0; i < numbers; ++i) {
            vertex.at(static_cast<Eigen::Index>(i)) =
                input::finite_number(words[i + 1], tag.columns[i + 1], place());
        }
        if (tag.kind != VertexKind::line) return;
        for (std::size_t i = 0; i < 2; ++i) {
            const std::string_view word = words[i + 3];
            if (word == "-1") continue;
            const std::uint64_t id = id_of(word, tag.columns[i + 3]);
            vertex.ends.at(i) = static_cast<std::int64_t>(id);
        }
    }

    void take_edge(const EdgeTag& tag, G2oWords words) {
        input::require_columns(words.size(), tag.columns, place());
        bound();
        PlanarEdge& edge = file_.graph.edges.emplace_back();
        edge.kind = tag.kind;
        std::size_t next = 0;
        const std::uint64_t from = id_of(words[next], tag.columns[next]);
        if (!edge.prior()) ++next;
        const std::uint64_t to = id_of(words[next], tag.columns[next]);
        ++next;
        if (!edge.prior() && from == to) {
            fail(line_, message(HITOS_TEXT("Errors",
                                           "the edge goes from vertex %1 to itself; expected two "
                                           "vertices"),
                                from));
        }
        named_.push_back({Named{from, line_}, Named{to, line_}});
        for (Eigen::Index i = 0; i < edge.size(); ++i, ++next) {
            edge.z(i) = input::finite_number(words[next], tag.columns[next], place());
        }
        for (Eigen::Index row = 0; row < edge.size(); ++row) {
            for (Eigen::Index column = row; column < edge.size(); ++column, ++next) {
                edge.information(row, column) = edge.information(column, row) =
                    input::finite_number(words[next], tag.columns[next], place(),
                                         kGreatestInformation);
            }
        }
        check_information(edge.information);
    }

    void check_information(const Eigen::Matrix3d& information) const {
        constexpr double kRounding = 1e-6;  // files with six digits have no more
        // Metres and radians may differ by any factor: each in units of its own.
        const Eigen::Vector3d units = information.diagonal().unaryExpr(
            [](double own) { return own > 0.0 ? 1.0 / std::sqrt(own) : 1.0; });
        const Eigen::Vector3d values =
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(
                units.asDiagonal() * information * units.asDiagonal(), Eigen::EigenvaluesOnly)
                .eigenvalues();
        if (information.diagonal().minCoeff() >= 0.0 && values.minCoeff() >= -kRounding) return;
        fail(line_,
             message(HITOS_TEXT("Errors",
                                "the information has the eigenvalue %1; expected none below 0: the "
                                "inverse of a covariance, its upper triangle row by row"),
                     fmt::format("{:.6g}", Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(
                                               information, Eigen::EigenvaluesOnly)
                                               .eigenvalues()
                                               .minCoeff())));
    }

    void pass_over(std::string_view tag) {
        constexpr std::size_t kMostTags = 32;
        constexpr std::size_t kLongest = 60;
        const std::string name = on_one_line(tag.substr(0, kLongest));
        auto found = std::ranges::find(file_.unread, name, &UnreadLines::tag);
        if (found == file_.unread.end()) {
            if (file_.unread.size() < kMostTags) {
                file_.unread.push_back({file_.unread.size() + 1 < kMostTags ? name : "others", 0});
            }
            found = file_.unread.end() - 1;
        }
        ++found->lines;
    }

    /// By their ids: however they are chosen, they are found soon.
    void index() {
        std::ranges::sort(ids_, [](const Named& a, const Named& b) {
            return std::pair(a.id, a.line) < std::pair(b.id, b.line);
        });
        const auto twice = std::ranges::adjacent_find(ids_, {}, &Named::id);
        if (twice == ids_.end()) return;
        fail((twice + 1)->line,
             message(HITOS_TEXT("Errors",
                                "vertex %1 is there already, in line %2; expected another "
                                "id"),
                     twice->id, twice->line));
    }

    std::uint32_t vertex_of(const Named& named) const {
        const auto found = std::ranges::lower_bound(ids_, named.id, {}, &Named::id);
        if (found == ids_.end() || found->id != named.id) {
            fail(named.line,
                 message(HITOS_TEXT("Errors",
                                    "names vertex %1, which the file does not have; expected a "
                                    "line VERTEX_SE2, VERTEX_XY or VERTEX_LINE2D with that id"),
                         named.id));
        }
        return found->vertex;
    }
    std::uint32_t vertex_of(const Named& named, VertexKind kind) const {
        const std::uint32_t vertex = vertex_of(named);
        const VertexKind is = file_.graph.vertices[vertex].kind;
        if (is != kind) {
            fail(named.line, message(HITOS_TEXT("Errors", "vertex %1 is of %2; expected one of %3"),
                                     named.id, g2o_tag(is), g2o_tag(kind)));
        }
        return vertex;
    }

    void fix() {
        for (const Named& named : fixed_) file_.graph.vertices[vertex_of(named)].fixed = true;
    }

    void join() {
        for (std::size_t i = 0; i < named_.size(); ++i) {
            PlanarEdge& edge = file_.graph.edges[i];
            edge.to = vertex_of(named_[i][1], kEdgeTags.at(static_cast<std::size_t>(edge.kind)).to);
            edge.from = edge.prior() ? edge.to : vertex_of(named_[i][0], VertexKind::pose);
        }
    }

    std::uint64_t id_of(std::string_view word, std::string_view column) const {
        constexpr std::uint64_t kGreatest = (std::uint64_t{1} << 63U) - 1;
        const auto id = input::parse_whole(word);
        if (!id || *id > kGreatest) {
            fail(line_,
                 message(HITOS_TEXT("Errors", "%1 is %2; expected a whole number from 0 to %3"),
                         column, input::in_quotes(word), kGreatest));
        }
        return *id;
    }

    /// What is read takes some ten times the memory of the shortest lines.
    void bound() const {
        constexpr std::size_t kMost = 4'000'000;
        if (file_.graph.vertices.size() + file_.graph.edges.size() < kMost) return;
        fail(line_, message(HITOS_TEXT("Errors", "has more than %1 vertices and edges"), kMost));
    }

    [[noreturn]] void fail(std::uint64_t line, const Message& problem) const {
        throw FormatError(name_, line, problem);
    }
    input::Place place() const { return {name_, line_}; }

    const std::string& name_;
    std::uint64_t line_ = 0;
    G2oFile file_;
    std::vector<Named> ids_;
    std::vector<Named> fixed_;
    std::vector<std::array<Named, 2>> named_;  // by edges
};

/// Writes what a G2oReader reads again.
class G2oWriter {
  public:
    explicit G2oWriter(const PlanarGraph& graph) : graph_(graph) {}

    std::string text() {
        for (const PlanarVertex& vertex : graph_.vertices) put(vertex);
        for (const PlanarVertex& vertex : graph_.vertices) {
            if (vertex.fixed) put_words("{} {}\n", kFix, vertex.id);
        }
        for (const PlanarEdge& edge : graph_.edges) put(edge);
        return std::move(out_);
    }

  private:
    template <class... Args>
    void put_words(fmt::format_string<Args...> words, Args&&... args) {
        fmt::format_to(std::back_inserter(out_), words, std::forward<Args>(args)...);
    }

    /// Of the line that is being written.
    void put(double value, double greatest = input::kGreatestNumber) {
        if (!(std::abs(value) <= greatest)) {
            throw Error(message(
                HITOS_TEXT("Errors",
                           "the graph cannot be written: \"%1\" would go on with %2, and "
                           "numbers from -%3 to %3 are read; are its numbers metres and "
                           "radians, and no edge false?"),
                out_.substr(line_), fmt::format("{:g}", value), fmt::format("{:g}", greatest)));
        }
        put_words(" {}", without_sign_of_zero(value));
    }

    void put(const PlanarVertex& vertex) {
        line_ = out_.size();
        put_words("{} {}", g2o_tag(vertex.kind), vertex.id);
        for (Eigen::Index i = 0; i < (vertex.kind == VertexKind::pose ? 3 : 2); ++i)
            put(vertex.at(i));
        if (vertex.kind == VertexKind::line) put_words(" {} {}", vertex.ends[0], vertex.ends[1]);
        out_ += '\n';
    }

    void put(const PlanarEdge& edge) {
        line_ = out_.size();
        out_ += g2o_tag(edge.kind);
        if (!edge.prior()) put_words(" {}", graph_.vertices[edge.from].id);
        put_words(" {}", graph_.vertices[edge.to].id);
        for (Eigen::Index i = 0; i < edge.size(); ++i) put(edge.z(i));
        for (Eigen::Index row = 0; row < edge.size(); ++row) {
            for (Eigen::Index column = row; column < edge.size(); ++column)
                put(edge.information(row, column), kGreatestInformation);
        }
        out_ += '\n';
    }

    const PlanarGraph& graph_;
    std::string out_;
    std::size_t line_ = 0;  ///< where it begins
};

}  // namespace

std::string_view g2o_tag(PlanarVertex::Kind kind) {
    return kVertexTags.at(static_cast<std::size_t>(kind)).name;
}

std::string_view g2o_tag(PlanarEdge::Kind kind) {
    return kEdgeTags.at(static_cast<std::size_t>(kind)).name;
}

G2oFile read_g2o(const std::filesystem::path& path) {
    return parse_g2o(input::read_text(path), path.string());
}

G2oFile parse_g2o(std::string_view text, const std::string& name) {
    return G2oReader(name).read(text);
}

std::string g2o_text(const PlanarGraph& graph) {
    return G2oWriter(graph).text();
}

}  // namespace hitos
