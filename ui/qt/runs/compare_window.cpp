// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare_window.hpp"

#include <QButtonGroup>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "look/named.hpp"
#include "look/parameter_text.hpp"
#include "look/screen_fit.hpp"
#include "look/theme.hpp"
#include "views/canvas_paint.hpp"

namespace hitos::window {
namespace {

constexpr int kBlinkMs = 700;
constexpr qint64 kMeasureMs = 250;
constexpr QSize kCompareSize(1100, 680);

}  // namespace

QRectF CompareWindow::Side::content() const {
    if (!run) return {};
    return bounds_of(grid).united(box_of(points_of(path())));
}

CompareWindow::CompareWindow(RunList& list, const ViewSettings& settings, QWidget* parent)
    : QDialog(parent, Qt::Window), list_(list) {
    setObjectName("compare_window");
    setWindowTitle(tr("Compare runs"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(make_tools());
    auto* boxes = new QHBoxLayout;
    auto* views = new QHBoxLayout;
    for (std::size_t side = 0; side < sides_.size(); ++side) {
        make_side(side, settings);
        boxes->addWidget(sides_[side].box, 1);
        views->addWidget(sides_[side].view, 1);
    }
    column->addLayout(boxes);
    column->addLayout(views, 1);
    strip_ = new ErrorStrip(this);
    strip_->hide();
    column->addWidget(strip_);
    connect(strip_, &ErrorStrip::alignment_changed, this, [this] { measure(); });
    connect(strip_, &ErrorStrip::picture_wanted, this, &CompareWindow::picture_wanted);
    connect(&settings, &ViewSettings::theme_changed, strip_, &ErrorStrip::restyle);
    verdict_ = named(new QLabel(this), "compare_verdict");
    verdict_->setWordWrap(true);
    column->addWidget(verdict_);
    blink_.setInterval(kBlinkMs);
    connect(&blink_, &QTimer::timeout, this, [this] {
        blinked_ = !blinked_;
        paint_sides();
    });
    connect(&list, &RunList::changed, this, &CompareWindow::fill_boxes);
    connect(&list, &RunList::present_changed, this, [this] {
        if (!isVisible()) return;
        for (Side& side : sides_) {
            const bool now = !side.choice.odometry || list_.present_rests();
            if (side.choice.number == 0 && now) take(side);
        }
        // It compares whole paths: no oftener than its cost allows.
        const qint64 wait_ms = std::max<qint64>(kMeasureMs, 20 * measuring_ms_);
        list_.present_rests() || since_measured_.elapsed() > wait_ms ? measure(Of::present)
                                                                     : paint_sides();
    });
    constexpr int kLeastWidth = 720;  // the words of a side in two lines at the most
    setMinimumWidth(kLeastWidth);
    resize(kCompareSize);
    fit_to_screen(*this);
    fill_boxes();
}

QWidget* CompareWindow::make_tools() {
    auto* tools = new QWidget(this);
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, 0, 0);
    auto* group = new QButtonGroup(this);
    const std::array words{tr("Side by side"), tr("Overlaid"), tr("Blinking")};
    for (std::size_t i = 0; i < modes_.size(); ++i) {
        modes_[i] = new QToolButton(tools);
        modes_[i]->setText(words[i]);
        modes_[i]->setProperty("role", "view");
        modes_[i]->setCheckable(true);
        group->addButton(modes_[i], static_cast<int>(i));
        row->addWidget(modes_[i]);
    }
    modes_.front()->setChecked(true);
    connect(group, &QButtonGroup::idClicked, this, [this](int id) { set_mode(Mode(id)); });
    row->addSpacing(12);
    figures_ = named(new QToolButton(tools), "compare_figures_shown");
    figures_->setText(tr("Figures"));
    figures_->setToolTip(tr("How far all are from the reference trajectory"));
    figures_->setProperty("role", "view");
    figures_->setCheckable(true);
    connect(figures_, &QToolButton::toggled, this, [this](bool on) {
        strip_->setVisible(on);
        measure();
        emit figures_shown(on);
    });
    row->addWidget(figures_);
    row->addStretch(1);
    auto* picture = new QPushButton(tr("Save as image…"), tools);
    connect(picture, &QPushButton::clicked, this,
            [this] { emit picture_wanted(sides_.front().view->exportable()); });
    row->addWidget(picture);
    return tools;
}

void CompareWindow::make_side(std::size_t side, const ViewSettings& settings) {
    Side& made = sides_[side];
    made.box = new QComboBox(this);
    made.box->setObjectName(side == 0 ? "compare_left" : "compare_right");
    made.box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    made.view = new GridView(this);
    made.view->set_layers(settings.layers());
    connect(&settings, &ViewSettings::layers_changed, made.view, &GridView::set_layers);
    made.builder = std::make_unique<MapBuilder>();
    connect(made.builder.get(), &MapBuilder::changed, this, [this, &made] {
        if (!made.made) return;  // of what was chosen before
        made.grid = made.builder->state().tiles;
        paint_sides();
    });
    connect(made.box, &QComboBox::currentIndexChanged, this, [this, side] {
        if (filling_) return;
        choose(static_cast<int>(side), {sides_[side].box->currentData().toPoint().x(),
                                        sides_[side].box->currentData().toPoint().y() != 0});
    });
    connect(made.view, &CanvasView::camera_moved, this,
            [this, side] { sides_[1 - side].view->look_as(*sides_[side].view); });
    connect(made.view, &CanvasView::picture_wanted, this,
            [this, view = made.view] { emit picture_wanted(view->exportable()); });
}

QString CompareWindow::title_of(const Choice& choice) const {
    const QString name = name_of({choice.number, nullptr});
    return choice.odometry ? tr("%1, odometry").arg(name) : name;
}

/// The list may have changed: what was chosen stays, and what is gone gives way to this run.
void CompareWindow::fill_boxes() {
    const QScopedValueRollback filling(filling_, true);
    const std::vector<ListedRun> runs = list_.runs();
    const Configuracion base = runs.empty() ? Configuracion{} : runs.front().run->configuration;
    for (Compared& other : others_) other.run = run_of(other.choice);
    std::erase_if(others_, [](const Compared& other) { return !other.run; });
    for (Side& side : sides_) {
        side.box->clear();
        for (const ListedRun& listed : runs) {
            QString words = title_of({listed.number, false});
            const QString different = difference_words(listed.run->configuration, base);
            if (!different.isEmpty()) words += ": " + different;
            const QString source = source_words(listed);
            if (source != source_words(runs.front())) words += " · " + source;
            side.box->addItem(words, QPoint(listed.number, 0));
            side.box->addItem(title_of({listed.number, true}), QPoint(listed.number, 1));
        }
        const QPoint chosen(side.choice.number, side.choice.odometry ? 1 : 0);
        const int place = side.box->findData(chosen);
        side.box->setCurrentIndex(std::max(place, 0));
        if (place < 0) {
            side.choice = replacement_for(side);
            side.run = nullptr;
            std::erase_if(others_, [&side](const Compared& o) { return o.choice == side.choice; });
            side.box->setCurrentIndex(
                side.box->findData(QPoint(side.choice.number, side.choice.odometry ? 1 : 0)));
        }
        take(side);
    }
    measure();
}

/// For a side whose run has gone: the first of the others, else the first of the list, by odometry
/// where the other side has it already.
CompareWindow::Choice CompareWindow::replacement_for(const Side& side) const {
    if (!others_.empty()) return others_.front().choice;
    const QPoint first = side.box->itemData(0).toPoint();
    const Side& beside = &side == &sides_.front() ? sides_.back() : sides_.front();
    const Choice choice{first.x(), false};
    return {choice.number, choice == beside.choice};
}

void CompareWindow::compare(const std::vector<ListedRun>& runs) {
    const std::vector<ListedRun> all = list_.runs();
    const bool present =
        !all.empty() && all.front().number == 0 && all.front().run->scans > 0;  // to be seen
    Choice left;
    if (!runs.empty()) {
        left = {runs.front().number, false};
    } else if (!present && !all.empty()) {
        left = {all.back().number, false};
    } else if (present) {  // what it was before, if there is any
        for (const ListedRun& kept : std::span(all).subspan(1)) {
            const KeptRun& now = *all.front().run;
            if (same_tour(*kept.run, now) && !same_run(*kept.run, now)) left = {kept.number, false};
        }
    }
    Choice right{left.number, true};
    others_.clear();
    left_out_ = runs.size() - std::min(runs.size(), kMostCompared);
    if (runs.size() > 1) {
        right = {runs[1].number, false};
        for (std::size_t i = 2; i < std::min(runs.size(), kMostCompared); ++i)
            others_.push_back({{runs[i].number, false}, runs[i].run, {}});
    } else if (present && left.number != 0) {
        right = {};
    }
    set_side(0, left);
    set_side(1, right);
    measure();
    sides_.front().view->fit();
}

void CompareWindow::choose(int side, const Choice& choice) {
    // One that was among the others leaves them its place, unless what was here is beside it.
    const auto place = static_cast<std::size_t>(side);
    const Choice before = sides_[place].choice;
    const auto same = [&choice](const Compared& other) { return other.choice == choice; };
    if (std::erase_if(others_, same) > 0 && before != sides_[1 - place].choice)
        others_.push_back({before, run_of(before), {}});
    set_side(place, choice);
    measure();
}

void CompareWindow::set_side(std::size_t side, const Choice& choice) {
    Side& changed = sides_[side];
    if (changed.choice != choice) changed.run = nullptr;
    changed.choice = choice;
    const QScopedValueRollback filling(filling_, true);
    changed.box->setCurrentIndex(
        changed.box->findData(QPoint(choice.number, choice.odometry ? 1 : 0)));
    take(changed);
}

/// Null where it is not in the list.
std::shared_ptr<const KeptRun> CompareWindow::run_of(const Choice& choice) const {
    std::shared_ptr<const KeptRun> run;
    for (const ListedRun& listed : list_.runs()) {
        if (listed.number == choice.number) run = listed.run;
    }
    return run;
}

/// What is chosen becomes what is shown.
void CompareWindow::take(Side& side) {
    std::shared_ptr<const KeptRun> run = run_of(side.choice);
    const bool grid_stays = run && run == side.run;
    side.run = std::move(run);
    if (!grid_stays) refresh_grid(side);
}

void CompareWindow::refresh_grid(Side& side) {
    side.builder->stop();
    side.grid = {};
    side.made = false;
    if (!side.run) return;
    if (!side.choice.odometry) side.grid = side.run->grid;
    if (!side.grid.empty() || side.path().empty()) return;
    side.made = true;
    side.builder->build(side.run->configuration, side.path());
}

bool CompareWindow::building() const {
    return std::ranges::any_of(sides_,
                               [](const Side& side) { return side.builder->state().running; });
}

void CompareWindow::set_mode(Mode mode) {
    mode_ = mode;
    modes_[static_cast<std::size_t>(mode)]->setChecked(true);
    blinked_ = false;
    sides_.back().view->setVisible(mode == Mode::side_by_side);
    mode == Mode::blinking ? blink_.start() : blink_.stop();
    paint_sides();
}

void CompareWindow::show_figures(bool on) {
    figures_->setChecked(on);
}

/// Why there are no figures, and what would help.
QString CompareWindow::problem_of(const Compared& of) const {
    if (!of.run || of.path().empty()) return tr("no scans yet");
    const QString log = log_of(*of.run);
    if (list_.reference_of(*of.run) != nullptr)
        return tr("the reference knows no pose at the times of its scans (%1)").arg(log);
    return tr("no reference trajectory of %1 is loaded; “File → Load reference trajectory…” "
              "takes one of the log in the window")
        .arg(log);
}

/// Left, right, and the others.
std::vector<const CompareWindow::Compared*> CompareWindow::compared() const {
    std::vector<const Compared*> all{&sides_.front(), &sides_.back()};
    for (const Compared& other : others_) all.push_back(&other);
    return all;
}

/// The run's own, as in the list; where two have the same, for the later one that nobody has.
QColor CompareWindow::colour_at(std::size_t place) const {
    std::vector<QColor> colours;
    for (const Compared* of : compared()) {
        colours.push_back(of->choice.odometry ? light_colours().odometry
                                              : colour_of({of->choice.number, nullptr}));
    }
    for (std::size_t i = 1; i <= place; ++i) {
        const auto end = colours.begin() + static_cast<std::ptrdiff_t>(i);
        if (std::find(colours.begin(), end, colours[i]) == end) continue;
        int next = 0;
        while (std::ranges::find(colours, colour_of({next, nullptr})) != colours.end()) ++next;
        colours[i] = colour_of({next, nullptr});
    }
    return colours[place];
}

PathFigures CompareWindow::figures_of(const Compared& of) const {
    const Trajectory* reference =
        figures_->isChecked() && of.run ? list_.reference_of(*of.run) : nullptr;
    if (reference == nullptr) return {};
    return path_figures(of.path(), of.run->later_tours, *reference, strip_->aligned());
}

/// Runs of one log may begin in different frames. With the figures as the alignment is chosen
/// there, else by the first poses, as where both begin at the same place.
std::optional<Pose> CompareWindow::laid_on_left(const Compared& of) const {
    const Compared& left = sides_.front();
    if (!of.run || !left.run || of.path().empty() || left.path().empty()) return Pose{};
    if (!same_tour(*of.run, *left.run)) return std::nullopt;
    if (of.path().front() == left.path().front() && !figures_->isChecked()) return Pose{};
    if (figures_->isChecked() && strip_->aligned()) {
        if (const auto error = trajectory_error(of.path(), left.path()))
            return error->pose_reference_estimate;
    }
    return first_alignment(of.path(), left.path());
}

void CompareWindow::measure(Of which) {
    since_measured_.start();
    const auto renew = [&](Compared& of) {
        if (of.choice.number == 0 || which == Of::all) of.figures = figures_of(of);
    };
    for (Side& side : sides_) renew(side);
    for (Compared& other : others_) {
        if (other.choice.number == 0) other.run = run_of(other.choice);
        renew(other);
    }
    sides_.back().laid = laid_on_left(sides_.back());
    for (Compared& other : others_) other.laid = laid_on_left(other);
    std::vector<ErrorStrip::Side> shown;
    for (const Compared* of : compared())
        shown.push_back(
            {title_of(of->choice), colour_at(shown.size()), of->figures, problem_of(*of)});
    strip_->show_sides(std::move(shown));
    measuring_ms_ = since_measured_.elapsed();
    paint_sides();
}

/// What is drawn of one over a grid; with figures, its path has their colours.
RunTrace CompareWindow::trace_of(std::size_t place, bool landmarks) const {
    const std::vector<const Compared*> all = compared();
    const Compared& of = *all[place];
    RunTrace trace{title_of(of.choice), colour_at(place), points_of(of.path()),
                   landmarks ? MarkedMap{of.run->map, of.run->line_extents} : MarkedMap{}};
    trace.begins = begins_of(of.path());
    if (const Pose laid = of.laid.value_or(Pose{}); mode_ == Mode::overlaid && laid != Pose{}) {
        trace.path = points_of(of.path(), laid);
        trace.landmarks = transform(laid, trace.landmarks.map, trace.landmarks.extents);
    }
    if (of.figures.errors.empty()) return trace;
    trace.errors_m.assign(trace.path.size(), std::numeric_limits<double>::quiet_NaN());
    for (const PathError& error : of.figures.errors) {
        if (error.pose < trace.errors_m.size()) trace.errors_m[error.pose] = error.error_m;
    }
    const std::size_t in_sight = mode_ == Mode::overlaid ? all.size() : sides_.size();
    for (std::size_t i = 0; i < in_sight; ++i)
        trace.greatest_m = std::max(trace.greatest_m, all[i]->figures.greatest_m());
    return trace;
}

/// The reference as the figures lay it on the path.
RunTrace CompareWindow::reference_of(const Compared& of) {
    return {.name = tr("Reference"),
            .colour = light_colours().reference,
            .path = of.figures.reference,
            .landmarks = {},
            .line = Qt::DashLine};
}

void CompareWindow::show_in(GridView& view, const Side& side) const {
    if (!side.run) return;
    view.set_frame(side.laid.value_or(Pose{}));
    view.set_grid(side.grid, side.path());
    view.set_landmarks(side.choice.odometry ? MarkedMap{}
                                            : MarkedMap{side.run->map, side.run->line_extents});
}

/// In what they differ, and why a grid is missing.
QString CompareWindow::verdict() const {
    const auto& [left, right] = sides_;
    const QString different = compared_words(right.run->configuration, left.run->configuration);
    QStringList words{different.isEmpty() ? tr("Left and right have the same configuration.")
                                          : tr("The right one differs in: %1").arg(different)};
    if (!same_tour(*left.run, *right.run)) {
        words << tr("The logs differ: %1 and %2").arg(log_of(*left.run), log_of(*right.run));
    }
    for (const Compared* of : compared()) {
        if (of->laid) continue;
        words << tr("%1 is not laid on the left one: it is of another log, or has none of its "
                    "stamps.")
                     .arg(title_of(of->choice));
    }
    if (left_out_ > 0) words << tr("Chosen as well, and left out: %1").arg(left_out_);
    for (const Side& side : sides_) {
        const QString& problem = side.builder->state().error;
        if (!side.made || problem.isEmpty()) continue;
        words << tr("No grid map of %1: %2").arg(title_of(side.choice), problem);
    }
    return words.join('\n');
}

void CompareWindow::paint_sides() {
    auto& [left, right] = sides_;
    const bool one_view = mode_ != Mode::side_by_side;
    show_in(*left.view, one_view && blinked_ ? right : left);
    std::array<std::vector<RunTrace>, 2> traces;  // of both views
    for (std::size_t i = 0; i < sides_.size(); ++i) {
        const Side& side = sides_[i];
        if (!side.run) continue;
        if (mode_ == Mode::overlaid) {
            // The left one's own marks are those of the grid.
            traces.front().push_back(trace_of(i, i == 1 && !side.choice.odometry));
            continue;
        }
        if (mode_ == Mode::blinking && blinked_ != (i == 1)) continue;
        std::vector<RunTrace>& shown = traces[one_view ? 0 : i];
        if (!side.figures.errors.empty()) {
            shown.push_back(reference_of(side));  // below, or it covers the colours of errors
            shown.push_back(trace_of(i, false));
        } else if (mode_ == Mode::blinking) {  // its path is that of the grid
            shown.push_back({title_of(side.choice), light_colours().path, {}, {}});
        }
    }
    if (mode_ == Mode::overlaid) {
        // That of the left one: to lie on several paths it would have to be drawn as often.
        if (!left.figures.reference.empty())
            traces.front().insert(traces.front().begin(), reference_of(left));
        for (std::size_t place = 0; place < others_.size(); ++place)
            traces.front().push_back(trace_of(sides_.size() + place, false));
    }
    left.view->set_traces(std::move(traces.front()));
    right.view->set_traces(std::move(traces.back()));
    if (!one_view) show_in(*right.view, right);
    if (left.run && right.run) {
        const Pose laid = right.laid.value_or(Pose{});
        QTransform left_right;
        left_right.translate(laid.x, laid.y);
        left_right.rotateRadians(laid.theta);
        const QRectF both = left.content().united(left_right.mapRect(right.content()));
        left.view->set_other_content(both);
        right.view->set_other_content(both);
        verdict_->setText(verdict());
    }
}

}  // namespace hitos::window
