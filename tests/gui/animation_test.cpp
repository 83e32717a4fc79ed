// SPDX-License-Identifier: GPL-3.0-or-later
// A run as an animation. What makes the film is a script of the test's own, or missing.

#include <QCheckBox>
#include <QComboBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QSpinBox>
#include <QToolTip>

#include "animation/animation_dialog.hpp"
#include "gui_fixture.hpp"
#include "tests.hpp"

namespace hitos::window {
namespace {

/// The programs that are there: those in one folder.
class OnlyPath {
  public:
    explicit OnlyPath(const QString& folder) : before_(qgetenv("PATH")) {
        qputenv("PATH", folder.toUtf8());
    }
    ~OnlyPath() { qputenv("PATH", before_); }
    OnlyPath(const OnlyPath&) = delete;
    OnlyPath& operator=(const OnlyPath&) = delete;

  private:
    QByteArray before_;
};

QString folder_of_programs(const Fixture& f) {
    QDir().mkpath(f.path("programs"));
    return f.path("programs");
}

/// Writes into its last argument what it was given.
void make_film_maker(const Fixture& f) {
    const QString program = f.write("programs/ffmpeg",
                                    "#!/bin/sh\n"
                                    "for film; do :; done\n"
                                    "echo \"$@\" frame-*.png > \"$film\"\n");
    QFile::setPermissions(program, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
}

void ask_for(int from, int to, int every) {
    in_dialog<AnimationDialog>([=](AnimationDialog& dialog) {
        dialog.findChild<QSpinBox*>("animation_from")->setValue(from);
        dialog.findChild<QSpinBox*>("animation_to")->setValue(to);
        dialog.findChild<QSpinBox*>("animation_every")->setValue(every);
        dialog.findChild<QSpinBox*>("animation_rate")->setValue(12);
        dialog.accept();
    });
}

}  // namespace

void ViewTest::what_is_told_at_a_field_covers_no_other() {
    Fixture f;
    f.run_to_end();
    QTRY_VERIFY(f.window->result_actions().total());
    const int scans = static_cast<int>(*f.window->result_actions().total());
    in_dialog<AnimationDialog>([&](AnimationDialog& dialog) {
        for (const char* name : {"animation_from", "animation_to", "animation_every"})
            QCOMPARE(dialog.findChild<QSpinBox*>(name)->maximum(), scans);
        auto* from = dialog.findChild<QSpinBox*>("animation_from");
        from->setFocus();
        from->selectAll();
        QTest::keyClicks(from, "0");
        QTRY_VERIFY(QToolTip::isVisible());
        const QWidget* tip = nullptr;
        for (const QWidget* top : QApplication::topLevelWidgets())
            if (top->objectName() == "qtooltip_label") tip = top;
        QVERIFY(tip != nullptr);
        for (const auto* input : dialog.findChildren<QWidget*>()) {
            if (qobject_cast<const QSpinBox*>(input) == nullptr &&
                qobject_cast<const QComboBox*>(input) == nullptr &&
                qobject_cast<const QPushButton*>(input) == nullptr) {
                continue;
            }
            const QRect place(input->mapToGlobal(QPoint()), input->size());
            QVERIFY2(!tip->geometry().intersects(place), qPrintable(input->objectName()));
        }
        QTest::keyClicks(from, "5");
        QTRY_VERIFY(!QToolTip::isVisible());
        dialog.reject();
    });
    f.trigger("action_save_animation");
}

void ViewTest::a_run_is_saved_as_frames_and_a_film() {
    Fixture f;
    f.run_steps(60);
    const OnlyPath path(folder_of_programs(f));
    make_film_maker(f);
    const QString there = f.path("programs");
    f.prompts.saves = {there, f.path("film")};
    ask_for(10, 45, 20);
    f.trigger("action_save_animation");
    QCOMPARE(f.prompts.warnings.size(), 1);  // a folder that is there is not written into
    QCOMPARE(QDir(f.path("film")).entryList(QDir::Files),
             QStringList({"film.mp4", "frame-000001.png", "frame-000002.png", "frame-000003.png"}));
    const QByteArray given = Fixture::read(f.path("film/film.mp4"));
    QVERIFY2(given.contains("-framerate 12 ") && given.contains("frame-000003.png"), given);
    QTRY_VERIFY2(f.notice().contains("film.mp4"), qPrintable(f.notice()));
    // Back where it was; and the frames are of the scans asked for, the last one too.
    QTRY_VERIFY(f.steps() == 60 && f.shows_everything());
    for (const auto& [frame, scan] : {std::pair(1, 10), std::pair(2, 30), std::pair(3, 45)}) {
        f.session.seek(static_cast<quint64>(scan));
        QTRY_VERIFY(f.steps() == static_cast<quint64>(scan) && f.shows_everything());
        f.window->grid_view().set_snapshot(f.session.snapshot());
        QCOMPARE(QImage(f.path(QString("film/frame-00000%1.png").arg(frame))),
                 image_of(f.window->grid_view().figures().front().as_seen(1.0))
                     .convertToFormat(QImage(f.path("film/frame-000001.png")).format()));
    }
}

void ViewTest::a_film_shows_both_views_up_to_its_size() {
    Fixture f;
    f.run_steps(30);
    GridView& grid = f.window->grid_view();
    const double zoom = grid.camera().pixels_per_m;
    QVERIFY(grid.fits());
    const OnlyPath path(folder_of_programs(f));
    f.prompts.saves = {f.path("both")};
    in_dialog<AnimationDialog>([](AnimationDialog& dialog) {
        dialog.findChild<QSpinBox*>("animation_from")->setValue(2);
        dialog.findChild<QSpinBox*>("animation_to")->setValue(30);
        dialog.findChild<QSpinBox*>("animation_every")->setValue(28);
        dialog.findChild<QComboBox*>("animation_view")->setCurrentIndex(2);
        dialog.findChild<QComboBox*>("animation_size")->setCurrentIndex(2);
        dialog.findChild<QCheckBox*>("animation_still")->setChecked(true);
        dialog.accept();
    });
    f.trigger("action_save_animation");
    QVERIFY2(f.prompts.warnings.isEmpty(), qPrintable(f.prompts.warnings.join(' ')));
    const QImage first(f.path("both/frame-000001.png"));
    const QImage last(f.path("both/frame-000002.png"));
    QCOMPARE(first.size(), last.size());
    QVERIFY(first.width() == 1920 || first.height() == 1080);
    QVERIFY(first.width() <= 1920 && first.height() <= 1080);
    QVERIFY(first != last);
    // Beside each other, of one height, each of its own shape.
    double shape = 0.0;
    for (CanvasView* view :
         {static_cast<CanvasView*>(&f.window->scan_view()), static_cast<CanvasView*>(&grid)}) {
        const QSizeF size = view->figures().front().as_seen(1.0).size;
        shape += size.width() / size.height();
    }
    QVERIFY(std::abs(static_cast<double>(first.width()) / first.height() - shape) < 0.01);
    // The camera stood where it was, and is free again.
    QTRY_VERIFY(f.steps() == 30 && f.shows_everything());
    QVERIFY(grid.fits());
    QVERIFY(std::abs(grid.camera().pixels_per_m / zoom - 1.0) < 1e-9);
}

void ViewTest::an_animation_needs_no_film_maker() {
    Fixture f;
    f.run_steps(20);
    const OnlyPath path(folder_of_programs(f));
    f.prompts.saves = {f.path("frames")};
    // The tour ends before the last scan that is asked for.
    ask_for(1000, 2000, 100);
    f.trigger("action_save_animation");
    QVERIFY2(f.prompts.warnings.isEmpty(), qPrintable(f.prompts.warnings.join(' ')));
    QCOMPARE(QDir(f.path("frames")).entryList(QDir::Files),
             QStringList({"frame-000001.png", "frame-000002.png"}));
    QTRY_VERIFY2(f.notice().contains("ffmpeg"), qPrintable(f.notice()));
    QTRY_COMPARE(f.steps(), quint64{20});
    // A film maker that fails leaves the frames.
    const QString program = f.write("programs/ffmpeg", "#!/bin/sh\necho no codec >&2\nexit 1\n");
    QFile::setPermissions(program, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    f.prompts.saves = {f.path("again")};
    ask_for(1, 2, 1);
    f.trigger("action_save_animation");
    QCOMPARE(QDir(f.path("again")).entryList(QDir::Files).size(), 2);
    QTRY_VERIFY2(f.notice().contains("no codec"), qPrintable(f.notice()));
}

void ViewTest::a_cancelled_animation_leaves_nothing() {
    Fixture f;
    f.run_steps(20);
    const QStringList before = QDir(f.path("")).entryList(QDir::AllEntries | QDir::NoDotAndDotDot);
    f.prompts.saves = {f.path("film")};
    ask_for(1, 100000, 1);
    in_dialog<QProgressDialog>([](QProgressDialog& progress) {
        QTRY_VERIFY(progress.value() >= 3);
        QTest::mouseClick(progress.findChild<QPushButton*>(), Qt::LeftButton);
    });
    f.trigger("action_save_animation");
    QCOMPARE(QDir(f.path("")).entryList(QDir::AllEntries | QDir::NoDotAndDotDot), before);
    QTRY_COMPARE(f.steps(), quint64{20});
    // Nor does one that cannot be written.
    f.prompts.saves = {f.path("no/such/folder")};
    ask_for(1, 3, 1);
    f.trigger("action_save_animation");
    QCOMPARE(f.prompts.warnings.size(), 1);
    QTRY_COMPARE(f.steps(), quint64{20});
    // A run that was over is over again.
    f.run_to_end();
    f.prompts.saves = {f.path("no/such/folder")};
    ask_for(1, 3, 1);
    f.trigger("action_save_animation");
    QTRY_VERIFY(f.state() == Progress::State::finished && f.shows_everything());
}

}  // namespace hitos::window
