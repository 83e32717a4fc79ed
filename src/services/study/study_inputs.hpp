// The files that a study's runs are made of.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <vector>

#include "hitos/services/study/study.hpp"

namespace hitos::study {

/// Log by log, where the log is what varies.
std::vector<std::vector<std::filesystem::path>> input_files(const Study& study);

/// The files as they are when a study begins.
class StudyInputs {
  public:
    explicit StudyInputs(const Study& study);

    /// Throws FileError where one is another file now, or was written to: a run that read it is
    /// none of the study.
    void check() const;

  private:
    struct Input {
        std::filesystem::path file;
        struct stat state {};
        bool there = false;
    };
    std::vector<Input> inputs_;
};

}  // namespace hitos::study
