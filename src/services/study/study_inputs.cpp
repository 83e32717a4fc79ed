#include "study_inputs.hpp"

#include <algorithm>
#include <string>

#include "hitos/base/error.hpp"

namespace hitos::study {
namespace {

bool same_state(const struct stat& a, const struct stat& b) {
    return a.st_dev == b.st_dev && a.st_ino == b.st_ino && a.st_size == b.st_size &&
           a.st_mtim.tv_sec == b.st_mtim.tv_sec && a.st_mtim.tv_nsec == b.st_mtim.tv_nsec;
}

}  // namespace

std::vector<std::vector<std::filesystem::path>> input_files(const Study& study) {
    std::vector<std::string> logs{study.configuration.source.file};
    for (const StudyParameter& parameter : study.parameters) {
        const auto key = std::ranges::find(parameter.keys, "source.file");
        if (key == parameter.keys.end()) continue;
        const auto component = static_cast<std::size_t>(key - parameter.keys.begin());
        logs.clear();
        for (const StudyValue& value : parameter.values) logs.push_back(value.at(component));
    }
    std::vector<std::vector<std::filesystem::path>> files;
    files.reserve(logs.size());
    for (const std::string& log : logs) {
        files.push_back(study.inputs ? study.inputs(log) : std::vector<std::filesystem::path>{log});
    }
    return files;
}

StudyInputs::StudyInputs(const Study& study) {
    for (const std::vector<std::filesystem::path>& log : input_files(study)) {
        for (const std::filesystem::path& file : log) {
            Input input{file, {}, false};
            input.there = ::stat(file.c_str(), &input.state) == 0;
            inputs_.push_back(std::move(input));
        }
    }
}

void StudyInputs::check() const {
    for (const Input& input : inputs_) {
        struct stat now {};
        const bool there = ::stat(input.file.c_str(), &now) == 0;
        if (there == input.there && (!there || same_state(now, input.state))) continue;
        throw FileError(input.file.string(),
                        message(HITOS_TEXT("Errors",
                                           "has changed while the study was at work; start it "
                                           "again when the file is complete")));
    }
}

}  // namespace hitos::study
