// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/run/step_hashes.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "hitos/base/digest.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/text_input.hpp"
#include "state_bytes.hpp"

namespace hitos {
namespace {

constexpr std::size_t kDigits = 16;
constexpr std::array<std::string_view, 8> kColumns{
    "scan", "odometry", "points", "features", "registration", "hypotheses", "landmarks", "path"};

std::string heading() {
    std::string text;
    for (const std::string_view column : kColumns)
        (text.empty() ? text : text += ',').append(column);
    return text;
}

using Cells = std::array<std::string_view, kColumns.size()>;

/// A table's lines, one after another.
class HashLines {
  public:
    HashLines(std::string_view text, const std::string& name) : rest_(text), name_(name) {
        if (input::next_line(rest_) != heading()) {
            throw FormatError(name_, 1,
                              message(HITOS_TEXT("Errors",
                                                 "expected the heading \"%1\" of a table "
                                                 "that hitos-cli run --hashes writes"),
                                      heading()));
        }
    }
    /// Nothing at the end.
    std::optional<Cells> next() {
        const std::optional<std::string_view> whole = input::next_line(rest_);
        if (!whole) return std::nullopt;
        ++line_;
        std::string_view line = *whole;
        Cells cells;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const std::size_t comma = i + 1 == cells.size() ? line.size() : line.find(',');
            if (comma == std::string_view::npos || comma == 0) refuse();
            cells.at(i) = line.substr(0, comma);
            if (i > 0 && comma != kDigits) refuse();
            line.remove_prefix(std::min(comma + 1, line.size()));
        }
        return cells;
    }

  private:
    [[noreturn]] void refuse() const {
        throw FormatError(
            name_, line_,
            HITOS_TEXT("Errors",
                       "expected the number of a scan and its seven hashes of 16 digits"));
    }
    std::string_view rest_;
    const std::string& name_;
    std::uint64_t line_ = 1;
};

}  // namespace

StepHashes::StepHashes() : text_(heading() + '\n') {}

void StepHashes::note(const Algoritmo& run) {
    const SlamFilter& filter = run.filter();
    std::string bytes;
    const auto end = [&] {
        text_ += ',';
        text_.append(Digest().add(std::exchange(bytes, {})).text(), 0, kDigits);
    };
    text_ += run.finished() ? "end" : std::to_string(run.steps());
    put_path(bytes, std::span(run.odometry_trajectory()).last(1));
    end();
    put_all(bytes, run.scan().points);
    put_told(bytes, run.scan());
    end();
    put_observation(bytes, run.observation());
    end();
    if (const Registration* registration = run.registration()) {
        put_all(bytes, registration->keys());
        for (const LoopRecord& loop : registration->loops()) put_loop(bytes, loop);
        for (const LoopRecord& loop : registration->refused_loops()) put_loop(bytes, loop);
    }
    end();
    put_hypotheses(bytes, filter);
    put(bytes, filter.pose_covariance());
    end();
    for (std::size_t i = 0; i < filter.hypotheses().size(); ++i)
        put_landmarks(bytes, filter.map(i));
    const Eigen::MatrixXd joint = filter.joint_covariance();
    put_all(bytes, joint.reshaped());
    end();
    put_all(bytes, filter.best_history());
    put_path(bytes, run.online_trajectory());
    end();
    text_ += '\n';
}

std::optional<StepDifference> first_difference(std::string_view a, const std::string& name_a,
                                               std::string_view b, const std::string& name_b) {
    HashLines lines_a(a, name_a);
    HashLines lines_b(b, name_b);
    while (true) {
        const std::optional<Cells> of_a = lines_a.next();
        const std::optional<Cells> of_b = lines_b.next();
        if (!of_a && !of_b) return std::nullopt;
        const Cells& there = of_a ? *of_a : *of_b;
        for (std::size_t i = 0; i < kColumns.size(); ++i) {
            if (of_a && of_b && of_a->at(i) == of_b->at(i)) continue;
            return StepDifference{std::string(there.front()), std::string(kColumns.at(i))};
        }
    }
}

}  // namespace hitos
