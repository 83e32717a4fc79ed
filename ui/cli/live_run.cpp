// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "damage.hpp"
#include "hitos/base/error.hpp"
#include "hitos/base/plural.hpp"
#include "hitos/base/process.hpp"
#include "hitos/slam/slam_filter.hpp"
#include "options.hpp"

namespace hitos::cli {
namespace {

namespace fs = std::filesystem;

bool is_standard_input(std::string_view log) {
    return log == "-" || log == "/dev/stdin";
}

/// "results.received": what comes in is kept beside the folder, so that it is there whatever
/// becomes of the run.
fs::path name_beside(const std::string& out) {
    fs::path folder = fs::path(out).lexically_normal();
    if (!folder.has_filename()) folder = folder.parent_path();
    return folder += ".received";
}

/// The value that a share of them do not exceed.
double quantile_of(std::vector<float> values, double share) {
    if (values.empty()) return 0.0;
    const auto at =
        static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size())) - 1.0);
    std::ranges::nth_element(values, values.begin() + at);
    return static_cast<double>(values[static_cast<std::size_t>(at)]);
}

}  // namespace

void add_live_options(CLI::App& command, LiveOptions& options) {
    CLI::Option* follow = command.add_flag(
        "--follow", options.follow,
        "Take the tour as it comes: the log is being written by another program (text or MCAP), or "
        "is - for what comes through a pipe, or ws://HOST:PORT for what foxglove_bridge tells of a "
        "running robot; Ctrl-C, or the other end, ends the tour");
    command
        .add_option(
            "--received", options.received,
            "With --follow, where to keep what comes through a pipe or from a robot, without "
            "an ending (default: the results' folder with .received behind it); the same "
            "map can be made of it again")
        ->needs(follow)
        ->check(&complaint_of_output);
    command
        .add_option("--patience", options.patience_s,
                    "With --follow, how long to look for a lost connection again before the tour "
                    "ends [s] (default: 60)")
        ->needs(follow)
        ->check(CLI::Range(0.0, 1e6));
    command
        .add_option("--opening", options.opening,
                    "With --follow, how many scans to look at before the first one is taken: what "
                    "says \"no return\", which topics, whether there is odometry (default: 20)")
        ->needs(follow)
        ->check(CLI::Range(1, 100000));
    command
        .add_option("--poses", options.poses,
                    "With --follow, write the pose after every scan at once into this CSV file, or "
                    "named pipe, with its covariance and how long it took since the scan came")
        ->needs(follow)
        ->check(&complaint_of_output);
}

