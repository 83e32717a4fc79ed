// SPDX-License-Identifier: GPL-3.0-or-later
#include "anchor_dialog.hpp"

#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "drawn_walls.hpp"
#include "hitos/registration/seen_wall.hpp"
#include "hitos/simulation/drawings/dxf_walls.hpp"
#include "look/named.hpp"
#include "look/theme.hpp"
#include "look/words_of.hpp"
#include "look/written_number.hpp"
#include "views/canvas_paint.hpp"
#include "wall_view.hpp"

namespace hitos::window {
namespace {

constexpr int kMillimetres = 3;  // decimals

/// As many numbers as are asked for, with commas between; else none.
std::vector<double> numbers_in(const QString& text, std::size_t count) {
    std::vector<double> numbers;
    for (const QString& word : list_with_points(text, true).split(',')) {
        const auto number = number_of(word);
        if (!number) return {};
        numbers.push_back(*number);
    }
    return numbers.size() == count ? numbers : std::vector<double>();
}

QString in_words(const std::vector<double>& numbers, int decimals) {
    QStringList words;
    for (const double number : numbers) words << QString::number(number, 'f', decimals);
    return words.join(", ");
}

std::vector<double> numbers_of(const std::optional<QPointF>& place) {
    return place ? std::vector<double>{place->x(), place->y()} : std::vector<double>();
}

QLineF line_between(const Point2& a, const Point2& b) {
    return {point_of(a), point_of(b)};
}

}  // namespace

AnchorDialog::AnchorDialog(Session& session, QWidget* parent) : QDialog(parent), session_(session) {
    setObjectName("anchor_dialog");
    setWindowTitle(tr("Anchor to a drawing"));
    auto* column = new QVBoxLayout(this);
    auto* top = new QHBoxLayout;
    column->addLayout(top);
    kind_ = named(new QComboBox(this), "anchor_kind");
    kind_->addItems({tr("A wall"), tr("A point")});
    kind_->setToolTip(tr("What the scan and the drawing have in common"));
    top->addWidget(kind_);
    open_ = named(new QPushButton(tr("Drawing…"), this), "anchor_open");
    open_->setAutoDefault(false);
    open_->setToolTip(
        tr("A DXF drawing, a world, a reference map, or segments.txt of a run; coordinates can be "
           "written without any"));
    top->addWidget(open_);
    unit_ = named(new QComboBox(this), "anchor_unit");
    unit_->setToolTip(tr("The unit of a DXF drawing"));
    unit_->addItem(tr("as the drawing says, else metres"), 0.0);
    for (const DrawingUnit& unit : kDrawingUnits)
        unit_->addItem(QCoreApplication::translate("DrawingUnit", unit.name), unit.metres);
    unit_->hide();
    top->addWidget(unit_);
    notes_ = named(new QLabel(this), "anchor_notes");
    notes_->setWordWrap(true);
    top->addWidget(notes_, 1);
    auto* halves = new QSplitter(Qt::Horizontal, this);
    column->addWidget(halves, 1);
    drawing_ = named(
        new WallView(tr("Drawing"), tr("Open a drawing, or write the coordinates below."), halves),
        "anchor_drawing");
    scan_ = named(new WallView(tr("Scan"), tr("No scan is shown."), halves), "anchor_scan");
    drawn_ = named(new QLineEdit(this), "anchor_drawn");
    seen_ = named(new QLineEdit(this), "anchor_seen");
    halves->addWidget(made_side(drawing_, drawn_, tr("In the drawing")));
    halves->addWidget(made_side(scan_, seen_, tr("In the scan")));
    state_ = named(new QLabel(this), "anchor_state");
    state_->setWordWrap(true);
    column->addWidget(state_);
    effect_ = named(new QLabel(this), "anchor_effect");
    effect_->setWordWrap(true);
    column->addWidget(effect_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    anchor_ = buttons->addButton(tr("Anchor"), QDialogButtonBox::ActionRole);
    anchor_->setObjectName("anchor_make");
    anchor_->setDefault(true);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    connect(anchor_, &QPushButton::clicked, this, &AnchorDialog::anchor);
    connect(open_, &QPushButton::clicked, this, &AnchorDialog::drawing_wanted);
    connect(kind_, &QComboBox::currentIndexChanged, this, &AnchorDialog::change_kind);
    connect(unit_, &QComboBox::currentIndexChanged, this, [this] { open_drawing(file_); });
    connect(drawing_, &WallView::chosen, this, &AnchorDialog::take_drawn);
    connect(scan_, &WallView::chosen, this, &AnchorDialog::take_seen);
    for (QLineEdit* line : {drawn_, seen_})
        connect(line, &QLineEdit::textEdited, this, &AnchorDialog::take_written);
    connect(&session_, &Session::snapshot_changed, this, &AnchorDialog::refresh);
    connect(&session_, &Session::restarted, this, [this] { tell({}); });
    resize(860, 560);
    change_kind();
}

QWidget* AnchorDialog::made_side(WallView* view, QLineEdit* line, const QString& words) {
    auto* side = new QWidget(this);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    view->setMinimumSize(160, 160);
    column->addWidget(view, 1);
    auto* row = new QHBoxLayout;
    auto* label = new QLabel(words, side);
    label->setBuddy(line);
    row->addWidget(label);
    row->addWidget(line, 1);
    column->addLayout(row);
    return side;
}

bool AnchorDialog::of_points() const {
    return kind_->currentIndex() == 1;
}

void AnchorDialog::change_kind() {
    for (WallView* view : {drawing_, scan_}) view->set_of_places(of_points());
    drawn_->setToolTip(of_points() ? tr("x, y [m] in the drawing's own coordinates")
                                   : tr("x, y of the wall's left end and of its right end, as the "
                                        "robot sees it [m], in the drawing's own coordinates"));
    seen_->setToolTip(of_points() ? tr("x ahead, y to the left [m], from the robot")
                                  : tr("Direction of the wall, to the left of ahead [°]"));
    drawn_->setPlaceholderText(of_points() ? tr("x, y") : tr("x, y, x, y"));
    seen_->setPlaceholderText(of_points() ? tr("ahead, left") : tr("direction"));
    take_drawn();
    take_seen();
}

void AnchorDialog::open_drawing(const QString& path) {
    if (path.isEmpty()) return;
    file_ = path;
    unit_->setVisible(is_dxf(path));
    DrawnWalls read = read_drawn_walls(path, unit_->currentData().toDouble());
    set_look(*notes_, "role", read.well ? "muted" : "warning");
    notes_->setText(read.words);
    emit drawing_read(read.walls.walls);
    drawing_->set_walls(std::move(read.walls));
    drawing_->choose_wall(std::nullopt);
    drawing_->choose_place(std::nullopt);
    drawing_->fit();
    drawn_numbers_.clear();
    drawn_->clear();
    show_over_drawing();
    show_state();
}

void AnchorDialog::showEvent(QShowEvent* event) {
    QDialog::showEvent(event);
    if (file_.isEmpty()) open_drawing(session_.reference_map_file());
    refresh();
    (drawing_->walls().walls.empty() ? static_cast<QWidget*>(open_) : drawing_)->setFocus();
}

void AnchorDialog::refresh() {
    if (!isVisible()) return;
    show_scan();
    show_over_drawing();
    show_state();
}

/// A scan is looked at when it stays: finding its walls takes some milliseconds.
void AnchorDialog::show_scan() {
    const auto snapshot = session_.snapshot();
    const bool same = snapshot && shown_ && snapshot->steps == shown_->steps;
    if (!same && session_.progress().state == Progress::State::running) return;
    shown_ = snapshot && snapshot->steps > 0 ? snapshot : nullptr;
    if (same) return;
    WallView::Walls seen;
    bearings_.clear();
    if (shown_) {
        const double range_m = session_.configuration().registration.range_m;
        for (const SeenWall& wall : seen_walls(shown_->scan, range_m)) {
            seen.walls.push_back(line_between(wall.left, wall.right));
            seen.places.push_back(point_of(wall.left));
            seen.places.push_back(point_of(wall.right));
            bearings_.push_back(wall.bearing);
        }
        for (const Esquina& corner : shown_->observation.corners)
            seen.places.emplace_back(corner.x, corner.y);
        for (const Point2& point : shown_points(shown_->scan)) seen.dots.push_back(point_of(point));
        seen.robot = Pose{};
    }
    seen.sided = true;
    scan_->set_walls(std::move(seen));
    scan_->choose_wall(std::nullopt);
    scan_->choose_place(std::nullopt);
    scan_->fit();
    seen_numbers_.clear();
    seen_->clear();
}

/// The scan where the anchors so far lay it in the drawing.
void AnchorDialog::show_over_drawing() {
    std::vector<QPointF> dots;
    std::optional<Pose> robot;
    if (shown_ && shown_->drawing && shown_->drawing->firm) {
        robot = between(shown_->drawing->pose, shown_->best_trajectory.back().pose);
        for (const Point2& point : shown_points(shown_->scan))
            dots.push_back(point_of(transform(*robot, point)));
    }
    drawing_->set_dots(std::move(dots), robot);
}

/// What was chosen in the drawing, as numbers.
void AnchorDialog::take_drawn() {
    const auto& wall = drawing_->wall();
    drawn_numbers_.clear();
    if (of_points()) {
        drawn_numbers_ = numbers_of(drawing_->place());
    } else if (wall) {
        drawn_numbers_ = {wall->x1(), wall->y1(), wall->x2(), wall->y2()};
    }
    drawn_->setText(in_words(drawn_numbers_, kMillimetres));
    show_state();
}

/// Likewise in the scan.
void AnchorDialog::take_seen() {
    seen_numbers_.clear();
    if (of_points()) {
        seen_numbers_ = numbers_of(scan_->place());
        seen_->setText(in_words(seen_numbers_, kMillimetres));
    } else {
        const auto& walls = scan_->walls().walls;
        const auto found = scan_->wall() ? std::ranges::find(walls, *scan_->wall()) : walls.end();
        if (found != walls.end())
            seen_numbers_ = {bearings_[static_cast<std::size_t>(found - walls.begin())]};
        seen_->setText(seen_numbers_.empty()
                           ? QString()
                           : QString::number(seen_numbers_[0] * kDegreesPerRadian, 'f', 1));
    }
    show_state();
}

/// What was written, in the views.
void AnchorDialog::take_written() {
    const std::size_t drawn = of_points() ? 2 : 4;
    if (sender() == drawn_) drawn_numbers_ = numbers_in(drawn_->text(), drawn);
    const std::vector<double>& d = drawn_numbers_;
    if (sender() == seen_) {
        seen_numbers_ = numbers_in(seen_->text(), of_points() ? 2 : 1);
        if (!of_points() && !seen_numbers_.empty())
            seen_numbers_[0] = wrap_angle(seen_numbers_[0] / kDegreesPerRadian);
    }
    const std::vector<double>& s = seen_numbers_;
    if (of_points()) {
        drawing_->choose_place(d.empty() ? std::nullopt : std::optional(QPointF(d[0], d[1])));
        scan_->choose_place(s.empty() ? std::nullopt : std::optional(QPointF(s[0], s[1])));
    } else {
        drawing_->choose_wall(d.empty() ? std::nullopt
                                        : std::optional(QLineF(d[0], d[1], d[2], d[3])));
        std::optional<QLineF> wall;
        if (!s.empty() && shown_) {
            const double range_m = session_.configuration().registration.range_m;
            if (const auto seen = seen_wall(shown_->scan, range_m, s[0]))
                wall = line_between(seen->left, seen->right);
        }
        scan_->choose_wall(wall);
    }
    show_state();
}

std::optional<GraphEdit> AnchorDialog::edit() const {
    const std::vector<double>& d = drawn_numbers_;
    const std::vector<double>& s = seen_numbers_;
    if (d.empty() || s.empty() || !shown_) return std::nullopt;
    GraphEdit edit;
    edit.scan = {shown_->steps - 1, shown_->best_trajectory.back().time_s};
    edit.left = {d[0], d[1]};
    if (of_points()) {
        edit.kind = GraphEdit::Kind::point;
        edit.seen = {s[0], s[1]};
        return edit;
    }
    edit.kind = GraphEdit::Kind::wall;
    edit.bearing = s[0];
    edit.right = {d[2], d[3]};
    return edit;
}

/// Of a whole anchor, what the ones before it say of it.
QString AnchorDialog::words_of_fit(const GraphEdit& edit) const {
    const auto& drawing = shown_->drawing;
    if (!drawing) {
        return tr(
            "One anchor moves nothing yet. A second wall that is not parallel, or a second "
            "point, lays the drawing on the map; each further one bends the map.");
    }
    if (!drawing->firm) {
        return tr(
            "With this one and the ones before it the drawing will lie on the map, if they "
            "are not all parallel.");
    }
    const Pose pose = between(drawing->pose, shown_->best_trajectory.back().pose);
    if (of_points()) {
        const Point2 at = transform(pose, edit.seen);
        return tr("As the anchors so far lay the drawing, the point is %1 m off.")
            .arg(distance(at, edit.left), 0, 'f', 2);
    }
    const QLineF drawn = line_between(edit.left, edit.right);
    const QLineF& wall = *scan_->wall();
    const Point2 middle = transform(pose, Point2{wall.center().x(), wall.center().y()});
    const double heading = std::atan2(wall.dy(), wall.dx()) + pose.theta;
    const double turned = wrap_angle(std::atan2(drawn.dy(), drawn.dx()) - heading);
    const double across =
        ((middle.x - edit.left.x) * drawn.dy() - (middle.y - edit.left.y) * drawn.dx()) /
        drawn.length();
    QString words =
        tr("As the anchors so far lay the drawing, the wall is %1 m off and turned by %2°.")
            .arg(std::abs(across), 0, 'f', 2)
            .arg(std::abs(turned) * kDegreesPerRadian, 0, 'f', 1);
    if (std::abs(turned) <= 0.25 * kPi) return words;
    return words + ' ' + tr("This is another wall, or it was seen from its other side (space).");
}

/// Of what is written and no numbers; empty where there is none.
QString AnchorDialog::unread_words() const {
    QString words;
    const auto look_at = [&](QLineEdit& line, const std::vector<double>& numbers) {
        const bool unread = numbers.empty() && !line.text().trimmed().isEmpty();
        const char* look = unread ? "wrong" : "good";
        if (line.property("state").toString() != look) set_look(line, "state", look);
        if (unread && words.isEmpty())
            words = tr("“%1” cannot be read; expected: %2").arg(line.text(), line.toolTip());
    };
    look_at(*drawn_, drawn_numbers_);
    look_at(*seen_, seen_numbers_);
    return words;
}

void AnchorDialog::show_state() {
    const auto whole = edit();
    QString words = unread_words();
    bool can = whole.has_value();
    if (!words.isEmpty()) {
        can = false;
    } else if (!shown_) {
        words = tr("Let the run come to a scan first.");
    } else if (!seen_numbers_.empty() && !of_points() && !scan_->wall()) {
        words = tr("The scan sees no straight wall of half a metre in that direction.");
        can = false;
    } else if (!whole) {
        words = of_points()
                    ? tr("Choose a place of the drawing and the same place in scan %1.")
                          .arg(shown_->steps)
                    : tr("Choose a wall of the drawing, on the side where the robot stood, and the "
                         "same wall in scan %1.")
                          .arg(shown_->steps);
    } else {
        try {
            std::vector<GraphEdit> edits =
                parse_graph_edits(session_.configuration().registration.edits);
            edits.push_back(*whole);
            parse_graph_edits(text_of(edits));  // says what is wrong with it
            words = words_of_fit(*whole);
        } catch (const std::exception& error) {
            words = words_of(error);
            can = false;
        }
    }
    state_->setText(words);
    anchor_->setEnabled(can);
}

void AnchorDialog::tell(const QString& effect) {
    effect_->setText(effect);
}

void AnchorDialog::anchor() {
    const auto made = edit();
    if (!made) return;
    for (WallView* view : {drawing_, scan_}) {
        view->choose_wall(std::nullopt);
        view->choose_place(std::nullopt);
    }
    take_drawn();
    take_seen();
    emit anchored(*made);
}

}  // namespace hitos::window
