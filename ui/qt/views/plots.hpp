// Figures of the run against time.
#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <memory>
#include <vector>

#include "app/session.hpp"
#include "workers/reference_meter.hpp"

class QCPAxisRect;
class QCPGraph;
class QCustomPlot;

namespace hitos::window {

/// Neff, landmarks, best weight, time per step, and with a reference the errors of map and path.
class Plots final : public QWidget {
    Q_OBJECT

  public:
    Plots(Session& session, ReferenceMeter& meter, QWidget* parent = nullptr);

    QImage picture(double scale) const;
    /// Points drawn so far of the plot in that place, for tests.
    int points(int plot) const;

    void restyle();

  signals:
    void picture_wanted();

  protected:
    void showEvent(QShowEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

  private:
    void add_plot(std::size_t plot);
    void clear();
    void clear_errors();
    void refresh(bool at_once);
    void note_errors(const Measured& figures);

    Session& session_;
    QCustomPlot* plot_;
    std::vector<QCPAxisRect*> rects_;
    std::vector<QCPGraph*> graphs_;
    quint64 taken_ = 0;
    QElapsedTimer clock_;
};

}  // namespace hitos::window
