// SPDX-License-Identifier: GPL-3.0-or-later
// Runs: RunWorker, which window and command line use too, driven from Python.

#include "runs.hpp"

#include <fmt/format.h>

#include <chrono>
#include <future>
#include <utility>
#include <vector>

#include "hitos/services/evaluation/reference_fit.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "python_calls.hpp"
#include "references.hpp"

namespace hitos::python {
namespace {

using Clock = std::chrono::steady_clock;

/// Whether the answer of a progress callback asks to go on: anything but False.
bool goes_on(const py::object& answer) {
    return answer.ptr() != Py_False;
}

}  // namespace

class Run::Turn {
  public:
    explicit Turn(const Run& run) : taken_(run.taken_) {
        if (taken_.exchange(true)) {
            throw Error(
                verbatim("this run is under way already, by another thread or by the "
                         "function that asks; wait for it, or make a run of its own"));
        }
    }
    ~Turn() { taken_ = false; }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

  private:
    std::atomic<bool>& taken_;
};

class Run::Reading {
  public:
    explicit Reading(Run& run) : run_(run) {
        // A signal's handler may ask again in the midst of it; Turn refuses that.
        if (run_.reader_.load() == std::this_thread::get_id()) return;
        while (!without_python([this] { return run_.reading_.try_lock_for(kPoll); })) {
            if (interrupted()) throw py::error_already_set();
        }
        run_.reader_ = std::this_thread::get_id();
        holds_ = true;
    }
    ~Reading() {
        if (!holds_) return;
        run_.reader_ = std::thread::id();
        run_.reading_.unlock();
    }
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;

  private:
    Run& run_;
    bool holds_ = false;
};

Run::Run(Configuracion configuration, References references, bool uncertainty)
    : configuration_(std::move(configuration)),
      references_(std::move(references)),
      inputs_(without_python([&] { return InputFiles(tour_files(configuration_.source)); })) {
    AlgoritmoOptions options;
    options.uncertainty = uncertainty;
    std::vector<Advice> doubts;
    worker_ = ended_without_python(without_python([&] {
        std::unique_ptr<TourReader> reader = open_tour(configuration_);
        if (references_.trajectory) {
            doubts = fit_of_reference(*reader, *references_.trajectory, references_.tolerance_s)
                         .doubts();
        }
        add_truth(references_, reader->truth());
        return std::make_unique<RunWorker>(configuration_, std::move(reader), options);
    }));
    for (const Advice& doubt : doubts) tell(doubt);
}

Progress Run::progress() const {
    return without_python([this] { return worker_->progress(); });
}

void Run::advance(std::uint64_t scans, const py::object& told) {
    const Work under_way;
    const Turn turn(*this);
    const Clock::time_point begin = Clock::now();
    const auto rest = [&] {
        without_python([this] {
            worker_->pause();
            worker_->wait();
        });
    };
    without_python([&] { worker_->run(scans); });
    for (;;) {
        const Progress now = without_python([this] {
            worker_->wait_for(kPoll);
            return worker_->progress();
        });
        if (interrupted()) {
            const py::error_already_set raised;
            rest();
            throw py::error_already_set(raised);
        }
        const bool going = now.state == Progress::State::running;
        if (now.state == Progress::State::failed) {
            rest();
            std::rethrow_exception(now.failure);
        }
        if (!told.is_none()) {
            try {
                if (!goes_on(told(now)) && going) {
                    rest();
                    break;
                }
            } catch (const py::error_already_set&) {
                rest();
                throw;
            }
        }
        if (!going) break;
    }
    seconds_ += std::chrono::duration<double>(Clock::now() - begin).count();
}

std::shared_ptr<const Snapshot> Run::newest_snapshot() {
    std::shared_ptr<const Snapshot> shown = without_python([this] {
        worker_->request_snapshot();
        worker_->wait();
        return worker_->latest_snapshot();
    });
    const Progress now = progress();
    if (now.state == Progress::State::failed) std::rethrow_exception(now.failure);
    return shown;
}

std::shared_ptr<State> Run::snapshot() {
    const Turn turn(*this);
    std::shared_ptr<const Snapshot> shown = newest_snapshot();
    return std::make_shared<State>(std::move(shown), progress().state == Progress::State::finished);
}

std::shared_ptr<Result> Run::result() {
    const Turn turn(*this);
    std::shared_ptr<const Snapshot> shown = newest_snapshot();
    // Between steps, so that all of it is of one moment.
    auto [grid, figures] = without_python([this] {
        auto task =
            worker_->with_run([](const Algoritmo& run) { return array_of(run.step_grid()); });
        return std::pair(task.get(), worker_->figures_since(0));
    });
    return std::make_shared<Result>(shared_from_this(), std::move(shown),
                                    progress().state == Progress::State::finished, std::move(grid),
                                    figures);
}

void Run::check_revision(std::uint64_t revision) const {
    if (progress().revision != revision) {
        throw Error(verbatim("the run has gone on since; ask it for its result() anew"));
    }
}

std::string Run::summary(std::uint64_t revision) {
    const Work under_way;
    const Reading reading(*this);
    const Turn turn(*this);
    check_revision(revision);
    return wait_for<std::string>(worker_->with_run([this](const Algoritmo& run) {
        return to_json(summarize(run, references_), seconds_);
    }),
                                 [] {});
}

std::unique_ptr<StagedFolder> Run::folder_for(const std::filesystem::path& path,
                                              const std::vector<std::string>& also) const {
    std::error_code ignored;
    for (const std::filesystem::path& file : tour_files(configuration_.source)) {
        const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
        if (is_results_file(file.filename()) &&
            std::filesystem::equivalent(folder, path, ignored)) {
            throw FileError(file.string(), verbatim("is read by the run and has the name of one "
                                                    "of its results; choose another folder"));
        }
    }
    if (const auto name = somebodys_file(path, also)) {
        throw FileError(path.string(),
                        verbatim(fmt::format("holds {}, which is of no run and would be written "
                                             "over; choose another folder",
                                             *name)));
    }
    // It knows where it is, and so is made in its place.
    // NOLINTNEXTLINE(modernize-make-unique)
    return std::unique_ptr<StagedFolder>(new StagedFolder(results_folder(path)));
}

std::string Run::write(std::uint64_t revision, const std::filesystem::path& folder,
                       const std::vector<std::string>& also) {
    const Reading reading(*this);
    const std::unique_ptr<StagedFolder> staged = folder_for(folder, also);
    return write(revision, *staged, also);
}

std::string Run::write(std::uint64_t revision, StagedFolder& folder,
                       const std::vector<std::string>& also) {
    const Work under_way;
    const Reading reading(*this);
    const Turn turn(*this);
    check_revision(revision);
    std::atomic<bool> stopped = false;
    const WritingObserver told = [&](const WritingProgress& /*now*/) {
        if (stopped) throw Error(verbatim("stopped"));
        inputs_.check();  // the tour is read once more for the grids
    };
    return wait_for<std::string>(worker_->with_run([&](const Algoritmo& run) {
        return to_json(write_results(run, references_, seconds_, folder, told, nullptr, also),
                       seconds_);
    }),
                                 [&] { stopped = true; });
}

Result::Result(std::shared_ptr<Run> run, std::shared_ptr<const Snapshot> shown, bool finished,
               std::shared_ptr<const GridArray> grid, const std::vector<StepFigures>& figures)
    : State(std::move(shown), finished), run_(std::move(run)), figures_(rows_of(figures)) {
    set_grid(std::move(grid));
}

}  // namespace hitos::python
