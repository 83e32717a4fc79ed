// SPDX-License-Identifier: GPL-3.0-or-later
#include "first_look.hpp"

#include <exception>
#include <future>
#include <utility>

#include "session/background.hpp"

namespace hitos::window {
namespace {

std::shared_ptr<const Snapshot> first_state(const Configuracion& configuration,
                                            std::unique_ptr<TourReader> reader) {
    RunWorker run(configuration, std::move(reader));
    run.run(1);
    run.wait();
    if (run.progress().steps == 0) return nullptr;
    run.request_snapshot();
    run.wait();
    return run.latest_snapshot();
}

/// The scan alone: where it was made the run that begins anew does not know.
std::shared_ptr<const Snapshot> scan_of(const Snapshot& snapshot) {
    auto seen = std::make_shared<Snapshot>();
    seen->steps = 1;
    seen->scan = snapshot.scan;
    seen->observation = snapshot.observation;
    return seen;
}

}  // namespace

FirstLook::FirstLook(Session& session, QObject* parent) : QObject(parent), session_(session) {
    pool_.setMaxThreadCount(1);
    connect(&session, &Session::configuration_changed, this, &FirstLook::begin);
    connect(&session, &Session::snapshot_changed, this, &FirstLook::note);
    begin();
}

FirstLook::~FirstLook() {
    if (stop_) *stop_ = true;
    pool_.waitForDone();
}

void FirstLook::begin() {
    if (stop_) *stop_ = true;
    stop_ = std::make_shared<std::atomic<bool>>(false);
    const bool possible = session_.has_source() && !session_.live_tour() && !session_.is_live();
    const SourceParams& source = session_.configuration().source;
    const void* incoming = session_.incoming_tour().get();
    const void* tour = session_.live_tour() ? session_.live_tour().get() : incoming;
    const bool other_tour = std::exchange(tour_, tour) != tour;
    if (std::exchange(source_, source) != source || other_tour) {
        newest_ = nullptr;
        show(nullptr, stop_);  // else the one before stays meanwhile
    } else if (!possible && snapshot_ != newest_) {
        show(newest_, stop_);
    }
    if (!possible) return;
    // The run itself tells what is wrong with its tour, or was given up meanwhile.
    using Reader = std::unique_ptr<TourReader>;
    auto reader = std::make_shared<std::future<Reader>>(session_.worker()->with_run(
        [](const Algoritmo& run) -> Reader { return run.reader().reopen(); }));
    pool_.start([this, reader, configuration = session_.configuration(), stop = stop_] {
        std::shared_ptr<const Snapshot> state;
        try {
            Reader own = reader->get();
            if (*stop) return;
            begin_background_work();
            state = first_state(configuration, std::move(own));
        } catch (const std::exception&) {
            state = nullptr;
        }
        QMetaObject::invokeMethod(
            this, [this, state, stop] { show(state, stop); }, Qt::QueuedConnection);
    });
}

void FirstLook::note() {
    const std::shared_ptr<const Snapshot> now = session_.snapshot();
    if (now && (session_.live_tour() || session_.is_live())) newest_ = scan_of(*now);
    if (!now && newest_) show(newest_, stop_);
}

void FirstLook::show(std::shared_ptr<const Snapshot> snapshot, const Stop& of) {
    if (of != stop_ || snapshot == snapshot_) return;
    snapshot_ = std::move(snapshot);
    emit changed();
}

}  // namespace hitos::window
