// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/study/study_abscissa.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "hitos/base/text_input.hpp"

namespace hitos {

StudyAbscissa study_abscissa(const StudyPlan::Axis& axis) {
    StudyAbscissa x;
    for (const StudyValue& value : axis.values) {
        x.words.push_back(fmt::format("{}", fmt::join(value, "/")));
        const auto number = input::parse_number(x.words.back());
        if (value.size() != 1 || !number || !std::isfinite(*number)) x.numbers = false;
        x.positions.push_back(number.value_or(0.0));
    }
    if (!x.numbers) {
        for (std::size_t i = 0; i < x.positions.size(); ++i)
            x.positions[i] = static_cast<double>(i + 1);
        return x;
    }
    // Values such as 5, 10, 20 … 500 are meant by their ratios.
    constexpr double kWide = 20.0;
    const auto [least, greatest] = std::minmax_element(x.positions.begin(), x.positions.end());
    x.logarithmic = *least > 0.0 && *greatest >= kWide * *least;
    return x;
}

std::pair<double, double> StudyAbscissa::range(double room) const {
    const auto [least, greatest] = std::ranges::minmax(positions);
    if (logarithmic) {
        const double factor = std::pow(greatest / least, room);
        return {least / factor, greatest * factor};
    }
    const double span = greatest - least;
    const double more = span > 0.0 ? room * span : std::max(1.0, std::abs(least));
    return {least - more, greatest + more};
}

std::string figure_label(const std::string& name, const std::string& unit) {
    return unit.empty() ? name : fmt::format("{} [{}]", name, unit);
}

std::string study_axis_label(const StudyPlan::Axis& axis) {
    std::string units;
    for (const std::string& unit : axis.units) {
        if (!unit.empty()) units += (units.empty() ? "" : ", ") + unit;
    }
    return figure_label(axis.name, units);
}

}  // namespace hitos
