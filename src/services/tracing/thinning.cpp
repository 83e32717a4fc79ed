// SPDX-License-Identifier: GPL-3.0-or-later
#include "thinning.hpp"

#include <algorithm>
#include <array>

namespace hitos {
namespace {

/// Clockwise from above.
constexpr std::array<std::pair<int, int>, 8> kAround = {
    {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};

/// For each cell, whether `counted` cells of a window along a row or column reach `needed`.
template <class At, class Put>
void slide(int length, int reach, bool all, const At& at, const Put& put) {
    int sum = 0;
    const auto value = [&](int i) { return i >= 0 && i < length && at(i) ? 1 : 0; };
    for (int i = 0; i < reach; ++i) sum += value(i);
    for (int i = 0; i < length; ++i) {
        sum += value(i + reach);
        sum -= value(i - reach - 1);
        put(i, all ? sum == 2 * reach + 1 : sum > 0);
    }
}

/// Along rows, then along columns: a square window is both.
CellMask windowed(const CellMask& mask, int reach, bool all) {
    CellMask rows(mask.columns(), mask.rows());
    for (int row = 0; row < mask.rows(); ++row) {
        slide(
            mask.columns(), reach, all, [&](int i) { return mask.at(i, row); },
            [&](int i, bool on) { rows.set(i, row, on); });
    }
    CellMask result(mask.columns(), mask.rows());
    for (int column = 0; column < mask.columns(); ++column) {
        slide(
            mask.rows(), reach, all, [&](int i) { return rows.at(column, i); },
            [&](int i, bool on) { result.set(column, i, on); });
    }
    return result;
}

/// Whether the cell can go and what is left hangs together as before: it is no end, and the
/// neighbours that are set are one piece.
bool can_go(const CellMask& mask, const SkeletonCell& cell) {
    std::array<bool, 8> p{};
    int count = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        p[i] = mask.at(cell.column + kAround[i].first, cell.row + kAround[i].second);
        count += p[i] ? 1 : 0;
    }
    int pieces = 0;
    for (std::size_t i = 0; i < p.size(); i += 2)
        pieces += !p[i] && (p[i + 1] || p[(i + 2) % p.size()]) ? 1 : 0;
    return count >= 2 && pieces == 1;
}

/// Neighbours along a line: one across a corner counts only where no other leads there.
std::vector<SkeletonCell> neighbours(const CellMask& mask, const SkeletonCell& cell) {
    std::vector<SkeletonCell> found;
    for (std::size_t i = 0; i < kAround.size(); ++i) {
        const SkeletonCell next{cell.column + kAround[i].first, cell.row + kAround[i].second};
        if (!mask.at(next.column, next.row)) continue;
        const bool across = i % 2 == 1;
        if (across && (mask.at(next.column, cell.row) || mask.at(cell.column, next.row))) continue;
        found.push_back(next);
    }
    return found;
}

std::vector<CellChain> walked(const CellMask& thin) {
    std::vector<CellChain> chains;
    CellMask done(thin.columns(), thin.rows());  // inner cells of chains
    const auto walk = [&](const SkeletonCell& from, const SkeletonCell& first) {
        CellChain chain{from, first};
        while (true) {
            const SkeletonCell now = chain.back();
            const std::vector<SkeletonCell> next = neighbours(thin, now);
            if (next.size() != 2) break;
            done.set(now.column, now.row, true);
            const SkeletonCell before = chain[chain.size() - 2];
            const SkeletonCell& on =
                next[0].column == before.column && next[0].row == before.row ? next[1] : next[0];
            chain.push_back(on);
            if (on.column == from.column && on.row == from.row) break;
        }
        return chain;
    };
    const auto each = [&](const auto& visit) {
        for (int row = 0; row < thin.rows(); ++row) {
            for (int column = 0; column < thin.columns(); ++column) {
                if (thin.at(column, row)) visit(SkeletonCell{column, row});
            }
        }
    };
    each([&](const SkeletonCell& cell) {
        const std::vector<SkeletonCell> next = neighbours(thin, cell);
        if (next.size() == 2) return;
        for (const SkeletonCell& first : next) {
            if (done.at(first.column, first.row)) continue;
            const bool other_end = neighbours(thin, first).size() != 2;
            // Between two ends there is no inner cell that tells; the first of both walks.
            if (other_end &&
                thin.index(first.column, first.row) < thin.index(cell.column, cell.row))
                continue;
            chains.push_back(walk(cell, first));
        }
    });
    each([&](const SkeletonCell& cell) {
        if (done.at(cell.column, cell.row)) return;
        const std::vector<SkeletonCell> next = neighbours(thin, cell);
        if (next.size() == 2) {
            done.set(cell.column, cell.row, true);
            chains.push_back(walk(cell, next[0]));
        }
    });
    return chains;
}

}  // namespace

CellMask grown(const CellMask& mask, int cells) {
    return windowed(mask, cells, false);
}

CellMask shrunk(const CellMask& mask, int cells) {
    return windowed(mask, cells, true);
}

CellMask thinned(CellMask mask) {
    std::vector<SkeletonCell> left;
    for (int row = 0; row < mask.rows(); ++row) {
        for (int column = 0; column < mask.columns(); ++column) {
            if (mask.at(column, row)) left.push_back({column, row});
        }
    }
    for (bool changed = true; changed;) {
        changed = false;
        for (const std::size_t side :
             {std::size_t{0}, std::size_t{4}, std::size_t{2}, std::size_t{6}}) {
            std::vector<SkeletonCell> border;
            for (const SkeletonCell& cell : left) {
                if (!mask.at(cell.column + kAround[side].first, cell.row + kAround[side].second))
                    border.push_back(cell);
            }
            bool any = false;
            for (const SkeletonCell& cell : border) {
                if (!can_go(mask, cell)) continue;
                mask.set(cell.column, cell.row, false);
                any = true;
            }
            if (!any) continue;
            changed = true;
            std::erase_if(
                left, [&](const SkeletonCell& cell) { return !mask.at(cell.column, cell.row); });
        }
    }
    return mask;
}

std::vector<CellChain> chains_of(CellMask& thin, int spur) {
    for (int round = 0; round < 2; ++round) {
        for (const CellChain& chain : walked(thin)) {
            const bool begins = neighbours(thin, chain.front()).size() == 1;
            const bool ends = neighbours(thin, chain.back()).size() == 1;
            if (begins == ends || chain.size() > static_cast<std::size_t>(spur)) continue;
            // The junction stays.
            for (std::size_t i = begins ? 0 : 1; i + (begins ? 1 : 0) < chain.size(); ++i)
                thin.set(chain[i].column, chain[i].row, false);
        }
    }
    return walked(thin);
}

}  // namespace hitos
