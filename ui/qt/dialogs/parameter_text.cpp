#include "parameter_text.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <map>
#include <string>
#include <string_view>

namespace hitos::window {
namespace {

using Words = std::map<std::string_view, const char*>;

const Words& labels() {
    static const Words table{
        {"source.file", QT_TRANSLATE_NOOP("ParameterLabel", "Log")},
        {"source.format", QT_TRANSLATE_NOOP("ParameterLabel", "Format")},
        {"source.max_range", QT_TRANSLATE_NOOP("ParameterLabel", "Maximum range")},
        {"source.odometry", QT_TRANSLATE_NOOP("ParameterLabel", "Odometry from")},
        {"filter.algorithm", QT_TRANSLATE_NOOP("ParameterLabel", "Algorithm")},
        {"filter.particles", QT_TRANSLATE_NOOP("ParameterLabel", "Particles")},
        {"association.method", QT_TRANSLATE_NOOP("ParameterLabel", "Association")},
        {"association.p0", QT_TRANSLATE_NOOP("ParameterLabel", "P0")},
        {"association.gate_probability", QT_TRANSLATE_NOOP("ParameterLabel", "Gate probability")},
        {"association.new_probability", QT_TRANSLATE_NOOP("ParameterLabel", "New landmark gate")},
        {"association.ambiguity", QT_TRANSLATE_NOOP("ParameterLabel", "Ambiguous")},
        {"association.ambiguity_ratio", QT_TRANSLATE_NOOP("ParameterLabel", "Ambiguity ratio")},
        {"motion.model", QT_TRANSLATE_NOOP("ParameterLabel", "Model")},
        {"motion.sigma_x", QT_TRANSLATE_NOOP("ParameterLabel", "σ x")},
        {"motion.sigma_y", QT_TRANSLATE_NOOP("ParameterLabel", "σ y")},
        {"motion.sigma_theta", QT_TRANSLATE_NOOP("ParameterLabel", "σ θ")},
        {"motion.var_along", QT_TRANSLATE_NOOP("ParameterLabel", "Var. along")},
        {"motion.var_across", QT_TRANSLATE_NOOP("ParameterLabel", "Var. across")},
        {"motion.var_theta_per_rad", QT_TRANSLATE_NOOP("ParameterLabel", "Var. θ per rad")},
        {"motion.var_theta_per_m", QT_TRANSLATE_NOOP("ParameterLabel", "Var. θ per m")},
        {"observation.var_rho", QT_TRANSLATE_NOOP("ParameterLabel", "σ² ρ")},
        {"observation.var_theta", QT_TRANSLATE_NOOP("ParameterLabel", "σ² θ")},
        {"observation.covariance", QT_TRANSLATE_NOOP("ParameterLabel", "Covariance")},
        {"observation.point_sigma", QT_TRANSLATE_NOOP("ParameterLabel", "σ range")},
        {"observation.common_sigma", QT_TRANSLATE_NOOP("ParameterLabel", "σ shared")},
        {"features.method", QT_TRANSLATE_NOOP("ParameterLabel", "Lines by")},
        {"features.detect", QT_TRANSLATE_NOOP("ParameterLabel", "Features")},
        {"features.corner_distance", QT_TRANSLATE_NOOP("ParameterLabel", "Corner distance (Es)")},
        {"split_merge.dmax", QT_TRANSLATE_NOOP("ParameterLabel", "D max")},
        {"split_merge.min_length", QT_TRANSLATE_NOOP("ParameterLabel", "L min")},
        {"split_merge.min_points", QT_TRANSLATE_NOOP("ParameterLabel", "P min")},
        {"split_merge.fit", QT_TRANSLATE_NOOP("ParameterLabel", "Fit")},
        {"split_merge.collinear_rho", QT_TRANSLATE_NOOP("ParameterLabel", "Collinear ρ")},
        {"split_merge.collinear_theta", QT_TRANSLATE_NOOP("ParameterLabel", "Collinear θ")},
        {"split_merge.collinear_gap", QT_TRANSLATE_NOOP("ParameterLabel", "Collinear gap")},
        {"split_merge.gap", QT_TRANSLATE_NOOP("ParameterLabel", "Gap")},
        {"split_merge.gap_per_range", QT_TRANSLATE_NOOP("ParameterLabel", "Gap per range")},
        {"ransac.edge", QT_TRANSLATE_NOOP("ParameterLabel", "RANSAC edge")},
        {"ransac.edge_per_range", QT_TRANSLATE_NOOP("ParameterLabel", "Edge per range")},
        {"ransac.threshold", QT_TRANSLATE_NOOP("ParameterLabel", "RANSAC threshold")},
        {"ransac.iterations", QT_TRANSLATE_NOOP("ParameterLabel", "RANSAC iterations")},
        {"resampling.rule", QT_TRANSLATE_NOOP("ParameterLabel", "Resampling")},
        {"resampling.neff_threshold", QT_TRANSLATE_NOOP("ParameterLabel", "Neff threshold")},
        {"resampling.method", QT_TRANSLATE_NOOP("ParameterLabel", "Resampling method")},
        {"filter.proposal", QT_TRANSLATE_NOOP("ParameterLabel", "Proposal")},
        {"grid.resolution", QT_TRANSLATE_NOOP("ParameterLabel", "Cell size")},
        {"grid.hit", QT_TRANSLATE_NOOP("ParameterLabel", "Hit")},
        {"grid.miss", QT_TRANSLATE_NOOP("ParameterLabel", "Miss")},
        {"grid.limit", QT_TRANSLATE_NOOP("ParameterLabel", "Limit")},
        {"grid.max_range", QT_TRANSLATE_NOOP("ParameterLabel", "Longest ray")},
        {"run.seed", QT_TRANSLATE_NOOP("ParameterLabel", "Seed")},
        {"run.threads", QT_TRANSLATE_NOOP("ParameterLabel", "Threads")},
    };
    return table;
}

const Words& choices() {
    static const Words table{
        {"source.format=auto", QT_TRANSLATE_NOOP("ParameterChoice", "Automatic")},
        {"source.format=player", QT_TRANSLATE_NOOP("ParameterChoice", "Player")},
        {"source.format=radish", QT_TRANSLATE_NOOP("ParameterChoice", "Radish")},
        {"source.format=normalized", QT_TRANSLATE_NOOP("ParameterChoice", "Normalised")},
        {"source.format=carmen", QT_TRANSLATE_NOOP("ParameterChoice", "CARMEN")},
        {"source.odometry=poses", QT_TRANSLATE_NOOP("ParameterChoice", "Logged poses")},
        {"source.odometry=velocities", QT_TRANSLATE_NOOP("ParameterChoice", "Logged velocities")},
        {"filter.algorithm=fastslam", QT_TRANSLATE_NOOP("ParameterChoice", "FastSLAM 1.0")},
        {"filter.algorithm=ekf-slam", QT_TRANSLATE_NOOP("ParameterChoice", "EKF-SLAM")},
        {"filter.proposal=motion", QT_TRANSLATE_NOOP("ParameterChoice", "Motion model")},
        {"association.method=ml", QT_TRANSLATE_NOOP("ParameterChoice", "Maximum likelihood")},
        {"association.method=gnn", QT_TRANSLATE_NOOP("ParameterChoice", "Gated nearest neighbour")},
        {"association.ambiguity=keep-likelihood",
         QT_TRANSLATE_NOOP("ParameterChoice", "Keep the likelihood")},
        {"association.ambiguity=neutral", QT_TRANSLATE_NOOP("ParameterChoice", "Neutral")},
        {"association.ambiguity=new-landmark",
         QT_TRANSLATE_NOOP("ParameterChoice", "As a new landmark")},
        {"association.ambiguity=off", QT_TRANSLATE_NOOP("ParameterChoice", "Off")},
        {"motion.model=odometry",
         QT_TRANSLATE_NOOP("ParameterChoice", "Differential with odometry")},
        {"motion.model=no-odometry",
         QT_TRANSLATE_NOOP("ParameterChoice", "Differential without odometry")},
        {"motion.model=proportional", QT_TRANSLATE_NOOP("ParameterChoice", "Proportional")},
        {"observation.covariance=fixed", QT_TRANSLATE_NOOP("ParameterChoice", "Fixed variances")},
        {"observation.covariance=points", QT_TRANSLATE_NOOP("ParameterChoice", "From the points")},
        {"features.method=split-merge", QT_TRANSLATE_NOOP("ParameterChoice", "Split and Merge")},
        {"features.method=ransac", QT_TRANSLATE_NOOP("ParameterChoice", "RANSAC")},
        {"features.detect=lines", QT_TRANSLATE_NOOP("ParameterChoice", "Lines")},
        {"features.detect=corners", QT_TRANSLATE_NOOP("ParameterChoice", "Corners")},
        {"features.detect=both", QT_TRANSLATE_NOOP("ParameterChoice", "Both")},
        {"split_merge.fit=endpoints", QT_TRANSLATE_NOOP("ParameterChoice", "End points")},
        {"split_merge.fit=least-squares", QT_TRANSLATE_NOOP("ParameterChoice", "Least squares")},
        {"resampling.rule=always", QT_TRANSLATE_NOOP("ParameterChoice", "Without threshold")},
        {"resampling.rule=neff", QT_TRANSLATE_NOOP("ParameterChoice", "Neff threshold")},
        {"resampling.method=low-variance", QT_TRANSLATE_NOOP("ParameterChoice", "Low variance")},
        {"resampling.method=stratified", QT_TRANSLATE_NOOP("ParameterChoice", "Stratified")},
        {"resampling.method=residual", QT_TRANSLATE_NOOP("ParameterChoice", "Residual")},
        {"resampling.method=multinomial", QT_TRANSLATE_NOOP("ParameterChoice", "Multinomial")},
    };
    return table;
}

QString group_words(ParameterGroup group) {
    switch (group) {
        case ParameterGroup::source:
            return QT_TRANSLATE_NOOP("ParameterGroup", "Data source");
        case ParameterGroup::particle_filter:
            return QT_TRANSLATE_NOOP("ParameterGroup", "Particle filter");
        case ParameterGroup::motion:
            return QT_TRANSLATE_NOOP("ParameterGroup", "Motion model");
        case ParameterGroup::observation:
            return QT_TRANSLATE_NOOP("ParameterGroup", "Observation model");
        case ParameterGroup::split_merge:
            return QT_TRANSLATE_NOOP("ParameterGroup", "Split and Merge algorithm");
        case ParameterGroup::resampling:
            return QT_TRANSLATE_NOOP("ParameterGroup", "Resampling");
        case ParameterGroup::grid:
            return QT_TRANSLATE_NOOP("ParameterGroup", "Grid map");
        case ParameterGroup::run:
            return QT_TRANSLATE_NOOP("ParameterGroup", "Run");
    }
    return {};
}

}  // namespace

QString to_qt(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString label_of(const Parameter& parameter) {
    const auto found = labels().find(parameter.key);
    return found == labels().end() ? to_qt(parameter.key)
                                   : QCoreApplication::translate("ParameterLabel", found->second);
}

QString description_of(const Parameter& parameter) {
    return QCoreApplication::translate("Parameter", std::string(parameter.description).c_str());
}

QString unit_of(const Parameter& parameter) {
    if (parameter.unit == "particles" || parameter.unit == "log-odds") return {};
    return to_qt(parameter.unit).replace("^2", "²");
}

QString choice_of(const Parameter& parameter, std::size_t place) {
    const std::string key =
        std::string(parameter.key) + '=' + std::string(parameter.choices.at(place));
    const auto found = choices().find(key);
    return found == choices().end() ? to_qt(parameter.choices[place])
                                    : QCoreApplication::translate("ParameterChoice", found->second);
}

QString title_of(ParameterGroup group) {
    return QCoreApplication::translate("ParameterGroup", group_words(group).toUtf8().constData());
}

QString value_of(const Parameter& parameter, const Configuracion& configuration) {
    switch (parameter.type) {
        case Parameter::Type::choice:
            return choice_of(parameter,
                             static_cast<std::size_t>(parameter.get_integer(configuration)));
        case Parameter::Type::text:
            return QFileInfo(QString::fromStdString(parameter.text(configuration))).fileName();
        default:
            return QString::fromStdString(parameter.text(configuration));
    }
}

QString value_with_unit(const Parameter& parameter, const Configuracion& configuration) {
    const QString unit = unit_of(parameter);
    const QString value = value_of(parameter, configuration);
    return unit.isEmpty() || value.isEmpty() ? value : value + ' ' + unit;
}

QString allowed_of(const Parameter& parameter) {
    const QString unit = unit_of(parameter);
    return QCoreApplication::translate("Parameter", "%1 to %2 %3")
        .arg(parameter.minimum)
        .arg(parameter.maximum)
        .arg(unit)
        .trimmed();
}

bool is_default(const Parameter& parameter, const Configuracion& configuration) {
    static const Configuracion defaults;
    return parameter.text(configuration) == parameter.text(defaults);
}

}  // namespace hitos::window
