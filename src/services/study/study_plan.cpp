// SPDX-License-Identifier: GPL-3.0-or-later
// The runs of a study: their order, names and digests, and whether the study makes sense.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "hitos/base/error.hpp"
#include "hitos/services/configuration/archivo_configuracion.hpp"
#include "hitos/services/configuration/config_parameter.hpp"
#include "hitos/services/results/results.hpp"
#include "hitos/services/study/study.hpp"
#include "json_input.hpp"
#include "study_files.hpp"
#include "study_inputs.hpp"

namespace hitos {
namespace {

namespace fs = std::filesystem;

/// In the enum's order.
constexpr std::array<std::string_view, 3> kPictureWords{"none", "first", "all"};

/// Whether the parameter can take the value; where not, its runs will fail and say why.
bool set_if_possible(const ConfigParameter& parameter, Configuracion& configuration,
                     const std::string& value) {
    try {
        parameter.set(configuration, value);
        return true;
    } catch (const ConfigError&) {
        return false;
    }
}

/// The value as the configuration writes it, so that 0.020 and 2e-2 are one value; as it stands
/// where a key cannot take it.
StudyValue canonical(const std::vector<std::string>& keys, StudyValue value) {
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const ConfigParameter& parameter = find_parameter(keys[i]);
        Configuracion scratch;
        if (set_if_possible(parameter, scratch, value[i])) value[i] = parameter.text(scratch);
    }
    return value;
}

StudyPlan::Axis axis_of(const StudyParameter& parameter, const Configuracion& configuration) {
    if (parameter.values.empty()) {
        throw ConfigError(parameter.name, HITOS_TEXT("Errors", "found no value to study"));
    }
    StudyPlan::Axis axis{parameter.name, parameter.keys, {}, {}};
    for (const std::string& key : parameter.keys) {
        const ConfigParameter& varied = find_parameter(key);
        if (varied.table() == "grid") {
            throw ConfigError(key, HITOS_TEXT("Errors",
                                              "has no effect on a landmark map; a study draws "
                                              "grids only to measure and show its runs"));
        }
        if (!can_be_varied(varied)) {
            throw ConfigError(parameter.name,
                              HITOS_TEXT("Errors",
                                         "%1 is set by the study itself; say the number of runs "
                                         "and the first seed instead"),
                              key);
        }
        axis.units.emplace_back(varied.unit_of(configuration));
    }
    for (const StudyValue& value : parameter.values) {
        if (value.size() != parameter.keys.size()) {
            throw ConfigError(parameter.name,
                              HITOS_TEXT("Errors", "a value has %1 components, expected %2"),
                              value.size(), parameter.keys.size());
        }
        StudyValue texts = canonical(parameter.keys, value);
        if (!std::ranges::all_of(texts, is_utf8)) {
            throw ConfigError(
                parameter.name,
                HITOS_TEXT("Errors", "the value %1 is no UTF-8 text; rename the file"),
                in_utf8(fmt::format("{}", fmt::join(texts, ", "))));
        }
        if (std::find(axis.values.begin(), axis.values.end(), texts) != axis.values.end()) {
            throw ConfigError(parameter.name, HITOS_TEXT("Errors", "the value %1 is given twice"),
                              fmt::format("{}", fmt::join(texts, ", ")));
        }
        axis.values.push_back(std::move(texts));
    }
    return axis;
}

/// The configuration of a cell; a value that its key cannot take is left out.
Configuracion configuration_of(const Configuracion& base, const std::vector<std::string>& keys,
                               const std::vector<std::string>& texts) {
    Configuracion configuration = base;
    for (std::size_t i = 0; i < keys.size(); ++i)
        set_if_possible(find_parameter(keys[i]), configuration, texts[i]);
    return configuration;
}

/// "odometry or no-odometry", as a condition has it, for readers of any language.
Message needed_words(std::string_view needed) {
    constexpr std::string_view kOr = " or ";
    constexpr std::string_view kComma = ", ";
    std::vector<std::string_view> words;
    while (true) {
        const std::size_t comma = needed.find(kComma);
        const bool last = comma == std::string_view::npos;
        const std::size_t end = last ? needed.find(kOr) : comma;
        words.push_back(needed.substr(0, end));
        if (end == std::string_view::npos) return either(words);
        needed.remove_prefix(end + (last ? kOr : kComma).size());
    }
}

/// A key without effect in all cells would make a study of equal runs.
void check_effect(const Configuracion& base, const StudyPlan& plan) {
    const std::vector<std::string> keys = plan.keys();
    std::vector<const ConfigParameter*> idle;
    idle.reserve(keys.size());
    for (const std::string& key : keys) idle.push_back(&find_parameter(key));
    for (std::size_t cell = 0; cell < plan.cells() && !idle.empty(); ++cell) {
        const Configuracion configuration = configuration_of(base, keys, plan.texts(cell));
        std::erase_if(idle, [&](const auto* key) { return key->used_by(configuration); });
    }
    if (idle.empty()) return;
    const Configuracion first = configuration_of(base, keys, plan.texts(0));
    const ConfigParameter::Condition& unmet = *idle.front()->unmet(first);
    throw ConfigError(std::string(idle.front()->key),
                      HITOS_TEXT("Errors", "has no effect where %1 is %2; set it to %3"), unmet.key,
                      find_parameter(unmet.key).text(first), needed_words(unmet.needed));
}

/// All that decides a result, but for values and seeds: program, parameters, log, reference.
std::string digest_of(const Study& study, const StudyPlan& plan, const std::string& program) {
    Configuracion base = study.configuration;
    base.source.file.clear();  // the content counts, not the place
    base.source.map.clear();
    base.run = {};
    Digest digest;
    digest.add(version()).add(program).add(ArchivoConfiguracion::to_text(base)).add(study.setting);
    digest.add(map_to_text(study.reference));
    if (study.reference_trajectory) digest.add(trajectory_to_text(*study.reference_trajectory));
    if (!study.relations.empty()) digest.add(relations_text(study.relations));
    if (plan.grid) digest.add("grid");
    for (const std::vector<fs::path>& log : study::input_files(study)) {
        for (const fs::path& file : log) {
            std::error_code error;
            const fs::file_type type = fs::status(file, error).type();
            // What cannot even be asked about is read or refused, never taken for nothing; but what
            // is no name is no file.
            const bool unknown =
                type == fs::file_type::none && error != std::errc::filename_too_long;
            const bool known = type == fs::file_type::regular || unknown;
            if (known) digest.add_file(file);
            digest.add("end of file");
        }
        digest.add("end of log");
    }
    return digest.text();
}

void count_reference(const LandmarkMap& reference, StudyPlan& plan) {
    for (const ICaracteristica& landmark : reference) {
        ++(landmark.kind() == FeatureKind::line ? plan.reference_lines : plan.reference_corners);
    }
}

}  // namespace

