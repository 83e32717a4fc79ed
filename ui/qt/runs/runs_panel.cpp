// SPDX-License-Identifier: GPL-3.0-or-later
#include "runs_panel.hpp"

#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <limits>
#include <utility>

#include "look/flow_layout.hpp"
#include "look/named.hpp"
#include "look/parameter_text.hpp"
#include "look/words_of.hpp"
#include "views/canvas_paint.hpp"

namespace hitos::window {
namespace {

QString metres_or_none(const std::optional<double>& error_m) {
    return error_m ? metre_words(*error_m) : QString("–");
}

/// What is not known comes after all that is.
double sortable(const std::optional<double>& error_m) {
    return error_m.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace

RunsModel::RunsModel(QObject* parent)
    : FiguresModel({tr("Run"), tr("Path error"), tr("Map error"), tr("Different from this run"),
                    tr("Landmarks"), tr("Scans"), tr("Time"), tr("Log")},
                   parent) {}

void RunsModel::set_runs(std::vector<ListedRun> runs, const Configuracion& base) {
    change(static_cast<int>(runs.size()), [&] {
        runs_ = std::move(runs);
        differences_.clear();
        for (const ListedRun& listed : runs_)
            differences_.push_back(difference_words(listed.run->configuration, base));
    });
}

QVariant RunsModel::key(int row, int column) const {
    const KeptRun& run = *this->run(row).run;
    switch (column) {
        case name:
            return this->run(row).number;
        case scans:
            return static_cast<qulonglong>(run.scans);
        case landmarks:
            return static_cast<qulonglong>(run.map.size());
        case path_error:
            return sortable(run.figures["trajectory_error_m"]);
        case map_error:
            return sortable(run.figures["error_m"]);
        case seconds:
            return run.seconds;
        default:
            return text(row, column);
    }
}

QString RunsModel::text(int row, int column) const {
    const KeptRun& run = *this->run(row).run;
    switch (column) {
        case name:
            return name_of(this->run(row));
        case log:
            return source_words(this->run(row));
        case different:
            return differences_[static_cast<std::size_t>(row)];
        case scans:
            return QString::number(run.scans);
        case landmarks:
            return QString::number(run.map.size());
        case path_error:
            return metres_or_none(run.figures["trajectory_error_m"]);
        case map_error:
            return metres_or_none(run.figures["error_m"]);
        default:
            return QString("%1 s").arg(run.seconds, 0, 'f', 1);
    }
}

RunsPanel::RunsPanel(Session& session, RunList& list, UserFiles& files, Prompts& prompts,
                     QWidget* parent)
    : QWidget(parent),
      session_(session),
      list_(list),
      files_(files),
      prompts_(prompts),
      model_(new RunsModel(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    column->setSpacing(4);
    table_ = named(new FiguresTable(model_, this), "runs_table");
    table_->setAccessibleName(tr("Runs"));
    table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    buttons_ = new QWidget(this);
    auto* row = new FlowLayout(buttons_, 4);
    compare_ = add_button(tr("Compare"), "runs_compare", &RunsPanel::compare);
    compare_->setToolTip(
        tr("Side by side, one over the other, or blinking; of up to six the errors"));
    use_ = add_button(tr("Use configuration"), "runs_use", &RunsPanel::use);
    remove_ = add_button(tr("Remove"), "runs_remove", &RunsPanel::remove);
    QPushButton* open = add_button(tr("Open results…"), "runs_open", &RunsPanel::results_wanted);
    open->setToolTip(tr("A folder that “Save all results” or hitos-cli run has written"));
    for (QPushButton* button : {compare_, use_, remove_, open}) row->addWidget(button);
    column->addWidget(buttons_);
    column->addWidget(table_, 1);
    connect(&list, &RunList::changed, this, &RunsPanel::refresh);
    connect(&list, &RunList::present_changed, this, [this] {
        constexpr qint64 kRefreshMs = 250;  // it copies paths
        const bool running = session_.progress().state == Progress::State::running;
        if (!running || !since_refresh_.isValid() || since_refresh_.elapsed() > kRefreshMs) {
            refresh();
        }
    });
    connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &RunsPanel::show_choice);
    connect(table_, &QAbstractItemView::activated, this, &RunsPanel::compare);
    show_choice();
}

QPushButton* RunsPanel::add_button(const QString& text, const char* name,
                                   void (RunsPanel::*act)()) {
    auto* button = named(new QPushButton(text, buttons_), name);
    connect(button, &QPushButton::clicked, this, act);
    return button;
}

std::vector<ListedRun> RunsPanel::chosen() const {
    const std::vector<int> rows = table_->chosen_rows();
    std::vector<ListedRun> runs;
    runs.reserve(rows.size());
    for (const int row : rows) runs.push_back(model_->run(row));
    return runs;
}

void RunsPanel::refresh() {
    if (!isVisible()) return;
    since_refresh_.start();
    const std::vector<ListedRun> before = chosen();
    std::vector<int> numbers;
    numbers.reserve(before.size());
    for (const ListedRun& listed : before) numbers.push_back(listed.number);
    model_->set_runs(list_.runs(), session_.configuration());
    std::vector<int> rows;  // of those runs, which may stand elsewhere now
    for (int row = 0; row < model_->rowCount(); ++row) {
        if (std::ranges::find(numbers, model_->run(row).number) != numbers.end()) {
            rows.push_back(row);
        }
    }
    table_->choose_rows(rows);
    show_choice();
}

void RunsPanel::show_choice() {
    const std::vector<ListedRun> runs = isVisible() ? chosen() : std::vector<ListedRun>();
    compare_->setEnabled(model_->rowCount() > 0);
    use_->setEnabled(runs.size() == 1 && runs.front().number > 0);
    remove_->setEnabled(std::ranges::any_of(runs, [](const auto& one) { return one.number > 0; }));
    std::vector<RunTrace> traces;
    traces.reserve(runs.size());
    for (const ListedRun& listed : runs) {
        const Trajectory& path = listed.run->path;
        traces.push_back({.name = name_of(listed),
                          .colour = colour_of(listed),
                          .path = points_of(path),
                          .landmarks = {},
                          .begins = begins_of(path)});
    }
    emit traces_changed(std::move(traces));
}

void RunsPanel::remove() {
    for (const ListedRun& listed : chosen()) list_.remove(listed.number);
}

void RunsPanel::use() {
    const std::vector<ListedRun> runs = chosen();
    if (!runs.empty()) emit configuration_wanted(runs.front().run->configuration);
}

QString RunsPanel::ask_folder() {
    return prompts_.choose_folder(this, tr("Open a folder of results"),
                                  files_.folder_to_open("results"));
}

std::optional<ListedRun> RunsPanel::open_folder(const QString& folder) {
    try {
        ListedRun opened = list_.open(folder);
        files_.note_opened("results", folder);
        return opened;
    } catch (const std::exception& error) {
        prompts_.warn(this, tr("The results were not opened"), words_of(error));
        return std::nullopt;
    }
}

void RunsPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
}

void RunsPanel::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    show_choice();
}

}  // namespace hitos::window
