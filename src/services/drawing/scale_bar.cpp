// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/drawing/scale_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "picture_drawing.hpp"

namespace hitos {

double round_length(double limit) {
    const double power = std::pow(10.0, std::floor(std::log10(limit)));
    for (const double factor : {5.0, 2.0}) {
        if (factor * power <= limit) return factor * power;
    }
    return power;
}

double add_scale_bar(VectorDrawing& drawing, const Point2& lower_left, double longest,
                     double pixels_per_m) {
    constexpr double kThickness = 4.0;
    const double length_m = round_length(longest / pixels_per_m);
    const double length = std::max(1.0, std::round(length_m * pixels_per_m));
    const std::string text = fmt::format("{:g} m", length_m);
    const Point2& at = lower_left;
    DrawnLayer bar{"scale-bar", {.fill = kBlack}};
    bar.lines = {rectangle({at.x, at.y - kThickness}, {at.x + length, at.y})};
    DrawnLayer words{"scale", word_style(kBlack, kPictureLetters)};
    words.texts = {{{at.x, at.y - kThickness - 4.0}, text}};
    drawing.layers.push_back(std::move(bar));
    drawing.layers.push_back(std::move(words));
    return at.x + std::max(length, drawing::widest({&text, 1}, kPictureLetters));
}

}  // namespace hitos
