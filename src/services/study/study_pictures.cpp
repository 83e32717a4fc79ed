// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/study/study_pictures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "hitos/base/error.hpp"
#include "hitos/base/staged_folder.hpp"
#include "hitos/services/drawing/contact_sheet.hpp"
#include "hitos/services/files/trajectory_file.hpp"
#include "study_files.hpp"
#include "study_pictures.hpp"

namespace hitos::study {
namespace {

namespace fs = std::filesystem;

constexpr int kLongestTile = 600;  // pixels a side: more than a sheet shows, so that many fit

/// A small map is drawn larger, so that its path and marks do not hide it.
int scale_of(const MapImage& map) {
    constexpr int kWanted = 800;  // pixels of the longer side
    constexpr int kMost = 4;
    return std::clamp(kWanted / std::max({map.picture.width, map.picture.height, 1}), 1, kMost);
}

/// The value, then what was measured.
std::vector<std::string> caption_of(const StudyPlan& plan, std::size_t run,
                                    const StudyRecord& record) {
    std::string first = plan.cell_label(plan.cell_of(run));
    if (first.empty() || plan.pictures == StudyPictures::all) first = plan.label(run);
    if (!record.ok) return {std::move(first), "failed"};
    std::vector<std::string> words;
    const char* error = record.figures["error_m"] ? "error_m" : "trajectory_error_m";
    for (const char* word : {error, "landmarks", "blur_m2"}) {
        const Measure& measure = run_measures().find(word);
        if (const std::optional<double>& value = record.figures[measure]) {
            const std::string number = measure.rounded(*value, false);
            words.push_back(measure.is_count() ? fmt::format("{} {}", number, measure.label)
                                               : fmt::format("{} {} {}", measure.label, number,
                                                             plain_unit(measure.unit)));
        }
    }
    return {std::move(first), fmt::format("{}", fmt::join(words, ", "))};
}

/// One row for each value of the first parameter where there are two, or for all runs of a value.
int columns_of(const StudyPlan& plan) {
    const int runs = plan.pictures == StudyPictures::all ? plan.seeds : 1;
    if (plan.axes.size() > 1) return static_cast<int>(plan.axes[1].values.size()) * runs;
    return runs > 1 ? runs : 0;
}

std::string title_of(const StudyPlan& plan) {
    std::vector<std::string> names;
    names.reserve(plan.axes.size());
    for (const StudyPlan::Axis& axis : plan.axes) names.push_back(axis.name);
    std::string title = plan.source;
    if (!names.empty()) title += fmt::format(": {}", fmt::join(names, ", "));
    if (plan.pictures == StudyPictures::first) title += fmt::format(", seed {}", plan.first_seed);
    return title;
}

}  // namespace

Message write_pictures(const StudyLayout& runs, const StudyLayout& out, const StudyPlan& plan,
                       std::span<const StudyRecord> records) {
    if (plan.pictures == StudyPictures::none) return {};
    const fs::path folder = made_output_folder(out.file("pictures"));
    ContactSheet sheet;
    sheet.title = title_of(plan);
    sheet.columns = columns_of(plan);
    for (std::size_t run = 0; run < records.size(); ++run) {
        if (!plan.pictured(run)) continue;
        SheetTile tile = study_tile(runs, plan, run, records[run]);
        if (records[run].picture) {
            write_picture(tile.map,
                          {scale_of(tile.map), tile.paths, true, PathMarks::cross_and_ring},
                          folder / (plan.file_stem(run) + ".png"));
        }
        tile.map = shrunk(std::move(tile.map), kLongestTile);
        sheet.tiles.push_back(std::move(tile));
    }
    try {
        write_contact_sheet(sheet, out.file("contact-sheet.png"));
    } catch (const Error& error) {
        return error.message();
    }
    return {};
}

}  // namespace hitos::study

namespace hitos {

SheetTile study_tile(const StudyLayout& layout, const StudyPlan& plan, std::size_t run,
                     const StudyRecord& record) {
    SheetTile tile;
    tile.caption = study::caption_of(plan, run, record);
    if (!record.picture) return tile;
    tile.map = {read_grey_picture(study::grid_file(layout, plan, run)), record.picture->origin,
                record.picture->m_per_pixel};
    tile.paths = lines_of(read_trajectory(study::path_file(layout, plan, run)));
    return tile;
}

}  // namespace hitos
