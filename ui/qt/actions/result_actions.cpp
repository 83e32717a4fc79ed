#include "result_actions.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QEventLoop>
#include <QFileInfo>
#include <QWidget>
#include <chrono>

#include "dialogs/picture_dialog.hpp"
#include "hitos/base/error.hpp"
#include "hitos/services/maps/dxf_file.hpp"
#include "hitos/services/maps/segment_file.hpp"
#include "views/grid_view.hpp"

namespace hitos::window {

ResultActions::ResultActions(Session& session, UserFiles& files, Prompts& prompts, QWidget* window)
    : QObject(window), session_(session), files_(files), prompts_(prompts), window_(window) {}

MapWindow* ResultActions::open_window(QPointer<MapWindow>& place, const QString& title,
                                      MapWindow::Show show) {
    if (place) place->close();
    place = new MapWindow(title, show, window_);
    connect(place, &MapWindow::picture_wanted, this,
            [this](const GridView* view) { save_picture(*view); });
    place->show();
    return place;
}

void ResultActions::view_best() {
    if (session_.progress().steps == 0) return;
    const auto snapshot = session_.snapshot();
    // The newest state, which while the run goes on is a few steps after the one in the views.
    auto path =
        session_.worker()->with_run([](const Algoritmo& run) { return run.best_trajectory(); });
    MapWindow* map =
        open_window(best_, tr("Grid map of the best particle"), MapWindow::Show::result);
    const bool shown = snapshot && snapshot->steps > 0;
    if (!shown || path.wait_for(std::chrono::milliseconds(40)) == std::future_status::ready) {
        map->builder().build(session_.configuration(), path.get());
    } else {  // a slow step is under way; what is in the views will do
        map->builder().build(session_.configuration(), snapshot->best_trajectory);
    }
}

void ResultActions::view_odometry() {
    if (!session_.has_source()) return;
    MapWindow* map =
        open_window(odometry_, tr("Grid map based on odometry"), MapWindow::Show::growth);
    map->builder().build_from_odometry(session_.configuration());
}

void ResultActions::save_map() {
    if (session_.progress().steps == 0) return;
    // The map of this moment, however long the user thinks about its name.
    struct Moment {
        LandmarkMap map;
        std::vector<LineExtent> segments;
        Trajectory path;
    };
    const auto moment = session_.worker()
                            ->with_run([](const Algoritmo& run) {
                                Moment now{run.filter().best_map(), {}, run.best_trajectory()};
                                now.segments = run.line_extents().of(now.map, now.path);
                                return now;
                            })
                            .share();
    const QString path = save_until_done(
        prompts_, window_,
        {tr("Save best particle's map"), files_.last_folder("map") + "/map.txt",
         tr("Maps (*.txt *.map);;Segments (*.seg);;CAD drawings (*.dxf);;All files (*)"), "txt"},
        [&](const QString& target) {
            const auto& [map, segments, trajectory] = moment.get();
            const std::string file = target.toStdString();
            const QString ending = QFileInfo(target).suffix().toLower();
            if (ending == "dxf") {
                write_dxf(map, segments, trajectory, file);
            } else if (ending == "seg") {
                write_segments(map, segments, file);
            } else {
                write_map(map, file);
            }
        });
    if (path.isEmpty()) return;
    files_.note_folder("map", path);
    emit notice(tr("Map saved: %1").arg(QDir::toNativeSeparators(path)));
}

void ResultActions::save_results() {
    if (!session_.has_source() || session_.progress().steps == 0) return;
    const QString path = save_until_done(
        prompts_, window_,
        {tr("Save all results: name of a new folder"),
         files_.last_folder("map") + "/results",
         tr("Folders (*)"),
         {}},
        [this](const QString& target) {
            prepare_output_folder(target.toStdString());
            RunWorker& worker = *session_.worker();
            auto written = worker.with_run([&](const Algoritmo& run) {
                double seconds = 0.0;
                for (const StepFigures& step : worker.figures_since(0))
                    seconds += step.step_seconds;
                return write_results(run, session_.references(), seconds, target.toStdString());
            });
            // Pictures of a great map take a second; the window goes on painting meanwhile.
            while (written.wait_for(std::chrono::milliseconds(10)) != std::future_status::ready)
                QCoreApplication::processEvents(QEventLoop::ExcludeUserInputEvents);
            written.get();
        });
    if (!path.isEmpty()) emit notice(tr("Results saved: %1").arg(QDir::toNativeSeparators(path)));
}

void ResultActions::save_picture(const CanvasView& view) {
    PictureDialog dialog(view, window_);
    if (dialog.exec() != QDialog::Accepted) return;
    const QString path =
        save_until_done(prompts_, window_,
                        {tr("Save as image"), files_.last_folder("picture") + "/hitos.jpg",
                         tr("Images (*.jpg *.jpeg *.png)"), "jpg"},
                        [&](const QString& target) {
                            write_image(view.picture(dialog.whole(), dialog.scale()), target);
                        });
    if (path.isEmpty()) return;
    files_.note_folder("picture", path);
    emit notice(tr("Image saved: %1").arg(QDir::toNativeSeparators(path)));
}

}  // namespace hitos::window
