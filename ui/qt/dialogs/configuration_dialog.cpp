// SPDX-License-Identifier: GPL-3.0-or-later
#include "configuration_dialog.hpp"

#include <QApplication>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "hitos/base/error.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "look/named.hpp"
#include "look/parameter_text.hpp"
#include "look/screen_fit.hpp"
#include "look/theme.hpp"
#include "look/words_of.hpp"
#include "ui_configuration_dialog.h"

namespace hitos::window {
namespace {

using Group = ParameterGroup;

/// Two columns of groups, about as long as each other. Of the source, how it is read.
const std::array<std::vector<Group>, 2> kColumnGroups{{
    {Group::particle_filter, Group::motion, Group::resampling, Group::source},
    {Group::observation, Group::split_merge, Group::registration, Group::grid, Group::run},
}};

/// Of the longest label, so that the editors of all groups stand below each other.
int label_width() {
    const QFontMetrics metrics(QApplication::font());
    int width = 0;
    for (const ConfigParameter& parameter : parameters()) {
        if (names_source(parameter)) continue;
        width = std::max(width, metrics.size(0, in_lines(full_label_of(parameter))).width());
    }
    return width + 8;
}

}  // namespace

ConfigurationDialog::ConfigurationDialog(const Configuracion& configuration, QWidget* parent)
    : QDialog(parent),
      ui_(std::make_unique<Ui::ConfigurationDialog>()),
      original_(configuration),
      result_(configuration) {
    ui_->setupUi(this);
    columns_ = new QHBoxLayout(ui_->groups);
    columns_->setContentsMargins(0, 0, 6, 0);
    columns_->setSpacing(12);
    for (const auto& groups : kColumnGroups) {
        auto* column = new QVBoxLayout;
        column->setSpacing(12);
        for (const Group group : groups) {
            auto* box = new QFrame(ui_->groups);
            box->setProperty("role", "card");
            box->setObjectName(QString("group_%1").arg(static_cast<int>(group)));
            auto* rows = new QGridLayout(box);
            rows->setContentsMargins(14, 10, 14, 12);
            rows->setHorizontalSpacing(10);
            rows->setVerticalSpacing(5);
            rows->setColumnStretch(1, 1);
            rows->setColumnMinimumWidth(0, label_width());
            rows->setColumnMinimumWidth(2, 52);
            add_group(group, rows, box);
            column->addWidget(box);
        }
        column->addStretch(1);
        columns_->addLayout(column, 1);
    }
    connect(ui_->search, &QLineEdit::textChanged, this, &ConfigurationDialog::arrange);
    connect(ui_->buttons, &QDialogButtonBox::accepted, this, &ConfigurationDialog::accept);
    connect(ui_->buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(ui_->buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
            [this] {
                fill(Configuracion{});
                arrange();
            });
    fill(configuration);
    scroll_down_only(*ui_->scroll);  // with all fields, so that none makes it wider later
    arrange();
    fit_to_screen(*this);
}

ConfigurationDialog::~ConfigurationDialog() = default;

/// Where there is no room for two columns of whole words they stand one below the other.
void ConfigurationDialog::resizeEvent(QResizeEvent* event) {
    constexpr int kTwoColumns = 940;
    columns_->setDirection(width() < kTwoColumns ? QBoxLayout::TopToBottom
                                                 : QBoxLayout::LeftToRight);
    columns_->setStretch(0, width() < kTwoColumns ? 0 : 1);  // no hole before the second
    QDialog::resizeEvent(event);
}

void ConfigurationDialog::add_group(Group group, QGridLayout* rows, QWidget* box) {
    auto* title = new QLabel(title_of(group, original_), box);
    auto* more = named(new QToolButton(box), QString("more_%1").arg(static_cast<int>(group)));
    more->setProperty("role", "chip");
    more->setCheckable(true);
    connect(more, &QToolButton::toggled, this, &ConfigurationDialog::arrange);
    boxes_.push_back({group, box, title, more});
    title->setProperty("role", "title");
    rows->addWidget(title, 0, 0, 1, 3);
    for (const ConfigParameter& parameter : parameters()) {
        if (group_of(parameter.table()).group != group || names_source(parameter)) continue;
        auto* field = new FieldOf<Configuracion>(parameter, rows, box);
        fields_.push_back(field);
        connect(field, &ParameterField::edited, this, [this, field] {
            Configuracion scratch = original_;
            field->apply(scratch);
            show_verdict();
            if (field->facts().type == ParameterFacts::Type::choice) arrange();  // others are used
        });
    }
    rows->addWidget(more, rows->rowCount(), 0);
}

void ConfigurationDialog::fill(const Configuracion& configuration) {
    for (FieldOf<Configuracion>* field : fields_) field->set_value(configuration);
    show_verdict();
}

FieldOf<Configuracion>* ConfigurationDialog::field(std::string_view key) const {
    const auto found = std::find_if(fields_.begin(), fields_.end(), [key](const auto* candidate) {
        return candidate->parameter().key == key;
    });
    return found == fields_.end() ? nullptr : *found;
}

/// What is searched for, else of each group what is worth a first look.
void ConfigurationDialog::arrange() {
    const QStringList wanted = plain(ui_->search->text()).split(' ', Qt::SkipEmptyParts);
    const auto has_all = [&wanted](const QString& text) {
        return std::ranges::all_of(
            wanted, [text = plain(text)](const QString& word) { return text.contains(word); });
    };
    bool any = false;
    for (const Box& box : boxes_) {
        const bool whole = has_all(box.title->text());
        int shown = 0;
        int left_out = 0;
        for (FieldOf<Configuracion>* field : fields_) {
            if (group_of(field->parameter().table()).group != box.group) continue;
            const bool worth = !field->facts().card.empty() && field->is_used();
            const bool here = !wanted.isEmpty()
                                  ? whole || has_all(search_text_of(field->facts()))
                                  : box.more->isChecked() || worth || field->differs() ||
                                        field->has_error() || field->has_focus();
            field->set_shown(here);
            ++(here ? shown : left_out);
        }
        box.box->setVisible(wanted.isEmpty() || shown > 0);
        box.more->setVisible(wanted.isEmpty() && (left_out > 0 || box.more->isChecked()));
        box.more->setText(box.more->isChecked() ? tr("Fewer") : tr("%1 more").arg(left_out));
        any = any || shown > 0;
    }
    set_look(*ui_->search, "state", any ? "good" : "wrong");
    ui_->search->setToolTip(any ? QString() : tr("No parameter has all of these words"));
}

/// Greys out what has no effect beside the other values; the values stay. The titles name what is
/// chosen.
Configuracion ConfigurationDialog::mark_unused() {
    Configuracion edited = original_;
    for (const FieldOf<Configuracion>* field : fields_) field->give(edited);
    for (FieldOf<Configuracion>* field : fields_)
        field->set_used(field->parameter().used_by(edited));
    for (const Box& box : boxes_) box.title->setText(title_of(box.group, edited));
    return edited;
}

void ConfigurationDialog::show_verdict() {
    const QStringList changed = changes(mark_unused());
    const auto wrong = std::count_if(fields_.begin(), fields_.end(),
                                     [](const auto* field) { return field->has_error(); });
    set_look(*ui_->verdict, "role", wrong > 0 ? "error" : "muted");
    ui_->verdict->setToolTip(changed.join('\n'));
    if (wrong > 0) {
        ui_->verdict->setText(
            tr("Values to correct: %1. Nothing changes until all are possible.").arg(wrong));
    } else if (changed.isEmpty()) {
        ui_->verdict->setText(
            tr("Values that differ from their default are marked. Nothing changes until you "
               "confirm."));
    } else {
        constexpr int kMost = 3;
        QStringList told = changed.mid(0, kMost);
        if (changed.size() > kMost) told << tr("… and %1 more").arg(changed.size() - kMost);
        ui_->verdict->setText(tr("OK starts from the beginning with: %1").arg(told.join("; ")));
    }
}

bool ConfigurationDialog::read(Configuracion& out) {
    FieldOf<Configuracion>* first_wrong = nullptr;
    for (FieldOf<Configuracion>* field : fields_) {
        if (!field->apply(out) && first_wrong == nullptr) first_wrong = field;
    }
    if (first_wrong == nullptr) {
        try {
            check(out);
        } catch (const ConfigError& error) {
            first_wrong = field(error.key());
            if (first_wrong == nullptr) first_wrong = fields_.front();
            first_wrong->set_error(words_of(error));
        }
    }
    if (first_wrong == nullptr) return true;
    ui_->search->clear();  // what is wrong may not be in sight
    arrange();
    first_wrong->focus();
    return false;
}

QStringList ConfigurationDialog::changes(const Configuracion& next) const {
    QStringList lines;
    for (const ConfigParameter& parameter : parameters()) {
        if (parameter.text(original_) == parameter.text(next)) continue;
        lines << QString("%1: %2 → %3")
                     .arg(full_label_of(parameter), value_of(parameter, original_),
                          value_of(parameter, next));
    }
    return lines;
}

void ConfigurationDialog::accept() {
    Configuracion next = original_;
    const bool good = read(next);
    show_verdict();
    if (!good) return;
    if (changes(next).isEmpty()) {
        reject();
        return;
    }
    result_ = next;
    QDialog::accept();
}

/// In the search field Return goes to what was found, and Escape shows all again.
void ConfigurationDialog::keyPressEvent(QKeyEvent* event) {
    const bool searches = focusWidget() == ui_->search;
    if (searches && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)) {
        const auto found = std::ranges::find_if(
            fields_, [](const auto* field) { return field->is_shown() && field->is_used(); });
        if (found != fields_.end()) (*found)->focus();
    } else if (searches && event->key() == Qt::Key_Escape && !ui_->search->text().isEmpty()) {
        ui_->search->clear();
    } else {
        QDialog::keyPressEvent(event);
    }
}

void ConfigurationDialog::show_group(ParameterGroup group) {
    const auto found = std::find_if(fields_.begin(), fields_.end(), [group](const auto* candidate) {
        return group_of(candidate->parameter().table()).group == group;
    });
    if (found != fields_.end()) (*found)->focus();
    if (auto* box = findChild<QWidget*>(QString("group_%1").arg(static_cast<int>(group)))) {
        ui_->scroll->ensureWidgetVisible(box);
    }
}

}  // namespace hitos::window
