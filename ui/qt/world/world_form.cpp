// SPDX-License-Identifier: GPL-3.0-or-later
#include "world_form.hpp"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <array>
#include <utility>

#include "hitos/simulation/worlds/world_key.hpp"
#include "look/named.hpp"
#include "look/parameter_text.hpp"
#include "look/screen_fit.hpp"
#include "look/words_of.hpp"

namespace hitos::window {
namespace {

struct WorldGroup {
    const char* table = "";
    const char* title = "";
};

/// Two columns, about as long as each other.
constexpr std::array<std::array<WorldGroup, 4>, 2> kColumns = {
    {{{{"robot", QT_TRANSLATE_NOOP("WorldForm", "Robot")},
       {"tour", QT_TRANSLATE_NOOP("WorldForm", "Tour")},
       {"seed", QT_TRANSLATE_NOOP("WorldForm", "Noise")},
       {"landmarks", QT_TRANSLATE_NOOP("WorldForm", "Landmarks in the place of a laser")}}},
     {{{"laser", QT_TRANSLATE_NOOP("WorldForm", "Laser")},
       {"odometry", QT_TRANSLATE_NOOP("WorldForm", "Odometry")},
       {"raster", QT_TRANSLATE_NOOP("WorldForm", "Raster of the walls")}}}}};

}  // namespace

WorldForm::WorldForm(WorldText text, QWidget* parent) : QDialog(parent), text_(std::move(text)) {
    setObjectName("world_form");
    setWindowTitle(tr("Robot, laser, odometry"));
    auto* all = new QVBoxLayout(this);
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    auto* groups = new QWidget(scroll);
    auto* columns = new QHBoxLayout(groups);
    for (const auto& tables : kColumns) {
        auto* column = new QVBoxLayout;
        for (const WorldGroup& group : tables) {
            if (*group.table == '\0') continue;
            auto* box = new QFrame(groups);
            box->setProperty("role", "card");
            auto* rows = new QGridLayout(box);
            constexpr int kEditorWidth = 150;
            rows->setColumnStretch(1, 1);
            rows->setColumnMinimumWidth(1, kEditorWidth);
            add_group(group.table, translated("WorldForm", group.title), rows, box);
            column->addWidget(box);
        }
        column->addStretch(1);
        columns->addLayout(column, 1);
    }
    scroll->setWidget(groups);
    scroll_down_only(*scroll);
    all->addWidget(scroll, 1);
    verdict_ = named(new QLabel(this), "world_form_verdict");
    verdict_->setProperty("role", "error");
    verdict_->setWordWrap(true);
    verdict_->hide();
    all->addWidget(verdict_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    all->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &WorldForm::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    resize(sizeHint().width(), groups->sizeHint().height() + buttons->sizeHint().height() * 2);
    fit_to_screen(*this);
}

void WorldForm::add_group(std::string_view group, const QString& title, QGridLayout* rows,
                          QWidget* box) {
    auto* label = new QLabel(title, box);
    label->setProperty("role", "title");
    rows->addWidget(label, 0, 0, 1, 3);
    for (const WorldKey& key : world_keys()) {
        if (key.table() != group) continue;
        auto* field = new FieldOf<World>(key, rows, box);
        field->set_value(text_.world());
        fields_.push_back(field);
        connect(field, &ParameterField::edited, field, [field] { field->take(); });
    }
}

void WorldForm::accept() {
    World next = text_.world();
    FieldOf<World>* first_wrong = nullptr;
    for (FieldOf<World>* field : fields_) {
        if (!field->apply(next) && first_wrong == nullptr) first_wrong = field;
    }
    if (first_wrong != nullptr) {
        first_wrong->focus();
        return;
    }
    try {
        text_.set(next);
    } catch (const std::exception& error) {  // a tour that was driven faster, say
        verdict_->setText(words_of(error));
        verdict_->show();
        return;
    }
    QDialog::accept();
}

}  // namespace hitos::window
