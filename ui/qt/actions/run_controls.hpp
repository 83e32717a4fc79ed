// SPDX-License-Identifier: GPL-3.0-or-later
// The control panel: seven buttons [T 9.2.6.3], the time line and the speed, in one row.
#pragma once

#include <QWidget>
#include <vector>

#include "session/session.hpp"

class QAction;
class QSettings;
class QToolButton;

namespace hitos::window {

class PaceControl;
class TimeLine;

/// The actions of the seven buttons; the window's menus and keys use the same ones.
struct RunActions {
    QAction* run = nullptr;
    QAction* stop = nullptr;
    QAction* step = nullptr;
    QAction* best_map = nullptr;
    QAction* odometry = nullptr;
    QAction* save_map = nullptr;
    QAction* restart = nullptr;
    QAction* full_speed = nullptr;
    QAction* previous_event = nullptr;  ///< without buttons, as is
    QAction* next_event = nullptr;      ///< this one
};

class RunControls final : public QWidget {
    Q_OBJECT

  public:
    explicit RunControls(QWidget* parent = nullptr);

    /// Makes the buttons and lets them do what they say with the session.
    void set_up(const RunActions& actions, Session& session, QSettings& settings);

    /// Which actions are possible in this state.
    void show_progress(const Progress& progress, bool has_source);
    /// The number of scans of the whole log, where it is known.
    void set_total(std::optional<quint64> scans);
    /// How long it took to record it.
    void set_duration(double seconds);

    QSize minimumSizeHint() const override;

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    /// Which buttons have words beside their icons.
    enum class Words { none, of_controls, all };
    void set_words(Words words);
    int width_with(Words words);
    void measure();
    void fit_buttons();
    void note_marks(const Session& session);
    void note_disturbances(const Session& session);
    void forget_marks();
    void enable_events();
    QToolButton* add_button(QAction* action, const char* name, bool primary = false);
    /// A button that goes inactive would give the keyboard to whatever is next: from running or
    /// stepping it goes to the stop button, and back.
    void pass_focus(bool running, bool can_run);

    RunActions actions_;
    QToolButton* run_ = nullptr;
    QToolButton* stop_ = nullptr;
    QToolButton* step_ = nullptr;
    std::vector<QToolButton*> controls_;  // what runs
    std::vector<QToolButton*> maps_;      // what it makes
    PaceControl* pace_ = nullptr;
    int least_width_ = 0;             // of the row without the time line and any words,
    int some_width_ = 0;              // with those of the controls,
    int full_width_ = 0;              // and with all
    QWidget* before_stop_ = nullptr;  // what had the keyboard
    TimeLine* time_line_ = nullptr;
    std::size_t figures_taken_ = 0;  // for marks
    std::uint64_t skipped_ = 0;      // damaged lines so far
    std::vector<bool> disturbances_noted_;
    std::optional<quint64> total_;
};

}  // namespace hitos::window
