// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/opening.hpp"

#include <fmt/core.h>

#include <QCoreApplication>
#include <QEventLoop>
#include <QObject>
#include <algorithm>
#include <optional>

#include "app/main_window.hpp"
#include "measures.hpp"
#include "probe.hpp"
#include "views/grid_view.hpp"
#include "views/scan_view.hpp"
#include "workers/first_look.hpp"
#include "workers/log_counter.hpp"

namespace hitos::window {

int measure_opening(MainWindow& window, const CommandLine& line) {
    constexpr double kFirstScan = 0.5;  // [s]
    const FirstLook& look = *window.findChild<FirstLook*>();
    std::optional<double> known_s;
    window.show();
    QCoreApplication::processEvents();
    Probe probe;
    const auto begin = Clock::now();
    QObject::connect(window.findChild<LogCounter*>(), &LogCounter::counted, &window,
                     [&](std::optional<quint64> scans) {
                         if (scans) known_s = seconds_since(begin);
                     });
    open_named(window, line, Audience::nobody);
    const double opened_s = seconds_since(begin);
    while (look.snapshot() == nullptr && !known_s)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    for (QWidget* view :
         {static_cast<QWidget*>(&window.scan_view()), static_cast<QWidget*>(&window.grid_view())})
        view->repaint();
    const double shown_s = seconds_since(begin);
    while (!known_s) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    std::vector<double> answers = probe.finish();
    std::ranges::sort(answers);
    fmt::print("opened after {:.2f} s, first scan in the views after {:.2f} s (limit {:.1f} s)\n",
               opened_s, shown_s, kFirstScan);
    fmt::print("whole log surveyed after {:.2f} s\n", *known_s);
    fmt::print("slowest answer {:.1f} ms, median {:.2f} ms\n", quantile(answers, 1.0),
               quantile(answers, 0.5));
    return shown_s <= kFirstScan ? 0 : 1;
}

}  // namespace hitos::window
