// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameter_field.hpp"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <cstdlib>

#include "hitos/base/error.hpp"
#include "look/named.hpp"
#include "look/parameter_text.hpp"
#include "look/theme.hpp"
#include "look/written_number.hpp"

namespace hitos::window {
namespace {

QString tip_of(const ParameterFacts& facts, const std::string& normal) {
    QString tip =
        "<p style='white-space:pre-wrap'>" + description_of(facts).toHtmlEscaped() + "</p><p>";
    if (facts.type == ParameterFacts::Type::real || facts.type == ParameterFacts::Type::integer) {
        tip += ParameterField::tr("Allowed: %1").arg(allowed_of(facts)) + "<br/>";
    }
    if (facts.type != ParameterFacts::Type::text) {
        tip += ParameterField::tr("Default: %1").arg(value_words(facts, normal)) + "<br/>";
    }
    tip += "<code>" + to_qt(facts.key) + "</code>";
    if (!facts.symbol.empty()) tip += " · " + to_qt(facts.symbol);
    return tip + "</p>";
}

}  // namespace

QString in_lines(QString label) {
    constexpr qsizetype kLong = 25;
    if (label.size() <= kLong) return label;
    qsizetype best = -1;
    for (qsizetype at = label.indexOf(' '); at >= 0; at = label.indexOf(' ', at + 1)) {
        if (best < 0 || std::abs(2 * at - label.size()) < std::abs(2 * best - label.size()))
            best = at;
    }
    if (best >= 0) label[best] = '\n';
    return label;
}

ParameterField::ParameterField(const ParameterFacts& facts, const std::string& normal,
                               QGridLayout* rows, QWidget* parent)
    : QObject(parent), facts_(facts), normal_(QString::fromStdString(normal)) {
    const QString key = to_qt(facts.key);
    const int row = rows->rowCount();
    label_ = new QLabel(in_lines(full_label_of(facts)), parent);
    if (facts.type == ParameterFacts::Type::choice) {
        choice_ = new QComboBox(parent);
        choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        choice_->setFocusPolicy(Qt::StrongFocus);
        for (std::size_t i = 0; i < facts.choices.size(); ++i)
            choice_->addItem(choice_of(facts, i));
        connect(choice_, &QComboBox::currentIndexChanged, this, &ParameterField::mark_changed);
        connect(choice_, &QComboBox::currentIndexChanged, this, &ParameterField::edited);
    } else {
        line_ = new QLineEdit(parent);
        connect(line_, &QLineEdit::textChanged, this, &ParameterField::mark_changed);
        connect(line_, &QLineEdit::textEdited, this, &ParameterField::edited);
    }
    editor()->setObjectName("field_" + key);
    label_->setBuddy(editor());
    if (choice_ == nullptr) {
        unit_ = new QLabel(unit_of(facts), parent);
        unit_->setProperty("role", "muted");
    }
    error_ = named(new QLabel(parent), "error_" + key);
    error_->setProperty("role", "error");
    error_->setWordWrap(true);
    error_->hide();
    for (QWidget* widget : {static_cast<QWidget*>(label_), editor()})
        widget->setToolTip(tip_of(facts, normal));
    rows->addWidget(label_, row, 0);
    rows->addWidget(editor(), row, 1, 1, unit_ == nullptr ? 2 : 1);  // words need the room
    if (unit_ != nullptr) rows->addWidget(unit_, row, 2);
    rows->addWidget(error_, row + 1, 0, 1, 3);
}

QWidget* ParameterField::editor() const {
    return choice_ != nullptr ? static_cast<QWidget*>(choice_) : line_;
}

QString ParameterField::text() const {
    if (choice_ == nullptr) return line_->text();
    return QString::fromStdString(
        facts_.choices.at(static_cast<std::size_t>(choice_->currentIndex())).word);
}

void ParameterField::set_text(const std::string& value) {
    if (choice_ != nullptr) {
        choice_->setCurrentIndex(static_cast<int>(facts_.place_of(value).value_or(0)));
    } else {
        line_->setText(as_written(facts_, QString::fromStdString(value)));
    }
    good_ = text();
    set_error({});
    mark_changed();
}

std::optional<ParameterFacts::Value> ParameterField::take() {
    try {
        ParameterFacts::Value value = facts_.value_from(as_read(facts_, text()).toStdString());
        good_ = text();
        set_error({});
        return value;
    } catch (const Error&) {
        // The library's words name the key; here the field itself says what is meant.
        set_error(facts_.type == ParameterFacts::Type::integer
                      ? tr("Whole numbers: %1").arg(allowed_of(facts_))
                      : tr("Allowed: %1").arg(allowed_of(facts_)));
        return std::nullopt;
    }
}

std::optional<ParameterFacts::Value> ParameterField::last_good() const {
    try {
        return facts_.value_from(as_read(facts_, good_).toStdString());
    } catch (const Error&) {
        return std::nullopt;  // so impossible was what the form was opened with
    }
}

void ParameterField::set_error(const QString& error) {
    error_->setText(error);
    error_->setVisible(!error.isEmpty() && is_shown());
    set_look(*editor(), "state", error.isEmpty() ? "good" : "wrong");
}

/// What stands in its row.
QList<QWidget*> ParameterField::parts() const {
    QList<QWidget*> all{label_, editor()};
    if (unit_ != nullptr) all << unit_;
    return all;
}

bool ParameterField::has_error() const {
    return !error_->text().isEmpty();
}

void ParameterField::set_used(bool used) {
    for (QWidget* widget : parts()) widget->setEnabled(used);
    if (used || !has_error()) return;
    if (line_ != nullptr) line_->setText(good_);  // nobody can mend it where it is grey
    set_error({});
}

bool ParameterField::is_used() const {
    return label_->isEnabled();
}

void ParameterField::set_shown(bool shown) {
    for (QWidget* widget : parts()) widget->setVisible(shown);
    error_->setVisible(shown && has_error());
}

bool ParameterField::is_shown() const {
    return !editor()->isHidden();
}

bool ParameterField::has_focus() const {
    return editor()->hasFocus();
}

void ParameterField::focus() {
    editor()->setFocus();
    if (line_ != nullptr) line_->selectAll();
}

bool ParameterField::differs() const {
    return as_read(facts_, text()) != normal_;
}

void ParameterField::mark_changed() {
    set_look(*label_, "role", differs() ? "changed" : "value");
}

}  // namespace hitos::window
