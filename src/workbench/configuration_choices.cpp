#include "hitos/workbench/configuration_choices.hpp"

#include "hitos/services/configuration/archivo_configuracion.hpp"

namespace hitos {

void choose_values(Configuracion& configuration, const ValueChoices& choices) {
    for (const std::string& assignment : choices.assignments) {
        set_parameter(configuration, assignment);
    }
    for (const std::string& assignment : choices.world_assignments) {
        std::string& changes = configuration.source.world_set;
        if (!changes.empty()) changes += ' ';
        changes += assignment;
    }
    if (choices.tour_seed) {
        find_parameter("source.tour_seed").set(configuration, std::to_string(*choices.tour_seed));
    }
    if (choices.seed) {
        find_parameter("run.seed").set(configuration, std::to_string(*choices.seed));
    }
    if (choices.threads) {
        find_parameter("run.threads").set(configuration, std::to_string(*choices.threads));
    }
    check(configuration);
}

Configuracion read_configuration(const std::filesystem::path& file) {
    Configuracion configuration = ArchivoConfiguracion::read(file);
    const std::filesystem::path log = configuration.source.file;
    std::error_code ignored;
    if (log.empty() || log.is_absolute() || std::filesystem::exists(log, ignored)) {
        return configuration;
    }
    const std::filesystem::path beside = std::filesystem::absolute(file).parent_path() / log;
    if (std::filesystem::exists(beside, ignored)) configuration.source.file = beside.string();
    return configuration;
}

}  // namespace hitos
