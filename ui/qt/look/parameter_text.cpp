// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameter_text.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStringList>
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "edit_words.hpp"
#include "hitos/base/error.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/results/kept_run.hpp"
#include "words_of.hpp"

namespace hitos::window {
namespace {

QString shown_unit(std::string_view unit) {
    constexpr std::string_view kOr = " or ";
    if (const std::size_t either = unit.find(kOr); either != std::string_view::npos) {
        return QCoreApplication::translate("Parameter", "%1 or %2")
            .arg(shown_unit(unit.substr(0, either)), shown_unit(unit.substr(either + kOr.size())));
    }
    if (unit == "degrees") return QString::fromUtf8("°");
    // What is counted is a word of English, and the label has it: "particles", "scans", "log-odds".
    const bool word =
        std::ranges::all_of(unit, [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; });
    if (word && unit.size() > std::string_view("rad").size()) return {};
    return to_qt(unit).replace("^2", "²");
}

/// A list may be as long as somebody likes, and a line is not.
QString shortened(const QString& words) {
    constexpr qsizetype kMost = 60;
    return words.size() <= kMost ? words : words.left(kMost - 1) + QString::fromUtf8("…");
}

/// As the list of changes by hand has them; as they are where they are none.
QString edits_in_words(const std::string& text) {
    QStringList words;
    try {
        for (const GraphEdit& edit : parse_graph_edits(text)) words << change_in_words(edit);
    } catch (const Error&) {
        return to_qt(text);
    }
    return words.join(QStringLiteral("; "));
}

/// "Particles 100"
QString setting_words(const ConfigParameter& parameter, const Configuracion& configuration) {
    const QString value = value_with_unit(parameter, configuration);
    return label_of(parameter) + ' ' +
           (value.isEmpty()
                ? translated("ParameterChoice", QT_TRANSLATE_NOOP("ParameterChoice", "none"))
                : shortened(value));
}

QStringList differing(const Configuracion& configuration, const Configuracion& base) {
    QStringList words;
    for (const ConfigParameter* parameter : differences(configuration, base)) {
        if (!parameter->used_by(configuration)) continue;  // it says nothing of this one
        words << setting_words(*parameter, configuration);
    }
    return words;
}

}  // namespace

QString translated(const char* context, std::string_view text) {
    return QCoreApplication::translate(context, std::string(text).c_str());
}

QString to_qt(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

bool names_source(const ParameterFacts& parameter) {
    constexpr std::array<std::string_view, 4> kNames{"source.file", "source.format",
                                                     "source.scan_topic", "source.odom_topic"};
    return std::ranges::find(kNames, parameter.key) != kNames.end();
}

QString label_of(const ParameterFacts& parameter) {
    return translated("ParameterLabel", parameter.label);
}

QString full_label_of(const ParameterFacts& parameter) {
    struct Named {
        std::string_view key;
        const char* words;
    };
    static constexpr std::array kNamed{
        Named{"filter.particles", QT_TRANSLATE_NOOP("FullLabel", "Number of particles")},
        Named{"features.detect", QT_TRANSLATE_NOOP("FullLabel", "Kind of features")},
        Named{"association.p0", QT_TRANSLATE_NOOP("FullLabel", "Probability of a new observation")},
        Named{"split_merge.min_points",
              QT_TRANSLATE_NOOP("FullLabel", "Least number of points in a line")},
        Named{"split_merge.dmax", QT_TRANSLATE_NOOP("FullLabel", "Greatest distance to the line")},
        Named{"split_merge.min_length", QT_TRANSLATE_NOOP("FullLabel", "Least length of a line")},
        Named{"motion.model", QT_TRANSLATE_NOOP("FullLabel", "Model of the robot")},
        Named{"resampling.rule", QT_TRANSLATE_NOOP("FullLabel", "Kind of resampler")},
        Named{"resampling.neff_threshold",
              QT_TRANSLATE_NOOP("FullLabel", "Number of effective particles")}};
    const auto named = std::ranges::find(kNamed, parameter.key, &Named::key);
    if (named == kNamed.end()) return label_of(parameter);
    const QString words = translated("FullLabel", named->words);
    return parameter.symbol.empty() ? words : words + " (" + to_qt(parameter.symbol) + ')';
}

QString description_of(const ParameterFacts& parameter) {
    return translated("Parameter", parameter.description);
}

QString search_text_of(const ParameterFacts& parameter) {
    QStringList words{label_of(parameter), full_label_of(parameter), to_qt(parameter.key),
                      to_qt(parameter.symbol), description_of(parameter)};
    for (std::size_t i = 0; i < parameter.choices.size(); ++i) words << choice_of(parameter, i);
    return words.join(' ');
}

QString plain(const QString& text) {
    QString out = text.normalized(QString::NormalizationForm_D).toCaseFolded();
    out.removeIf([](QChar c) { return c.isMark(); });
    return out;
}

QString unit_of(const ParameterFacts& parameter) {
    return shown_unit(parameter.unit);
}

QString choice_of(const ParameterFacts& parameter, std::size_t place) {
    return translated("ParameterChoice", parameter.choices.at(place).label);
}

QString value_words(const ParameterFacts& parameter, const std::string& text) {
    if (parameter.key == "source.file" || parameter.key == "source.map") {
        return QFileInfo(QString::fromStdString(text)).fileName();
    }
    if (parameter.key == kGraphEditsKey) return edits_in_words(text);
    const std::optional<std::size_t> place = parameter.place_of(text);
    return place ? choice_of(parameter, *place) : QString::fromStdString(text);
}

QString value_of(const ConfigParameter& parameter, const Configuracion& configuration) {
    return value_words(parameter, parameter.text(configuration));
}

QString title_of(ParameterGroup group, const Configuracion& configuration) {
    if (group == ParameterGroup::particle_filter && has_particles(configuration))
        return translated("ParameterGroup", QT_TRANSLATE_NOOP("ParameterGroup", "Particle filter"));
    const auto facts = std::ranges::find(parameter_groups(), group, &ParameterGroupFacts::group);
    if (facts->title_key.empty()) return translated("ParameterGroup", facts->title);
    const ConfigParameter& chosen = find_parameter(facts->title_key);
    QString words = value_of(chosen, configuration);
    if (group != ParameterGroup::split_merge || chosen.text(configuration) != "split-merge")
        return words;
    return QCoreApplication::translate("ParameterGroup", "%1 algorithm").arg(words);
}

QString algorithm_of(const Configuracion& configuration) {
    return value_of(find_parameter("filter.algorithm"), configuration);
}

bool has_particles(const Configuracion& configuration) {
    return find_parameter("filter.particles").used_by(configuration);
}

QString value_with_unit(const ConfigParameter& parameter, const Configuracion& configuration) {
    const QString unit = shown_unit(parameter.unit_of(configuration));
    const QString value = value_of(parameter, configuration);
    return unit.isEmpty() || value.isEmpty() ? value : value + ' ' + unit;
}

QString difference_words(const Configuracion& configuration, const Configuracion& base) {
    return differing(configuration, base).join(", ");
}

QString compared_words(const Configuracion& right, const Configuracion& left) {
    QStringList words;
    for (const ConfigParameter* parameter : differences(left, right)) {
        const bool of_right = parameter->used_by(right);
        const QString said = setting_words(*parameter, of_right ? right : left);
        words << (of_right ? said
                           : QCoreApplication::translate("Parameter", "%1 (the left one alone)")
                                 .arg(said));
    }
    return words.join(", ");
}

QString change_words(const Configuracion& configuration, const Configuracion& base) {
    constexpr qsizetype kMost = 3;
    QStringList words = differing(configuration, base);
    if (configuration.run.threads != base.run.threads) {  // which changes no result
        const ConfigParameter& threads = find_parameter("run.threads");
        words << label_of(threads) + ' ' + value_of(threads, configuration);
    }
    if (!same_log(configuration, base)) {
        const QFileInfo now(QString::fromStdString(configuration.source.file));
        const QFileInfo other(QString::fromStdString(base.source.file));
        words.prepend(now.fileName() == other.fileName()
                          ? now.dir().dirName() + '/' + now.fileName()
                          : now.fileName());
    }
    if (words.empty()) {
        return QCoreApplication::translate("Parameter", "nothing that this run makes use of");
    }
    const qsizetype more = words.size() - kMost;
    if (more < 2) return words.join(", ");
    return QCoreApplication::translate("Parameter", "%1 and %2 more")
        .arg(words.mid(0, kMost).join(", "))
        .arg(more);
}

QString allowed_of(const ParameterFacts& parameter) {
    using Type = ParameterFacts::Type;
    if (parameter.type == Type::choice || parameter.type == Type::text)
        return words_of(parameter.allowed_message());
    const QString unit = unit_of(parameter);
    const auto limit = [&parameter](double value) {
        return parameter.type == ParameterFacts::Type::integer ? QString::number(value, 'f', 0)
                                                               : QString::number(value);
    };
    return QCoreApplication::translate("Parameter", "%1 to %2 %3")
        .arg(limit(parameter.minimum), limit(parameter.maximum))
        .arg(unit)
        .trimmed();
}

bool is_default(const ConfigParameter& parameter, const Configuracion& configuration) {
    static const Configuracion defaults;
    return parameter.text(configuration) == parameter.text(defaults);
}

}  // namespace hitos::window
