// SPDX-License-Identifier: GPL-3.0-or-later
// Graphs of poses from files: seen, changed by hand, solved and written as hitos-cli graph does.

#include <QCheckBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QProcess>
#include <QPushButton>
#include <QSpinBox>
#include <QUrl>
#include <algorithm>
#include <cmath>

#include "actions/command_line.hpp"
#include "app/opening.hpp"
#include "gui_fixture.hpp"
#include "hitos/services/files/g2o_file.hpp"
#include "inspect/graph_model.hpp"
#include "inspect/graph_view.hpp"
#include "inspect/graph_window.hpp"
#include "spoken.hpp"
#include "tests.hpp"
#include "unit/slam/manhattan.hpp"

namespace hitos::window {
namespace {

/// A town with two loops that are false, between poses 20 and 150 and 40 and 220.
PlanarGraph town() {
    PlanarGraph graph =
        test::ManhattanWorld({.poses = 300, .half_m = 8.0, .points = 6, .lines = 3}).graph;
    for (const auto& [from, to] : {std::pair(20U, 150U), std::pair(40U, 220U)}) {
        PlanarEdge& edge = graph.edges.emplace_back();
        edge.from = from;
        edge.to = to;
        edge.z << 0.3, -0.2, 0.1;
        edge.information.diagonal() << 400.0, 400.0, 2500.0;
    }
    return graph;
}

struct Graphs : Fixture {
    Graphs() : Fixture(false) {}

