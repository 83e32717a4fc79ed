// SPDX-License-Identifier: GPL-3.0-or-later
// The loops of a run: listed, shown, chosen in the map, changed by hand.

#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSpinBox>
#include <algorithm>
#include <cmath>

#include "gui_fixture.hpp"
#include "inspect/loop_model.hpp"
#include "inspect/loop_table.hpp"
#include "inspect/loop_view.hpp"
#include "look/parameter_text.hpp"
#include "tests.hpp"

namespace hitos::window {
namespace {

class Loops : public Fixture {
  public:
    explicit Loops(bool search = true) {
        Configuracion configuration =
            ArchivoConfiguracion::read(Fixture::source_file("config/recorded.cfg").toStdString());
        configuration.source.file = Fixture::source_file("data/bigloop.log.gz").toStdString();
        configuration.filter.particles = 3;
        configuration.registration.loops = search;
        session.set_configuration(configuration);
    }

    LoopTable& dock() const { return *window->findChild<LoopTable*>(); }
    const LoopModel& model() const { return *dock().findChild<LoopModel*>(); }
    QPushButton& button(const char* name) const { return *dock().findChild<QPushButton*>(name); }
    void press(const char* name) const { QTest::mouseClick(&button(name), Qt::LeftButton); }
    QSpinBox& number(const char* name) const { return *dock().findChild<QSpinBox*>(name); }
    /// To its end with the dock open.
    void run_with_dock() {
        run_to_end();
        trigger("action_loops_dock");
        QTRY_VERIFY(shows_everything() && !session.snapshot()->key_scans.empty());
    }
    bool at_rest() const { return state() == Progress::State::finished && shows_everything(); }
    std::string edits() const { return session.configuration().registration.edits; }
    QString reason() const { return dock().findChild<QLabel*>("loop_reason")->text(); }
    void list(int which) const {
        dock().findChild<QComboBox*>("loops_listed")->setCurrentIndex(which);
    }
    /// The first loop that was closed.
    RunLoop closed() const {
        const auto snapshot = session.snapshot();
        const auto found = std::ranges::find_if(snapshot->loops, &RunLoop::closed);
        if (found == snapshot->loops.end()) qFatal("no loop was closed");
        return *found;
    }
    void choose(const RunLoop& loop) const {
        const auto& loops = model().loops();
        const auto found = std::ranges::find_if(loops, [&](const RunLoop& one) {
            return one.record.scan == loop.record.scan && one.record.earlier == loop.record.earlier;
        });
        if (found == loops.end()) qFatal("the loop is not listed");
        FiguresTable& table = dock().table();
        auto* proxy = qobject_cast<QSortFilterProxyModel*>(table.model());
        const QModelIndex index =
            proxy->mapFromSource(model().index(static_cast<int>(found - loops.begin()), 0));
        table.scrollTo(index);
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(index).center());
    }
};

}  // namespace

void InspectTest::loops_are_listed_with_the_reason() {
    Loops f;
    f.run_to_end();
    QVERIFY(f.session.snapshot()->key_scans.empty());  // nobody looks
    f.trigger("action_loops_dock");
    QTRY_VERIFY(f.shows_everything() && !f.session.snapshot()->key_scans.empty());
    const auto snapshot = f.session.snapshot();
    QVERIFY(std::ranges::all_of(f.model().loops(), &RunLoop::closed));
    f.list(2);
    QVERIFY(!f.model().loops().empty());
    QVERIFY(std::ranges::none_of(f.model().loops(), &RunLoop::closed));
    f.choose(f.model().loops().front());
    QVERIFY2(f.reason().startsWith("Said once: too few searches"), qPrintable(f.reason()));
    f.list(0);
    QCOMPARE(f.model().loops().size(), snapshot->loops.size());

    const QImage before = f.window->grid_view().grab().toImage();
    f.choose(f.closed());
    QVERIFY2(f.reason().startsWith("Closed: the walls match"), qPrintable(f.reason()));
    QVERIFY(f.window->grid_view().grab().toImage() != before);
    // Both passages over each other: most of what the later one saw lies on what the earlier saw.
    const LoopView& view = f.dock().view();
    QVERIFY(view.earlier_points().size() > 500 && view.later_points().size() > 500);
    const auto near = std::ranges::count_if(view.later_points(), [&](const QPointF& point) {
        return std::ranges::any_of(view.earlier_points(), [&](const QPointF& other) {
            return QLineF(point, other).length() < 0.15;
        });
    });
    QVERIFY2(near > static_cast<std::ptrdiff_t>(view.later_points().size()) * 7 / 10,
             qPrintable(QString("%1 of %2").arg(near).arg(view.later_points().size())));
    // To its scans and back.
    const RunLoop loop = f.closed();
    QTest::mouseClick(&f.button("loop_to_earlier"), Qt::LeftButton);
    QTRY_COMPARE(f.session.progress().steps, loop.record.earlier + 1);
}

