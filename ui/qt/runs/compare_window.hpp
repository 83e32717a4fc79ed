// SPDX-License-Identifier: GPL-3.0-or-later
// Two runs beside each other, one over the other, or in turn; the errors of more.
#pragma once

#include <QDialog>
#include <QElapsedTimer>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "error_strip.hpp"
#include "run_list.hpp"
#include "views/grid_view.hpp"
#include "views/view_settings.hpp"
#include "workers/map_builder.hpp"

class QComboBox;
class QLabel;
class QToolButton;

namespace hitos::window {

/// The grid maps, landmarks and paths of two runs of a list, or of a run and its odometry, under
/// one camera. A grid that was not kept is made from the log.
class CompareWindow final : public QDialog {
    Q_OBJECT

  public:
    enum class Mode { side_by_side, overlaid, blinking };

    CompareWindow(RunList& list, const ViewSettings& settings, QWidget* parent);

    /// A run or its odometry.
    struct Choice {
        int number = 0;  ///< of the list
        bool odometry = false;
        friend bool operator==(const Choice&, const Choice&) = default;
    };
    /// Those of the two sides; of more the others' paths are in the figures and laid over. A run
    /// alone is compared with that of the window. None at all: that one with the last before it on
    /// the same log, else with its odometry.
    void compare(const std::vector<ListedRun>& runs);
    void choose(int side, const Choice& choice);
    void set_mode(Mode mode);
    Mode mode() const { return mode_; }
    /// How far all are from the reference, below the views and as the colour of their paths.
    void show_figures(bool on);
    /// Left and right; the left one is the only one in sight but in side_by_side.
    GridView& view(int side) const { return *sides_[static_cast<std::size_t>(side)].view; }
    /// Whether a grid is still being made.
    bool building() const;

  signals:
    void picture_wanted(const hitos::window::Exportable& figure);
    void figures_shown(bool on);

  private:
    struct Compared {
        Choice choice;
        std::shared_ptr<const KeptRun> run;  ///< shown; null before the first
        PathFigures figures;
        std::optional<Pose> laid = Pose{};  ///< into the left one's frame; nothing: it is unknown

        const Trajectory& path() const { return choice.odometry ? run->odometry : run->path; }
    };
    struct Side : Compared {
        QComboBox* box = nullptr;
        GridView* view = nullptr;
        std::unique_ptr<MapBuilder> builder;
        GridTiles grid;
        bool made = false;  ///< by the builder

        /// All that there is to see [m].
        QRectF content() const;
    };

    void make_side(std::size_t side, const ViewSettings& settings);
    QWidget* make_tools();
    void fill_boxes();
    Choice replacement_for(const Side& side) const;
    void set_side(std::size_t side, const Choice& choice);
    void take(Side& side);
    void refresh_grid(Side& side);
    void paint_sides();
    std::vector<const Compared*> compared() const;
    QColor colour_at(std::size_t place) const;
    std::shared_ptr<const KeptRun> run_of(const Choice& choice) const;
    enum class Of { all, present };
    void measure(Of which = Of::all);
    PathFigures figures_of(const Compared& of) const;
    std::optional<Pose> laid_on_left(const Compared& of) const;
    QString problem_of(const Compared& of) const;
    static RunTrace reference_of(const Compared& of);
    RunTrace trace_of(std::size_t place, bool landmarks) const;
    QString verdict() const;
    void show_in(GridView& view, const Side& side) const;
    QString title_of(const Choice& choice) const;

    RunList& list_;
    std::array<Side, 2> sides_;
    std::vector<Compared> others_;  ///< chosen with them
    std::size_t left_out_ = 0;      ///< of those chosen, beyond kMostCompared
    std::array<QToolButton*, 3> modes_{};
    QToolButton* figures_ = nullptr;
    ErrorStrip* strip_ = nullptr;
    QLabel* verdict_ = nullptr;
    QElapsedTimer since_measured_;
    qint64 measuring_ms_ = 0;  ///< that it took
    Mode mode_ = Mode::side_by_side;
    QTimer blink_;
    bool blinked_ = false;  ///< the second one is in sight
    bool filling_ = false;
};

}  // namespace hitos::window
