// SPDX-License-Identifier: GPL-3.0-or-later
// A small study for the tests of studies.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>

#include "hitos/services/study/study.hpp"
#include "support.hpp"

namespace hitos {

/// A robot that drives 3 m between the walls x = 4 and y = 2 and sees both.
inline std::string small_log() {
    std::string text;
    for (int i = 0; i <= 30; ++i) {
        const double time = 0.1 * i;
        const double x = 0.1 * i;
        text += "ODOM " + std::to_string(time) + (i == 0 ? " 0 0\n" : " 1 0\n");
        text += "LASER " + std::to_string(time) + " 60";
        for (int k = 0; k < 30; ++k)
            text += " " + std::to_string(4.0 - x) + " " + std::to_string(-1.0 + 0.1 * k);
        for (int k = 0; k < 30; ++k) text += " " + std::to_string(3.95 - x - 0.1 * k) + " 2";
        text += "\n";
    }
    return text;
}

/// A study of the small log in a folder of its own.
class StudyTest : public ::testing::Test {
  protected:
    Study study(const std::string& out) const {
        Study study;
        study.configuration.source.file = log_.string();
        study.configuration.filter.particles = 10;
        study.configuration.extraction.lines.min_points = 5;
        study.reference = parse_map("rho: 4 theta: 0\nrho: 2 theta: 90\nx: 4 y: 2\n", "reference");
        study.parameters = {parse_study_parameter("dmax=0.02,0.05"),
                            parse_study_parameter("p=2,3")};
        study.seeds = 3;
        study.layout = study_in_folder(folder_ / out);
        return study;
    }

    static StudyOutcome run(const Study& study, StudyOptions options = {}) {
        if (options.threads == 0) options.threads = 1;
        return std::move(run_studies({&study, 1}, options).front());
    }

    /// Every file's content but for the times, by its name.
    std::map<std::string, std::string> files(const std::string& out) const {
        std::map<std::string, std::string> files;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / out)) {
            const std::string name =
                std::filesystem::relative(entry.path(), folder_ / out).string();
            if (entry.is_regular_file() && name != "timing.csv" && !name.starts_with("runs/")) {
                files[name] = test::content(entry.path());
            }
        }
        return files;
    }

    test::TempFolder folder_;
    std::filesystem::path log_ = folder_.put("small.log", small_log());
};

}  // namespace hitos
