// SPDX-License-Identifier: GPL-3.0-or-later
// A run as pictures, one after the other, and as a film where the computer can make one.
#pragma once

#include <QProcess>
#include <QString>
#include <QTemporaryDir>
#include <QTimer>
#include <functional>
#include <memory>

#include "session/session.hpp"
#include "views/picture.hpp"

namespace hitos::window {

struct AnimationPlan {
    quint64 from = 1;  ///< scans, from 1
    quint64 to = 1;
    quint64 every = 1;
    int frames_per_second = 25;
    QString folder;  ///< that is not there yet

    /// The last one is of the last scan, however far it is from the one before.
    quint64 frames() const { return (to - from + every - 1) / every + 1; }
};

/// The program that makes a film of frames: ffmpeg (film.mp4), else ImageMagick's convert
/// (film.gif).
struct FilmMaker {
    QString program;  ///< empty: there is none
    QString film;     ///< the file's name

    static FilmMaker find();
    /// Of frames frame-000001.png … in the working folder.
    QStringList arguments(int frames_per_second) const;
};

/// Takes the run from scan to scan and writes a picture of each; at the end the run is back at the
/// scan where it was. The folder is there with everything in it, or not at all.
class Animation final : public QObject {
    Q_OBJECT

  public:
    /// `frame` makes the picture of the run as it is.
    Animation(Session& session, AnimationPlan plan, std::function<Picture()> frame,
              QObject* parent);
    ~Animation() override;

    void start();
    void cancel();
    /// The film's name; empty where there is none, with what its maker said.
    const QString& film() const { return film_; }
    const QString& complaint() const { return complaint_; }
    int written() const { return written_; }

  signals:
    /// Frames so far.
    void progressed(int frames);
    /// `problem` is empty where all frames are written.
    void finished(QString problem);

  private:
    void step();
    void make_film();
    void end_film(int code, QProcess::ExitStatus status);
    void keep();
    void end(const QString& problem);

    Session& session_;
    AnimationPlan plan_;
    std::function<Picture()> frame_;
    std::unique_ptr<QTemporaryDir> folder_;
    QTimer timer_;
    QProcess process_;
    FilmMaker maker_;
    QString film_;
    QString complaint_;
    quint64 before_ = 0;  ///< where the run was; beyond the last scan where it was over
    quint64 scan_ = 0;    ///< of the next frame
    int written_ = 0;
    bool ended_ = false;
};

}  // namespace hitos::window
