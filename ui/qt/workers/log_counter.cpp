#include "log_counter.hpp"

#include <exception>

#include "background.hpp"
#include "hitos/workbench/source_inspection.hpp"

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
    if (!live && wanted.file == source_.file && wanted.format == source_.format) return;
    source_ = live ? SourceParams{} : wanted;  // nobody knows how long it will be
    if (stop_) *stop_ = true;
    emit counted(std::nullopt);
    if (source_.file.empty()) return;
    stop_ = std::make_shared<std::atomic<bool>>(false);
    pool_.start([this, wanted, stop = stop_] {
        begin_background_work();
        std::optional<quint64> scans;
        try {
            const TourSummary summary =
                inspect_source(wanted, [&](double) { return !stop->load(); }).tour;
            if (summary.complete) scans = summary.report.scans;
        } catch (const std::exception&) {
            scans.reset();  // the run itself tells what is wrong with the log
        }
        QMetaObject::invokeMethod(
            this,
            [this, stop, scans] {
                if (stop == stop_ && !*stop) emit counted(scans);
            },
            Qt::QueuedConnection);
    });
}

}  // namespace hitos::window