    QString town_file() const {
        return write("town.g2o", QByteArray::fromStdString(g2o_text(town())));
    }
    /// Null where none is open.
    GraphWindow* graph() const { return window->findChild<GraphWindow*>(); }
    bool rests() const {
        return graph() != nullptr && !graph()->busy() && graph()->shown() &&
               graph()->shown()->stage == ShownGraph::Stage::solved;
    }
    void open(const QString& path) {
        prompts.opens = {path};
        trigger("action_open_graph");
        QTRY_VERIFY(rests() && graph()->isActiveWindow());
    }
    template <class Part>
    Part& part(const char* name) const {
        auto* found = graph()->findChild<Part*>(name);
        if (found == nullptr) qFatal("no %s", name);
        return *found;
    }
    QPushButton& button(const char* name) const { return part<QPushButton>(name); }
    void press(const char* name) const {
        QVERIFY2(button(name).isEnabled(), name);
        button(name).click();
        QTRY_VERIFY(rests());
    }
    void name_poses(const QString& a, const QString& b) const {
        for (const auto& [name, id] : {std::pair("graph_a", a), std::pair("graph_b", b)}) {
            auto& line = part<QLineEdit>(name);
            line.selectAll();
            QTest::keyClick(&line, Qt::Key_Delete);
            QTest::keyClicks(&line, id);
        }
    }
    void type(const char* name, const QString& text) const {
        auto& line = part<QLineEdit>(name);
        line.selectAll();
        QTest::keyClicks(&line, text);
    }
    const std::vector<GraphModel::Row>& rows() const {
        return graph()->findChild<GraphModel*>()->rows();
    }
    bool lists(std::uint64_t from, std::uint64_t to) const {
        return std::ranges::any_of(
            rows(), [&](const GraphModel::Row& row) { return row.from == from && row.to == to; });
    }
    QMap<QString, QByteArray> files_in(const QString& name) const {
        QMap<QString, QByteArray> all;
        for (const QString& file : QDir(path(name)).entryList(QDir::Files | QDir::Hidden))
            all[file] = read(path(name) + '/' + file);
        return all;
    }
    static int call_command(const QStringList& arguments) {
        QProcess program;
        program.start(QString(HITOS_BIN_DIR) + "/hitos-cli", arguments);
        return program.waitForFinished(kPatienceMs) ? program.exitCode() : -1;
    }
};

}  // namespace

void GraphTest::a_graph_is_shown_with_its_worst_edges_data() {
    add_languages();
}

void GraphTest::a_graph_is_shown_with_its_worst_edges() {
    QFETCH(const QString, language);
    const Spoken spoken(language);
    Graphs f;
    f.open(f.town_file());
    f.graph()->resize(1180, 700);
    QCOMPARE(f.rows().size(), 10U);
    QVERIFY(f.lists(20, 150) && f.lists(40, 220));
    QVERIFY(std::ranges::is_sorted(f.rows(), std::greater<>(), &GraphModel::Row::sigmas));
    QVERIFY(f.files.recent().contains(f.path("town.g2o")));
    const QString words = f.part<QLabel>("graph_words").text();
    QVERIFY2(words.startsWith("Poses: 300, "), qPrintable(words));
    // As the file has it and solved are two pictures.
    GraphView& view = f.graph()->view();
    const QImage solved = view.grab().toImage();
    f.button("graph_before").click();
    QVERIFY(view.grab().toImage() != solved);
    f.button("graph_before").click();
    QCOMPARE(view.grab().toImage(), solved);
    // A row and a click on the edge choose the same.
    const auto row = std::ranges::find(f.rows(), 150U, &GraphModel::Row::to);
    const QModelIndex index =
        f.graph()->table().model()->index(static_cast<int>(row - f.rows().begin()), 0);
    QTest::mouseClick(f.graph()->table().viewport(), Qt::LeftButton, {},
                      f.graph()->table().visualRect(index).center());
    QCOMPARE(f.part<QLineEdit>("graph_a").text(), "150");
    QCOMPARE(f.part<QLineEdit>("graph_b").text(), "20");
    QVERIFY(view.grab().toImage() != solved);
    QVERIFY(keep_picture(*f.graph(), "graph.png"));  // of the guide
    const auto pixel = [&](std::uint32_t vertex) {
        const Point2 place = view.place_of(vertex);
        return pixel_in(view, {place.x, place.y});
    };
    f.name_poses("", "");
    QCOMPARE(f.graph()->table().chosen(), -1);
    QTest::mouseClick(&view, Qt::LeftButton, {}, pixel(150));
    const QString clicked = f.part<QLineEdit>("graph_a").text();  // perhaps one that lies on it
    QVERIFY(!clicked.isEmpty());
    QVERIFY((pixel(clicked.toUInt()) - pixel(150)).manhattanLength() < 6);
    // With fewer of them in the table.
    f.part<QSpinBox>("graph_worst").setValue(2);
    QTRY_VERIFY(f.rests() && f.rows().size() == 2);
}

void GraphTest::changes_are_solved_at_once_undone_and_taken_back() {
    Graphs f;
    f.open(f.town_file());
    const double first = f.graph()->shown()->solved.solution.chi_square_after;
    const auto chi = [&] { return f.graph()->shown()->solved.solution.chi_square_after; };
    f.name_poses("150", "20");
    f.press("graph_refuse");
    QVERIFY(!f.lists(20, 150));
    QVERIFY(chi() < first);
    const double second = chi();
    f.name_poses("220", "40");
    f.graph()->table().setFocus();
    QTest::keyClick(&f.graph()->table(), Qt::Key_Delete);
    QTRY_VERIFY(f.rests() && f.graph()->edits().size() == 2);
    QVERIFY(chi() < second);
    const double third = chi();
    QTest::keyClick(f.graph(), Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(f.rests() && f.graph()->edits().size() == 1);
    QCOMPARE(chi(), second);
    QTest::keySequence(f.graph(), QKeySequence::Redo);
    QTRY_VERIFY(f.rests() && f.graph()->edits().size() == 2);
    QCOMPARE(chi(), third);
    auto& list = f.part<QListWidget>("graph_edits");
    QCOMPARE(list.count(), 2);
    list.setCurrentRow(0);
    f.press("graph_take_back");
    QCOMPARE(list.count(), 1);
    QVERIFY(f.lists(20, 150) && !f.lists(40, 220));
    // What is typed is where it goes, to the digit.
    f.name_poses("300", "0");  // there is none of that name
    QVERIFY(!f.button("graph_fix").isEnabled() && !f.button("graph_slip").isEnabled());
    f.name_poses("299", "0");
    f.type("graph_fix_at", "1.5, -2, 90");
    const auto away = [&] {
        const Pose pose = f.graph()->shown()->solved.graph.vertices[299].pose();
        return std::hypot(pose.x - 1.5, pose.y + 2.0);
    };
    const double before = away();
    f.press("graph_fix");
    QVERIFY2(away() < 0.5 * before, qPrintable(QString::number(away() / before)));
    QCOMPARE(f.graph()->edits().back().pose, (Pose{1.5, -2.0, kPi / 2.0}));
    f.press("graph_slip");
    f.type("graph_close_at", "0.5, 0, 180");
    f.press("graph_close");
    QCOMPARE(f.graph()->edits().size(), 4U);
    const QString closed = list.item(3)->text();
    QVERIFY2(closed.startsWith("4. Closed: 299 seen from 0 ("), qPrintable(closed));
    QVERIFY2(closed.endsWith(" σ off)"), qPrintable(closed));
    // What cannot be read looks wrong.
    auto& line = f.part<QLineEdit>("graph_fix_at");
    f.type("graph_fix_at", "1.5, -2");
    QCOMPARE(line.property("state").toString(), "wrong");
    f.type("graph_fix_at", "1.5, -2, 0");
    QCOMPARE(line.property("state").toString(), "good");
}

void GraphTest::keys_undo_changes_unless_somebody_writes() {
    Graphs f;
    f.open(f.town_file());
    const auto press = [](const QKeySequence& keys) {
        QTest::keySequence(QApplication::focusWidget(), keys);
    };
    const auto undo = [&] { press(QKeySequence::Undo); };
    const auto changes = [&] { return f.graph()->edits().size(); };
    auto& a = f.part<QLineEdit>("graph_a");
    f.name_poses("150", "20");
    // What goes out of use does not hand the keys to a field, or to another change.
    f.button("graph_refuse").setFocus();
    press(Qt::Key_Space);
    QTRY_VERIFY(f.rests() && changes() == 1);
    QVERIFY(!f.button("graph_refuse").isEnabled());
    QCOMPARE(QApplication::focusWidget(), &f.graph()->table());
    for (QWidget* with_keys :
         {static_cast<QWidget*>(&f.graph()->table()), static_cast<QWidget*>(&a),
          static_cast<QWidget*>(&f.part<QSpinBox>("graph_worst"))}) {
        with_keys->setFocus();
        undo();
        QTRY_VERIFY(f.rests() && changes() == 0);
        undo();  // there is nothing to undo, and no text either
        press(QKeySequence::Redo);
        QTRY_VERIFY(f.rests() && changes() == 1);
        QCOMPARE(a.text(), QString("150"));
    }
    // Who writes undoes what is written.
    a.setFocus();
    QTest::keyClicks(&a, "7");
    const QString written = a.text();
    QVERIFY(written != "150");
    undo();
    QTRY_VERIFY(f.rests());
    QVERIFY(a.text() != written);
    QCOMPARE(changes(), 1U);
    // By keys again and again: at the end no other button has taken the place.
    f.button("graph_undo").setFocus();
    press(Qt::Key_Space);
    QTRY_VERIFY(f.rests() && changes() == 0);
    QCOMPARE(QApplication::focusWidget(), &f.graph()->table());
}

void GraphTest::of_two_changes_of_the_same_poses_the_later_stands() {
    Graphs f;
    f.open(f.town_file());
    const auto kind = [&] { return f.graph()->edits().back().kind; };
    QVERIFY(!f.button("graph_refuse").isEnabled());
    f.name_poses("150", "20");
    f.press("graph_refuse");
    QVERIFY(!f.button("graph_refuse").isEnabled());  // there is none any more
    const QString line = f.part<QListWidget>("graph_edits").item(0)->text();
    QVERIFY2(line.startsWith("1. Refused: the edges between 150 and 20 ("), qPrintable(line));
    f.type("graph_close_at", "0.5, 0, 180");
    f.press("graph_close");
    QCOMPARE(f.graph()->edits().size(), 1U);
    QCOMPARE(kind(), GraphEdit::Kind::close);
    const QString words = f.part<QLabel>("graph_words").text();
    QVERIFY2(words.startsWith("Another change of the same poses was given up for it: Refused: the "
                              "edges between 150 and 20. Poses: 300"),
             qPrintable(words));
    f.press("graph_refuse");
    QCOMPARE(f.graph()->edits().size(), 1U);
    QCOMPARE(kind(), GraphEdit::Kind::refuse);
    // What is there by hand alone goes with its change.
    f.name_poses("200", "10");
    QVERIFY(!f.button("graph_refuse").isEnabled());
    f.press("graph_close");
    QCOMPARE(f.graph()->edits().size(), 2U);
    f.press("graph_refuse");
    QCOMPARE(f.graph()->edits().size(), 1U);
    QCOMPARE(f.prompts.warnings, QStringList());
}

void GraphTest::a_graph_that_fits_has_nothing_marked() {
    Graphs f;
    QByteArray text;
    for (int i = 0; i < 12; ++i) text += QString("VERTEX_SE2 %1 %1 0 0\n").arg(i).toUtf8();
    for (int i = 0; i < 11; ++i)
        text += QString("EDGE_SE2 %1 %2 1 0 0 1 0 0 1 0 1\n").arg(i).arg(i + 1).toUtf8();
    f.open(f.write("fits.g2o", text));
    QCOMPARE(f.rows().size(), 10U);
    const QImage picture = f.graph()->view().grab().toImage();
    const QColor path = picture.pixelColor(pixel_in(f.graph()->view(), {3.5, 0.0}));
    QVERIFY2(path.blue() > path.red() + 50, qPrintable(path.name()));  // is drawn, and not red
    f.part<QSpinBox>("graph_worst").setValue(0);
    QTRY_VERIFY(f.rests() && f.rows().empty());
    QCOMPARE(f.graph()->view().grab().toImage(), picture);
}

void GraphTest::ids_of_many_digits_leave_room_for_errors() {
    Graphs f;
    f.open(f.write("long.g2o",
                   "VERTEX_SE2 1234567890 0 0 0\nVERTEX_SE2 1234567891 0 9 0\n"
                   "EDGE_SE2 1234567890 1234567891 0 9 0 1 0 0 1 0 1\n"
                   "EDGE_SE2 1234567890 1234567891 0 9.5 0 1 0 0 1 0 1\n"));
    f.graph()->resize(1180, 700);
    const FiguresTable& table = f.graph()->table();
    QTRY_VERIFY(table.columnViewportPosition(GraphModel::error) +
                    table.columnWidth(GraphModel::error) <=
                table.viewport()->width());
    // Nothing lies below the legend.
    const GraphView& view = f.graph()->view();
    for (const std::uint32_t vertex : {0U, 1U}) {
        const Point2 place = view.place_of(vertex);
        QVERIFY(pixel_in(view, {place.x, place.y}).y() > 2 * view.fontMetrics().height());
    }
}

void GraphTest::the_window_writes_what_the_command_writes_data() {
    QTest::addColumn<bool>("robust");
    QTest::addRow("plain") << false;
    QTest::addRow("robust") << true;
}

void GraphTest::the_window_writes_what_the_command_writes() {
    QFETCH(bool, robust);
    Graphs f;
    const QString town = f.town_file();
    f.open(town);
    f.part<QCheckBox>("graph_robust").setChecked(robust);
    f.part<QSpinBox>("graph_worst").setValue(7);
    f.name_poses("150", "20");
    f.press("graph_refuse");
    f.name_poses("7", "3");
    f.press("graph_close");  // as they lie
    f.press("graph_slip");
    f.press("graph_fix");
    f.prompts.saves = {f.path("by-window")};
    f.press("graph_save");
    QCOMPARE(f.prompts.warnings, QStringList());
    const QMap<QString, QByteArray> written = f.files_in("by-window");
    QCOMPARE(written.keys(), (QStringList{"edits.txt", "graph.g2o", "graph.png", "graph.svg"}));
    QStringList arguments{"graph",   town, "--edits", f.path("by-window/edits.txt"),
                          "--worst", "7",  "--out",   f.path("by-command")};
    if (robust) arguments << "--robust";
    QCOMPARE(Graphs::call_command(arguments), 0);
    QVERIFY(f.files_in("by-command") == written);
    // They are written, so that nothing is lost; read again they are the same.
    const std::vector<GraphEdit> edits = f.graph()->edits();
    f.graph()->close();
    QCOMPARE(f.prompts.confirmed_texts, QStringList());
    QTRY_VERIFY(f.graph() == nullptr);
    f.open(town);
    f.prompts.opens = {f.path("by-window/edits.txt")};
    f.press("graph_open_edits");
    QVERIFY(f.graph()->edits() == edits);
}

void GraphTest::what_is_no_graph_is_told_and_nothing_is_lost() {
    Graphs f;
    f.open(f.town_file());
    f.name_poses("150", "20");
    f.press("graph_refuse");
    const QString wrong = f.write("wrong.g2o", "VERTEX_SE2 1 0 0\n");
    f.prompts.opens = {wrong};
    f.trigger("action_open_graph");
    QTRY_COMPARE(f.prompts.warnings.size(), 1);
    QVERIFY2(f.prompts.warnings.front().contains("wrong.g2o:1: found 3 fields"),
             qPrintable(f.prompts.warnings.front()));
    QCOMPARE(f.prompts.warning_titles.front(), "The graph was not opened");
    QTRY_COMPARE(f.window->findChildren<GraphWindow*>().size(), 1);
    QVERIFY(!f.files.recent().contains(wrong));
    QCOMPARE(f.graph()->edits().size(), 1U);
    QVERIFY(f.rests());
    // Changes that meet nothing, contradict others or cannot be read.
    const auto refused = [&](const QString& reason) {
        QTRY_VERIFY(!f.prompts.warnings.isEmpty() && f.rests());
        const QString told = f.prompts.warnings.takeLast();
        QVERIFY2(told.contains(reason), qPrintable(told));
        QCOMPARE(f.graph()->edits().size(), 1U);
        QCOMPARE(f.graph()->shown()->edits.size(), 1U);
    };
    f.prompts.warnings.clear();
    f.prompts.opens = {f.write("none.txt", "refuse 10 200\n")};
    f.button("graph_open_edits").click();
    refused("the graph has no edge between the poses 10 and 200");
    f.prompts.opens = {f.write("twice.txt", "refuse 150 20\nclose 20 150 0 0 0\n")};
    f.button("graph_open_edits").click();
    refused("is of the same poses as change 1");
    f.prompts.opens = {f.write("edits.txt", "slip 3\nmove 7\n")};
    f.button("graph_open_edits").click();
    refused("edits.txt:2: change 2: found \"move 7\"; expected");
    f.prompts.opens = {f.write("other.txt", "slip 7777\n")};
    f.button("graph_open_edits").click();
    refused("the graph has no pose with the id 7777");
    // Where its own graph would go, or a run's results are.
    const QByteArray before = Fixture::read(f.path("town.g2o"));
    QVERIFY(QDir(f.path("")).mkpath("run"));
    f.write("run/summary.json", "{}");
    f.prompts.confirms = {true};
    f.prompts.saves = {f.path("run")};
    f.button("graph_save").click();
    refused("holds the results of a run");
    QCOMPARE(Fixture::read(f.path("town.g2o")), before);
}

void GraphTest::its_own_file_is_not_written_over() {
    Graphs f;
    QVERIFY(QDir(f.path("")).mkpath("old"));
    const QString file = f.write("old/graph.g2o", QByteArray::fromStdString(g2o_text(town())));
    const QByteArray before = Fixture::read(file);
    f.open(file);
    f.prompts.confirms = {true};
    f.prompts.saves = {f.path("old")};
    f.press("graph_save");
    QCOMPARE(f.prompts.warnings.size(), 1);
    QVERIFY2(f.prompts.warnings.front().contains("is read by this very command"),
             qPrintable(f.prompts.warnings.front()));
    QCOMPARE(f.files_in("old").keys(), QStringList{"graph.g2o"});
    QCOMPARE(Fixture::read(file), before);
}

void GraphTest::changes_that_are_written_nowhere_are_asked_about() {
    Graphs f;
    f.open(f.town_file());
    f.name_poses("150", "20");
    f.press("graph_refuse");
    f.graph()->close();  // cancelled
    QCOMPARE(f.prompts.confirmed_texts.size(), 1);
    QVERIFY(f.graph()->isVisible());
    f.window->close();
    QCOMPARE(f.prompts.confirmed_texts.size(), 2);
    QVERIFY(f.window->isVisible());
    QTest::keyClick(f.graph(), Qt::Key_Escape);
    QCOMPARE(f.prompts.confirmed_texts.size(), 3);
    f.prompts.confirms = {true};
    f.graph()->close();
    QTRY_VERIFY(f.graph() == nullptr);
}

void GraphTest::a_graph_is_dropped_and_named_on_the_command_line() {
    Graphs f;
    const QString file = f.town_file();
    QCOMPARE(kind_of(file), FileKind::graph);
    QCOMPARE(kind_of("a.G2O.gz"), FileKind::graph);
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(f.window.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(f.window.get(), &drop);
    QTRY_VERIFY(f.rests());
    f.graph()->close();
    QTRY_VERIFY(f.graph() == nullptr);
    CommandLine line;
    line.open = file.toStdString();
    open_named(*f.window, line, Audience::somebody);
    QTRY_VERIFY(f.rests());
    QCOMPARE(f.prompts.warnings, QStringList());
    QVERIFY(f.session.configuration().source.file.ends_with("bigloop-noisy.log.gz"));
}

void GraphTest::a_window_that_closes_waits_for_nothing() {
    Graphs f;
    const test::ManhattanWorld large({.poses = 3000});
    const QString file = f.write("large.g2o", QByteArray::fromStdString(g2o_text(large.graph)));
    f.prompts.opens = {file};
    f.trigger("action_open_graph");
    QTRY_VERIFY(f.graph() != nullptr && f.graph()->shown());
    f.graph()->close();  // while it is solved
    QTRY_VERIFY(f.graph() == nullptr);
    QCOMPARE(f.prompts.warnings, QStringList());
}

}  // namespace hitos::window
