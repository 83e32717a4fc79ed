// SPDX-License-Identifier: GPL-3.0-or-later
#include "words_of.hpp"

#include <QCoreApplication>
#include <QStringList>

#include "hitos/base/error.hpp"
#include "hitos/base/geometry.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/evaluation/suitability.hpp"
#include "parameter_text.hpp"

namespace hitos::window {

QString words_of(const Message& message) {
    return QString::fromStdString(message.translated([](const char* text) {
        return QCoreApplication::translate("Errors", text).toStdString();
    }));
}

QString words_of(const std::exception& error) {
    return words_of(message_of(error));
}

QString words_of(const Advice& advice) {
    return translated("Advice", advice.text).arg(QString::fromStdString(advice.figure));
}

QString words_of(const std::vector<SourceSetting>& settings) {
    QStringList words;
    for (const auto& [key, value] : settings) {
        const ConfigParameter& parameter = find_parameter(key);
        words << QCoreApplication::translate("Finding", "“%1” %2")
                     .arg(label_of(parameter), value_words(parameter, value));
    }
    return words.join(", ");
}

QString words_of(const TourFinding& finding) {
    QStringList words{words_of(finding.what)};
    for (const Remedy& remedy : finding.remedies) {
        words << words_of(remedy.words);
        if (!remedy.settings.empty()) words.back() += ": " + words_of(remedy.settings);
    }
    return words.join("; ");
}

QString set_apart(const QString& note) {
    return QString::fromUtf8("• ") + note.left(1).toUpper() + note.mid(1);
}

QString counted_words(quint64 count, const QString& one, const QString& several) {
    return count == 1 ? one : several.arg(count);
}

QString metre_words(double metres) {
    return QString("%1 m").arg(metres, 0, 'f', 3);
}

QString degree_words(double radians) {
    return QString("%1°").arg(radians * kDegreesPerRadian, 0, 'f', 2);
}

}  // namespace hitos::window
