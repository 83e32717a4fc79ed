#include "hitos/workbench/configuration_choices.hpp"

#include "hitos/services/configuration/config_parameter.hpp"

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

void TopicChoices::choose(SourceParams& source) const {
    if (!scan_topic.empty()) source.read.scan_topic = scan_topic;
    if (!odom_topic.empty()) source.read.odom_topic = odom_topic;
    if (!same_frames.empty()) source.read.same_frames = same_frames;
    if (!laser_pose.empty()) source.read.laser_pose = laser_pose;
}

std::string complaint_of_seed(const std::string& text) {
    return text.starts_with('-') ? "found " + text + ", expected a whole number from 0 on" : "";
}

}  // namespace hitos
