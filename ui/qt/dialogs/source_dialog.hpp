// SPDX-License-Identifier: GPL-3.0-or-later
// Choosing the log [T 9.2.6.6, use case 8.2.2.1].
#pragma once

#include <QDialog>
#include <QThreadPool>
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hitos/services/configuration/configuracion.hpp"
#include "hitos/workbench/source_inspection.hpp"
#include "look/prompts.hpp"

namespace hitos::window {

class SourceReading;
class TopicList;

namespace Ui {
class SourceDialog;
}

/// The first lines of a file, to see what it is where it is no log; nothing where it cannot be
/// read.
std::vector<Message> beginning_of(const std::string& file);

/// Reads the whole file while the user looks at its first lines; only a log that can be read can be
/// accepted.
class SourceDialog final : public QDialog {
    Q_OBJECT

  public:
    SourceDialog(SourceParams source, Prompts& prompts, QString folder, QWidget* parent);
    ~SourceDialog() override;

    /// Whatever file is chosen, it goes on with the map that the source has.
    void go_on_with_map() { goes_on_ = true; }
    /// What the user chose.
    SourceParams source() const;
    /// What the chosen log holds.
    const std::optional<SourceInspection>& summary() const { return summary_; }

    void set_path(const QString& path);

  signals:
    /// A file was read, or found to be no log.
    void checked(bool good);

  protected:
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    /// Return counts while a file is still being read: as soon as it turns out good.
    void keyPressEvent(QKeyEvent* event) override;

  private:
    using Stop = std::shared_ptr<std::atomic<bool>>;

    /// Why a file was not taken, and what it is.
    struct Refusal {
        QString reason;
        std::vector<Message> first_lines;
    };

    void browse();
    void begin_check();
    bool may_accept() const;
    /// Anew, where it is to be read otherwise than at the last check.
    void check_reading();
    void show_topics(bool shown);
    void connect_fields();
    void end_check(const Stop& stop, const std::optional<SourceInspection>& summary,
                   const Refusal& refusal);
    void show_lines(const std::vector<Message>& first_lines);
    void offer_topics(const std::vector<RecordedTopic>& topics);
    void show_verdict(const QString& text, const char* role);
    /// A button for each setting that a finding advises, unless it is so already.
    void offer_remedies(const std::vector<TourFinding>& findings);

    std::unique_ptr<Ui::SourceDialog> ui_;
    Prompts& prompts_;
    QString folder_;
    TopicList* topics_ = nullptr;
    SourceReading* how_read_ = nullptr;
    SourceParams source_;
    SourceParams checked_;  ///< of the newest check
    std::optional<SourceInspection> summary_;
    Stop stop_;             ///< of the check under way
    bool typed_ = false;    ///< what is shown is not what fields say
    bool hurries_ = false;  ///< Return was pressed before all was read
    bool goes_on_ = false;  ///< with a map
    /// What checks tell comes to here: one that is slow to stop may outlive the dialog.
    std::shared_ptr<QObject> told_{new QObject, [](QObject* object) { object->deleteLater(); }};
    std::shared_ptr<QThreadPool> pool_ = std::make_shared<QThreadPool>();
};

}  // namespace hitos::window