void InspectTest::a_loop_is_chosen_in_the_map() {
    Loops f;
    f.run_to_end();
    f.trigger("action_loops_dock");
    QTRY_VERIFY(f.shows_everything() && !f.session.snapshot()->key_scans.empty());
    GridView& map = f.window->grid_view();
    LayerSet layers = map.layers();
    layers.set(Layer::graph, true);
    map.set_layers(layers);
    int chosen = 0;
    for (const RunLoop& loop : f.session.snapshot()->loops) {
        if (!loop.closed()) continue;
        f.dock().choose(std::nullopt);
        const QPointF middle((loop.scan.pose.x + loop.earlier.pose.x) / 2.0,
                             (loop.scan.pose.y + loop.earlier.pose.y) / 2.0);
        QTest::mouseClick(&map, Qt::LeftButton, {}, pixel_in(map, middle));
        const int row = f.dock().table().chosen();  // -1 where a landmark lies before it
        if (row < 0) continue;
        ++chosen;
        const RunLoop& found = f.model().loops()[static_cast<std::size_t>(row)];
        QVERIFY(found.closed());
        QVERIFY(QLineF(middle, QPointF(found.scan.pose.x, found.scan.pose.y)).length() < 1.0);
    }
    QVERIFY(chosen > 0);
    f.dock().choose(f.closed());
    QVERIFY(f.dock().table().chosen() >= 0);
    QTest::mouseClick(&map, Qt::LeftButton, {}, {4, 4});  // where nothing is
    QCOMPARE(f.dock().table().chosen(), -1);
}