LiveRun::LiveRun(const LiveOptions& options, const std::string& log, const std::string& out,
                 bool replace)
    : options_(options) {
    const auto goes_on = [] { return !StopByRequest::wanted(); };
    const bool server = is_websocket_address(log);
    if (server || is_standard_input(log)) {
        const fs::path name =
            options.received.empty() ? name_beside(out) : fs::path(options.received);
        source_ = server ? LiveSource::of_server(
                               log, name, replace,
                               std::chrono::seconds(std::llround(options.patience_s)), goes_on)
                         : LiveSource::of_pipe(STDIN_FILENO, name, replace, goes_on);
        received_ = source_ != nullptr;
        if (received_) fmt::print(stderr, "received: {}\n", on_one_line(file()));
    } else {
        source_ = std::make_unique<LiveSource>(fs::path(log));
    }
    if (!source_) return;
    // Whatever waits for more is to hear it, also before there is a run.
    watch_ = std::jthread([this](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            if (StopByRequest::wanted()) {
                source_->end();
                return;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
    });
}

void LiveRun::open_poses() {
    if (options_.poses.empty()) return;
    poses_.emplace(options_.poses);
    poses_->put("time_s,x_m,y_m,theta_rad,xx,xy,xtheta,yy,ytheta,thetatheta,latency_s\n");
}

LiveRun::~LiveRun() {
    end();
}

bool LiveRun::wait_for_opening(SourceParams& source) {
    constexpr double kPatience = 3.0;  // [s]: half a line is none yet
    ProgressLine line("scan");
    std::string told;
    double since_s = 0.0;
    const auto opening = source_->wait_for_opening(
        source.format, source.read, options_.opening, [&](const LiveSource::Opening& now) {
            tell_news(line);
            const std::string problem = now.problem.english();
            if (problem.empty() || problem == told) since_s = line.seconds();
            if (line.seconds() - since_s > kPatience) line.say(told = problem);
            line.show(now.scans, std::nullopt, fmt::format("of {} awaited", options_.opening));
            return now.scans > 0 || !StopByRequest::wanted();
        });
    tell_news(line);
    if (!opening) return false;
    source.file = file();
    source.read.opening_bytes = std::max<std::uint64_t>(opening->bytes, 1);
    source.read.growth = source_->growth();
    return true;
}

void LiveRun::note(const Algoritmo& run) {
    if (run.steps() == steps_) return;  // its end
    steps_ = run.steps();
    std::optional<double> latency_s;
    if (const auto came = source_->growth()->taken_came()) {
        latency_s = std::chrono::duration<double>(FileGrowth::Clock::now() - *came).count();
        const std::scoped_lock lock(mutex_);
        latencies_s_.push_back(static_cast<float>(*latency_s));
    }
    if (poses_) put_pose(run, latency_s);
}

void LiveRun::put_pose(const Algoritmo& run, std::optional<double> latency_s) {
    const StampedPose& now = run.online_trajectory().back();
    const Eigen::Matrix3d c = run.filter().pose_covariance();
    poses_->put(
        fmt::format("{:.6f},{:.6f},{:.6f},{:.8f},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{}\n",
                    now.time_s, now.pose.x, now.pose.y, now.pose.theta, c(0, 0), c(0, 1), c(0, 2),
                    c(1, 1), c(1, 2), c(2, 2), latency_s ? fmt::format("{:.6f}", *latency_s) : ""));
    if (poses_->problem().empty()) return;
    const std::scoped_lock lock(mutex_);
    poses_problem_ = fmt::format("{}: {}", on_one_line(options_.poses), poses_->problem());
}

void LiveRun::tell_news(ProgressLine& line) {
    for (const Message& news : source_->take_news()) line.say(news.english());
    if (const auto problem = source_->problem(); problem && !std::exchange(told_problem_, true))
        line.say(problem->what());
    if (const auto problem = poses_problem(); problem && !std::exchange(told_poses_, true))
        line.say("not written: " + *problem);
    if (StopByRequest::wanted() && !std::exchange(asked_, true))
        line.say("the tour ends here; once more to stop at once");
}

void LiveRun::look(RunWorker& worker, ProgressLine& line) {
    tell_news(line);
    for (const TourFinding& finding : doubts_.look(worker))
        line.say(sentence_of(finding).english());
}

std::optional<double> LiveRun::behind_s() const {
    const auto came = source_->growth()->taken_came();
    if (!came) return std::nullopt;
    if (source_->growth()->waiting() == 0) return 0.0;
    return std::chrono::duration<double>(FileGrowth::Clock::now() - *came).count();
}

std::optional<std::string> LiveRun::poses_problem() const {
    const std::scoped_lock lock(mutex_);
    return poses_problem_;
}

std::string LiveRun::behind() const {
    const double seconds = behind_s().value_or(0.0);
    return seconds < LiveSource::kWorthSaying ? "" : fmt::format("  {:.0f} s behind", seconds);
}

void LiveRun::tell_early_end() {
    end();
    if (!received_) return;
    const std::string name = on_one_line(file());
    if (!source_->holds_something()) {
        fmt::print(stderr, "nothing was received: {} is {}\n", name,
                   source_->give_back() ? "as it was before" : "removed");
    } else if (steps_ == 0) {
        fmt::print(stderr,
                   "what was received is kept in {0}: \"hitos-cli info {0}\" says what it holds, "
                   "and \"hitos-cli run {0} --out DIR\" maps it; to receive anew say --replace, or "
                   "another name with --received\n",
                   name);
    }
    if (const std::string former = source_->former().string(); !former.empty()) {
        fmt::print(stderr, "what was there before is kept too: \"mv {} {}\" brings it back\n",
                   on_one_line(former), name);
    }
}

void LiveRun::replace_former() {
    if (!problem()) source_->replace_former();
}

void LiveRun::tell(Report& report) const {
    const std::scoped_lock lock(mutex_);
    report.object()["received"] = file();
    if (latencies_s_.empty()) return;
    const double median_s = quantile_of(latencies_s_, 0.5);
    const double most_s = quantile_of(latencies_s_, 0.99);
    const double worst_s = quantile_of(latencies_s_, 1.0);
    report.say(
        "from a scan's last byte to its pose: {:.1f} ms, 99 of 100 within {:.1f} ms, the "
        "worst {:.1f} ms ({})\n",
        1e3 * median_s, 1e3 * most_s, 1e3 * worst_s, plural(latencies_s_.size(), "scan"));
    report.object()["latency"] = {{"scans", latencies_s_.size()},
                                  {"median_s", median_s},
                                  {"p99_s", most_s},
                                  {"worst_s", worst_s}};
}

}  // namespace hitos::cli
