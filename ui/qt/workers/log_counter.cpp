#include "log_counter.hpp"

#include <exception>
#include <utility>

#include "hitos/workbench/source_inspection.hpp"
#include "session/background.hpp"

namespace hitos::window {

LogCounter::LogCounter(Session& session, QObject* parent) : QObject(parent), session_(session) {
    pool_.setMaxThreadCount(1);
    connect(&session, &Session::configuration_changed, this, &LogCounter::begin);
    begin();
}

LogCounter::~LogCounter() {
    if (stop_) *stop_ = true;
    pool_.waitForDone();
}

void LogCounter::begin() {
    const SourceParams& wanted = session_.configuration().source;
    const bool live = session_.live_tour() != nullptr;
    if (!live && wanted == source_) return;
    source_ = live ? SourceParams{} : wanted;  // nobody knows how long it will be
    if (stop_) *stop_ = true;
    emit counted(std::nullopt);
    emit doubted({});
    busy_ = !source_.file.empty();
    if (!busy_) return;
    stop_ = std::make_shared<std::atomic<bool>>(false);
    pool_.start([this, wanted, stop = stop_] {
        begin_background_work();
        std::optional<TourSummary> summary;
        try {
            summary = inspect_source(wanted, [&](double) { return !stop->load(); }).tour;
        } catch (const std::exception&) {
            summary.reset();  // the run itself tells what is wrong with the log
        }
        QMetaObject::invokeMethod(
            this,
            [this, stop, summary = std::move(summary)] {
                if (stop != stop_ || *stop) return;
                busy_ = false;
                if (!summary || !summary->complete) return;
                emit counted(summary->report.scans);
                emit doubted(summary->findings);
            },
            Qt::QueuedConnection);
    });
}

}  // namespace hitos::window