bool can_be_varied(const ConfigParameter& parameter) {
    return parameter.table() != "run" && parameter.table() != "grid";
}

std::string_view word_of(StudyPictures pictures) {
    return kPictureWords.at(static_cast<std::size_t>(pictures));
}

StudyPictures parse_study_pictures(std::string_view word, const std::string& option) {
    for (std::size_t i = 0; i < kPictureWords.size(); ++i) {
        if (kPictureWords.at(i) == word) return static_cast<StudyPictures>(i);
    }
    throw ConfigError(option, HITOS_TEXT("Errors", "found \"%1\", expected one of %2"), word,
                      fmt::format("{}", fmt::join(kPictureWords, ", ")));
}

StudyPlan plan_study(const Study& study) {
    return plan_study(study, build_identity());
}

StudyPlan plan_study(const Study& study, const std::string& program) {
    check(study.configuration);
    constexpr std::size_t kMostParameters = 2;
    if (study.parameters.size() > kMostParameters) {
        throw ConfigError(
            study.parameters.back().name,
            HITOS_TEXT("Errors", "found %1 parameters; a study varies two at the most"),
            study.parameters.size());
    }
    if (study.seeds < 1 || static_cast<std::size_t>(study.seeds) > StudyPlan::kMostRuns) {
        throw ConfigError("runs", HITOS_TEXT("Errors", "found %1 for each value, expected 1 to %2"),
                          study.seeds, StudyPlan::kMostRuns);
    }
    constexpr auto kLastSeed = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    if (study.first_seed > kLastSeed - static_cast<std::uint64_t>(study.seeds)) {
        throw ConfigError("seed", HITOS_TEXT("Errors", "%1 and %2 more go beyond %3"),
                          study.first_seed, study.seeds - 1, kLastSeed);
    }
    StudyPlan plan;
    plan.first_seed = study.first_seed;
    plan.seeds = study.seeds;
    plan.setting = study.setting;
    plan.source = fs::path(study.configuration.source.file).filename().string();
    std::set<std::string> keys;
    for (const StudyParameter& parameter : study.parameters) {
        plan.axes.push_back(axis_of(parameter, study.configuration));
        for (const std::string& key : parameter.keys) {
            if (!keys.insert(key).second) {
                throw ConfigError(
                    key, HITOS_TEXT("Errors", "is varied by both parameters of the study"));
            }
        }
    }
    if (!plan.is_possible()) {
        throw ConfigError(
            "runs",
            HITOS_TEXT(
                "Errors",
                "%1 values and %2 runs of each are more than %3 runs; choose fewer values or runs"),
            plan.cells(), plan.seeds, StudyPlan::kMostRuns);
    }
    check_effect(study.configuration, plan);
    count_reference(study.reference, plan);
    plan.pictures = study.pictures;
    plan.grid = study.reference.empty() || study.pictures != StudyPictures::none;
    plan.digest = digest_of(study, plan, program);
    return plan;
}

