// SPDX-License-Identifier: GPL-3.0-or-later
#include "summary_bar.hpp"

#include <QDir>
#include <QEvent>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QScreen>
#include <QVariant>
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "hitos/services/configuration/config_parameter.hpp"
#include "look/elided_label.hpp"
#include "look/named.hpp"
#include "look/parameter_text.hpp"

namespace hitos::window {
namespace {

constexpr std::array kCards{ParameterGroup::source, ParameterGroup::motion,
                            ParameterGroup::particle_filter, ParameterGroup::observation,
                            ParameterGroup::split_merge};

constexpr std::string_view kMap = "source.map";

/// What the card of a group shows: its own parameters, then those of other groups that stand on it;
/// what has no effect is left out.
std::vector<const ConfigParameter*> rows_of(ParameterGroup card,
                                            const Configuracion& configuration) {
    std::vector<const ConfigParameter*> rows;
    const auto add = [&](bool own) {
        for (const ConfigParameter& parameter : parameters()) {
            if (parameter.card.empty() || group_of(parameter.card).group != card) continue;
            if ((group_of(parameter.table()).group == card) != own) continue;
            if (parameter.used_by(configuration)) rows.push_back(&parameter);
        }
    };
    add(true);
    add(false);
    if (card == ParameterGroup::source && !configuration.source.map.empty())
        rows.push_back(&find_parameter(kMap));
    return rows;
}

/// Of the keys that press a button.
bool is_choice(const QEvent& event) {
    const int key = static_cast<const QKeyEvent&>(event).key();
    return key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter;
}

void set_role(QWidget* widget, const char* role) {
    widget->setProperty("role", role);
}

bool is_marked(const ConfigParameter& parameter, const Configuracion& configuration) {
    const bool told = parameter.type != ConfigParameter::Type::text || parameter.key == kMap;
    return told && !is_default(parameter, configuration);
}

QString shown_value(const ConfigParameter& parameter, const Configuracion& configuration) {
    const QString text = value_with_unit(parameter, configuration);
    return text.isEmpty() ? SummaryBar::tr("none") : text;
}

void add_row(QGridLayout* rows, const ConfigParameter& parameter,
             const Configuracion& configuration) {
    auto* name = new ElidedLabel(label_of(parameter));
    name->setMinimumWidth(20);
    set_role(name, "muted");
    auto* value = named(new ElidedLabel(shown_value(parameter, configuration)),
                        "value_" + QString::fromStdString(std::string(parameter.key)));
    value->setTextFormat(Qt::PlainText);
    const bool changed = is_marked(parameter, configuration);
    set_role(value, changed ? "changed" : "value");
    // Where there is no room for both, the name ends in dots: what one looks for is the value.
    constexpr int kLeastWidth = 20;
    const int widest = parameter.type == ConfigParameter::Type::choice ? 80 : 130;
    value->ensurePolished();
    value->setMinimumWidth(parameter.type == ConfigParameter::Type::text
                               ? kLeastWidth
                               : std::min(value->sizeHint().width(), widest));
    QString tip = description_of(parameter);
    if (parameter.type == ConfigParameter::Type::text) {
        tip = QDir::toNativeSeparators(QString::fromStdString(parameter.text(configuration)));
    } else if (changed) {
        static const Configuracion defaults;
        tip +=
            '\n' + SummaryBar::tr("Changed; the default is %1.").arg(value_of(parameter, defaults));
    }
    name->setToolTip(tip);
    value->setToolTip(tip);
    const int row = rows->rowCount();
    rows->addWidget(name, row, 0);
    rows->addWidget(value, row, 1);
}

void fill_card(QFrame& frame, ParameterGroup card, const Configuracion& configuration) {
    auto* rows = new QGridLayout(&frame);
    rows->setContentsMargins(12, 8, 12, 8);
    rows->setHorizontalSpacing(10);
    rows->setVerticalSpacing(1);
    rows->setColumnStretch(1, 1);
    auto* title = new ElidedLabel(title_of(card, configuration));
    title->setMinimumWidth(20);
    set_role(title, "title");
    rows->addWidget(title, 0, 0, 1, 2);
    for (const ConfigParameter* parameter : rows_of(card, configuration)) {
        add_row(rows, *parameter, configuration);
    }
    rows->setRowStretch(rows->rowCount(), 1);
}

/// Where titles end in dots they have to differ in their first letters.
QString short_title(ParameterGroup card, const Configuracion& configuration) {
    if (card == ParameterGroup::motion) return SummaryBar::tr("Motion");
    if (card == ParameterGroup::observation) return SummaryBar::tr("Observation");
    return title_of(card, configuration);
}

/// What differs from the default, and the log. Returns how wide it ought to be.
int fill_chip(QFrame& frame, ParameterGroup card, const Configuracion& configuration) {
    auto* row = new QHBoxLayout(&frame);
    row->setContentsMargins(10, 3, 10, 3);
    row->setSpacing(8);
    auto* title = new ElidedLabel(short_title(card, configuration));
    set_role(title, "title");
    row->addWidget(title, 1);
    QStringList marked;
    QStringList all;
    QString file;
    for (const ConfigParameter* parameter : rows_of(card, configuration)) {
        const QString value = shown_value(*parameter, configuration);
        all << label_of(*parameter) + ": " + value;
        // A word that is one of several says what it is of, a number or "On" does not.
        if (is_marked(*parameter, configuration)) {
            marked << (parameter->choices.size() > 2 ? value : label_of(*parameter) + ' ' + value);
        }
        if (card == ParameterGroup::source && file.isEmpty()) file = value;
    }
    if (!file.isEmpty()) marked.prepend(file);
    auto* values = named(new ElidedLabel(marked.join(", ")), "marked");
    values->setTextFormat(Qt::PlainText);
    values->setHidden(values->text().isEmpty());
    set_role(values, card == ParameterGroup::source ? "value" : "changed");
    row->addWidget(values);
    // Where there is no room for both, the title ends in dots first, as names do in the cards.
    constexpr int kShortTitle = 56;
    constexpr int kMost = 360;
    title->ensurePolished();
    values->ensurePolished();
    const int wanted = std::min(frame.sizeHint().width(), kMost);
    title->setMinimumWidth(std::min(title->sizeHint().width(), kShortTitle));
    title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    frame.setToolTip(all.join('\n'));
    return wanted;
}

}  // namespace

SummaryBar::SummaryBar(QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
}

void SummaryBar::set_configuration(const Configuracion& configuration) {
    configuration_ = configuration;
    rebuild();
}

void SummaryBar::set_folded(bool folded) {
    if (std::exchange(folded_, folded) != folded) rebuild();
}

QFrame* SummaryBar::make_frame(ParameterGroup group, QWidget* parent) {
    auto* frame = new QFrame(parent);
    set_role(frame, "card");
    frame->setProperty("group", static_cast<int>(group));
    frame->setCursor(Qt::PointingHandCursor);
    frame->setFocusPolicy(Qt::TabFocus);  // after a click the space bar runs and stops
    frame->setAccessibleName(title_of(group, configuration_));
    frame->installEventFilter(this);
    return frame;
}

void SummaryBar::rebuild() {
    QVariant focused;  // the group whose card has the keyboard
    while (QLayoutItem* item = layout()->takeAt(0)) {
        // Not at once: a click on it may be what brought us here.
        QWidget* card = item->widget();
        if (card->hasFocus() || window()->focusWidget() == card) focused = card->property("group");
        card->setParent(nullptr);
        card->deleteLater();
        delete item;
    }
    auto* row = qobject_cast<QHBoxLayout*>(layout());
    for (const ParameterGroup card : kCards) {
        QFrame* frame = make_frame(card, this);
        frame->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        int share = 1;
        if (folded_)
            share = fill_chip(*frame, card, configuration_);
        else
            fill_card(*frame, card, configuration_);
        row->addWidget(frame, share);
        if (focused != frame->property("group")) continue;
        frame->show();  // what is hidden cannot take it
        frame->setFocus();
    }
}

void SummaryBar::open_card(QWidget& chip) {
    const auto group = static_cast<ParameterGroup>(chip.property("group").toInt());
    QFrame* card = make_frame(group, this);
    card->setObjectName("opened_card");
    card->setWindowFlags(Qt::Popup);
    card->setAttribute(Qt::WA_DeleteOnClose);
    fill_card(*card, group, configuration_);
    constexpr int kWidth = 280;
    card->resize(std::max(kWidth, chip.width()), card->sizeHint().height());
    card->setAttribute(Qt::WA_NoMouseReplay);  // a click on the chip closes it
    const QRect room = chip.screen()->availableGeometry();
    const QPoint below = chip.mapToGlobal(QPoint(0, chip.height() + 2));
    card->move(std::max(room.left(), std::min(below.x(), room.right() + 1 - card->width())),
               std::max(room.top(), std::min(below.y(), room.bottom() + 1 - card->height())));
    card->show();
    card->setFocus();
}

bool SummaryBar::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && is_choice(*event)) {
        event->accept();  // or the space bar would run and stop
        return true;
    }
    if (event->type() == QEvent::MouseButtonPress) pressed_ = watched;
    if ((event->type() == QEvent::MouseButtonRelease &&
         std::exchange(pressed_, nullptr) == watched) ||
        (event->type() == QEvent::KeyPress && is_choice(*event))) {
        auto& frame = *qobject_cast<QWidget*>(watched);
        if (folded_ && !frame.isWindow()) {
            open_card(frame);
            return true;
        }
        const auto group = static_cast<ParameterGroup>(frame.property("group").toInt());
        if (frame.isWindow()) frame.close();
        emit group_clicked(group);
        return true;
    }
    if (event->type() == QEvent::KeyPress &&
        static_cast<const QKeyEvent&>(*event).key() == Qt::Key_Escape) {
        auto& frame = *qobject_cast<QWidget*>(watched);
        if (frame.isWindow()) return frame.close();
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace hitos::window
