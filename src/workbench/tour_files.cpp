// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/workbench/tour_files.hpp"

#include <vector>

#include "hitos/base/error.hpp"
#include "hitos/base/input_files.hpp"
#include "hitos/base/staged_files.hpp"
#include "hitos/capture/log_format.hpp"
#include "hitos/capture/log_writer.hpp"
#include "hitos/services/files/map_file.hpp"
#include "hitos/services/files/trajectory_file.hpp"
#include "hitos/simulation/drive/simulated_tour_reader.hpp"
#include "hitos/simulation/worlds/reference_map.hpp"
#include "tour_picture.hpp"

namespace hitos {

namespace fs = std::filesystem;

void write_tour_files(const std::shared_ptr<const SimulatedTour>& tour, const TourFiles& files,
                      std::span<const fs::path> inputs,
                      const std::function<void(const TourReader&)>& told) {
    const std::string format = checked_target_format(files.format, files.log.string());
    // As the robot would have recorded it: whoever reads the log unwarps it.
    SimulatedTourReader reader(tour, ReadOptions{.mend = Mend::nothing});
    // The log comes last: it is what all the others belong to.
    std::vector<fs::path> outputs;
    for (const fs::path& file : {files.picture, files.truth, files.reference, files.log}) {
        if (!file.empty()) outputs.push_back(file);
    }
    check_apart(outputs, inputs);
    StagedFiles staged(outputs);
    staged.write([&] {
        const auto to = [&](const fs::path& file) { return staged.staged(file).string(); };
        if (!files.picture.empty()) write_tour_picture(*tour, to(files.picture));
        if (!files.truth.empty()) write_trajectory(reader.truth()->path, to(files.truth));
        if (!files.reference.empty()) {
            write_map(reference_map(tour->world()), to(files.reference));
        }
        if (files.log.empty()) return;
        const auto writer = make_log_writer(format, to(files.log));
        try {
            write_tour(reader, *writer, [&] {
                if (told) told(reader);
            });
        } catch (const FormatError& error) {
            // Nobody knows of the file in which it really is.
            throw FormatError(files.log.string(), error.line(), error.problem());
        }
        writer->finish();
    });
    staged.commit();
}

fs::path truth_beside(const fs::path& log) {
    fs::path name = log.filename();
    if (name.extension() == ".gz") name = name.stem();
    name = name.stem();
    name += ".truth.tum";
    return log.parent_path() / name;
}

}  // namespace hitos
