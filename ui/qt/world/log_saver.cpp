// SPDX-License-Identifier: GPL-3.0-or-later
#include "log_saver.hpp"

#include <QCoreApplication>
#include <exception>
#include <memory>
#include <utility>

#include "hitos/capture/log_format.hpp"
#include "hitos/workbench/open_tour.hpp"
#include "look/words_of.hpp"
#include "session/background.hpp"

namespace hitos::window {
namespace {

QString filter_of(const LogFormat& format) {
    return QStringLiteral("%1 (%2)").arg(
        QCoreApplication::translate("ParameterChoice", format.label.c_str()),
        QString::fromStdString(format.endings));
}

/// What went wrong; empty where nothing did.
QString write(const World& driven, const TourFiles& files) {
    try {
        write_tour_files(std::make_shared<const SimulatedTour>(driven), files,
                         tour_files(driven.file));
        return {};
    } catch (const std::exception& error) {
        return words_of(error);
    }
}

}  // namespace

QStringList log_filters() {
    const std::string usual = TourFiles{}.format;
    QStringList filters{filter_of(log_formats().find(usual))};
    for (const LogFormat& format : log_formats().entries()) {
        if (format.make_writer != nullptr && format.word != usual) filters << filter_of(format);
    }
    return filters;
}

std::string format_of_filter(const QString& filter) {
    for (const LogFormat& format : log_formats().entries()) {
        if (format.make_writer != nullptr && filter == filter_of(format)) return format.word;
    }
    return TourFiles{}.format;
}

LogSaver::LogSaver(QObject* parent) : QObject(parent) {
    pool_.setMaxThreadCount(1);
}

LogSaver::~LogSaver() {
    pool_.waitForDone();
}

bool LogSaver::save(World driven, TourFiles files) {
    if (busy_) return false;
    busy_ = true;
    emit changed();
    pool_.start([this, driven = std::move(driven), files = std::move(files)] {
        begin_background_work();
        const QString problem = write(driven, files);
        const QString path = QString::fromStdString(files.log.string());
        QMetaObject::invokeMethod(
            this, [this, path, problem] { take(path, problem); }, Qt::QueuedConnection);
    });
    return true;
}

void LogSaver::take(const QString& path, const QString& problem) {
    busy_ = false;
    emit changed();
    if (problem.isEmpty()) {
        emit saved(path);
    } else {
        emit failed(problem);
    }
}

}  // namespace hitos::window
