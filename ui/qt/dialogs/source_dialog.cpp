// SPDX-License-Identifier: GPL-3.0-or-later
#include "source_dialog.hpp"

#include <QBoxLayout>
#include <QCheckBox>
#include <QCompleter>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QFontDatabase>
#include <QKeyEvent>
#include <QMimeData>
#include <QPointer>
#include <QPushButton>
#include <cmath>
#include <utility>

#include "hitos/base/error.hpp"
#include "hitos/capture/archivo.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "look/named.hpp"
#include "look/parameter_text.hpp"
#include "look/screen_fit.hpp"
#include "look/theme.hpp"
#include "look/words_of.hpp"
#include "session/background.hpp"
#include "source_reading.hpp"
#include "topic_list.hpp"
#include "ui_source_dialog.h"

namespace hitos::window {
namespace {

QString format_words(const std::string& word) {
    const ConfigParameter& format = find_parameter("source.format");
    const std::optional<std::size_t> place = format.place_of(word);
    return place ? choice_of(format, *place) : SourceDialog::tr("World");
}

/// Whether the file is a ROS recording, whose topics may have to be chosen.
bool needs_topics(const std::string& file) {
    return !file.empty() && is_recording(file);
}

QString scans_words(const TourSummary& summary) {
    QString words = counted_words(summary.report.scans, SourceDialog::tr("1 scan"),
                                  SourceDialog::tr("%1 scans"));
    if (summary.scans_of_map == 0) return words;
    return SourceDialog::tr("%1, %2 of them the map's").arg(words).arg(summary.scans_of_map);
}

/// How much of a tour there is.
QString source_counts(const TourSummary& summary) {
    QString words =
        SourceDialog::tr("%1: %2, %3, %4 s, %5 m.")
            .arg(format_words(summary.format))
            .arg(scans_words(summary))
            .arg(counted_words(summary.report.odometry, SourceDialog::tr("1 odometry reading"),
                               SourceDialog::tr("%1 odometry readings")))
            .arg(summary.duration_s, 0, 'f', 1)
            .arg(summary.distance_m, 0, 'f', 1);
    if (summary.fan.count == 0) return words;
    const double degrees =
        std::abs(summary.fan.max_angle_rad - summary.fan.min_angle_rad) * kDegreesPerRadian;
    return words + ' ' +
           SourceDialog::tr("Laser: %1 rays over %2°.")
               .arg(summary.fan.count)
               .arg(degrees, 0, 'f', 0);
}

/// Damaged lines are counted; the first says why, which is often the reason of all.
QString damage_note(const ReadReport& report) {
    const QString text =
        report.of_recording
            ? SourceDialog::tr(
                  "Damaged messages or records that will be skipped: %1; the first is "
                  "%2")
            : SourceDialog::tr("Damaged lines that will be skipped: %1; the first is %2");
    return text.arg(report.skipped).arg(words_of(report.placed(report.examples.front())));
}

/// What the user should know of a source before it is run.
QStringList source_notes(const SourceInspection& source) {
    const TourSummary& summary = source.tour;
    const ReadReport& report = summary.report;
    QStringList notes;
    if (!source.doubt.empty()) notes << words_of(source.doubt);
    for (const TourFinding& finding : summary.findings) notes << words_of(finding);
    if (report.early_scans > 0) {
        notes << SourceDialog::tr(
                     "Scans before the first odometry reading: %1. They are used as if the "
                     "robot had stood still until then; “%2” in the configuration leaves "
                     "them out.")
                     .arg(report.early_scans)
                     .arg(label_of(find_parameter("source.early_scans")));
    }
    if (report.early_scans_left_out > 0) {
        notes << SourceDialog::tr(
                     "Scans before the first odometry reading, which are left out: %1.")
                     .arg(report.early_scans_left_out);
    }
    if (report.skipped > 0) notes << damage_note(report);
    return notes;
}

}  // namespace

std::vector<Message> beginning_of(const std::string& file) {
    try {
        return first_lines_of(file);
    } catch (const Error&) {
        return {};
    }
}

SourceDialog::SourceDialog(SourceParams source, Prompts& prompts, QString folder, QWidget* parent)
    : QDialog(parent),
      ui_(std::make_unique<Ui::SourceDialog>()),
      prompts_(prompts),
      folder_(std::move(folder)),
      source_(std::move(source)) {
    ui_->setupUi(this);
    pool_->setMaxThreadCount(1);
    const ConfigParameter& format = find_parameter("source.format");
    for (std::size_t i = 0; i < format.choices.size(); ++i)
        ui_->type->addItem(choice_of(format, i), to_qt(format.choices[i].word));
    ui_->type->setCurrentIndex(ui_->type->findData(QString::fromStdString(source_.format)));
    ui_->lines->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    QSizePolicy place_kept = ui_->reading->sizePolicy();
    place_kept.setRetainSizeWhenHidden(true);
    ui_->reading->setSizePolicy(place_kept);
    ui_->reading->hide();
    ui_->path->setText(QString::fromStdString(source_.file));
    ui_->path->setFocus();  // another file is what most come for
    ui_->path->selectAll();
    ui_->scan_topic->setText(QString::fromStdString(source_.read.scan_topic));
    ui_->odom_topic->setText(QString::fromStdString(source_.read.odom_topic));
    how_read_ = new SourceReading(source_, this);
    ui_->reading_place->addWidget(how_read_);
    topics_ = named(new TopicList(this), "topics");
    topics_->hide();
    auto* column = static_cast<QBoxLayout*>(layout());
    column->insertWidget(column->indexOf(ui_->lines), topics_, 1);
    show_topics(needs_topics(source_.file));
    scroll_down_only(*ui_->verdict_area);
    how_read_->hide();
    connect_fields();
    ReadOptions set = source_.read;
    set.scan_topic.clear();
    set.odom_topic.clear();
    ReadOptions usual = for_another_recording(set);
    usual.odometry = set.odometry;  // which a preset says too
    ui_->how->setChecked(set != usual || !source_.map.empty());
    begin_check();
    fit_to_screen(*this);
}

void SourceDialog::connect_fields() {
    connect(ui_->path, &QLineEdit::textChanged, this, [this] {
        hurries_ = false;
        // What was set is of the recording that it was set for.
        SourceParams other = goes_on_ ? source() : source_;
        const bool same = ui_->path->text().trimmed().toStdString() == source_.file;
        if (!same && !goes_on_) forget_recording(other);
        other.read = same ? source_.read : for_another_recording(source_.read);
        ui_->scan_topic->setText(QString::fromStdString(other.read.scan_topic));
        ui_->odom_topic->setText(QString::fromStdString(other.read.odom_topic));
        how_read_->show(other);
        begin_check();
    });
    connect(ui_->scan_topic, &QLineEdit::editingFinished, this, &SourceDialog::check_reading);
    connect(ui_->odom_topic, &QLineEdit::editingFinished, this, &SourceDialog::check_reading);
    connect(topics_, &TopicList::chosen, this, [this](const QString& scans, const QString& odom) {
        ui_->scan_topic->setText(scans);
        ui_->odom_topic->setText(odom);
        check_reading();
    });
    connect(ui_->type, &QComboBox::currentIndexChanged, this, &SourceDialog::begin_check);
    connect(ui_->browse, &QPushButton::clicked, this, &SourceDialog::browse);
    connect(ui_->buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(ui_->buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(ui_->how, &QCheckBox::toggled, this, [this](bool on) {
        how_read_->setVisible(on);
        constexpr int kMore = 6;  // than the first lines get
        auto* column = static_cast<QVBoxLayout*>(layout());
        column->setStretch(column->indexOf(ui_->verdict_area), on ? kMore : 1);
    });
    // What has just been typed is no part of what is read yet.
    connect(how_read_, &SourceReading::edited, this, [this] {
        ui_->buttons->button(QDialogButtonBox::Ok)->setEnabled(false);
        typed_ = true;
        hurries_ = false;
        show_verdict(tr("Reading…"), "muted");
    });
    connect(how_read_, &SourceReading::changed, this, &SourceDialog::check_reading);
}

SourceDialog::~SourceDialog() {
    if (stop_) *stop_ = true;
    // Nobody waits here for a log whose reading takes a while to stop.
    QThreadPool::globalInstance()->start([pool = std::move(pool_)] { pool->waitForDone(); });
}

SourceParams SourceDialog::source() const {
    SourceParams chosen = source_;
    how_read_->give(chosen);
    chosen.file = ui_->path->text().trimmed().toStdString();
    chosen.format = ui_->type->currentData().toString().toStdString();
    chosen.read.scan_topic = ui_->scan_topic->text().trimmed().toStdString();
    chosen.read.odom_topic = ui_->odom_topic->text().trimmed().toStdString();
    return chosen;
}

/// It was read as all fields say.
bool SourceDialog::may_accept() const {
    return summary_ && summary_->tour.report.scans > 0 && how_read_->good() &&
           !how_read_->pending() && source() == checked_;
}

void SourceDialog::check_reading() {
    if (typed_ || source() != checked_) begin_check();
}

void SourceDialog::show_topics(bool shown) {
    for (QWidget* widget : std::initializer_list<QWidget*>{ui_->scan_topic_label, ui_->scan_topic,
                                                           ui_->odom_topic_label, ui_->odom_topic})
        widget->setVisible(shown);
    ui_->lines_label->setText(shown ? tr("Topics") : tr("First lines"));
    if (shown) return;
    topics_->hide();
    ui_->lines->show();
}

void SourceDialog::set_path(const QString& path) {
    ui_->path->setText(path);
}

void SourceDialog::browse() {
    const QString path = ui_->path->text().trimmed();
    const QString chosen =
        prompts_.open_file(this, {tr("Open log"),
                                  path.isEmpty() ? folder_ : path,
                                  tr("Logs and worlds (%1 *.gz *.toml);;All files (*)")
                                      .arg(QString::fromStdString(log_endings())),
                                  {}});
    if (!chosen.isEmpty()) set_path(chosen);
}

void SourceDialog::begin_check() {
    if (stop_) *stop_ = true;
    typed_ = false;
    summary_.reset();
    ui_->buttons->button(QDialogButtonBox::Ok)->setEnabled(false);
    ui_->lines->clear();
    offer_remedies({});
    const SourceParams wanted = source();
    checked_ = wanted;
    how_read_->mark_unused(wanted);
    show_topics(needs_topics(wanted.file));
    if (wanted.file.empty()) {
        stop_.reset();
        ui_->reading->hide();
        show_verdict(tr("Choose a log: odometry and laser scans, as text, .gz or ROS recording."),
                     "muted");
        return;
    }
    show_verdict(tr("Reading…"), "muted");
    ui_->reading->setValue(0);
    ui_->reading->show();
    stop_ = std::make_shared<std::atomic<bool>>(false);
    const QPointer<SourceDialog> self(this);
    pool_->start([self, wanted, stop = stop_, told = told_] {
        begin_background_work();
        std::optional<SourceInspection> summary;
        Refusal refusal;
        try {
            summary = inspect_source(wanted, [&](double part) {
                QMetaObject::invokeMethod(
                    told.get(),
                    [self, stop, part] {
                        if (self && stop == self->stop_)
                            self->ui_->reading->setValue(static_cast<int>(part * 1000.0));
                    },
                    Qt::QueuedConnection);
                return !stop->load();
            });
        } catch (const std::exception& error) {
            refusal = {words_of(error), beginning_of(wanted.file)};
        }
        QMetaObject::invokeMethod(
            told.get(),
            [self, stop, summary, refusal] {
                if (self) self->end_check(stop, summary, refusal);
            },
            Qt::QueuedConnection);
    });
}

void SourceDialog::end_check(const Stop& stop, const std::optional<SourceInspection>& summary,
                             const Refusal& refusal) {
    if (stop != stop_ || *stop) return;  // a later check is under way
    ui_->reading->hide();
    if (!summary) {
        hurries_ = false;
        show_verdict(refusal.reason, "error");
        show_lines(refusal.first_lines);
        emit checked(false);
        return;
    }
    show_lines(summary->first_lines);
    offer_topics(summary->topics);
    const bool listed = !summary->topics.empty();
    topics_->setVisible(listed);
    ui_->lines->setVisible(!listed);
    if (listed) {
        topics_->show_topics(summary->topics, ui_->scan_topic->text().trimmed(),
                             ui_->odom_topic->text().trimmed());
    }
    if (!summary->choice.empty()) {
        show_verdict(tr("The recording has several lasers or odometries: write above which ones to "
                        "use, or tick them below."),
                     "warning");
        emit checked(false);
        return;
    }
    summary_ = summary;
    const ReadReport& report = summary->tour.report;
    const bool scans = report.scans > 0;
    const QStringList notes = source_notes(*summary);
    QStringList lines{scans ? source_counts(summary->tour)
                            : tr("The file holds odometry but not one readable scan.")};
    for (const QString& note : notes) lines << set_apart(note);
    show_verdict(lines.join('\n'), !scans ? "error" : notes.isEmpty() ? "good" : "warning");
    offer_remedies(summary->tour.findings);
    ui_->buttons->button(QDialogButtonBox::Ok)->setEnabled(may_accept());
    emit checked(scans);
    if (hurries_ && may_accept()) accept();
}

void SourceDialog::show_lines(const std::vector<Message>& first_lines) {
    QStringList lines;
    for (const Message& line : first_lines) lines << words_of(line);
    ui_->lines->setPlainText(lines.join('\n'));
}

/// Those of the right kind, while a name is written.
void SourceDialog::offer_topics(const std::vector<RecordedTopic>& topics) {
    const auto offer = [&](QLineEdit& line, std::string_view type, const char* other) {
        QStringList names;
        for (const RecordedTopic& topic : topics) {
            if (topic.type == type && topic.messages > 0)
                names << QString::fromStdString(topic.name);
        }
        if (!names.isEmpty()) names << other;
        auto* completer = new QCompleter(names, &line);
        completer->setFilterMode(Qt::MatchContains);
        delete line.completer();
        line.setCompleter(completer);
    };
    offer(*ui_->scan_topic, "sensor_msgs/LaserScan", "all");
    offer(*ui_->odom_topic, "nav_msgs/Odometry", "tf");
}

void SourceDialog::show_verdict(const QString& text, const char* role) {
    ui_->verdict->setText(text);
    set_look(*ui_->verdict, "role", role);
}

void SourceDialog::offer_remedies(const std::vector<TourFinding>& findings) {
    for (QPushButton* before : ui_->verdict_box->findChildren<QPushButton*>()) {
        before->hide();
        before->deleteLater();  // it may be the one that was pressed
    }
    Configuracion now;
    now.source = checked_;
    for (const TourFinding& finding : findings) {
        for (const Remedy& remedy : finding.remedies) {
            const auto can_be_set = [&](const SourceSetting& one) {
                return how_read_->has(find_parameter(one.key));
            };
            const auto is_new = [&](const SourceSetting& one) {
                return find_parameter(one.key).text(now) != one.value;
            };
            if (!std::ranges::all_of(remedy.settings, can_be_set) ||
                std::ranges::none_of(remedy.settings, is_new)) {
                continue;
            }
            auto* button = named(
                new QPushButton(tr("Set %1").arg(words_of(remedy.settings)), ui_->verdict_box),
                "remedy_" + to_qt(remedy.settings.front().key));
            button->setToolTip(words_of(remedy.words));
            button->setAutoDefault(false);
            connect(button, &QPushButton::clicked, this, [this, settings = remedy.settings] {
                ui_->how->setChecked(true);
                for (const auto& [key, value] : settings) {
                    how_read_->set(find_parameter(key), value);
                }
            });
            ui_->remedies->addWidget(button, 0, Qt::AlignLeft);
        }
    }
}

void SourceDialog::keyPressEvent(QKeyEvent* event) {
    const bool reads = typed_ || ui_->reading->isVisible();
    hurries_ = reads && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter);
    QDialog::keyPressEvent(event);
}

void SourceDialog::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void SourceDialog::dropEvent(QDropEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (!urls.isEmpty()) set_path(urls.front().toLocalFile());
}

}  // namespace hitos::window
