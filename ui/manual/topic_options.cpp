#include "manual/topic_options.hpp"

namespace hitos::manual {

void add_topic_options(CLI::App& program, TopicChoices& choices) {
    program.add_option("--scan-topic", choices.scan_topic,
                       "Laser topic of a ROS recording with several: one, several with commas "
                       "between them, or all");
    program.add_option("--odom-topic", choices.odom_topic,
                       "Odometry topic of a ROS recording with several, or tf for its transforms");
}

}  // namespace hitos::manual
