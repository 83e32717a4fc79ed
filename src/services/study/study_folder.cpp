// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_folder.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <system_error>

#include "hitos/base/atomic_file.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/file_exchange.hpp"
#include "hitos/base/folder_entries.hpp"
#include "hitos/base/staged_folder.hpp"
#include "hitos/base/text_input.hpp"
#include "json_input.hpp"
#include "results/written_files.hpp"
#include "study_files.hpp"
#include "study_pictures.hpp"
#include "study_plot.hpp"

namespace hitos::study {
namespace {

namespace fs = std::filesystem;

constexpr const char* kJournal = "journal.json";

/// A layout's hidden folder, in its own, so that its files can take the places of others in a step.
StudyLayout hidden(const StudyLayout& layout, const char* word) {
    return {layout.folder / ("." + plan_file(layout).filename().string() + ".hitos-" + word),
            layout.prefix, layout.quality};
}

/// Where what publish() writes of a study in place waits.
StudyLayout staging_of(const StudyLayout& layout) {
    return hidden(layout, "new");
}

/// Throws FileError where nobody knows: who takes it for another study works beside those that are
/// at work on this one.
std::optional<StudyPlan> plan_in(const StudyLayout& layout) {
    try {
        if (!is_file(plan_file(layout))) return std::nullopt;
        return read_plan(layout);
    } catch (const FormatError&) {
        return std::nullopt;  // none that can be gone on with
    }
}

bool holds_plan(const StudyLayout& layout, const StudyPlan& plan) {
    const std::optional<StudyPlan> there = plan_in(layout);
    return there && same(*there, plan);
}

/// Likewise, but a file that cannot be read is none of another study.
bool is_same_plan(const StudyLayout& layout, const StudyPlan& plan) {
    try {
        return same(read_plan(layout), plan);
    } catch (const FormatError&) {
        return false;
    }
}

std::string relative(const fs::path& file, const StudyLayout& layout) {
    return file.lexically_relative(layout.folder).string();
}

/// Whether it tells times, which differ from run to run.
bool holds_times(const StudyLayout& layout, const std::string& name) {
    return name == layout.prefix + "timing.csv" ||
           (name.starts_with(layout.prefix + "runs/") && name.ends_with(".json"));
}

/// What the folder has of the plan's runs.
void list_runs(const StudyLayout& layout, const StudyPlan& plan, std::set<std::string>& names) {
    for (std::size_t run = 0; run < plan.runs(); ++run) {
        std::vector<fs::path> files = run_files(layout, plan, run);
        files.push_back(record_file(layout, plan, run));
        for (const fs::path& file : files) {
            if (is_there(file)) names.insert(relative(file, layout));
        }
    }
}

/// What a former study has left in the folder, by its list, its plan and the names of tables.
std::set<std::string> former_files(const StudyLayout& layout, bool with_runs) {
    std::set<std::string> names;
    if (!is_there(plan_file(layout))) return names;  // whatever their names, they are somebody's
    try {
        for (const WrittenFile& file : read_plan_state(layout).files) {
            if (with_runs || !is_of_run(layout, file.name)) names.insert(file.name);
        }
        if (!names.empty()) names.insert(layout.prefix + "timing.csv");
        if (with_runs) list_runs(layout, read_plan(layout), names);
        return names;
    } catch (const FormatError&) {
        names.clear();  // of an older version, or damaged: by the names of tables
    }
    for (const fs::directory_entry& entry : folder_entries(layout.folder)) {
        const std::string name = entry.path().filename().string();
        if (is_table(layout, name) && !entry.is_directory()) names.insert(name);
    }
    return names;
}

FormatError lost(const StudyLayout& layout, const WrittenFile& file) {
    return {
        (layout.folder / file.name).string(), 0,
        message(HITOS_TEXT(
            "Errors",
            "was changed or lost while the study was put in place; start the same command again"))};
}

/// Puts in place what the journal in `staging` lists, the plan file last, and takes away what is of
/// the study before. Going on after an interruption it finds what is still to be done by the
/// contents.
void install(const StudyLayout& staging, const StudyLayout& target) {
    const fs::path journal = staging.folder / kJournal;
    std::vector<WrittenFile> files;
    bool with_runs = false;
    try {
        const auto json = parsed<nlohmann::json>(input::read_text(journal), journal.string());
        files = files_named(json, journal, true);
        with_runs = json.at("with_runs");
    } catch (const nlohmann::json::exception& error) {
        throw FormatError(journal.string(), 0, HITOS_TEXT("Errors", "is no list of files: %1"),
                          error.what());
    } catch (const FileError& error) {
        // Nobody knows of the folder in which it really is.
        throw error.replaced(staging.folder.string(), target.folder.string());
    }
    const std::string seal = relative(plan_file(target), target);
    FileExchange exchange(staging.folder, target.folder);
    std::set<std::string> former = former_files(target, with_runs);
    const auto put = [&](const WrittenFile& file) {
        if (is_unchanged(file, staging.folder)) exchange.add(file.name);
    };
    for (const WrittenFile& file : files) {
        check_no_folder(target.folder / file.name);
        former.erase(file.name);
    }
    exchange.flush();  // else a loss of power may take the folder in which the former files wait
    for (const WrittenFile& file : files) {
        if (file.name != seal) put(file);
    }
    for (const std::string& name : former) {
        if (is_there(target.folder / name)) exchange.add(name);
    }
    exchange.flush();
    for (const WrittenFile& file : files) {
        if (file.name != seal && !is_unchanged(file, target.folder)) throw lost(target, file);
    }
    for (const WrittenFile& file : files) {
        if (file.name == seal) put(file);
    }
    exchange.flush();
    exchange.keep();
    // The former plan first: without the journal it would pass for a study that waits.
    for (const fs::path& path : {plan_file(staging), journal, staging.folder}) remove_whole(path);
}

/// The names of all that a study may have, whether it is there or not.
std::set<std::string> names_of(const StudyLayout& layout) {
    std::set<std::string> names = former_files(layout, true);
    if (!is_file(plan_file(layout))) return names;
    const StudyPlan plan = read_plan(layout);
    for (std::size_t run = 0; run < plan.runs(); ++run) {
        for (const fs::path& file : run_files(layout, plan, run))
            names.insert(relative(file, layout));
        names.insert(relative(record_file(layout, plan, run), layout));
    }
    return names;
}

/// Of an installation that cannot be finished: what has changed places goes back, the former
/// study's files too; tables that are put in place are no others' than its own.
void take_back(const StudyLayout& staging, const StudyLayout& target) {
    const fs::path journal = staging.folder / kJournal;
    std::set<std::string> own;
    std::vector<WrittenFile> files;
    try {
        files = files_named(parsed<nlohmann::json>(input::read_text(journal), journal.string()),
                            journal, true);
        own = names_of(target);
    } catch (const FormatError&) {
        return;  // nobody knows what it has put there
    } catch (const nlohmann::json::exception&) {
        return;
    }
    FileExchange exchange(staging.folder, target.folder);
    const std::string seal = relative(plan_file(target), target);
    for (const WrittenFile& file : files) {
        const bool was_own = own.erase(file.name) > 0;
        if (file.name == seal || !is_unchanged(file, target.folder)) continue;
        if (was_own) {
            // One with the very same bytes never went anywhere.
            const bool moved = is_there(staging.folder / file.name);
            if (moved && !is_unchanged(file, staging.folder)) exchange.add(file.name);
        } else if (is_of_run(target, file.name)) {
            exchange.add(file.name);
        } else {
            remove_whole(target.folder / file.name);
        }
    }
    for (const std::string& name : own) {
        const bool waits = is_there(staging.folder / name) && !is_there(target.folder / name);
        if (waits && name != seal) exchange.add(name);
    }
    exchange.flush();
    exchange.keep();
}

/// Finishes what an interrupted publish() began. Only where nobody else is at work.
void settle(const StudyLayout& target) {
    for (const StudyLayout& staging : {staging_of(target), next_study(target)}) {
        try {
            if (is_there(staging.folder / kJournal)) install(staging, target);
        } catch (const FormatError&) {
            // What it lists is not there as it was: then it is as if it had not begun.
            take_back(staging, target);
            remove_whole(staging.folder / kJournal);
        }
    }
    remove_whole(staging_of(target).folder);
    const StudyLayout next = next_study(target);
    if (!is_there(plan_file(next))) remove_whole(next.folder);
}

std::unique_ptr<FolderLock> lock_of(const StudyLayout& target, StudyFolder::Keep keep) {
    made_output_folder(target.folder);
    if (keep == StudyFolder::Keep::not_kept) return nullptr;
    if (keep == StudyFolder::Keep::alone) return std::make_unique<FolderLock>(plan_file(target));
    return std::make_unique<FolderLock>(plan_file(target), FolderLock::Shared{});
}

/// Whether somebody began to work on `a` after the last one on `b`.
bool is_newer(const StudyLayout& a, const StudyLayout& b) {
    std::error_code ignored;
    return fs::last_write_time(plan_file(a), ignored) > fs::last_write_time(plan_file(b), ignored);
}

/// No folder is made for a study that is not there.
void check_there(const StudyLayout& target) {
    if (!is_there(plan_file(target)) && !is_there(plan_file(next_study(target)))) {
        read_plan(target);  // throws
    }
}

StudyLayout work_place(const StudyLayout& target, const StudyPlan& plan) {
    if (holds_plan(target, plan)) return target;
    if (is_file(plan_file(target)) || holds_plan(next_study(target), plan))
        return next_study(target);
    return target;
}

void check_others(const StudyLayout& target, const StudyPlan& plan, const FolderLock* lock) {
    if (lock == nullptr || lock->alone() || holds_plan(target, plan) ||
        holds_plan(next_study(target), plan)) {
        return;
    }
    throw FileError(
        plan_file(target).string(),
        HITOS_TEXT(
            "Errors",
            "is the plan of another study, on which others are at work: program, configuration, "
            "log, values or seeds differ; wait for them or choose another folder"));
}

/// Tables without a plan are of no study: whatever their names, they are somebody's.
void check_nobodys(const StudyLayout& target) {
    for (const StudyLayout& layout : {target, next_study(target)})
        if (is_there(plan_file(layout))) return;
    for (const fs::path& file : {target.quality_file(), target.file("summary.csv"),
                                 target.file("summary.md"), target.file("summary.tex")}) {
        if (!is_there(file)) continue;
        throw FileError(target.folder.string(),
                        HITOS_TEXT("Errors",
                                   "holds %1, which is of no study and would be written over; move "
                                   "it away or choose another folder"),
                        file.filename().string());
    }
}

/// What stayed would be taken for a part of the study that comes there.
void take_away(const fs::path& path) {
    remove_whole(path);
    if (!is_there(path)) return;
    throw FileError(path.parent_path().string(),
                    HITOS_TEXT("Errors",
                               "cannot be written: %1, which a process has left, cannot be "
                               "removed; remove it by hand"),
                    path.string());
}

void remove_tables(const StudyLayout& layout) {
    std::vector<fs::path> tables{layout.file("pictures")};
    for (const fs::directory_entry& entry : folder_entries(layout.folder)) {
        if (is_table(layout, entry.path().filename().string())) tables.push_back(entry.path());
    }
    for (const fs::path& table : tables) take_away(table);
}

void write_tables(const StudyLayout& layout, const StudyPlan& plan,
                  std::span<const StudyRecord> records) {
    for (const auto& [file, text] : tables(layout, plan, records)) write_file(file, text);
}

/// What can be done without: why it could not be done, else an empty text.
Message attempted(const std::function<Message()>& write) {
    try {
        return write();
    } catch (const std::exception& error) {  // of a library too
        return message_of(error);
    }
}

}  // namespace

std::vector<std::pair<fs::path, std::string>> tables(const StudyLayout& layout,
                                                     const StudyPlan& plan,
                                                     std::span<const StudyRecord> records) {
    const std::vector<StudyCell> cells = summarize(plan, records);
    return {{layout.quality_file(), quality_csv(layout, plan, records)},
            {layout.file("summary.csv"), summary_csv(plan, cells)},
            {layout.file("summary.md"), summary_markdown(plan, cells)},
            {layout.file("summary.tex"), summary_latex(plan, cells)},
            {layout.file("timing.csv"), timing_csv(plan, records)}};
}

StudyLayout next_study(const StudyLayout& layout) {
    return hidden(layout, "next");
}

bool is_interrupted(const StudyLayout& layout) {
    return is_there(staging_of(layout).folder / kJournal) ||
           is_there(next_study(layout).folder / kJournal);
}

StudyFolder::StudyFolder(StudyLayout target, StudyPlan plan, StudyLayout work,
                         std::unique_ptr<FolderLock> lock)
    : target_(std::move(target)),
      plan_(std::move(plan)),
      lock_(std::move(lock)),
      work_(std::move(work)) {}

StudyFolder::StudyFolder(StudyLayout target, StudyPlan plan, Keep keep)
    : target_(std::move(target)), plan_(std::move(plan)), lock_(lock_of(target_, keep)) {
    check_others(target_, plan_, lock_.get());
    if (lock_ == nullptr || lock_->alone()) settle(target_);
    check_nobodys(target_);
    work_ = lock_ == nullptr ? target_ : work_place(target_, plan_);
}

StudyFolder StudyFolder::of_last(const StudyLayout& target) {
    check_there(target);
    auto lock = lock_of(target, Keep::alone);
    settle(target);
    const StudyLayout next = next_study(target);
    const bool beside = plan_in(next) && (!plan_in(target) || is_newer(next, target));
    const StudyLayout work = beside ? next : target;
    return {target, read_plan(work), work, std::move(lock)};
}

StudyFolder StudyFolder::in_place(const StudyLayout& target) {
    check_there(target);
    auto lock = lock_of(target, Keep::alone);
    settle(target);
    return {target, read_plan(target), target, std::move(lock)};
}

/// Nobody knows of the folder in which the work is really done.
void StudyFolder::named(const std::function<void()>& work) const {
    try {
        work();
    } catch (const FileError& error) {
        throw error.replaced(work_.folder.string(), target_.folder.string());
    }
}

void StudyFolder::begin() {
    bool known = false;
    named([&] { known = is_there(plan_file(work_)) && is_same_plan(work_, plan_); });
    if (is_beside() && !known) take_away(work_.folder);  // of a third study
    named([&] {
        made_output_folder(work_.folder);
        made_output_folder(work_.file("maps"));
        made_output_folder(work_.file("runs"));
        // Destroyed without commit, the probe leaves nothing behind.
        AtomicFile(target_.quality_file()).write("");
        if (!known) write_plan(work_, plan_);
    });
    std::error_code ignored;
    fs::last_write_time(plan_file(work_), fs::file_time_type::clock::now(), ignored);
    if (lock_ == nullptr || lock_->alone()) clear_leftovers();
}

/// Of those that were killed: only where nobody else is at work.
void StudyFolder::clear_leftovers() const {
    for (const char* folder : {"maps", "runs", "pictures"}) {
        remove_leftovers(work_.file(folder));
        remove_leftovers(target_.file(folder));
    }
    // Where several share the folder, others may be at work in it.
    if (target_.prefix.empty()) {
        remove_leftovers(target_.folder);
        remove_leftovers(work_.folder);
    }
}

void StudyFolder::reopen() {
    named([&] {
        PlanState state = read_plan_state(work_);
        if (std::exchange(state.finished, false)) write_plan(work_, plan_, state);
    });
}

void StudyFolder::share() {
    if (lock_) lock_->share();
}

std::optional<StudyRecord> StudyFolder::done(std::size_t run) const {
    std::optional<StudyRecord> record;
    named([&] {
        record = read_record(work_, plan_, run);
        if (record || !is_beside()) return;
        record = read_record(target_, plan_, run);
        if (record && !record->ok) record.reset();
        if (record && !plan_.pictured(run)) record->picture.reset();
        if (record) copy_run(target_, work_, plan_, run, *record);
    });
    return record;
}

void StudyFolder::discard() const {
    if (is_beside()) remove_whole(work_.folder);
}

/// All that belongs together once the tables are in `staging`; the runs are there or at `work`.
std::vector<WrittenFile> StudyFolder::written(const StudyLayout& staging) const {
    std::vector<WrittenFile> files = written_files(staging.folder);
    const std::string seal = relative(plan_file(staging), staging);
    std::erase_if(files, [&](const WrittenFile& file) { return file.name == seal; });
    if (!is_beside()) {
        std::set<std::string> runs;
        list_runs(work_, plan_, runs);
        for (const std::string& name : runs) files.push_back(written_file(work_.folder, name));
    }
    std::ranges::sort(files, {}, &WrittenFile::name);
    return files;
}

StudyFolder::Problems StudyFolder::publish(std::span<const StudyRecord> records, bool finished) {
    clear_leftovers();
    const StudyLayout staging = is_beside() ? work_ : staging_of(target_);
    try {
        made_output_folder(staging.folder);
        remove_tables(staging);  // of an attempt that failed
        remove_leftovers(staging.folder);
        Problems problems;
        write_tables(staging, plan_, records);
        problems.plots =
            attempted([&] { return write_plots(staging, plan_, summarize(plan_, records)); });
        problems.pictures =
            attempted([&] { return write_pictures(work_, staging, plan_, records); });
        std::vector<WrittenFile> files = written(staging);
        PlanState state{finished, files};
        std::erase_if(state.files,
                      [&](const WrittenFile& file) { return holds_times(target_, file.name); });
        write_plan(staging, plan_, state);
        files.push_back(written_file(staging.folder, relative(plan_file(staging), staging)));
        write_file(
            staging.folder / kJournal,
            nlohmann::ordered_json{{"with_runs", is_beside()}, {"files", json_of(files)}}.dump(1) +
                "\n");
        install(staging, target_);
        work_ = target_;
        const auto told = [&](const Message& problem) {
            return problem.replaced(staging.folder.string(), target_.folder.string());
        };
        return {told(problems.plots), told(problems.pictures)};
    } catch (const std::exception& error) {
        give_up(staging);
        const auto* file = dynamic_cast<const FileError*>(&error);
        if (file == nullptr) throw;
        // Nobody knows of the folder in which it really was.
        throw file->replaced(staging.folder.string(), target_.folder.string());
    }
}

/// After a failure: runs that were done beside stay for the next time.
void StudyFolder::give_up(const StudyLayout& staging) const {
    remove_whole(staging.folder / kJournal);
    if (!is_beside()) remove_whole(staging.folder);
}

}  // namespace hitos::study
