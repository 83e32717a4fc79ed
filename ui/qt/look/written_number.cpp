// SPDX-License-Identifier: GPL-3.0-or-later
#include "written_number.hpp"

#include <QApplication>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QRegularExpression>
#include <algorithm>
#include <array>
#include <cmath>

#include "field_tip.hpp"
#include "hitos/base/text_input.hpp"
#include "theme.hpp"

namespace hitos::window {
namespace {

bool& comma() {
    static bool on = false;  // one application, one country
    return on;
}

/// Of a spin box that has refused a key: what it shows is not what was typed.
constexpr const char* kRefused = "refused";

QString range_of(const QAbstractSpinBox& box) {
    if (const auto* whole = qobject_cast<const QSpinBox*>(&box))
        return NumberBoxes::tr("Allowed: %1 to %2").arg(whole->minimum()).arg(whole->maximum());
    if (const auto* real = qobject_cast<const QDoubleSpinBox*>(&box)) {
        return NumberBoxes::tr("Allowed: %1 to %2")
            .arg(real->textFromValue(real->minimum()), real->textFromValue(real->maximum()));
    }
    return {};
}

/// What a parameter's text is made of.
enum class Made { words, numbers, list, pose };

struct MadeOf {
    std::string_view key;
    Made made;
};

Made made_of(const ParameterFacts& parameter) {
    using Type = ParameterFacts::Type;
    if (parameter.type == Type::real) return Made::numbers;
    if (parameter.type != Type::text) return Made::words;
    static constexpr std::array kTexts{
        MadeOf{"source.laser_pose", Made::pose},    MadeOf{"source.start", Made::pose},
        MadeOf{"source.odometry_axes", Made::list}, MadeOf{"source.scan_clock", Made::list},
        MadeOf{"source.world_set", Made::numbers},  MadeOf{"registration.edits", Made::numbers}};
    const auto known = std::ranges::find(kTexts, parameter.key, &MadeOf::key);
    return known == kTexts.end() ? Made::words : known->made;
}

const QRegularExpression& comma_between_digits() {
    static const QRegularExpression comma(R"((?<=\d),(?=\d))");
    return comma;
}

void tell_range(QAbstractSpinBox& box) {
    show_field_tip(box, range_of(box));
}

}  // namespace

/// Before it is shown: what was typed and is out of range is told, and not taken for what is left
/// of it.
void NumberBoxes::look_after(QAbstractSpinBox& box) {
    const auto refuse = [&box](bool refused) {
        const bool told = box.property("state").toString() == "wrong";
        box.setProperty(kRefused, refused);
        set_look(box, "state", refused ? "wrong" : "good");
        if (refused) {
            tell_range(box);
        } else if (told) {
            hide_field_tip();
        }
    };
    auto* line = box.findChild<QLineEdit*>();
    if (line == nullptr) return;
    const auto accept = [refuse] { refuse(false); };
    // Another value comes before the word of a key that was refused.
    if (auto* whole = qobject_cast<QSpinBox*>(&box))
        connect(whole, &QSpinBox::valueChanged, &box, accept);
    if (auto* real = qobject_cast<QDoubleSpinBox*>(&box))
        connect(real, &QDoubleSpinBox::valueChanged, &box, accept);
    connect(line, &QLineEdit::inputRejected, &box, [refuse] { refuse(true); });
    connect(line, &QLineEdit::textEdited, &box,
            [&box, refuse] { refuse(!box.hasAcceptableInput()); });
}

bool NumberBoxes::eventFilter(QObject* watched, QEvent* event) {
    const bool polish = event->type() == QEvent::Polish;
    if (!polish && event->type() != QEvent::KeyPress) return false;
    auto* box = qobject_cast<QAbstractSpinBox*>(watched);
    if (box == nullptr) return false;
    if (polish) {
        look_after(*box);
        return false;
    }
    const auto& key = static_cast<const QKeyEvent&>(*event);
    if (key.text() == "," && decimal_comma() && qobject_cast<QDoubleSpinBox*>(box) != nullptr) {
        QKeyEvent point(QEvent::KeyPress, Qt::Key_Period, key.modifiers(), ".");
        QApplication::sendEvent(box, &point);
        return true;
    }
    const bool ends = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    if (!ends || !box->property(kRefused).toBool()) return false;
    tell_range(*box);
    box->setProperty(kRefused, false);  // told; who means what is left says so once more
    box->selectAll();
    return true;
}

bool decimal_comma() {
    return comma();
}

void set_decimal_comma(bool on) {
    comma() = on;
}

QString with_point(const QString& number) {
    if (!decimal_comma() || number.contains('.')) return number;
    return QString(number).replace(',', '.');
}

std::optional<double> number_of(const QString& written) {
    const auto number = input::parse_number(with_point(written).trimmed().toStdString());
    return number && std::isfinite(*number) ? number : std::nullopt;
}

bool has_decimal_comma(const QString& list) {
    return decimal_comma() && list.contains(comma_between_digits());
}

QString list_with_points(const QString& list, bool fractions) {
    static const QRegularExpression around_parts(R"(\s*([:/])\s*)");
    static const QRegularExpression separators(R"(\s*[;,]\s*|\s+)");
    QString text = list.trimmed();
    const bool points = text.contains('.') && !text.contains(';');
    if (decimal_comma() && fractions && !points) text.replace(comma_between_digits(), ".");
    return text.replace(around_parts, "\\1").replace(separators, ",");
}

QString pose_with_points(const QString& pose) {
    static const QRegularExpression as_it_stands(
        R"(^\s*([-+]?[0-9.]+),([-+]?[0-9.]+),([-+]?[0-9.]+)(,[^0-9]*)?$)");
    return as_it_stands.match(pose).hasMatch() ? pose : list_with_points(pose, true);
}

QString list_as_written(const QString& list) {
    return decimal_comma() ? QString(list).replace(',', "; ") : list;
}

QString as_read(const ParameterFacts& parameter, const QString& written) {
    switch (made_of(parameter)) {
        case Made::numbers:
            // Blanks part several of them: a comma is nothing else.
            return parameter.type == ParameterFacts::Type::real ? with_point(written)
                   : decimal_comma() ? QString(written).replace(comma_between_digits(), ".")
                                     : written;
        case Made::list:
            return list_with_points(written, true);
        case Made::pose:
            return pose_with_points(written);
        case Made::words:
            break;
    }
    return written;
}

QString as_written(const ParameterFacts& parameter, const QString& read) {
    const Made made = made_of(parameter);
    return made == Made::list || made == Made::pose ? list_as_written(read) : read;
}

}  // namespace hitos::window
