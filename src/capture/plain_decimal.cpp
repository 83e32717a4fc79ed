// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_decimal.hpp"

namespace hitos::plain {
namespace {

constexpr std::array<std::uint64_t, 9> kWholePowersOfTen = {
    1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};

}  // namespace

Decimal long_decimal(const char* at, const char* end) {
    if (at == end) return {};
    const bool negative = *at == '-';
    const char* const first = at + (negative || *at == '+' ? 1 : 0);
    constexpr std::ptrdiff_t kMostDigits = 10;
    const char* stop = first;
    std::uint64_t whole = 0;
    for (; stop != end && *stop >= '0' && *stop <= '9'; ++stop) {
        if (stop - first == kMostDigits) return {};
        whole = whole * 10 + static_cast<std::uint64_t>(*stop - '0');
    }
    if (stop == first) return {};
    unsigned decimals = 0;
    if (stop != end && *stop == '.') {
        ++stop;
        const std::uint64_t bytes = eight_from(stop, end) ^ eight_of('0');
        decimals = place_of_first(no_digits(bytes));
        if (decimals > 0) whole = whole * kWholePowersOfTen[decimals] + joined(bytes, decimals);
        stop += decimals;
    }
    constexpr std::uint64_t kGreatestExact = std::uint64_t{1} << 53;
    if (whole > kGreatestExact || (stop != end && !is_blank(*stop))) return {};
    const double value = scaled(whole, decimals);
    return {static_cast<std::size_t>(stop - at), negative ? -value : value};
}

}  // namespace hitos::plain
