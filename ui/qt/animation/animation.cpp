// SPDX-License-Identifier: GPL-3.0-or-later
#include "animation.hpp"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <algorithm>
#include <utility>

#include "look/prompts.hpp"

namespace hitos::window {
namespace {

constexpr int kLookMs = 2;
constexpr int kLongestComplaint = 300;  // letters of what a program says

}  // namespace

FilmMaker FilmMaker::find() {
    if (QString ffmpeg = QStandardPaths::findExecutable("ffmpeg"); !ffmpeg.isEmpty()) {
        return {std::move(ffmpeg), "film.mp4"};
    }
    QString convert = QStandardPaths::findExecutable("convert");
    return convert.isEmpty() ? FilmMaker{} : FilmMaker{std::move(convert), "film.gif"};
}

QStringList FilmMaker::arguments(int frames_per_second) const {
    if (film.endsWith(".gif")) {
        return {"-delay", QString("1x%1").arg(frames_per_second), "-loop", "0", "frame-*.png",
                film};
    }
    // Players want an even number of pixels, and this kind of colour.
    return {"-nostdin",
            "-loglevel",
            "error",
            "-framerate",
            QString::number(frames_per_second),
            "-i",
            "frame-%06d.png",
            "-vf",
            "pad=ceil(iw/2)*2:ceil(ih/2)*2",
            "-pix_fmt",
            "yuv420p",
            film};
}

Animation::Animation(Session& session, AnimationPlan plan, std::function<Picture()> frame,
                     QObject* parent)
    : QObject(parent), session_(session), plan_(std::move(plan)), frame_(std::move(frame)) {
    timer_.setInterval(kLookMs);
    connect(&timer_, &QTimer::timeout, this, &Animation::step);
    connect(&process_, &QProcess::finished, this, &Animation::end_film);
    connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) end_film(-1, QProcess::CrashExit);
    });
}

Animation::~Animation() {
    process_.disconnect(this);
    process_.kill();
    process_.waitForFinished();
}

void Animation::start() {
    const Progress before = session_.progress();
    // Past the end path and map are smoothed, which they are not after the last scan.
    before_ = before.state == Progress::State::finished ? RunWorker::kToTheEnd : before.steps;
    session_.pause();
    folder_ = std::make_unique<QTemporaryDir>(plan_.folder + "-XXXXXX");
    if (!folder_->isValid()) {
        end(tr("%1 cannot be made: %2")
                .arg(QDir::toNativeSeparators(plan_.folder), folder_->errorString()));
        return;
    }
    scan_ = plan_.from;
    session_.seek(scan_);
    timer_.start();
}

void Animation::cancel() {
    end(tr("Cancelled"));
}

/// The run is at the next frame's scan, or at the last of the log.
void Animation::step() {
    const Progress now = session_.progress();
    if (now.state == Progress::State::failed) {
        end(words_of(now.error));
        return;
    }
    const bool over = now.state == Progress::State::finished;
    const bool there = now.state != Progress::State::running && session_.up_to_date() &&
                       (now.steps == scan_ || (over && now.steps < scan_));
    if (!there) return;
    try {
        ++written_;
        write_picture(
            frame_(),
            folder_->filePath(QString("frame-%1.png").arg(written_, 6, 10, QLatin1Char('0'))));
    } catch (const std::exception& problem) {
        end(words_of(problem));
        return;
    }
    if (now.steps < scan_ || scan_ >= plan_.to) {
        make_film();
    } else {  // the last frame is of the last scan that was asked for
        scan_ = std::min(scan_ + plan_.every, plan_.to);
        session_.seek(scan_);
    }
    emit progressed(written_);
}

void Animation::make_film() {
    timer_.stop();
    maker_ = FilmMaker::find();
    if (maker_.program.isEmpty()) {
        complaint_ = tr("neither ffmpeg nor ImageMagick's convert is installed");
        keep();
        return;
    }
    process_.setWorkingDirectory(folder_->path());
    process_.start(maker_.program, maker_.arguments(plan_.frames_per_second));
}

void Animation::end_film(int code, QProcess::ExitStatus status) {
    if (code == 0 && status == QProcess::NormalExit &&
        QFile::exists(folder_->filePath(maker_.film))) {
        film_ = maker_.film;
    } else {
        QFile::remove(folder_->filePath(maker_.film));
        const QString said = QString::fromUtf8(process_.readAllStandardError()).trimmed();
        complaint_ =
            tr("%1 has failed: %2")
                .arg(QDir::toNativeSeparators(maker_.program),
                     said.isEmpty() ? process_.errorString() : said.left(kLongestComplaint));
    }
    keep();
}

void Animation::keep() {
    // Made for its owner alone, as temporary folders are.
    QDir made(folder_->path());
    if (made.mkdir("as-usual")) {
        QFile::setPermissions(folder_->path(), QFileInfo(made.filePath("as-usual")).permissions());
        made.rmdir("as-usual");
    }
    if (!QDir().rename(folder_->path(), plan_.folder)) {
        end(tr("%1 cannot be made; is it there already?")
                .arg(QDir::toNativeSeparators(plan_.folder)));
        return;
    }
    folder_->setAutoRemove(false);
    end({});
}

void Animation::end(const QString& problem) {
    if (std::exchange(ended_, true)) return;
    timer_.stop();
    process_.disconnect(this);
    process_.kill();
    process_.waitForFinished();
    folder_.reset();
    if (before_ == 0) {
        session_.restart();
    } else {
        session_.seek(before_);
    }
    emit finished(problem);
}

}  // namespace hitos::window
