// SPDX-License-Identifier: GPL-3.0-or-later
// How often the window reads a log.

#include <QDialogButtonBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>

#include "actions/configuration_actions.hpp"
#include "counted_format.hpp"
#include "dialogs/source_dialog.hpp"
#include "gui_fixture.hpp"
#include "hitos/capture/stamp_line.hpp"
#include "tests.hpp"
#include "workers/first_look.hpp"

namespace hitos::window {

/// In a program of its own: the format would be among those that other tests list.
void ReadingsTest::initTestCase() {
    test::add_counted_format();
}

void ReadingsTest::a_log_is_read_once_to_look_at_it_and_once_to_run_it() {
    constexpr int kScans = 40;
    // The stamp of the first one is judged by those behind it.
    constexpr int kToLookAt = static_cast<int>(StampJudge::kRun) + 1;
    Fixture f(false);
    const std::string log = test::CountedConversor::log(kScans);
    const QString path = f.write("counted.txt", QByteArray::fromStdString(log));
    test::scans_made = 0;
    in_dialog<SourceDialog>([path](SourceDialog& dialog) {
        dialog.set_path(path);
        auto* ok = dialog.findChild<QDialogButtonBox*>("buttons")->button(QDialogButtonBox::Ok);
        QTRY_VERIFY(ok->isEnabled());
        ok->click();
    });
    f.trigger("action_select_source");
    const auto* scan = f.window->findChild<QLabel*>("status_scan");
    QTRY_VERIFY2(scan->text().contains("40"), qPrintable(scan->text()));
    // The first one once more, to be shown before the run.
    const auto* look = f.window->findChild<FirstLook*>();
    QTRY_VERIFY(look->snapshot() != nullptr);
    QCOMPARE(test::scans_made.load(), kScans + kToLookAt);
    f.run_to_end();
    f.prompts.saves = {f.path("results")};
    f.trigger("action_save_results");
    QTRY_VERIFY(QFile::exists(f.path("results/summary.json")));
    QCOMPARE(test::scans_made.load(), 2 * kScans + kToLookAt);
    // One that is opened without the form is looked at beside the run.
    test::scans_made = 0;
    const QString other = f.write("other.txt", QByteArray::fromStdString(log + "C 40\n"));
    QVERIFY(f.window->configuration_actions().open(other));
    QTRY_VERIFY2(scan->text().contains("41"), qPrintable(scan->text()));
    f.run_to_end();
    QTRY_VERIFY(look->snapshot() != nullptr);
    QCOMPARE(test::scans_made.load(), 2 * (kScans + 1) + kToLookAt);
}

}  // namespace hitos::window
