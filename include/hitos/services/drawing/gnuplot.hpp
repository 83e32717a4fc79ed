// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures drawn by gnuplot.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "hitos/base/geometry.hpp"
#include "hitos/base/message.hpp"

namespace hitos {

/// A text that gnuplot reads: a script or its data.
struct PlotFile {
    std::string name;
    std::string text;
};

/// Writes the files into the folder and has gnuplot run the script, one of them, which makes the
/// pictures; each picture appears whole. Where `refusal` says why there is nothing to draw, or
/// gnuplot is missing or fails, pictures of an earlier time are removed and the reason is given;
/// else an empty message.
Message draw_pictures(const std::filesystem::path& folder, std::span<const PlotFile> files,
                      const std::string& script, std::span<const std::string> pictures,
                      const Message& refusal = {});

/// Lines or points of one look in a picture of a place.
struct PlotLayer {
    std::string name;                        ///< of its data
    std::string look;                        ///< what gnuplot's plot says after the data
    std::vector<std::vector<Point2>> lines;  ///< each apart from the others, world [m]
};

/// A script for a picture (PNG) of the layers that have something, one over the other, with their
/// data: equal axes in metres, a legend below.
std::string place_script(const std::string& picture, std::span<const PlotLayer> layers);

/// The text in gnuplot's quotes, in one line.
std::string gnuplot_quoted(const std::string& text);

/// The name of a file in gnuplot's quotes, which runs what stands behind `<` or `|` and knows names
/// such as `-` and `+`.
std::string gnuplot_file(const std::string& name);

/// A script's first line, a comment.
std::string gnuplot_head(const std::string& script);

}  // namespace hitos
