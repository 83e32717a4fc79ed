// SPDX-License-Identifier: GPL-3.0-or-later
#include "numbers_strip.hpp"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <algorithm>
#include <cmath>

#include "look/parameter_text.hpp"
#include "look/theme.hpp"
#include "look/written_number.hpp"

namespace hitos::window {
namespace {

/// To a tenth of a millimetre, without zeros behind.
QString number_words(double value) {
    constexpr double kDigits = 1e4;
    return QString::number(std::round(value * kDigits) / kDigits + 0.0, 'g', 10);
}

}  // namespace

NumbersStrip::NumbersStrip(QWidget* parent) : QWidget(parent) {
    constexpr int kFieldWidth = 76;
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    for (std::size_t i = 0; i < kMost; ++i) {
        names_[i] = new QLabel(this);
        fields_[i] = new QLineEdit(this);
        fields_[i]->setObjectName(QStringLiteral("drawn_number_%1").arg(i));
        fields_[i]->setMaximumWidth(kFieldWidth);
        fields_[i]->installEventFilter(this);
        units_[i] = new QLabel(this);
        units_[i]->setProperty("role", "muted");
        row->addWidget(names_[i]);
        row->addWidget(fields_[i]);
        row->addWidget(units_[i]);
        connect(fields_[i], &QLineEdit::textEdited, this, [this, i] {
            const QString text = fields_[i]->text();
            set_look(*fields_[i], "state", text.isEmpty() || number_of(text) ? "good" : "wrong");
            if (asks_) emit edited();
        });
        connect(fields_[i], &QLineEdit::editingFinished, this, [this, i] {
            if (!asks_) take(i);
        });
    }
    row->addStretch(1);
    lay_out({}, false);
}

void NumbersStrip::lay_out(const std::vector<ItemNumber>& numbers, bool asks) {
    asks_ = asks;
    shown_ = numbers;
    for (std::size_t i = 0; i < kMost; ++i) {
        const bool there = i < numbers.size();
        for (QWidget* widget : {static_cast<QWidget*>(names_[i]), static_cast<QWidget*>(fields_[i]),
                                static_cast<QWidget*>(units_[i])}) {
            widget->setVisible(there);
        }
        if (!there) continue;
        const QString name = translated("WorldItem", numbers[i].name);
        names_[i]->setText(name);
        units_[i]->setText(to_qt(numbers[i].unit));
        fields_[i]->setAccessibleName(name);
        fields_[i]->setText(asks ? QString() : number_words(numbers[i].value));
        set_look(*fields_[i], "state", "good");
    }
}

void NumbersStrip::show_numbers(const std::vector<ItemNumber>& numbers) {
    lay_out(numbers, false);
}

void NumbersStrip::ask_for(const std::vector<ItemNumber>& numbers) {
    lay_out(numbers, true);
}

std::optional<double> NumbersStrip::typed(std::size_t place) const {
    return place < shown_.size() ? number_of(fields_[place]->text()) : std::nullopt;
}

void NumbersStrip::begin(const QString& text) {
    if (shown_.empty()) return;
    fields_[0]->setFocus();
    fields_[0]->setText(text);
    if (asks_) emit edited();
}

/// Where what was typed is no number, the one before stands there again.
void NumbersStrip::take(std::size_t place) {
    if (place >= shown_.size()) return;
    const auto value = typed(place);
    const QString before = number_words(shown_[place].value);
    if (!value || fields_[place]->text() == before) {
        fields_[place]->setText(before);
        set_look(*fields_[place], "state", "good");
        return;
    }
    fields_[place]->setText(before);  // until it is so: a question may take the keyboard away
    emit entered(place, *value);
}

/// Return and Escape in a field are not the dialog's.
bool NumbersStrip::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    // NOLINTNEXTLINE(*-static-cast-downcast): by its type
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Escape) {
        lay_out(std::vector<ItemNumber>(shown_), asks_);
        emit left();
        return true;
    }
    if (key != Qt::Key_Return && key != Qt::Key_Enter) return QWidget::eventFilter(watched, event);
    if (asks_) {
        const bool good = std::ranges::all_of(fields_, [](const QLineEdit* field) {
            return field->text().isEmpty() || number_of(field->text());
        });
        if (good) emit finished();  // else the red one waits
        return true;
    }
    for (std::size_t i = 0; i < kMost; ++i) {
        if (watched == fields_[i]) take(i);
    }
    emit left();
    return true;
}

}  // namespace hitos::window
