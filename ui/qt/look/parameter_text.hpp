// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters in the user's words and language.
#pragma once

#include <QString>
#include <string_view>

#include "hitos/base/parameter.hpp"
#include "hitos/services/configuration/configuracion.hpp"

namespace hitos::window {

QString to_qt(std::string_view text);
/// A text that HITOS_TEXT marks, in the user's language.
QString translated(const char* context, std::string_view text);
/// Whether it says which source is read, which the form of the source asks on its own.
bool names_source(const ParameterFacts& parameter);
/// "D max"
QString label_of(const ParameterFacts& parameter);
/// In the words of the thesis's form [T 8.2.2.4], which are longer: "Greatest distance to the
/// line (Dmax)".
QString full_label_of(const ParameterFacts& parameter);
/// The sentence of the parameter table, translated.
QString description_of(const ParameterFacts& parameter);
/// All that somebody may look for it by, translated: label, key, symbol, description, choices.
QString search_text_of(const ParameterFacts& parameter);
/// Without capitals and accents, to look for words in.
QString plain(const QString& text);
/// "m²", "rad²/m", or empty.
QString unit_of(const ParameterFacts& parameter);
/// A word of a choice as the user reads it: "Differential with odometry".
QString choice_of(const ParameterFacts& parameter, std::size_t place);
/// The group's title [T 9.2.6.1]; that of the algorithm and of the line method says what is chosen.
QString title_of(ParameterGroup group, const Configuracion& configuration);
/// "EKF-SLAM"
QString algorithm_of(const Configuracion& configuration);
/// Whether the algorithm has particles to speak of.
bool has_particles(const Configuracion& configuration);
/// A value's text as the user reads it, without unit; file names without their folder.
QString value_words(const ParameterFacts& parameter, const std::string& text);
QString value_of(const ConfigParameter& parameter, const Configuracion& configuration);
/// "0.02 m"
QString value_with_unit(const ConfigParameter& parameter, const Configuracion& configuration);
/// What the configuration has otherwise than `base`: "Particles 200, Seed 3"; empty where nothing.
QString difference_words(const Configuracion& configuration, const Configuracion& base);
/// The same of a change, with another log's name and threads, and of many the first few:
/// "aces.log.gz, Particles 200, D max 0.02 m and 11 more".
QString change_words(const Configuracion& configuration, const Configuracion& base);
/// In what two runs that are compared differ, by the values of the right one; of what only the left
/// one makes use of by its own.
QString compared_words(const Configuracion& right, const Configuracion& left);
/// "0 to 10 m", translated.
QString allowed_of(const ParameterFacts& parameter);
bool is_default(const ConfigParameter& parameter, const Configuracion& configuration);

}  // namespace hitos::window
