// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_inputs.hpp"

#include <algorithm>
#include <string>

namespace hitos::study {

namespace fs = std::filesystem;

std::vector<std::vector<fs::path>> input_files(const Study& study) {
    std::vector<std::string> logs{study.configuration.source.file};
    for (const StudyParameter& parameter : study.parameters) {
        const auto key = std::ranges::find(parameter.keys, "source.file");
        if (key == parameter.keys.end()) continue;
        const auto component = static_cast<std::size_t>(key - parameter.keys.begin());
        logs.clear();
        for (const StudyValue& value : parameter.values) logs.push_back(value.at(component));
    }
    std::vector<std::vector<fs::path>> files;
    files.reserve(logs.size());
    for (const std::string& log : logs) {
        files.push_back(study.inputs ? study.inputs(log) : std::vector<fs::path>{log});
    }
    return files;
}

std::vector<fs::path> all_input_files(const Study& study) {
    std::vector<fs::path> files;
    for (const std::vector<fs::path>& log : input_files(study)) {
        files.insert(files.end(), log.begin(), log.end());
    }
    return files;
}

}  // namespace hitos::study
