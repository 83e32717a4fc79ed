// SPDX-License-Identifier: GPL-3.0-or-later
// The topics of a ROS recording, to tick those that a tour is read from.
#pragma once

#include <QTreeWidget>
#include <vector>

#include "hitos/capture/log_format.hpp"

namespace hitos::window {

/// One row for each topic: what it gives, its name, type, number of messages and frame; below
/// transforms the tree of the frames that they place. Those that a tour can be read from have a
/// box: lasers as many as one likes, of odometry and transforms one.
class TopicList final : public QTreeWidget {
    Q_OBJECT

  public:
    explicit TopicList(QWidget* parent);

    /// With the boxes of what is chosen ticked, in the words of ReadOptions: names with commas
    /// between them, "all", "tf"; empty: the only one of its kind.
    void show_topics(const std::vector<RecordedTopic>& topics, const QString& scans,
                     const QString& odometry);

  signals:
    /// By the user, in the same words.
    void chosen(QString scans, QString odometry);

  private:
    bool shows(const std::vector<RecordedTopic>& rows) const;
    void add_row(const RecordedTopic& topic);
    void tick(const QString& scans, const QString& odometry);
    /// The rows of that use that have a box.
    QList<QTreeWidgetItem*> rows_for(TopicUse use) const;
    void take(QTreeWidgetItem* changed);
};

}  // namespace hitos::window
