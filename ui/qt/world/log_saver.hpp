// SPDX-License-Identifier: GPL-3.0-or-later
// The log of a driven tour, written beside the window.
#pragma once

#include <QObject>
#include <QStringList>
#include <QThreadPool>
#include <string>

#include "hitos/workbench/tour_files.hpp"

namespace hitos::window {

/// The formats of logs that can be written, as a file dialog offers them; what `hitos-cli simulate`
/// writes unasked comes first.
QStringList log_filters();
/// The format of one of these; of any other text, the first one's.
std::string format_of_filter(const QString& filter);

/// Writes one log at a time. What is asked for is written, whole: who ends the program meanwhile
/// waits for it.
class LogSaver final : public QObject {
    Q_OBJECT

  public:
    explicit LogSaver(QObject* parent);
    ~LogSaver() override;

    bool busy() const { return busy_; }
    /// Simulates the world's tour and writes it, on a thread of its own. False, and nothing
    /// happens, where another one is being written.
    bool save(World driven, TourFiles files);

  signals:
    void changed();  ///< busy()
    void saved(QString path);
    void failed(QString reason);

  private:
    void take(const QString& path, const QString& problem);

    QThreadPool pool_;
    bool busy_ = false;
};

}  // namespace hitos::window
