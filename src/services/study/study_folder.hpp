// SPDX-License-Identifier: GPL-3.0-or-later
// Where a study is worked on, and how what it has written is put in place.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hitos/base/folder_lock.hpp"
#include "hitos/base/message.hpp"
#include "hitos/services/results/results.hpp"
#include "hitos/services/study/study_result.hpp"

namespace hitos::study {

/// The tables of a study, which its records decide to the last byte.
std::vector<std::pair<std::filesystem::path, std::string>> tables(
    const StudyLayout& layout, const StudyPlan& plan, std::span<const StudyRecord> records);

/// The layout of another study that is under way in the folder of a whole one.
StudyLayout next_study(const StudyLayout& layout);

/// Whether publish() was interrupted while it put files in place.
bool is_interrupted(const StudyLayout& layout);

/// A study's folder while somebody works on it.
///
/// Runs are written into the folder as they are done, so that a study that was stopped goes on. If
/// the folder holds another study, that one stays as it is: the work is then done in a hidden
/// folder in it, and takes the other one's place when it is complete. What publish() writes goes
/// into a hidden folder first, with a list of all that belongs together (the journal); from the
/// moment that the journal is there, whoever opens the folder next finishes what was begun.
class StudyFolder {
  public:
    enum class Keep {
        alone,    ///< nobody else may work on the study
        shared,   ///< with others of the same plan; alone until share()
        not_kept  ///< the caller keeps a folder of many, and wants runs alone: they are in place
    };

    /// Makes the folder. Throws FileError where it cannot be made or written, or where others are
    /// at work who may not be there: any others of a whole study, those on another plan of a shard.
    StudyFolder(StudyLayout target, StudyPlan plan, Keep keep);

    /// The study that is there, to be put in order: the one that was worked on last. Throws
    /// FileError or FormatError where there is none.
    static StudyFolder of_last(const StudyLayout& target);
    /// The study that is in place, whatever is under way beside it.
    static StudyFolder in_place(const StudyLayout& target);

    const StudyPlan& plan() const { return plan_; }
    /// Where runs are written.
    const StudyLayout& work() const { return work_; }
    /// Whether another study's results are still in place.
    bool is_beside() const { return work_.folder != target_.folder; }
    /// Its folder, or its quality file where it lies beside others.
    std::filesystem::path place() const {
        return target_.prefix.empty() ? target_.folder : target_.quality_file();
    }

    /// Makes what runs need.
    void begin();
    /// To be called before a run is done anew: until publish() the plan file says that the study is
    /// not finished.
    void reopen();
    /// Lets other shards in.
    void share();

    /// The run's record, if it needs not be done anew; one of the other study in the folder is
    /// taken over.
    std::optional<StudyRecord> done(std::size_t run) const;

    /// Gives up what was done beside another study.
    void discard() const;

    struct Problems {
        Message plots;     ///< why there are none; empty where there are
        Message pictures;  ///< likewise of the contact sheet
    };
    /// Writes tables, plots and pictures and puts them in place together, and with them all runs
    /// where those are beside. `finished`: every run has a record. Throws FileError; the folder
    /// then has what it had.
    Problems publish(std::span<const StudyRecord> records, bool finished);

  private:
    StudyFolder(StudyLayout target, StudyPlan plan, StudyLayout work,
                std::unique_ptr<FolderLock> lock);
    void named(const std::function<void()>& work) const;
    std::vector<WrittenFile> written(const StudyLayout& staging) const;
    void give_up(const StudyLayout& staging) const;
    void clear_leftovers() const;

    StudyLayout target_;
    StudyPlan plan_;
    std::unique_ptr<FolderLock> lock_;
    StudyLayout work_;
};

}  // namespace hitos::study
