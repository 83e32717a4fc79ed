// SPDX-License-Identifier: GPL-3.0-or-later
// A graph from a file, read, changed by hand, solved and written beside the window.
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <vector>

#include "hitos/services/drawing/graph_shape.hpp"
#include "hitos/services/files/g2o_file.hpp"
#include "hitos/services/results/solved_graph.hpp"

namespace hitos::window {

/// What there is to show of a graph.
struct ShownGraph {
    enum class Stage : std::uint8_t {
        read,      ///< as the file has it
        foreseen,  ///< with its changes, from where it was solved before them
        solved     ///< as hitos-cli graph solves it
    };
    std::shared_ptr<const G2oFile> file;
    GraphChoices choices;
    std::vector<GraphEdit> edits;
    SolvedGraph solved;
    GraphShape before;  ///< its edges where the file has the vertices
    GraphShape after;
    Stage stage = Stage::read;
};

/// One graph. Nothing waits for what is under way, which ends soon where nobody wants it any more.
/// All signals come in the window's thread.
class GraphSolver final : public QObject {
    Q_OBJECT

  public:
    GraphSolver(QString path, QObject* parent);
    ~GraphSolver() override;

    const QString& path() const { return path_; }
    /// Null until it is read.
    std::shared_ptr<const ShownGraph> shown() const { return shown_; }
    /// Reading, solving or writing.
    bool busy() const { return at_work_ > 0; }

    void read();
    /// From the file's places; what was asked for before is wanted no more. Where that takes its
    /// time a foreseen graph is shown first.
    void solve(const PlacedEdits& edits, const GraphChoices& choices);
    /// As hitos-cli graph writes what is shown, into a folder.
    void write(const QString& folder);

  signals:
    /// shown() is another graph.
    void changed();
    void not_read(QString problem);
    /// shown() is what it was.
    void not_solved(QString problem);
    /// Empty: all is well.
    void written(QString folder, QString problem);
    void busy_changed();

  private:
    template <class Work, class Take>
    void start(Work work, Take take);
    void work_ended();

    QString path_;
    std::shared_ptr<const ShownGraph> shown_;
    std::stop_source stop_;
    quint64 number_ = 0;  ///< of what was asked for last
    int at_work_ = 0;
};

}  // namespace hitos::window
