// SPDX-License-Identifier: GPL-3.0-or-later
#include "topic_list.hpp"

#include <QHeaderView>
#include <QMap>
#include <QSignalBlocker>
#include <algorithm>
#include <limits>

namespace hitos::window {
namespace {

// Columns.
constexpr int kName = 0;
constexpr int kUse = 1;
constexpr int kType = 2;
constexpr int kMessages = 3;
constexpr int kFrame = 4;
constexpr const char* kAllLasers = "all";
constexpr const char* kTransforms = "tf";

QString use_words(TopicUse use) {
    switch (use) {
        case TopicUse::scans:
            return TopicList::tr("Laser");
        case TopicUse::odometry:
            return TopicList::tr("Odometry");
        case TopicUse::transforms:
            return TopicList::tr("Transforms");
        case TopicUse::none:
            break;
    }
    return {};
}

/// Below `row`, each frame below the one that it is placed in; of a circle nothing.
void add_frames(QTreeWidgetItem& row,
                const std::vector<std::pair<std::string, std::string>>& frames) {
    QMap<QString, QStringList> below;
    QStringList placed;
    for (const auto& [frame, parent] : frames) {
        below[QString::fromStdString(parent)] << QString::fromStdString(frame);
        placed << QString::fromStdString(frame);
    }
    const auto grow = [&below](const auto& self, QTreeWidgetItem& above,
                               const QString& frame) -> void {
        auto* item = new QTreeWidgetItem(&above, {frame});
        for (const QString& next : below.value(frame)) self(self, *item, next);
    };
    for (const QString& root : below.keys()) {
        if (!placed.contains(root)) grow(grow, row, root);
    }
}

}  // namespace

TopicList::TopicList(QWidget* parent) : QTreeWidget(parent) {
    setHeaderLabels({tr("Topic"), tr("Gives"), tr("Type"), tr("Messages"), tr("Frame")});
    setAccessibleName(tr("Topics"));
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    setUniformRowHeights(true);
    connect(this, &QTreeWidget::itemChanged, this, &TopicList::take);
}

void TopicList::show_topics(const std::vector<RecordedTopic>& topics, const QString& scans,
                            const QString& odometry) {
    const QSignalBlocker blocker(this);
    std::vector<RecordedTopic> rows = topics;
    // What a tour can be read from is at the front.
    std::ranges::stable_sort(rows, {}, [](const RecordedTopic& topic) {
        return topic.use == TopicUse::none ? std::numeric_limits<int>::max()
                                           : static_cast<int>(topic.use);
    });
    if (shows(rows)) {  // of a recording that grows
        for (std::size_t i = 0; i < rows.size(); ++i)
            topLevelItem(static_cast<int>(i))
                ->setText(kMessages, QString::number(rows[i].messages));
        return;
    }
    clear();
    for (const RecordedTopic& topic : rows) add_row(topic);
    tick(scans, odometry);
    expandAll();
}

/// All but how many messages there are.
bool TopicList::shows(const std::vector<RecordedTopic>& rows) const {
    if (static_cast<int>(rows.size()) != topLevelItemCount() || rows.empty()) return false;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const QTreeWidgetItem& row = *topLevelItem(static_cast<int>(i));
        const RecordedTopic& topic = rows[i];
        if (row.text(kName) != QString::fromStdString(topic.name) ||
            row.text(kType) != QString::fromStdString(topic.type) ||
            row.text(kFrame) != QString::fromStdString(topic.frame) ||
            (row.text(kMessages) == "0") != (topic.messages == 0) || row.childCount() != 0 ||
            !topic.frames.empty()) {
            return false;
        }
    }
    return true;
}

void TopicList::add_row(const RecordedTopic& topic) {
    auto* row = new QTreeWidgetItem(
        this, {QString::fromStdString(topic.name), use_words(topic.use),
               QString::fromStdString(topic.type), QString::number(topic.messages),
               QString::fromStdString(topic.frame)});
    row->setTextAlignment(kMessages, Qt::AlignRight | Qt::AlignVCenter);
    row->setData(kUse, Qt::UserRole, static_cast<int>(topic.use));
    if (topic.use != TopicUse::none && topic.messages > 0) {
        row->setCheckState(kName, Qt::Unchecked);
    } else {
        row->setDisabled(true);
    }
    add_frames(*row, topic.frames);
}

QList<QTreeWidgetItem*> TopicList::rows_for(TopicUse use) const {
    QList<QTreeWidgetItem*> rows;
    for (int i = 0; i < topLevelItemCount(); ++i) {
        QTreeWidgetItem* row = topLevelItem(i);
        const bool ticks = row->data(kName, Qt::CheckStateRole).isValid();
        if (ticks && row->data(kUse, Qt::UserRole).toInt() == static_cast<int>(use)) rows << row;
    }
    return rows;
}

void TopicList::tick(const QString& scans, const QString& odometry) {
    QStringList names;
    for (const QString& name : scans.split(',')) names << name.trimmed();
    const QList<QTreeWidgetItem*> lasers = rows_for(TopicUse::scans);
    for (QTreeWidgetItem* row : lasers) {
        const bool only = scans.isEmpty() && lasers.size() == 1;
        const bool on = only || scans == kAllLasers || names.contains(row->text(kName));
        row->setCheckState(kName, on ? Qt::Checked : Qt::Unchecked);
    }
    const QList<QTreeWidgetItem*> odometries = rows_for(TopicUse::odometry);
    for (QTreeWidgetItem* row : odometries) {
        const bool only = odometry.isEmpty() && odometries.size() == 1;
        row->setCheckState(kName,
                           only || odometry == row->text(kName) ? Qt::Checked : Qt::Unchecked);
    }
    const bool by_frames = odometry == kTransforms || (odometry.isEmpty() && odometries.isEmpty());
    for (QTreeWidgetItem* row : rows_for(TopicUse::transforms)) {
        row->setCheckState(kName, by_frames ? Qt::Checked : Qt::Unchecked);
    }
}

/// One way to know where the robot went gives way to another.
void TopicList::take(QTreeWidgetItem* changed) {
    const auto use = static_cast<TopicUse>(changed->data(kUse, Qt::UserRole).toInt());
    QStringList scans;
    QString odometry;
    for (const QTreeWidgetItem* row : rows_for(TopicUse::scans)) {
        if (row->checkState(kName) == Qt::Checked) scans << row->text(kName);
    }
    if (use == TopicUse::scans) {
        for (const QTreeWidgetItem* row : rows_for(TopicUse::odometry)) {
            if (row->checkState(kName) == Qt::Checked) odometry = row->text(kName);
        }
        for (const QTreeWidgetItem* row : rows_for(TopicUse::transforms)) {
            if (row->checkState(kName) == Qt::Checked) odometry = kTransforms;
        }
    } else if (changed->checkState(kName) == Qt::Checked) {
        odometry = use == TopicUse::transforms ? kTransforms : changed->text(kName);
    }
    emit chosen(scans.join(QStringLiteral(", ")), odometry);
}

}  // namespace hitos::window
