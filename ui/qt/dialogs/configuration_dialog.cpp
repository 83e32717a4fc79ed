#include "configuration_dialog.hpp"

#include <QApplication>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

#include "hitos/base/error.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "look/parameter_text.hpp"
#include "look/screen_fit.hpp"
#include "look/theme.hpp"
#include "ui_configuration_dialog.h"

namespace hitos::window {
namespace {

using Group = ParameterGroup;

/// Two columns of groups, about as long as each other. Of the source, how it is read.
const std::array<std::vector<Group>, 2> kColumnGroups{{
    {Group::particle_filter, Group::motion, Group::resampling, Group::run, Group::source},
    {Group::observation, Group::split_merge, Group::registration, Group::grid},
}};

/// Of the longest label, so that the editors of all groups stand below each other.
int label_width() {
    const QFontMetrics metrics(QApplication::font());
    int width = 0;
    for (const ConfigParameter& parameter : parameters()) {
        if (names_source(parameter)) continue;
        width = std::max(width, metrics.horizontalAdvance(label_of(parameter)));
    }
    return width + 8;
}

}  // namespace

ConfigurationDialog::ConfigurationDialog(const Configuracion& configuration, Prompts& prompts,
                                         QWidget* parent)
    : QDialog(parent),
      ui_(std::make_unique<Ui::ConfigurationDialog>()),
      prompts_(prompts),
      original_(configuration),
      result_(configuration) {
    ui_->setupUi(this);
    auto* columns = new QHBoxLayout(ui_->groups);
    columns->setContentsMargins(0, 0, 6, 0);
    columns->setSpacing(12);
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
        columns->addLayout(column, 1);
    }
    connect(ui_->buttons, &QDialogButtonBox::accepted, this, &ConfigurationDialog::accept);
    connect(ui_->buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(ui_->buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
            [this] { fill(Configuracion{}); });
    fill(configuration);
    scroll_down_only(*ui_->scroll);
    fit_to_screen(*this);
}

ConfigurationDialog::~ConfigurationDialog() = default;

void ConfigurationDialog::add_group(Group group, QGridLayout* rows, QWidget* box) {
    auto* title = new QLabel(title_of(group, original_), box);
    titles_.emplace_back(group, title);
    title->setProperty("role", "title");
    rows->addWidget(title, 0, 0, 1, 3);
    for (const ConfigParameter& parameter : parameters()) {
        if (group_of(parameter.table()).group != group || names_source(parameter)) continue;
        auto* field = new FieldOf<Configuracion>(parameter, rows, box);
        fields_.push_back(field);
        connect(field, &ParameterField::edited, this, [this, field] {
            Configuracion scratch = original_;
            field->apply(scratch);
            mark_unused();
            show_verdict();
        });
    }
}

void ConfigurationDialog::fill(const Configuracion& configuration) {
    for (FieldOf<Configuracion>* field : fields_) field->set_value(configuration);
    mark_unused();
    show_verdict();
}

FieldOf<Configuracion>* ConfigurationDialog::field(std::string_view key) const {
    const auto found = std::find_if(fields_.begin(), fields_.end(), [key](const auto* candidate) {
        return candidate->parameter().key == key;
    });
    return found == fields_.end() ? nullptr : *found;
}

/// Greys out what has no effect beside the other values; the values stay. The titles name what is
/// chosen.
void ConfigurationDialog::mark_unused() {
    Configuracion edited = original_;
    for (const FieldOf<Configuracion>* field : fields_) field->give(edited);
    for (FieldOf<Configuracion>* field : fields_)
        field->set_used(field->parameter().used_by(edited));
    for (const auto& [group, title] : titles_) title->setText(title_of(group, edited));
}

void ConfigurationDialog::show_verdict() {
    const auto wrong = std::count_if(fields_.begin(), fields_.end(),
                                     [](const auto* field) { return field->has_error(); });
    set_look(*ui_->verdict, "role", wrong > 0 ? "error" : "muted");
    ui_->verdict->setText(
        wrong > 0 ? tr("Values to correct: %1. Nothing changes until all are possible.").arg(wrong)
                  : tr("Values that differ from their default are marked. Nothing "
                       "changes until you confirm."));
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
    first_wrong->focus();
    return false;
}

QString ConfigurationDialog::changes(const Configuracion& next) const {
    constexpr int kMostLines = 12;
    QStringList lines;
    for (const ConfigParameter& parameter : parameters()) {
        if (parameter.text(original_) == parameter.text(next)) continue;
        lines << QString("%1: %2 → %3")
                     .arg(label_of(parameter), value_of(parameter, original_),
                          value_of(parameter, next));
    }
    if (lines.size() > kMostLines) {
        const auto more = lines.size() - kMostLines;
        lines = lines.mid(0, kMostLines);
        lines << tr("… and %1 more").arg(more);
    }
    return lines.join('\n');
}

void ConfigurationDialog::accept() {
    Configuracion next = original_;
    const bool good = read(next);
    show_verdict();
    if (!good) return;
    const QString what = changes(next);
    if (what.isEmpty()) {
        reject();
        return;
    }
    if (!prompts_.confirm(
            this, {tr("Change the configuration"),
                   tr("Apply these values and start from the beginning?"), what, tr("Apply")})) {
        return;
    }
    result_ = next;
    QDialog::accept();
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
