// SPDX-License-Identifier: GPL-3.0-or-later
#include "connection.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <filesystem>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/capture/tour_summary.hpp"
#include "look/words_of.hpp"
#include "session/background.hpp"

namespace hitos::window {
namespace {

constexpr int kLookMs = 100;

/// Those of a server; of a recording that is being written only where one has to be chosen.
std::vector<RecordedTopic> topics_now(const LiveSource& source, bool to_choose) {
    std::vector<RecordedTopic> topics = source.topics();
    if (!topics.empty() || !to_choose || !is_recording(source.file())) return topics;
    try {
        return topics_of(source.file());
    } catch (const Error&) {  // half of it is not there yet
        return {};
    }
}

std::uint64_t bytes_of(const std::filesystem::path& file) {
    std::error_code none;
    const std::uintmax_t bytes = std::filesystem::file_size(file, none);
    return none ? 0 : bytes;
}

}  // namespace

/// What the window and the thread that waits share.
struct Connection::Attempt {
    std::atomic<bool> stop = false;
    std::mutex mutex;
    QString scans;     // topics, guarded by it
    QString odometry;  // likewise
    int chosen = 0;    // how often, likewise
};

struct Connection::Bell {
    explicit Bell(Connection* connection) : to(connection) {}
    void ring() {
        const std::scoped_lock lock(mutex);
        if (to == nullptr || rung.exchange(true)) return;  // that is about to be looked at
        QMetaObject::invokeMethod(
            to,
            [connection = to] {
                connection->bell_->rung = false;
                connection->session_.follow();
            },
            Qt::QueuedConnection);
    }
    std::mutex mutex;
    Connection* to;
    std::atomic<bool> rung = false;
};

Connection::Connection(Session& session, QObject* parent)
    : QObject(parent), session_(session), bell_(std::make_shared<Bell>(this)) {
    pool_.setMaxThreadCount(1);  // one attempt after the other
    timer_.setInterval(kLookMs);
    connect(&timer_, &QTimer::timeout, this, &Connection::look);
    connect(&session, &Session::configuration_changed, this, [this] {
        if (state_ == State::live && session_.incoming_tour() != tour_) stop({});
    });
}

Connection::~Connection() {
    if (attempt_) attempt_->stop = true;
    if (tour_) tour_->source().end();
    pool_.waitForDone();
    const std::scoped_lock lock(bell_->mutex);
    bell_->to = nullptr;
}

void Connection::begin(const Wish& wish) {
    end();
    tour_ = nullptr;  // which the session may still have
    timer_.stop();
    problem_.clear();
    received_ = {};
    file_.clear();
    former_.clear();
    follows_ = !is_websocket_address(wish.address.toStdString());
    state_ = State::connecting;
    attempt_ = std::make_shared<Attempt>();
    attempt_->scans = QString::fromStdString(wish.source.read.scan_topic);
    attempt_->odometry = QString::fromStdString(wish.source.read.odom_topic);
    pool_.start([this, attempt = attempt_, wish] {
        begin_background_work();
        try {
            open(attempt, wish);
        } catch (const ConfigError& error) {  // without the name of a key
            tell(attempt, [this, why = words_of(error.problem())] { stop(why); });
        } catch (const std::exception& error) {
            tell(attempt, [this, why = words_of(error)] { stop(why); });
        }
    });
    emit changed();
}

/// In the window's thread, unless another attempt was made meanwhile.
void Connection::tell(const std::shared_ptr<Attempt>& of, const std::function<void()>& act) {
    QMetaObject::invokeMethod(
        this,
        [this, of, act] {
            if (of == attempt_ && !of->stop) act();
        },
        Qt::QueuedConnection);
}

void Connection::open(const std::shared_ptr<Attempt>& attempt, const Wish& wish) {
    const std::string address = wish.address.toStdString();
    const bool server = is_websocket_address(address);
    std::shared_ptr<LiveSource> live;
    if (server) {
        live = LiveSource::of_server(address, wish.name.toStdString(), wish.replace,
                                     LiveSource::kPatience, [&attempt] { return !attempt->stop; });
        if (!live) return;
    } else {
        live = std::make_shared<LiveSource>(address);
    }
    SourceParams source = wish.source;
    source.file = live->file().string();
    tell(attempt, [this] {
        state_ = State::waiting;
        emit changed();
    });
    std::uint64_t listed_bytes = 0;
    std::vector<RecordedTopic> listed;
    std::optional<LiveSource::Opening> opening;
    while (!opening && !attempt->stop) {
        int chosen = 0;
        {
            const std::scoped_lock lock(attempt->mutex);
            chosen = attempt->chosen;
            source.read.scan_topic = attempt->scans.toStdString();
            source.read.odom_topic = attempt->odometry.toStdString();
        }
        opening = live->wait_for_opening(
            source.format, source.read, LiveSource::kOpeningScans,
            [&](const LiveSource::Opening& now) {
                const std::uint64_t bytes = bytes_of(source.file);
                // A file is listed by reading all of it: anew where it has grown by a half.
                if (server || 2 * bytes > 3 * listed_bytes) {
                    listed = topics_now(*live, now.to_choose);
                    listed_bytes = listed.empty() ? 0 : bytes;
                }
                Received received{now.scans,    bytes, live->link(), listed, words_of(now.problem),
                                  now.to_choose};
                const bool kept = live->holds_something();
                const std::string former = kept ? live->former().string() : "";
                tell(attempt, [this, received = std::move(received), news = live->take_news(),
                               name = QString::fromStdString(kept ? source.file : ""),
                               former = QString::fromStdString(former)] {
                    file_ = name;
                    former_ = former;
                    note(received, news);
                });
                const std::scoped_lock lock(attempt->mutex);
                return !attempt->stop && chosen == attempt->chosen;
            });
    }
    if (attempt->stop) return;
    if (opening->scans == 0)
        throw Error(marked(HITOS_TEXT("Errors", "it ended before the first scan had come")));
    source.read.opening_bytes = std::max<std::uint64_t>(opening->bytes, 1);
    tell(attempt, [this, live, source] { take(live, source); });
}

void Connection::take(const std::shared_ptr<LiveSource>& source, const SourceParams& how) {
    attempt_ = nullptr;
    source->replace_former();
    former_.clear();
    state_ = State::live;
    file_ = QString::fromStdString(how.file);
    tour_ = std::make_shared<IncomingTour>(source, [bell = bell_] { bell->ring(); });
    timer_.start();
    emit opened(how, tour_);
    emit changed();
}

void Connection::look() {
    if (!tour_) return;
    const LiveSource& source = tour_->source();
    const bool over = !tour_->is_live();
    note({tour_->scans(),
          bytes_of(source.file()),
          source.link(),
          topics_now(source, false),
          {},
          false},
         tour_->source().take_news());
    const std::optional<FileError> found = source.problem();
    const QString problem = found ? words_of(*found) : QString();
    if (state_ == State::live && problem != problem_) {
        problem_ = problem;
        emit said(problem);
        emit changed();
    }
    if (!over) return;
    tour_ = nullptr;
    timer_.stop();
    if (state_ == State::live) stop(problem);
}

void Connection::note(Received received, const std::vector<Message>& news) {
    received_ = std::move(received);
    for (const Message& one : news) emit said(words_of(one));
    emit changed();
}

void Connection::choose(const QString& scans, const QString& odometry) {
    if (!attempt_) return;
    const std::scoped_lock lock(attempt_->mutex);
    attempt_->scans = scans;
    attempt_->odometry = odometry;
    ++attempt_->chosen;
}

/// The session still has the tour, which ends beside the window; until then it is looked at.
void Connection::end() {
    if (active()) stop({});
}

void Connection::stop(const QString& problem) {
    if (attempt_) attempt_->stop = true;
    attempt_ = nullptr;
    if (tour_) pool_.start([tour = tour_] { tour->source().end(); });
    problem_ = problem;
    state_ = State::over;
    emit changed();
}

}  // namespace hitos::window
