// SPDX-License-Identifier: GPL-3.0-or-later
// The way from a robot, or from a program that writes a log, to the run that maps it.
#pragma once

#include <QObject>
#include <QStringList>
#include <QThreadPool>
#include <QTimer>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "hitos/capture/live_source.hpp"
#include "hitos/capture/log_format.hpp"
#include "session/incoming_tour.hpp"
#include "session/session.hpp"

namespace hitos::window {

/// One connection at a time. Until the first scans are there, by which is decided how the tour is
/// read, it waits beside the window; then opened() gives the tour, for which the session is
/// followed as scans come.
class Connection final : public QObject {
    Q_OBJECT

  public:
    enum class State {
        none,
        connecting,
        waiting,  ///< for the first scans, or for the user to choose among topics
        live,
        over
    };
    /// What has come by now.
    struct Received {
        std::uint64_t scans = 0;
        std::uint64_t bytes = 0;
        LinkState link;
        std::vector<RecordedTopic> topics;
        QString problem;         ///< why nothing can be made of it yet; empty where something can
        bool to_choose = false;  ///< among its topics
    };

    Connection(Session& session, QObject* parent);
    ~Connection() override;

    struct Wish {
        QString address;  ///< of a server (ws://…), or the path of a log that is being written
        QString name;     ///< what a server tells is kept in this with .mcap behind it
        bool replace = false;  ///< what is there already
        SourceParams source;   ///< says how it is read
    };
    /// Ends the one before.
    void begin(const Wish& wish);
    /// Of the topics, in the words of ReadOptions.
    void choose(const QString& scans, const QString& odometry);
    /// The tour is what has come by now.
    void end();

    State state() const { return state_; }
    bool active() const { return state_ != State::none && state_ != State::over; }
    const Received& received() const { return received_; }
    /// Where what came is kept; empty where nothing did.
    const QString& file() const { return file_; }
    /// Whether that is another program's log.
    bool follows() const { return follows_; }
    /// Where what was in that file before is kept, as the map of what came did not begin.
    const QString& former() const { return former_; }
    /// Why it is over, or what is amiss with the file; empty where it ended as it was asked to, or
    /// the link was given up.
    const QString& problem() const { return problem_; }

  signals:
    void changed();
    /// What has happened to the connection.
    void said(QString words);
    void opened(const SourceParams& source, std::shared_ptr<IncomingTour> tour);

  private:
    struct Attempt;
    /// By which a tour's thread finds the window's object for as long as it is there.
    struct Bell;
    void open(const std::shared_ptr<Attempt>& attempt, const Wish& wish);
    void tell(const std::shared_ptr<Attempt>& of, const std::function<void()>& act);
    void take(const std::shared_ptr<LiveSource>& source, const SourceParams& how);
    void note(Received received, const std::vector<Message>& news);
    void look();
    void stop(const QString& problem);

    Session& session_;
    State state_ = State::none;
    Received received_;
    QString file_;
    QString former_;
    bool follows_ = false;
    QString problem_;
    std::shared_ptr<Attempt> attempt_;
    std::shared_ptr<IncomingTour> tour_;
    std::shared_ptr<Bell> bell_;
    QTimer timer_;
    QThreadPool pool_;
};

}  // namespace hitos::window
