// SPDX-License-Identifier: GPL-3.0-or-later
// Two poses of a graph from a file, and what can be changed by hand of them.
#pragma once

#include <QStringList>
#include <QWidget>
#include <cstdint>
#include <memory>
#include <optional>

#include "hitos/registration/graph_edit.hpp"
#include "hitos/slam/planar_graph.hpp"

class QLineEdit;
class QPushButton;

namespace hitos::window {

struct ShownGraph;

class GraphHand final : public QWidget {
    Q_OBJECT

  public:
    /// `list` gets the focus where a button goes out of use.
    GraphHand(QWidget& list, QWidget* parent);

    void set_graph(std::shared_ptr<const ShownGraph> graph);
    /// By their ids.
    void set_poses(const QString& a, const QString& b);
    /// It is A; what was A before is B.
    void take_pose(const QString& id);
    void refuse();

    /// Vertices of the graph; nothing where there is no such pose.
    std::optional<std::uint32_t> a() const { return pose_in(*a_); }
    std::optional<std::uint32_t> b() const { return pose_in(*b_); }
    QString a_id() const;
    QString b_id() const;
    /// Ids of which the graph has no pose, in words.
    QStringList problems() const;

  signals:
    /// By somebody who writes.
    void poses_written();
    void edit_wanted(const hitos::GraphEdit& edit);

  private:
    QPushButton* made_button(const char* name, const QString& words, const QString& tip,
                             void (GraphHand::*pressed)());
    QLineEdit* made_number(const char* name, const QString& words);
    QLineEdit* made_pose(const char* name, const QString& words, QPushButton* done);
    void close_loop();
    void slip();
    void fix();
    std::optional<std::uint32_t> pose_in(const QLineEdit& line) const;
    void forget_written();
    void refresh();
    void show_state();

    QWidget& list_;
    std::shared_ptr<const ShownGraph> graph_;
    QLineEdit* a_;
    QLineEdit* b_;
    QPushButton* refuse_;
    QPushButton* slip_;
    QPushButton* close_;
    QLineEdit* close_at_;
    QPushButton* fix_;
    QLineEdit* fix_at_;
};

/// Whether there is a step between the two vertices.
bool joined(const PlanarGraph& graph, std::uint32_t a, std::uint32_t b);

}  // namespace hitos::window
