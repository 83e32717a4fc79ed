// SPDX-License-Identifier: GPL-3.0-or-later
// Use case 8.2.2.10, and finding one's way in the views.

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPainter>
#include <QPointer>
#include <QPushButton>
#include <QToolButton>
#include <QWheelEvent>
#include <cmath>
#include <map>

#include "dialogs/export_dialog.hpp"
#include "gui_fixture.hpp"
#include "hitos/services/drawing/picture_file.hpp"
#include "look/theme.hpp"
#include "tests.hpp"
#include "views/canvas_paint.hpp"
#include "views/grid_layer.hpp"
#include "views/plots.hpp"

namespace hitos::window {
namespace {

void accept_picture(bool whole) {
    in_dialog<ExportDialog>([whole](ExportDialog& dialog) {
        dialog.findChild<QComboBox*>("export_part")->setCurrentIndex(whole ? 1 : 0);
        dialog.accept();
    });
}

/// A pixel of the scan view on the first line of the map.
QPoint pixel_of_line(const Fixture& f) {
    const LineExtent& extent = f.session.snapshot()->line_extents.front();
    const ScanView& view = f.window->scan_view();
    const QPointF middle((extent.a.x + extent.b.x) / 2.0, (extent.a.y + extent.b.y) / 2.0);
    return view.camera().to_screen(view.size()).map(middle).toPoint();
}

void wheel(QWidget& widget, const QPointF& at, int delta) {
    QWheelEvent event(at, widget.mapToGlobal(at), {}, QPoint(0, delta), Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &event);
}

}  // namespace

void ViewTest::in_the_dark_free_and_unknown_are_far_apart() {
    const auto luminance = [](int grey) {  // WCAG 2.1, "relative luminance"
        const double part = grey / 255.0;
        return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    const double free = luminance(shade_of(255, true));
    const double unknown = luminance(shade_of(kUnknownGrey, true));
    QVERIFY((free + 0.05) / (unknown + 0.05) >= 3.0);
    QCOMPARE(shade_of(0, true), std::uint8_t{0});
    for (int grey = 0; grey < 256; ++grey) {
        const auto cell = static_cast<std::uint8_t>(grey);
        QCOMPARE(shade_of(cell, false), cell);
        if (grey > 0) QVERIFY(shade_of(cell, true) >= shade_of(cell - 1, true));  // in their order
    }
    // And so is it painted: the middle of the free cells about the robot.
    Fixture f;
    f.run_steps(60);
    apply_theme(*qApp, Theme::dark);
    const QImage seen = f.window->grid_view().grab().toImage();
    apply_theme(*qApp, Theme::light);
    std::map<QRgb, int> counts;
    for (int y = 0; y < seen.height(); ++y)
        for (int x = 0; x < seen.width(); ++x) ++counts[seen.pixel(x, y)];
    const int shade = shade_of(kUnknownGrey, true);
    QVERIFY(counts[qRgb(shade, shade, shade)] > seen.width());
    QVERIFY(counts[qRgb(kUnknownGrey, kUnknownGrey, kUnknownGrey)] < seen.width() / 10);
}

void ViewTest::no_way_leads_from_one_tour_to_the_next() {
    QImage paper(100, 100, QImage::Format_RGB32);
    paper.fill(Qt::white);
    Trajectory path{{0.0, {10.0, 20.0, 0.0}},
                    {1.0, {10.0, 80.0, 0.0}},
                    {2.0, {90.0, 80.0, 0.0}, true},
                    {3.0, {90.0, 20.0, 0.0}}};
    const Scene scene{QTransform(), paper.size(), 1.0, light_colours(), false};
    const auto drawn = [&](int x, int y) { return paper.pixelColor(x, y) != QColor(Qt::white); };
    QPainter painter(&paper);
    draw_path(painter, scene, path, QPen(Qt::red, 3.0));
    QVERIFY(drawn(10, 50) && drawn(90, 50) && !drawn(50, 80));
    path[2].begins = false;
    draw_path(painter, scene, path, QPen(Qt::red, 3.0));
    QVERIFY(drawn(50, 80));
}

void ViewTest::a_view_is_saved_as_jpg_and_png() {
    Fixture f;
    f.run_steps(40);
    for (const bool whole : {false, true}) {
        for (const char* name : {"scan.jpg", "scan.png"}) {
            QFile::remove(f.path(name));
            f.prompts.saves = {f.path(name)};
            accept_picture(whole);
            emit f.window->scan_view().picture_wanted();
            const QImage image(f.path(name));
            QVERIFY2(!image.isNull(), name);
            const FigureOffer offer = f.window->scan_view().figures()[whole ? 1 : 0];
            QCOMPARE(image.width(), qRound(2.0 * offer.width));
        }
    }
}

void ViewTest::pictures_are_written_as_shapes_too() {
    Fixture f;
    f.run_steps(40);
    f.prompts.saves = {f.path("map.svg")};
    accept_picture(true);
    emit f.window->grid_view().picture_wanted();
    QVERIFY2(f.prompts.warnings.isEmpty(), qPrintable(f.prompts.warnings.join(' ')));
    const QByteArray svg = Fixture::read(f.path("map.svg"));
    QVERIFY(svg.contains("<svg") && svg.contains("<path"));
    QVERIFY(svg.contains("<image"));  // the cells
    f.prompts.saves = {f.path("scan.pdf")};
    accept_picture(false);
    emit f.window->scan_view().picture_wanted();
    QVERIFY(Fixture::read(f.path("scan.pdf")).startsWith("%PDF"));
    f.trigger("action_plots_dock");
    f.prompts.saves = {f.path("plots.svg")};
    accept_picture(false);
    emit f.window->plots().picture_wanted();
    // Letters are letters, and can be edited.
    QVERIFY(Fixture::read(f.path("plots.svg")).contains("Landmarks</text>"));
}

void ViewTest::a_picture_goes_to_the_clipboard() {
    Fixture f;
    f.run_steps(10);
    QApplication::clipboard()->clear();
    f.window->scan_view().setFocus();
    f.trigger("action_copy_picture");
    QCOMPARE(QApplication::clipboard()->image().size(), f.window->scan_view().size() * 2);
    f.trigger("action_plots_dock");
    Plots& plots = f.window->plots();
    QTRY_VERIFY(plots.isVisible());
    plots.setFocus();
    QTRY_VERIFY(plots.hasFocus());
    f.trigger("action_copy_picture");
    QCOMPARE(QApplication::clipboard()->image().size(),
             plots.exportable().offers.front().as_seen(kCopyScale).pixels());
}

void ViewTest::pictures_ask_before_they_overwrite() {
    Fixture f;
    f.run_steps(5);
    const QString there = f.write("there.png", "precious");
    f.prompts.saves = {there};
    f.prompts.confirms = {false};
    accept_picture(false);
    emit f.window->grid_view().picture_wanted();
    QCOMPARE(Fixture::read(there), QByteArray("precious"));
    QCOMPARE(f.prompts.saves_asked, 2);
    f.prompts.saves = {there};
    f.prompts.confirms = {true};
    accept_picture(true);
    emit f.window->grid_view().picture_wanted();
    QVERIFY(!QImage(there).isNull());
}

void ViewTest::a_picture_of_another_kind_is_refused() {
    Fixture f;
    f.run_steps(5);
    f.prompts.saves = {f.path("map.bmp"), f.path("no/folder/map.png")};
    accept_picture(false);
    emit f.window->grid_view().picture_wanted();
    QCOMPARE(f.prompts.warnings.size(), 2);
    QVERIFY(f.prompts.warnings.front().contains(".png"));
    QVERIFY(!QFile::exists(f.path("map.bmp")));
}

void ViewTest::the_right_button_offers_the_picture() {
    Fixture f;
    f.run_steps(5);
    ScanView& view = f.window->scan_view();
    QContextMenuEvent event(QContextMenuEvent::Mouse, view.rect().center(),
                            view.mapToGlobal(view.rect().center()));
    QApplication::sendEvent(&view, &event);
    // A question closes it, with some versions of Qt, and it is gone.
    const QPointer<QMenu> menu = view.findChild<QMenu*>("view_menu");
    QVERIFY(menu != nullptr);
    f.prompts.saves = {f.path("scan.jpg")};
    accept_picture(false);
    menu->actions().front()->trigger();
    QVERIFY(QFile::exists(f.path("scan.jpg")));
    if (menu != nullptr) menu->close();
    // The right button offers it wherever something is drawn.
    f.trigger("action_odometry");
    f.trigger("action_best_map");
    f.trigger("action_plots_dock");
    for (QWidget* widget :
         {static_cast<QWidget*>(&f.window->grid_view()),
          static_cast<QWidget*>(&f.window->result_actions().odometry_window()->view()),
          static_cast<QWidget*>(&f.window->result_actions().best_window()->view()),
          static_cast<QWidget*>(&f.window->plots())}) {
        QContextMenuEvent press(QContextMenuEvent::Mouse, widget->rect().center(),
                                widget->mapToGlobal(widget->rect().center()));
        QApplication::sendEvent(widget, &press);
        auto* offered = widget->findChild<QMenu*>();
        QVERIFY(offered != nullptr);
        QStringList words;
        for (const QAction* action : offered->actions()) words << action->text();
        QVERIFY2(words.filter("Save as image").size() == 1, qPrintable(words.join(", ")));
        QVERIFY2(words.contains("Copy picture"), qPrintable(words.join(", ")));
        offered->close();
    }
}

void ViewTest::the_plots_are_saved() {
    Fixture f;
    f.trigger("action_plots_dock");
    f.run_steps(20);
    f.prompts.saves = {f.path("plots.bmp"), f.path("plots.png")};
    accept_picture(false);
    emit f.window->plots().picture_wanted();
    QCOMPARE(f.prompts.warnings.size(), 1);
    QVERIFY(!QImage(f.path("plots.png")).isNull());
}

void ViewTest::a_figure_has_what_is_wished() {
    Fixture f;
    f.run_steps(60);
    ExportDialog dialog(f.window->grid_view().exportable(), f.files.settings(), f.window.get());
    dialog.show();
    const auto choose = [&](const char* name, const QVariant& value) {
        auto* box = dialog.findChild<QComboBox*>(name);
        box->setCurrentIndex(value.typeId() == QMetaType::Int ? value.toInt()
                                                              : box->findData(value));
    };
    const auto check = [&](const char* name, bool on) {
        dialog.findChild<QCheckBox*>(name)->setChecked(on);
    };
    const auto set = [&](const char* name, double value) {
        dialog.findChild<QDoubleSpinBox*>(name)->setValue(value);
    };
    // In millimetres letters have their size on paper, and pixels follow from the resolution.
    choose("export_unit", 1);
    set("export_mm", 127.0);
    set("export_dots", 200.0);
    QCOMPARE(dialog.picture().pixels().width(), 1000);
    const QImage at_first = image_of(dialog.picture());
    QCOMPARE(qRound(at_first.dotsPerMeterX() * 0.0254), 200);
    // Axes and legend have room of their own round the picture, which gets smaller.
    check("export_axes", false);
    const QImage bare = image_of(dialog.picture());
    check("export_legend", false);
    const QImage alone = image_of(dialog.picture());
    QVERIFY(alone.height() < bare.height());
    QVERIFY(bare != at_first.scaled(bare.size()));
    // A title has its line.
    dialog.findChild<QLineEdit*>("export_title")->setText("Recinto");
    const QImage titled = image_of(dialog.picture());
    QVERIFY(titled.height() > alone.height());
    dialog.findChild<QLineEdit*>("export_title")->clear();
    // A layer that is left out is not drawn, and the view on the screen keeps it.
    auto* layers = dialog.findChild<QListWidget*>("export_layers");
    QVERIFY(layers->count() > 3);
    for (int i = 0; i < layers->count(); ++i) layers->item(i)->setCheckState(Qt::Unchecked);
    QVERIFY(image_of(dialog.picture()) != alone);
    QVERIFY(f.window->grid_view().layers() == default_layers());
    // In the dark the ground is light unless the screen's is wished.
    apply_theme(*qApp, Theme::dark);
    const QImage light = image_of(dialog.picture());
    check("export_light", false);
    const QImage dark = image_of(dialog.picture());
    apply_theme(*qApp, Theme::light);
    QVERIFY(dark.pixelColor(5, 5).lightness() < light.pixelColor(5, 5).lightness());
    check("export_light", true);
    // Shapes have a size on paper and no pixels.
    choose("export_format", "pdf");
    QVERIFY(!dialog.findChild<QWidget*>("export_dots")->isEnabled());
    const auto* sum = dialog.findChild<QLabel*>("export_sum");
    QTRY_VERIFY(sum->text().startsWith("127 ") && !sum->text().contains("pixels"));
}

void ViewTest::a_figure_in_pdf_has_its_letters() {
    Fixture f;
    f.run_steps(60);
    f.trigger("action_plots_dock");
    const std::vector<Exportable> all{f.window->grid_view().exportable(),
                                      f.window->scan_view().exportable(),
                                      f.window->plots().exportable()};
    for (const Exportable& each : all) {
        for (std::size_t i = 0; i < each.offers.size(); ++i) {
            const FigureOffer& offer = each.offers[i];
            FigureWish wish;
            wish.width_mm = 85.0;
            wish.mm_per_point = 0.2;
            wish.legend = wish.axes = true;
            wish.layers = offer.layers;
            const QString path = f.path(each.name + QString::number(i) + ".pdf");
            write_picture(offer.picture(wish), path);
            const QByteArray pdf = Fixture::read(path);
            // Each font is described, and brings its shapes with it.
            const auto fonts = pdf.count("/FontDescriptor\n");
            const auto files = pdf.count("/FontFile");
            QVERIFY2(files > 0 && files >= fonts, qPrintable(path));
            const auto box = pdf.indexOf("/MediaBox [");
            QVERIFY2(box > 0, qPrintable(path));
            const auto numbers = pdf.mid(box + 11, 60).simplified().split(' ');
            const double width = (numbers[2].toDouble() - numbers[0].toDouble()) / 72.0 * 25.4;
            QVERIFY2(std::abs(width - 85.0) < 0.5, qPrintable(QString::number(width)));
        }
    }
    // What is for papers is what a run's results have.
    FigureWish wish;
    wish.legend = wish.axes = true;
    const FigureOffer& paper = all.front().offers.back();
    wish.layers = paper.shown;
    QVERIFY(paper.for_print);
    QVERIFY(paper.picture(wish).shapes("svg").contains("odometry"));
    // Their program's title is the source's name, as in map.pdf; what is written above is another.
    QVERIFY(paper.picture(wish).shapes("svg").contains("<title>bigloop.log.gz</title>"));
    wish.title = "Above";
    QVERIFY(paper.picture(wish).shapes("svg").contains("<title>bigloop.log.gz</title>"));
    wish.layers.set(Layer::odometry, false);
    QVERIFY(!paper.picture(wish).shapes("svg").contains("odometry"));
    // A layer is named by what is drawn.
    QCOMPARE(paper.uncertainty, QString("Uncertainty (2 σ)"));
    QVERIFY(paper.picture(wish).shapes("svg").contains("uncertainty, 2 σ"));
    ExportDialog dialog(all.front(), f.files.settings(), f.window.get());
    const auto layers_of = [&dialog](int offer) {
        auto* what = dialog.findChild<QComboBox*>("export_part");
        what->setCurrentIndex(offer);
        QStringList names;
        const auto* list = dialog.findChild<QListWidget*>("export_layers");
        for (int i = 0; i < list->count(); ++i) names << list->item(i)->text();
        return names;
    };
    QVERIFY(layers_of(0).contains("Uncertainty (1, 2, 3 σ)"));
    const QStringList paper_layers = layers_of(static_cast<int>(all.front().offers.size()) - 1);
    QVERIFY(paper_layers.contains("Uncertainty (2 σ)"));
    QVERIFY(!paper_layers.contains("Uncertainty (1, 2, 3 σ)"));
}

void ViewTest::what_was_wished_is_wished_again() {
    Fixture f;
    f.run_steps(5);
    in_dialog<ExportDialog>([](ExportDialog& dialog) {
        auto* format = dialog.findChild<QComboBox*>("export_format");
        format->setCurrentIndex(format->findData("svg"));
        dialog.findChild<QCheckBox*>("export_legend")->setChecked(false);
        dialog.accept();
    });
    f.prompts.saves = {f.path("a.svg")};
    emit f.window->scan_view().picture_wanted();
    const ExportDialog next(f.window->plots().exportable(), f.files.settings(), f.window.get());
    QCOMPARE(next.format(), QString("svg"));
    QVERIFY(!next.findChild<QCheckBox*>("export_legend")->isChecked());
    QVERIFY(next.windowTitle().contains("Plots"));
}

void ViewTest::a_figure_is_saved_as_it_was_accepted() {
    Fixture f;
    f.run_steps(20);
    QByteArray seen;
    in_dialog<ExportDialog>([&](ExportDialog& dialog) {
        auto* format = dialog.findChild<QComboBox*>("export_format");
        format->setCurrentIndex(format->findData("png"));
        dialog.accept();
        seen = dialog.bytes();
        f.session.run_steps(30);  // goes on while a name is chosen
    });
    f.prompts.saves = {f.path("map.png")};
    emit f.window->grid_view().picture_wanted();
    QCOMPARE(Fixture::read(f.path("map.png")), seen);
    // What pixels could not hold is no reason against shapes.
    ExportDialog dialog(f.window->plots().exportable(), f.files.settings(), f.window.get());
    dialog.show();
    const auto choose = [&](const char* format) {
        auto* box = dialog.findChild<QComboBox*>("export_format");
        box->setCurrentIndex(box->findData(format));
    };
    const auto* save = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save);
    choose("png");
    dialog.findChild<QComboBox*>("export_unit")->setCurrentIndex(1);
    dialog.findChild<QDoubleSpinBox*>("export_mm")->setValue(400.0);
    dialog.findChild<QDoubleSpinBox*>("export_dots")->setValue(1200.0);
    QTRY_VERIFY(!save->isEnabled());
    choose("pdf");
    QTRY_VERIFY(save->isEnabled());
}

void ViewTest::a_class_sees_one_view_in_large_letters() {
    Fixture f;
    f.run_steps(20);
    f.trigger("action_plots_dock");
    QVERIFY(f.window->plots().isVisible());
    const double letters = f.window->grid_view().font().pointSizeF();
    const int height = f.window->grid_view().height();
    f.trigger("action_presenting");
    QVERIFY(f.window->grid_view().font().pointSizeF() > 1.3 * letters);
    const auto* scan = f.window->findChild<QLabel*>("status_scan");  // is not cut
    QVERIFY(scan->sizeHint().width() <= scan->width());
    QVERIFY(!f.window->plots().isVisible());
    QVERIFY(f.window->grid_view().isVisible() != f.window->scan_view().isVisible());
    QTRY_VERIFY(f.window->grid_view().height() >= height);
    f.trigger("action_presenting");
    QCOMPARE(f.window->grid_view().font().pointSizeF(), letters);
    QVERIFY(f.window->plots().isVisible());
    QVERIFY(f.window->grid_view().isVisible() && f.window->scan_view().isVisible());
    QVERIFY(f.action("action_summary")->isChecked());
}

void ViewTest::a_layout_has_a_name() {
    Fixture f;
    auto* menu = f.window->findChild<QMenu*>("menu_layouts");
    const auto entry = [menu](const QString& name) {
        emit menu->aboutToShow();
        return menu->findChild<QAction*>(name);
    };
    f.trigger("action_plots_dock");
    f.action("action_legend")->setChecked(false);
    f.prompts.texts = {"Plots / mine"};
    entry("keep_layout")->trigger();
    f.trigger("action_plots_dock");
    f.action("action_legend")->setChecked(true);
    QVERIFY(!f.window->plots().isVisible());
    QVERIFY(entry("action_layout_Plots - mine") != nullptr);
    entry("action_layout_Plots - mine")->trigger();
    QVERIFY(f.window->plots().isVisible());
    QVERIFY(!f.action("action_legend")->isChecked());
    // Another one of that name asks; one that is forgotten is gone.
    f.prompts.texts = {"Plots - mine"};
    f.prompts.confirms = {false};
    entry("keep_layout")->trigger();
    QVERIFY(f.prompts.confirmed_texts.back().contains("Plots - mine"));
    f.prompts.numbers = {0};
    entry("forget_layout")->trigger();
    QVERIFY(entry("action_layout_Plots - mine") == nullptr);
}

void ViewTest::a_picture_can_be_given_up() {
    Fixture f;
    f.run_steps(5);
    in_dialog<ExportDialog>([](ExportDialog& dialog) { dialog.reject(); });
    emit f.window->scan_view().picture_wanted();
    QCOMPARE(f.prompts.saves_asked, 0);
    accept_picture(false);
    emit f.window->scan_view().picture_wanted();  // and now in the file dialog
    QCOMPARE(f.prompts.saves_asked, 1);
    QVERIFY(f.prompts.warnings.isEmpty());
}

void ViewTest::the_scale_bar_covers_nothing_of_the_map() {
    constexpr int kBar = 40;  // pixels
    Fixture f;
    f.run_steps(200);
    GridView& view = f.window->grid_view();
    const GridTiles& tiles = view.tiles();
    const auto rows = static_cast<int>(tiles.area.end_row - tiles.area.first_row);
    // One pixel for each cell: what is higher than the map lies above and below it.
    const int free = view.figures()[1].as_seen(1.0).pixels().height() - rows;
    QVERIFY2(free >= kBar, qPrintable(QString::number(free)));
    const QTransform to_screen = view.camera().to_screen(view.size());
    const double lowest =
        to_screen.map(QPointF(0.0, static_cast<double>(tiles.area.first_row) * tiles.resolution_m))
            .y();
    QVERIFY2(lowest <= view.height() - kBar, qPrintable(QString::number(lowest)));
}

void ViewTest::a_window_of_its_own_is_saved_too() {
    Fixture f;
    f.trigger("action_odometry");
    MapWindow* map = f.window->result_actions().odometry_window();
    QTRY_VERIFY(!map->builder().state().running);
    f.prompts.saves = {f.path("odometry.jpg")};
    accept_picture(true);
    map->findChild<QPushButton*>("picture")->click();
    QVERIFY(!QImage(f.path("odometry.jpg")).isNull());
}

void ViewTest::the_wheel_zooms_at_the_cursor() {
    Fixture f;
    f.run_steps(10);
    for (CanvasView* view : {static_cast<CanvasView*>(&f.window->scan_view()),
                             static_cast<CanvasView*>(&f.window->grid_view())}) {
        const QPointF cursor(60.0, 90.0);
        const QPointF before = view->world_at(cursor);
        const double zoom = view->camera().pixels_per_m;
        wheel(*view, cursor, 240);
        QVERIFY(view->camera().pixels_per_m > zoom * 1.2);
        const QPointF after = view->world_at(cursor);
        QVERIFY(QLineF(before, after).length() < 1e-9);
    }
}

void ViewTest::dragging_pans_and_fit_comes_back() {
    Fixture f;
    f.run_steps(10);
    GridView& view = f.window->grid_view();
    QVERIFY(view.fits());
    const QPointF before = view.world_at({100.0, 100.0});
    QTest::mousePress(&view, Qt::LeftButton, {}, QPoint(100, 100));
    QTest::mouseMove(&view, QPoint(120, 100));
    QTest::mouseMove(&view, QPoint(140, 130));
    QTest::mouseRelease(&view, Qt::LeftButton, {}, QPoint(140, 130));
    QVERIFY(!view.fits());
    QVERIFY(QLineF(before, view.world_at({140.0, 130.0})).length() < 1e-9);
    QTest::keyClick(&view, Qt::Key_F);
    QVERIFY(view.fits());
    QVERIFY(QLineF(before, view.world_at({100.0, 100.0})).length() < 1e-9);
}

void ViewTest::the_view_follows_the_robot() {
    Fixture f;
    f.trigger("action_follow");
    f.run_steps(80);
    const Pose pose = f.session.snapshot()->best_pose;
    const QPointF centre = f.window->grid_view().camera().centre;
    QVERIFY(QLineF(centre, QPointF(pose.x, pose.y)).length() < 1e-9);
    f.window->grid_view().fit();
    QVERIFY(!f.action("action_follow")->isChecked());
}

void ViewTest::a_click_highlights_in_both_views() {
    Fixture f;
    f.trigger("action_world_frame");
    f.run_steps(60);
    const auto snapshot = f.session.snapshot();
    QVERIFY(!snapshot->line_extents.empty());
    ScanView& view = f.window->scan_view();
    const QPoint pixel = pixel_of_line(f);
    const QImage scan_before = view.grab().toImage();
    const QImage grid_before = f.window->grid_view().grab().toImage();
    QTest::mouseMove(&view, pixel);
    QTest::mouseClick(&view, Qt::LeftButton, {}, pixel);
    QVERIFY(view.grab().toImage() != scan_before);
    QVERIFY(f.window->grid_view().grab().toImage() != grid_before);
    QVERIFY(f.window->findChild<QLabel*>("status_place")->text().startsWith("x "));
}

void ViewTest::a_landmark_may_go_from_below_the_cursor() {
    GridView view;
    view.resize(400, 300);
    view.show();
    MarkedMap marked;
    marked.map.push_back({Esquina{0.0, 0.0}});
    view.set_landmarks(marked);
    const QImage bare = view.grab().toImage();
    QTest::mouseMove(&view, QPoint(1, 1));
    QTest::mouseMove(&view, view.camera().to_screen(view.size()).map(QPointF(0.0, 0.0)).toPoint());
    QVERIFY(view.grab().toImage() != bare);  // its values stand beside it
    view.set_landmarks({});
    QVERIFY(!view.grab().isNull());
}

void ViewTest::what_is_highlighted_goes_with_its_run() {
    Fixture f;
    f.trigger("action_world_frame");
    ScanView& view = f.window->scan_view();
    const auto both = [&] {
        f.window->grid_view().set_snapshot(f.session.snapshot());  // else a little later
        return std::pair(view.grab().toImage(), f.window->grid_view().grab().toImage());
    };
    f.run_steps(60);
    const auto bare = both();
    // Emitted instead of clicked: the cursor would name the landmark below it.
    emit view.landmark_clicked({f.session.snapshot()->best_map.front()});
    QVERIFY(both() != bare);
    f.trigger("action_restart");
    f.run_steps(60);
    const auto again = both();
    emit view.landmark_clicked({});
    QVERIFY(both() == again);  // there was nothing to take away
}

/// A wall along the x axis, in a view that is turned by an eighth of a turn and moved.
void ViewTest::a_grid_in_another_frame_is_turned() {
    auto tile = std::make_shared<GridTile>();
    tile->grey.fill(255);
    for (std::size_t row = 30; row < 34; ++row) {
        for (std::size_t column = 0; column < kTileSide; ++column)
            tile->grey[row * kTileSide + column] = 0;
    }
    GridTiles tiles;
    tiles.area = {0, 0, kTileSide, kTileSide};
    tiles.columns = tiles.rows = 1;
    tiles.resolution_m = 0.1;
    tiles.tiles = {tile};
    for (const Pose& frame : {Pose{}, Pose{3.0, -1.0, kPi / 4.0}, Pose{0.0, 2.0, -2.0}}) {
        GridView view;
        view.resize(400, 400);
        view.set_frame(frame);
        view.set_grid(tiles, {});
        view.show();
        view.fit();
        const QImage image = view.grab().toImage();
        const auto grey_at = [&](double x, double y) {
            const Point2 at = transform(frame, Point2{x, y});
            const QPointF pixel = view.camera().to_screen(view.size()).map(QPointF(at.x, at.y));
            return qGray(image.pixel(pixel.toPoint()));
        };
        for (const double x : {0.6, 3.2, 5.8}) {
            QVERIFY2(grey_at(x, 3.2) < 60, qPrintable(QString("%1 %2").arg(frame.theta).arg(x)));
            for (const double y : {1.6, 4.8}) QVERIFY(grey_at(x, y) > 200);
        }
    }
}

void ViewTest::trees_are_circles_as_large_as_they_are() {
    const auto drawn = [](const std::vector<double>& radii_m, const std::vector<Point2>& at) {
        auto snapshot = std::make_shared<Snapshot>();
        snapshot->steps = 1;
        snapshot->scan.points = {{4.0, -3.0}, {4.0, 3.0}, {0.0, 3.0}};
        snapshot->observation.corners = {{3.0, 0.0}};
        snapshot->observation.circle_radii_m = radii_m;
        ScanView view;
        view.resize(500, 500);
        view.set_robot_frame(true);
        view.set_snapshot(snapshot);
        view.show();
        const QImage image = view.grab().toImage();
        std::vector<QRgb> colours;
        for (const Point2& point : at) {
            colours.push_back(image.pixel(
                view.camera().to_screen(view.size()).map(QPointF(point.x, point.y)).toPoint()));
        }
        return colours;
    };
    const std::vector<Point2> on_the_large_one = {{3.0, 1.0}, {2.0, 0.0}, {3.0, -1.0}};
    const std::vector<Point2> on_the_small_one = {{3.0, 0.6}, {2.4, 0.0}, {3.0, -0.6}};
    const auto canvas = drawn({}, on_the_large_one);
    QCOMPARE(drawn({0.6}, on_the_large_one), canvas);
    const auto large = drawn({1.0}, on_the_large_one);
    const auto small = drawn({0.6}, on_the_small_one);
    const auto within = drawn({1.0}, on_the_small_one);
    for (std::size_t i = 0; i < canvas.size(); ++i) {
        QVERIFY(large[i] != canvas[i]);
        QVERIFY(small[i] != within[i]);
    }
}

void ViewTest::layers_are_remembered() {
    Fixture f;
    f.run_steps(30);
    const QImage with = f.window->scan_view().grab().toImage();
    f.trigger("layer_landmarks");
    QVERIFY(f.window->scan_view().grab().toImage() != with);
    f.window->close();
    MainWindow next(f.session, f.files, f.prompts);
    QVERIFY(!next.findChild<QAction*>("layer_landmarks")->isChecked());
    QVERIFY(next.findChild<QAction*>("layer_scan")->isChecked());
}

void ViewTest::the_landmark_below_the_cursor_stays_named() {
    Fixture f;
    f.trigger("action_world_frame");
    f.run_steps(60);
    ScanView& view = f.window->scan_view();
    const QImage bare = view.grab().toImage();
    const QPoint pixel = pixel_of_line(f);
    QMouseEvent move(QEvent::MouseMove, pixel, view.mapToGlobal(pixel), Qt::NoButton, {}, {});
    QApplication::sendEvent(&view, &move);
    const QImage named = view.grab().toImage();
    QVERIFY(named != bare);
    view.set_snapshot(std::make_shared<const Snapshot>(*f.session.snapshot()));
    QCOMPARE(view.grab().toImage(), named);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(&view, &leave);
    view.set_snapshot(f.session.snapshot());
    QCOMPARE(view.grab().toImage(), bare);
}

void ViewTest::what_is_not_shown_cannot_be_clicked() {
    Fixture f;
    f.trigger("action_world_frame");
    f.run_steps(60);
    QList<bool> found;
    QObject::connect(
        &f.window->scan_view(), &ScanView::landmark_clicked, f.window.get(),
        [&found](const PickedLandmark& picked) { found << picked.landmark.has_value(); });
    QTest::mouseClick(&f.window->scan_view(), Qt::LeftButton, {}, pixel_of_line(f));
    f.trigger("layer_landmarks");
    QTest::mouseClick(&f.window->scan_view(), Qt::LeftButton, {}, pixel_of_line(f));
    QCOMPARE(found, (QList<bool>{true, false}));
}

void ViewTest::a_double_click_clicks_once() {
    Fixture f;
    f.run_steps(20);
    GridView& view = f.window->grid_view();
    int clicks = 0;
    QObject::connect(&view, &GridView::landmark_clicked, f.window.get(), [&clicks] { ++clicks; });
    wheel(view, {60.0, 60.0}, 240);
    const QPoint pixel(60, 60);
    QTest::mouseClick(&view, Qt::LeftButton, {}, pixel);
    for (const auto kind : {QEvent::MouseButtonDblClick, QEvent::MouseButtonRelease}) {
        QMouseEvent event(kind, pixel, view.mapToGlobal(pixel), Qt::LeftButton, Qt::LeftButton, {});
        QApplication::sendEvent(&view, &event);
    }
    QCOMPARE(clicks, 1);
    QVERIFY(view.fits());
}

void ViewTest::what_is_lost_is_not_replaced_by_return_alone() {
    QtPrompts prompts;
    in_dialog<QMessageBox>([](QMessageBox& box) {
        QCOMPARE(box.defaultButton(), box.button(QMessageBox::Cancel));
        QTest::keyClick(&box, Qt::Key_Return);
    });
    QVERIFY(!may_overwrite(prompts, nullptr, "there.png"));
    expect_no_awaited_dialog();
}

void ViewTest::the_grid_view_shows_the_grid_map() {
    Fixture f;
    f.run_steps(200);
    const Grid grid =
        f.session.worker()->with_run([](const Algoritmo& run) { return run.step_grid(); }).get();
    const GridTiles& tiles = f.window->grid_view().tiles();
    QCOMPARE(tiles.area, grid.area());
    const GridTiles whole = tiles_of(grid);
    QCOMPARE(tiles.tiles.size(), whole.tiles.size());
    for (std::size_t i = 0; i < whole.tiles.size(); ++i) {
        if (tiles.tiles[i]) {
            QVERIFY(tiles.tiles[i]->grey == whole.tiles[i]->grey);
        } else {
            for (const std::uint8_t grey : whole.tiles[i]->grey) QCOMPARE(grey, std::uint8_t{205});
        }
    }
}

void ViewTest::the_legend_names_and_switches_what_is_drawn() {
    Fixture f;
    f.run_steps(5);
    const auto chip = [&](const char* legend, const char* name) {
        return f.window->findChild<QWidget*>(legend)->findChild<QToolButton*>(name);
    };
    QVERIFY(chip("scan_legend", "chip_landmarks")->isVisible());
    QVERIFY(chip("grid_legend", "chip_landmarks") == nullptr);
    QVERIFY(!chip("grid_legend", "chip_odometry")->isVisible());  // off, and so by default
    QVERIFY(!chip("scan_legend", "chip_associations")->toolTip().isEmpty());
    QVERIFY(!chip("scan_legend", "chip_associations")->icon().isNull());
    const QImage before = f.window->scan_view().grab().toImage();
    chip("scan_legend", "chip_landmarks")->click();
    QVERIFY(!f.action("layer_landmarks")->isChecked());
    QVERIFY(chip("scan_legend", "chip_landmarks")->isVisible());  // to be switched on again
    QVERIFY(f.window->scan_view().grab().toImage() != before);
    f.action("layer_odometry")->trigger();
    QVERIFY(chip("grid_legend", "chip_odometry")->isVisible());
    f.trigger("action_legend");
    QVERIFY(!chip("grid_legend", "chip_odometry")->isVisible());
}

void ViewTest::a_view_is_shown_alone_or_above_the_other() {
    Fixture f;
    QWidget& scan = f.window->scan_view();
    QWidget& grid = f.window->grid_view();
    auto* title = f.window->findChild<QLabel*>("grid_panel_title");
    scan.setFocus();
    f.trigger("action_alone");
    QVERIFY(scan.isVisible() && !grid.isVisible());
    f.trigger("action_alone");
    QVERIFY(scan.isVisible() && grid.isVisible());
    QTest::mouseDClick(title, Qt::LeftButton);
    QVERIFY(!scan.isVisible() && grid.isVisible() && grid.hasFocus());
    QTest::mouseDClick(title, Qt::LeftButton);
    QVERIFY(scan.isVisible());
    const auto place = [&](const QWidget& view) { return view.mapTo(f.window.get(), QPoint()); };
    QCOMPARE(place(scan).y() < place(grid).y() + 30 && place(scan).x() < place(grid).x(), true);
    f.trigger("action_stacked");
    QCoreApplication::processEvents();
    QVERIFY(place(scan).y() + scan.height() < place(grid).y());
    f.trigger("action_alone");
    f.window->leave();
    MainWindow next(f.session, f.files, f.prompts);
    QVERIFY(next.findChild<QAction*>("action_stacked")->isChecked());
    next.resize(1360, 860);
    next.show();
    QCoreApplication::processEvents();
    QVERIFY(next.scan_view().height() > 150 && next.grid_view().height() > 150);
}

}  // namespace hitos::window
