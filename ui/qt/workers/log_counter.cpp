// SPDX-License-Identifier: GPL-3.0-or-later
#include "log_counter.hpp"

#include <exception>
#include <utility>

#include "hitos/workbench/source_inspection.hpp"
#include "session/background.hpp"

namespace hitos::window {
namespace {

constexpr int kAgainMs = 100;

}  // namespace

LogCounter::LogCounter(Session& session, QObject* parent) : QObject(parent), session_(session) {
    pool_.setMaxThreadCount(1);
    again_.setSingleShot(true);
    again_.setInterval(kAgainMs);
    connect(&again_, &QTimer::timeout, this, &LogCounter::look);
    connect(&session, &Session::configuration_changed, this, &LogCounter::begin);
    connect(&session, &Session::progress_changed, this, &LogCounter::look);
    connect(&session, &Session::leaving, this, [this] { live_.reset(); });  // with its worker
    connect(&session, &Session::restarted, this, [this] {
        told_.clear();
        if (session_.incoming_tour() && session_.is_live()) live_.emplace();
    });
    begin();
}

LogCounter::~LogCounter() {
    if (stop_) *stop_ = true;
    pool_.waitForDone();
}

void LogCounter::know(const SourceParams& source, const TourSummary& summary) {
    known_.emplace(source, summary);
}

void LogCounter::begin() {
    const auto known = std::exchange(known_, {});
    const SourceParams& wanted = session_.configuration().source;
    const bool comes_in = session_.incoming_tour() && session_.is_live();
    const bool live = session_.live_tour() || comes_in;
    live_.reset();
    if (!live && wanted == source_) return;
    source_ = live ? SourceParams{} : wanted;  // nobody knows how long it will be
    if (stop_) *stop_ = true;
    emit counted(std::nullopt);
    emit doubted({});
    busy_ = !source_.file.empty();
    if (comes_in) live_.emplace();
    told_.clear();
    if (!busy_) return;
    stop_ = std::make_shared<std::atomic<bool>>(false);
    if (known && known->first == source_) {
        tell(known->second, stop_);
        return;
    }
    pool_.start([this, wanted, stop = stop_] {
        begin_background_work();
        TourSummary summary;
        try {
            summary = inspect_source(wanted, [&](double) { return !stop->load(); }).tour;
        } catch (const std::exception&) {
            summary.complete = false;  // the run itself tells what is wrong with the log
        }
        tell(std::move(summary), stop);
    });
}

void LogCounter::look() {
    if (!live_) return;
    if (!session_.is_live()) {
        begin();
        return;
    }
    const std::vector<TourFinding> fresh = live_->look(*session_.worker());
    if (live_->awaits()) again_.start();  // also where no scan comes any more
    if (fresh.empty()) return;
    told_.insert(told_.end(), fresh.begin(), fresh.end());
    emit doubted(told_);
}

/// When all that the source's change brings about is done.
void LogCounter::tell(TourSummary summary, const Stop& of) {
    QMetaObject::invokeMethod(
        this,
        [this, stop = of, summary = std::move(summary)] {
            if (stop != stop_ || *stop) return;
            busy_ = false;
            if (!summary.complete) return;
            emit counted(summary.report.scans);
            emit timed(summary.duration_s);
            emit doubted(summary.findings);
        },
        Qt::QueuedConnection);
}

}  // namespace hitos::window