std::size_t StudyPlan::cells() const {
    std::size_t count = 1;
    for (const Axis& axis : axes) count *= axis.values.size();
    return count;
}

bool StudyPlan::is_possible() const {
    std::size_t most = kMostRuns;
    for (const Axis& axis : axes) {
        if (axis.values.empty() || axis.values.size() > most) return false;
        most /= axis.values.size();
    }
    return seeds >= 1 && static_cast<std::size_t>(seeds) <= most;
}

std::vector<std::size_t> StudyPlan::places(std::size_t cell) const {
    std::vector<std::size_t> places(axes.size());
    for (std::size_t a = axes.size(); a-- > 0;) {
        places[a] = cell % axes[a].values.size();
        cell /= axes[a].values.size();
    }
    return places;
}

std::vector<std::string> StudyPlan::texts(std::size_t cell) const {
    const std::vector<std::size_t> place = places(cell);
    std::vector<std::string> texts;
    for (std::size_t a = 0; a < axes.size(); ++a) {
        const StudyValue& value = axes[a].values[place[a]];
        texts.insert(texts.end(), value.begin(), value.end());
    }
    return texts;
}

std::vector<std::string> StudyPlan::keys() const {
    std::vector<std::string> keys;
    for (const Axis& axis : axes) keys.insert(keys.end(), axis.keys.begin(), axis.keys.end());
    return keys;
}

std::string StudyPlan::cell_label(std::size_t cell) const {
    const std::vector<std::size_t> place = places(cell);
    std::vector<std::string> words;
    words.reserve(axes.size());
    for (std::size_t a = 0; a < axes.size(); ++a) {
        words.push_back(
            fmt::format("{}={}", axes[a].name, fmt::join(axes[a].values[place[a]], "/")));
    }
    return fmt::format("{}", fmt::join(words, " "));
}

std::string StudyPlan::label(std::size_t run) const {
    const std::string cell = cell_label(cell_of(run));
    return fmt::format("{}{}seed {}", cell, cell.empty() ? "" : " ", seed_of(run));
}

std::string StudyPlan::file_stem(std::size_t run) const {
    const std::size_t cell = cell_of(run);
    const std::vector<std::size_t> place = places(cell);
    std::string stem;
    bool exact = true;
    for (std::size_t a = 0; a < axes.size(); ++a) {
        stem += fmt::format("{}-{}-", axes[a].name, fmt::join(axes[a].values[place[a]], "_"));
    }
    for (char& c : stem) {
        const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
                           (c >= 'A' && c <= 'Z') || c == '.' || c == '-' || c == '+' || c == '_';
        if (plain) continue;
        c = '_';
        exact = false;
    }
    constexpr std::size_t kLongest = 120;
    if (stem.size() > kLongest) {
        stem.resize(kLongest);
        exact = false;
    }
    // What was lost may have told two values apart; the cell's number does.
    if (!exact) stem += fmt::format("-v{}-", cell + 1);
    return stem + fmt::format("s{}", seed_of(run));
}

std::string StudyPlan::run_digest(std::size_t run) const {
    Digest run_digest;
    run_digest.add(digest);
    const std::vector<std::string> key = keys();
    const std::vector<std::string> text = texts(cell_of(run));
    for (std::size_t i = 0; i < key.size(); ++i) run_digest.add(key[i]).add(text[i]);
    return run_digest.add(std::to_string(seed_of(run))).text();
}

StudyLayout study_in_folder(const fs::path& folder) {
    return {folder, "", "quality.csv"};
}

StudyLayout study_beside(const fs::path& quality_file) {
    std::error_code ignored;
    if (!quality_file.has_filename() || fs::is_directory(quality_file, ignored)) {
        throw FileError(
            quality_file.string(),
            HITOS_TEXT("Errors", "is a folder; expected the path of the quality file to write"));
    }
    const fs::path folder = quality_file.has_parent_path() ? quality_file.parent_path() : ".";
    // A number is no ending: p0.5 and p0.6 are two studies.
    const std::string ending = quality_file.extension().string();
    const bool number = ending.find_first_not_of(".0123456789") == std::string::npos;
    const fs::path name = number ? quality_file.filename() : quality_file.stem();
    return {folder, name.string() + "-", quality_file.filename().string()};
}

}  // namespace hitos
