// SPDX-License-Identifier: GPL-3.0-or-later
// The scans of a tour on a line: where the run is, what happened when, and the way to any of them.
#pragma once

#include <QAbstractSlider>
#include <QString>
#include <vector>

namespace hitos::window {

/// Its value is the scan that the run has come to, 0 before the first. What the user chooses,
/// by dragging, clicking or keys (arrows one scan, with Shift ten, with Ctrl to the next event,
/// Home and End), is told by chosen(); the line itself moves when the run does.
class TimeLine final : public QAbstractSlider {
    Q_OBJECT

  public:
    /// Something that happened at a scan, counted from 1.
    struct Mark {
        enum class Kind { event, loop, filter, damage, disturbance };
        int scan = 0;
        QString text;
        /// Below the line, the rare ones longer, or above it: what the filter does all the time.
        Kind kind = Kind::event;
    };

    explicit TimeLine(QWidget* parent = nullptr);

    /// Where the run is; `last` is the last scan that can be chosen.
    void show_run(int scan, int last);
    /// The run goes nowhere: keys go on from where it is.
    void arrive() { on_its_way_ = false; }
    void set_marks(std::vector<Mark> marks);
    void add_marks(const std::vector<Mark>& marks);
    const std::vector<Mark>& marks() const { return marks_; }
    /// The nearest marked scan after (or before) where the line is, of what does not happen all the
    /// time; 0 where there is none.
    int event_beside(bool after) const;
    /// Chooses it, where there is one.
    void choose_event(bool after);

    /// The scan at a place of the widget.
    int scan_at(int x) const;
    /// Where a scan is drawn.
    int x_of(int scan) const;

    QSize sizeHint() const override { return {200, 22}; }
    QSize minimumSizeHint() const override { return {80, 22}; }

  signals:
    void chosen(int scan);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    bool event(QEvent* event) override;

  private:
    void choose(int scan);
    int place() const { return on_its_way_ ? wanted_ : value(); }
    void draw_marks(QPainter& painter, Mark::Kind kind, int middle) const;
    QString tip_at(int x) const;

    std::vector<Mark> marks_;
    int wanted_ = 0;  // the last one chosen: keys go on from it while the run is on its way there
    bool on_its_way_ = false;
};

}  // namespace hitos::window
