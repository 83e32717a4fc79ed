// SPDX-License-Identifier: GPL-3.0-or-later
#include "hitos/services/results/results_check.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

#include "hitos/base/error.hpp"
#include "hitos/base/file_exchange.hpp"
#include "hitos/base/folder_entries.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "results_summary.hpp"
#include "run_outputs.hpp"
#include "written_files.hpp"

namespace hitos {

namespace fs = std::filesystem;

namespace {

constexpr const char* kConfigFile = "config.cfg";

/// What the summary says of the run's settings is what stands in config.cfg.
void expect_settings(const fs::path& folder) {
    const fs::path file = folder / kConfigFile;
    if (!is_file(file)) return;  // which is told as missing
    const Configuracion settings = ArchivoConfiguracion::read(file);
    with_summary(folder, [&](const nlohmann::json& json) {
        const std::string summary = (folder / kSummaryFile).string();
        const auto expect = [&](const char* name, const char* parameter) {
            if (!json.contains(name)) return;
            const std::string set = find_parameter(parameter).text(settings);
            const nlohmann::json& stated = json.at(name);
            const std::string said = stated.is_string() ? stated.get<std::string>() : stated.dump();
            if (said == set) return;
            throw FormatError(summary, 0,
                              HITOS_TEXT("Errors",
                                         "says %1 %2, and config.cfg beside it %3; one of the two "
                                         "was changed or is of another run"),
                              name, said, set);
        };
        expect("algorithm", "filter.algorithm");
        expect("seed", "run.seed");
        expect("particles", "filter.particles");
        return 0;
    });
}

}  // namespace

ResultsCheck check_results(const fs::path& folder) {
    const fs::path summary = folder / kSummaryFile;
    ResultsCheck check;
    const auto files = with_summary(folder, [&](const nlohmann::json& json) {
        check.finished = json.value("finished", true);
        for (const nlohmann::json& one : json.value("not_written", nlohmann::json::array())) {
            check.not_written.push_back(one.at("file").get<std::string>() + ": " +
                                        one.at("reason").get<std::string>());
        }
        return files_named(json, summary);
    });
    if (files.empty()) {
        throw FormatError(summary.string(), 0,
                          HITOS_TEXT("Errors",
                                     "does not name the files of the run, as summaries before "
                                     "the first release did not; run it again to have them "
                                     "checked"));
    }
    check.files = files.size();
    for (const WrittenFile& file : files) {
        if (!is_file(folder / file.name)) {
            check.missing.push_back(file.name);
        } else if (!is_unchanged(file, folder)) {
            check.changed.push_back(file.name);
        }
    }
    if (!std::ranges::count(check.changed, kConfigFile)) expect_settings(folder);
    for (const fs::directory_entry& entry : folder_entries(folder)) {
        const std::string name = entry.path().filename().string();
        if (is_run_output(name) && !std::ranges::count(files, name, &WrittenFile::name)) {
            check.left_over.push_back(name);
        }
    }
    std::ranges::sort(check.left_over);
    return check;
}

}  // namespace hitos
