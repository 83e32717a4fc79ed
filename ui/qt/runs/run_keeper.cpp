// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_keeper.hpp"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QThreadPool>
#include <filesystem>
#include <system_error>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/base/staged_folder.hpp"
#include "hitos/services/results/results.hpp"
#include "look/user_files.hpp"

namespace hitos::window {
namespace {

constexpr const char* kFolder = "running";

std::filesystem::path results_in(const std::filesystem::path& place) {
    return place / "results";
}

}  // namespace

RunKeeper::RunKeeper(Session& session, QObject* parent) : QObject(parent), session_(session) {
    connect(&session, &Session::progress_changed, this, &RunKeeper::look);
    connect(&session, &Session::leaving, this, &RunKeeper::give_up);
}

RunKeeper::~RunKeeper() {
    give_up();
}

void RunKeeper::look() {
    // What was driven has a file of its own; until then results could name none.
    if (!place_.isEmpty() || session_.live_tour() ||
        session_.progress().state != Progress::State::finished ||
        session_.computed_seconds() < long_run_s_) {
        return;
    }
    keep();
}

/// A second chance only: where it cannot be written, the run is what it was, and nobody is
/// troubled.
void RunKeeper::keep() {
    const QFileInfo log(QString::fromStdString(session_.configuration().source.file));
    place_ = new_file_of_data(kFolder, log.completeBaseName(), "run");
    const std::string folder = place_.toStdString();
    const double seconds = session_.computed_seconds();
    const auto write = [folder, seconds, references = session_.references()](const Algoritmo& run) {
        try {
            StagedFolder results(results_folder(results_in(folder)));
            write_results(run, references, seconds, results, {}, nullptr, {}, [] { return true; });
        } catch (const std::exception&) {
            return;
        }
    };
    try {
        lock_ = std::make_shared<FolderLock>(folder);
    } catch (const Error&) {
        place_.clear();  // it is another window's
        return;
    }
    writing_ = session_.worker()->with_run(write).share();
}

/// Whoever goes on does not wait until all is written and taken away again.
void RunKeeper::give_up() {
    if (place_.isEmpty()) return;
    QThreadPool::globalInstance()->start([place = std::exchange(place_, {}),
                                          lock = std::exchange(lock_, nullptr),
                                          writing = std::exchange(writing_, {})] {
        if (writing.valid()) writing.wait();
        std::error_code ignored;
        // First what makes them results: nobody is told of what was taken away half.
        std::filesystem::remove(results_in(place.toStdString()) / "summary.json", ignored);
        std::filesystem::remove_all(place.toStdString(), ignored);
    });
}

void RunKeeper::let_stay() {
    if (writing_.valid()) writing_.wait();
    place_.clear();
    lock_ = nullptr;
}

QString RunKeeper::take_left() {
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + '/' +
                      kFolder);
    for (const QString& name : folder.entryList({"*.run"}, QDir::Dirs | QDir::Hidden)) {
        const std::filesystem::path place = folder.filePath(name).toStdString();
        try {
            const FolderLock lock(place);
            QString own;
            if (std::filesystem::exists(results_in(place) / "summary.json")) {
                own = new_file_of_data("results", QFileInfo(name).completeBaseName(), "run");
                std::filesystem::rename(results_in(place), own.toStdString());
            }
            std::filesystem::remove_all(place);
            if (!own.isEmpty()) return own;
        } catch (const std::exception&) {
            continue;  // of a window that is open, or not to be moved
        }
    }
    return {};
}

}  // namespace hitos::window
