#include "written_number.hpp"

#include <QApplication>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QRegularExpression>

namespace hitos::window {
namespace {

bool& comma() {
    static bool on = false;  // one application, one country
    return on;
}

class CommaIsPoint final : public QObject {
  public:
    using QObject::QObject;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::KeyPress || !decimal_comma()) return false;
        const auto& key = static_cast<const QKeyEvent&>(*event);
        if (key.text() != "," || qobject_cast<QDoubleSpinBox*>(watched) == nullptr) return false;
        QKeyEvent point(QEvent::KeyPress, Qt::Key_Period, key.modifiers(), ".");
        QApplication::sendEvent(watched, &point);
        return true;
    }
};

}  // namespace

bool decimal_comma() {
    return comma();
}

void set_decimal_comma(QApplication& application, bool on) {
    comma() = on;
    constexpr const char* kName = "comma_is_point";
    if (!on || application.findChild<QObject*>(kName) != nullptr) return;
    auto* filter = new CommaIsPoint(&application);
    filter->setObjectName(kName);
    application.installEventFilter(filter);
}

QString with_point(const QString& number) {
    if (!decimal_comma() || number.contains('.')) return number;
    return QString(number).replace(',', '.');
}

QString list_with_points(const QString& list, bool fractions) {
    static const QRegularExpression between_digits(R"((?<=\d),(?=\d))");
    static const QRegularExpression around_parts(R"(\s*([:/])\s*)");
    static const QRegularExpression separators(R"(\s*[;,]\s*|\s+)");
    QString text = list.trimmed();
    const bool points = text.contains('.') && !text.contains(';');
    if (decimal_comma() && fractions && !points) text.replace(between_digits, ".");
    return text.replace(around_parts, "\\1").replace(separators, ",");
}

}  // namespace hitos::window