void InspectTest::a_loop_is_refused_taken_back_and_closed_by_hand() {
    Loops f;
    f.run_to_end();
    f.trigger("action_loops_dock");
    QTRY_VERIFY(f.shows_everything() && !f.session.snapshot()->key_scans.empty());
    const RunLoop loop = f.closed();
    const auto trajectory = f.session.snapshot()->best_trajectory;
    const auto path_is_as_before = [&] {
        const auto& now = f.session.snapshot()->best_trajectory;
        return std::ranges::equal(now, trajectory, {}, &StampedPose::pose, &StampedPose::pose);
    };
    f.choose(loop);
    QCOMPARE(f.button("loop_change").text(), "Refuse");
    QTest::mouseClick(&f.button("loop_change"), Qt::LeftButton);
    const auto at_rest = [&] {
        return f.session.progress().state == Progress::State::finished && f.shows_everything();
    };
    QTRY_VERIFY_WITH_TIMEOUT(at_rest(), 60000);
    const std::string edits = f.session.configuration().registration.edits;
    QVERIFY2(edits.starts_with("refuse " + std::to_string(loop.record.scan + 1) + "@"),
             edits.c_str());
    QVERIFY(f.reason().startsWith("Refused by hand"));
    QCOMPARE(f.button("loop_change").text(), "Take back");
    QVERIFY(!path_is_as_before());
    // What it made of the map is told, and the map from before is one click away.
    const auto* effect = f.dock().findChild<QLabel*>("edit_effect");
    QVERIFY2(effect->text().startsWith("By the last change: χ²"), qPrintable(effect->text()));
    References references;
    references.trajectory = trajectory;
    f.session.set_references(references);
    const QRegularExpression told(
        "^By the last change: error [0-9.]+ → [0-9.]+ m, χ² [0-9.]+ → [0-9.]+, up to [0-9.]+ m "
        "moved\\.$");
    QVERIFY2(told.match(effect->text()).hasMatch(), qPrintable(effect->text()));
    const auto changed = f.session.snapshot();
    f.press("edit_before");
    QVERIFY(path_is_as_before());
    f.press("edit_before");
    QCOMPARE(f.session.snapshot(), changed);
    f.press("edit_before");
    f.session.seek(300);
    QVERIFY(!f.session.shows_before());
    QTRY_VERIFY(f.shows_everything() && f.steps() == 300);
    QVERIFY(!effect->isVisible());
    f.session.run();
    QTRY_VERIFY_WITH_TIMEOUT(at_rest(), 60000);
    f.list(0);
    f.choose(loop);
    f.list(1);
    QTest::mouseClick(&f.button("loop_change"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(at_rest() && f.session.configuration().registration.edits.empty(),
                             60000);
    QVERIFY(path_is_as_before());
    // Undo takes the change up again.
    f.trigger("action_undo");
    QCOMPARE(f.session.configuration().registration.edits, edits);
    QTRY_VERIFY_WITH_TIMEOUT(at_rest(), 60000);
    f.trigger("action_redo");
    QTRY_VERIFY_WITH_TIMEOUT(at_rest() && f.session.configuration().registration.edits.empty(),
                             60000);
    f.list(2);
    f.choose(f.model().loops().front());
    QCOMPARE(f.button("loop_change").text(), "Close");
    QTest::mouseClick(&f.button("loop_change"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(at_rest(), 60000);
    QVERIFY(f.session.configuration().registration.edits.starts_with("close "));
    QVERIFY(std::ranges::any_of(f.session.snapshot()->loops,
                                [](const RunLoop& one) { return one.record.by_hand; }));
}

void InspectTest::a_loop_is_laid_by_hand_and_fitted() {
    Loops f;
    f.run_with_dock();
    f.choose(f.closed());
    LoopView& view = f.dock().view();
    const Pose found = view.pose();
    // By a point of the later passage, which leads away from it.
    view.zoom(4.0);
    const QPoint middle = view.rect().center();
    const auto near = std::ranges::min_element(view.later_points(), {}, [&](const QPointF& point) {
        return QLineF(QPointF(pixel_in(view, point)), QPointF(middle)).length();
    });
    const QPoint grip = pixel_in(view, *near);
    QVERIFY(view.rect().contains(grip));
    const auto drag = [&](Qt::KeyboardModifiers keys, const QPoint& from, const QPoint& by) {
        QTest::mousePress(&view, Qt::LeftButton, keys, from);
        QTest::mouseMove(&view, from + by / 2);
        QTest::mouseMove(&view, from + by);
        QTest::mouseRelease(&view, Qt::LeftButton, keys, from + by);
    };
    const double pixels = view.camera().pixels_per_m;
    drag({}, grip, QPoint(static_cast<int>(0.4 * pixels), 0));
    QVERIFY(view.laid_by_hand());
    QVERIFY2(std::abs(view.pose().x - found.x - 0.4) < 0.05,
             qPrintable(QString::number(view.pose().x - found.x)));
    QCOMPARE(f.button("loop_change").text(), "Close");
    // With keys, back and a degree about.
    view.setFocus();
    for (int i = 0; i < 4; ++i) QTest::keyClick(&view, Qt::Key_Left);
    QTest::keyClick(&view, Qt::Key_Up);
    QTest::keyClick(&view, Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(std::abs(view.pose().theta - found.theta - kRadiansPerDegree) < 1e-9);
    f.press("loop_fit");
    QTRY_VERIFY(f.reason().startsWith("Fitted: score 0."));
    QVERIFY(std::hypot(view.pose().x - found.x, view.pose().y - found.y) < 0.05);
    QVERIFY(std::abs(wrap_angle(view.pose().theta - found.theta)) < 0.02);
    f.press("loop_change");
    QTRY_VERIFY_WITH_TIMEOUT(f.at_rest(), 60000);
    QVERIFY(f.edits().starts_with("close "));
    QCOMPARE(f.button("loop_change").text(), "Take back");
}

void InspectTest::a_loop_that_nobody_found_is_proposed() {
    Loops f(false);
    f.run_with_dock();
    QVERIFY(f.session.snapshot()->loops.empty());
    // The second lap over the first, by numbers.
    f.number("loop_earlier").setValue(60);
    f.number("loop_scan").setValue(551);
    QVERIFY(f.button("loop_change").isEnabled());
    QVERIFY(f.reason().startsWith("As the path has both passages"));
    QVERIFY(f.dock().view().later_points().size() > 500);
    f.press("loop_fit");
    QTRY_VERIFY(f.reason().startsWith("Fitted: score 0."));
    f.press("loop_change");
    QTRY_VERIFY_WITH_TIMEOUT(f.at_rest() && !f.session.snapshot()->loops.empty(), 60000);
    const RunLoop loop = f.session.snapshot()->loops.front();
    QVERIFY(loop.record.by_hand && loop.record.score > 0.5);
    QVERIFY(f.reason().startsWith("Closed: somebody has put it in"));
    // And by two clicks in the map.
    f.button("loop_pick").setChecked(true);
    GridView& map = f.window->grid_view();
    for (const std::uint64_t scan : {700U, 250U}) {
        const Pose pose = f.session.snapshot()->best_trajectory[scan].pose;
        QTest::mouseClick(&map, Qt::LeftButton, {}, pixel_in(map, {pose.x, pose.y}));
    }
    QVERIFY(!f.button("loop_pick").isChecked());
    QVERIFY(std::abs(f.number("loop_scan").value() - f.number("loop_earlier").value()) > 20);
    QVERIFY(f.button("loop_change").isEnabled());
}

void InspectTest::a_proposed_loop_is_of_its_tour() {
    Loops f(false);
    f.run_steps(120);
    f.trigger("action_loops_dock");
    QTRY_VERIFY(f.shows_everything() && !f.session.snapshot()->key_scans.empty());
    f.number("loop_scan").setValue(100);
    QVERIFY(f.button("loop_change").isEnabled() && f.reason().startsWith("As the path"));
    // Behind another dock and back.
    f.trigger("action_landmarks_dock");
    f.trigger("action_landmarks_dock");
    QTRY_VERIFY(f.dock().isVisible() && f.dock().isEnabled());
    QVERIFY(f.reason().startsWith("As the path"));
    f.dock().findChild<FiguresTable*>("loop_table")->setFocus();
    const QSignalSpy shown(&f.dock(), &LoopTable::loop_shown);
    Configuracion other = f.session.configuration();
    other.source.file = Fixture::source_file("data/bigloop-noisy.log.gz").toStdString();
    f.session.set_configuration(other);
    // The keyboard goes to nobody else while there is nothing to show.
    const QWidget* keys = f.window->focusWidget();
    QVERIFY2(keys == f.window->findChild<QLabel*>("no_loops"),
             qPrintable(keys == nullptr ? QString("nobody") : keys->objectName()));
    f.run_steps(120);
    QTRY_VERIFY(f.shows_everything() &&
                f.window->focusWidget() == f.dock().findChild<FiguresTable*>("loop_table"));
    QVERIFY(!f.button("loop_change").isEnabled());
    QVERIFY(!shown.isEmpty() && !shown.last().front().value<std::optional<RunLoop>>());
}

void InspectTest::a_step_that_slipped_is_listed_and_taken_back() {
    Loops f;
    f.run_steps(120);
    f.trigger("action_loops_dock");
    QTRY_VERIFY(f.shows_everything() && f.button("edit_slip").isEnabled());
    QCOMPARE(f.button("edit_slip").text(), "The step to 120 slipped");
    f.press("edit_slip");
    QTRY_VERIFY(f.state() == Progress::State::paused && f.shows_everything());
    QCOMPARE(f.steps(), 120);
    QVERIFY2(f.edits().starts_with("slip 120@"), f.edits().c_str());
    QVERIFY(!f.button("edit_slip").isEnabled());
    auto* list = f.dock().findChild<QListWidget*>("graph_edits");
    QVERIFY(list->isVisible());
    QCOMPARE(list->item(0)->text(), "1. The step to scan 120 slipped");
    // As Undo says it, too.
    Configuracion without = f.session.configuration();
    without.registration.edits.clear();
    const QString told = change_words(f.session.configuration(), without);
    QVERIFY2(told.endsWith(" The step to scan 120 slipped"), qPrintable(told));
    list->setCurrentRow(0);
    f.press("edit_take_back");
    QTRY_VERIFY(f.edits().empty() && f.shows_everything());
    QVERIFY(!list->isVisible());
}

void InspectTest::keys_take_changes_back_from_the_panel_of_loops() {
    Loops f;
    f.run_steps(120);
    f.trigger("action_loops_dock");
    QTRY_VERIFY(f.shows_everything() && f.button("edit_slip").isEnabled());
    f.window->activateWindow();
    QTRY_VERIFY(f.window->isActiveWindow());
    auto* at = f.dock().findChild<QLineEdit*>("edit_fix_at");
    const auto undone_from = [&](QWidget* with_keys) {
        with_keys->setFocus();
        QTest::keySequence(QApplication::focusWidget(), QKeySequence::Undo);
        QTRY_VERIFY(f.edits().empty() && f.shows_everything());
    };
    for (const char* change : {"edit_slip", "edit_fix"}) {
        // Neither the next button nor a field has the keys then.
        f.button(change).setFocus();
        QTest::keyClick(&f.button(change), Qt::Key_Space);
        QTRY_VERIFY(!f.edits().empty() && f.shows_everything());
        QVERIFY(!f.button(change).isEnabled());
        QTRY_COMPARE(QApplication::focusWidget(), &f.dock().table());
        undone_from(&f.dock().table());
        f.press(change);
        QTRY_VERIFY(!f.edits().empty() && f.shows_everything());
        undone_from(at);
    }
    // Who writes undoes what is written.
    f.press("edit_slip");
    QTRY_VERIFY(!f.edits().empty() && f.shows_everything());
    const QString place = at->text();
    at->setFocus();
    QTest::keyClicks(at, "1");
    QTest::keySequence(at, QKeySequence::Undo);
    QCOMPARE(at->text(), place);
    QVERIFY(!f.edits().empty());
    undone_from(&f.number("loop_scan"));
}

void InspectTest::what_is_wrong_with_changes_stands_below_them() {
    Loops f;
    f.run_with_dock();
    const auto* told = f.dock().findChild<QLabel*>("edit_warnings");
    QVERIFY(!told->isVisible());
    const auto change_to = [&](const std::string& edits) {
        f.session.set_edits(edits);
        QTRY_VERIFY_WITH_TIMEOUT(f.at_rest() && f.session.of_run(), 60000);
    };
    change_to("slip 60; refuse 200 3");
    QVERIFY(told->isVisible());
    QVERIFY2(told->text().startsWith("⚠ Changes by hand have met nothing to change (no. 2 of"),
             qPrintable(told->text()));
    QVERIFY(!told->text().contains('\n'));
    change_to("slip 60");
    QVERIFY(!told->isVisible());
    f.session.set_edits("slip 60; slip 100@1234567");
    QTRY_VERIFY_WITH_TIMEOUT(f.state() == Progress::State::failed && told->isVisible(), 60000);
    QVERIFY2(told->text().contains("change 2 is of another tour"), qPrintable(told->text()));
}

void InspectTest::a_narrow_panel_of_loops_says_all() {
    Loops f;
    f.window->resize(1024, 708);
    f.run_with_dock();
    f.session.set_edits("slip 60; slip 90; slip 120; refuse 200 3; refuse 240 4");
    QTRY_VERIFY_WITH_TIMEOUT(f.at_rest() && f.session.of_run(), 60000);
    auto* dock = f.window->findChild<QDockWidget*>("loops_dock");
    f.window->resizeDocks({dock}, {1}, Qt::Horizontal);
    const auto* area = f.dock().findChild<QScrollArea*>();
    // What does not fit scrolls down.
    QVERIFY(area != nullptr);
    QTRY_VERIFY(area->verticalScrollBar()->maximum() > 0);
    QCOMPARE(f.window->size(), QSize(1024, 708));
    if (const QString folder = qEnvironmentVariable("HITOS_PICTURES"); !folder.isEmpty())
        f.window->grab().save(folder + "/narrow.png");
    QCOMPARE(area->horizontalScrollBar()->maximum(), 0);
    const QWidget& content = *area->widget();
    for (const auto* label : content.findChildren<QLabel*>()) {
        if (!label->isVisible()) continue;
        const QString told = QString("%1: %2 x %3: %4")
                                 .arg(label->objectName())
                                 .arg(label->width())
                                 .arg(label->height())
                                 .arg(label->text());
        QVERIFY2(label->height() >= label->heightForWidth(label->width()), qPrintable(told));
    }
    for (const auto* button : content.findChildren<QPushButton*>()) {
        if (!button->isVisible()) continue;
        const QRect place(button->mapTo(&content, QPoint()), button->size());
        QVERIFY2(content.rect().contains(place) && button->width() >= button->sizeHint().width(),
                 qPrintable(button->text()));
    }
    QVERIFY(f.dock().view().height() >= 120 && f.dock().table().height() >= 80);
}

void InspectTest::a_scan_is_fixed_where_somebody_says() {
    Loops f(false);
    f.run_to_end();
    f.trigger("action_loops_dock");
    QTRY_VERIFY(f.at_rest() && f.button("edit_fix").isEnabled());
    const auto before = f.session.snapshot();
    const auto scans = before->steps;
    QCOMPARE(f.button("edit_fix").text(), QString("Fix scan %1 at").arg(scans));
    auto* at = f.dock().findChild<QLineEdit*>("edit_fix_at");
    at->setFocus();
    at->setText("1, 2");
    QVERIFY(!f.button("edit_fix").isEnabled());
    at->setText("1.5, 2.25, 90");
    QTest::keyClick(at, Qt::Key_Return);
    const auto is_there = [&](const Snapshot& snapshot) {
        const Pose& pose = snapshot.best_trajectory.back().pose;
        return std::hypot(pose.x - 1.5, pose.y - 2.25) < 0.1 && std::abs(pose.theta - 1.57) < 0.1;
    };
    QTRY_VERIFY_WITH_TIMEOUT(f.at_rest(), 60000);
    QVERIFY2(f.edits().starts_with("fix " + std::to_string(scans) + "@"), f.edits().c_str());
    QVERIFY(is_there(*f.session.snapshot()));
    QVERIFY(!f.button("edit_fix").isEnabled());
    // Taken back, what was before is there at once.
    f.trigger("action_undo");
    QVERIFY(f.session.snapshot() && f.session.snapshot()->foreseen);
    QVERIFY(f.session.snapshot()->best_trajectory == before->best_trajectory);
    QTRY_VERIFY_WITH_TIMEOUT(f.at_rest(), 60000);
    QVERIFY(!f.session.snapshot()->foreseen);
    QVERIFY(f.session.snapshot()->best_trajectory == before->best_trajectory);
}

void InspectTest::without_registration_there_are_no_loops() {
    Fixture f;
    f.run_steps(20);
    f.trigger("action_loops_dock");
    const auto* none = f.window->findChild<QLabel*>("no_loops");
    QVERIFY(none->isVisible());
    QVERIFY(none->text().contains("not registered"));
    QVERIFY(!f.window->findChild<FiguresTable*>("loop_table")->isVisible());
}

}  // namespace hitos::window
