// SPDX-License-Identifier: GPL-3.0-or-later
// A window with runs in its list, and their comparison.
#pragma once

#include <QImage>
#include <QPushButton>
#include <QTest>
#include <QToolButton>

#include "gui_fixture.hpp"
#include "runs/compare_window.hpp"
#include "runs/runs.hpp"
#include "runs/runs_panel.hpp"

namespace hitos::window {

struct RunsFixture : Fixture {
    using Fixture::Fixture;

    RunList& list() const { return window->runs().list(); }
    RunsPanel& panel() const { return window->runs().panel(); }
    QString cell(int row, int column) const {
        return panel().table().model()->index(row, column).data().toString();
    }
    int rows() const { return panel().table().model()->rowCount(); }
    void press(const char* button) const { panel().findChild<QPushButton*>(button)->click(); }
    bool enabled(const char* button) const {
        return panel().findChild<QPushButton*>(button)->isEnabled();
    }
    void change(int particles) {
        Configuracion next = session.configuration();
        next.filter.particles = particles;
        session.set_configuration(next);
    }
    CompareWindow& comparison() const {
        if (window->runs().comparison() == nullptr) qFatal("no comparison");
        return *window->runs().comparison();
    }
    /// All results of the run, in a folder of that name.
    void save_results(const QString& name) {
        prompts.saves = {path(name)};
        trigger("action_save_results");
        QTRY_VERIFY(!window->result_actions().writing());
    }
};

/// Two runs of 80 scans, 10 and 20 particles, and a third one under way.
inline void run_thrice(RunsFixture& f) {
    f.trigger("action_runs_dock");
    f.run_steps(80);
    f.change(20);
    f.run_steps(80);
    f.change(30);
    f.run_steps(40);
}

inline CompareWindow& compare_first_two(const RunsFixture& f) {
    f.panel().table().choose_rows({1, 2});
    f.press("runs_compare");
    return f.comparison();
}

/// The path of the first run, somewhere else, as the truth.
inline References moved_path_of_the_first(const RunsFixture& f) {
    References references;
    references.trajectory = f.list().runs()[1].run->path;
    for (StampedPose& stamped : *references.trajectory)
        stamped.pose = compose({4.0, -2.0, 1.0}, stamped.pose);
    return references;
}

inline QToolButton* figures_button(const CompareWindow& comparison) {
    return comparison.findChild<QToolButton*>("compare_figures_shown");
}

inline QImage seen(QWidget& widget) {
    return widget.grab().toImage();
}

}  // namespace hitos::window
